#include "sculpt/removal_queue.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace tetsculpt {

RankQueue::RankQueue(const ManifoldSolid& solid, std::size_t ranks)
    : solid_(&solid), ranks_(ranks), lists_(2 * ranks) {
  std::size_t count = lists_.size();
  do {
    count = (count + 63) / 64;
    bits_.emplace_back(count, 0);
  } while (count > 1);
}

std::uint32_t RankQueue::take_place() {
  if (free_ == kNone) {
    more_.emplace_back();
    return static_cast<std::uint32_t>(more_.size() - 1);
  }
  return std::exchange(free_, more_[free_].next);
}

void RankQueue::push(const RemovalEntry& entry) {
  const std::size_t list = list_of(entry.key);
  std::uint32_t next = kNone;
  if (marked(list)) {
    next = take_place();
    more_[next] = lists_[list];
  } else {
    mark(list);
    first_list_ = size_ == 0 ? list : std::max(first_list_, list);
  }
  lists_[list] = {entry.tet, next};
  ++size_;
}

RemovalEntry RankQueue::pop() {
  assert(!empty());
  const std::size_t list = first_list_;
  Item& first = lists_[list];
  Item* least = &first;
  for (std::uint32_t i = first.next; i != kNone; i = more_[i].next) {
    if (corners_less(solid_->vertices(more_[i].tet), solid_->vertices(least->tet)))
      least = &more_[i];
  }
  const TetId tet = std::exchange(least->tet, first.tet);  // a list has no order
  const std::uint32_t next = first.next;
  --size_;
  if (next == kNone) {
    unmark(list);
    if (!empty()) first_list_ = highest_marked();
    __builtin_prefetch(&lists_[first_list_]);
  } else {
    first = more_[next];
    more_[next].next = std::exchange(free_, next);
  }
  return {key_of(list), tet};
}

void RankQueue::clear() {
  while (!empty()) pop();
}

std::size_t RankQueue::highest_marked() const {
  std::size_t at = 0;
  for (std::size_t level = bits_.size(); level-- > 0;) {
    at = 64 * at + 63 - static_cast<std::size_t>(std::countl_zero(bits_[level][at]));
  }
  return at;
}

void RankQueue::mark(std::size_t list) {
  for (auto& level : bits_) {
    std::uint64_t& word = level[list / 64];
    const bool marked = word != 0;
    word |= std::uint64_t{1} << (list % 64);
    if (marked) break;
    list /= 64;
  }
}

void RankQueue::unmark(std::size_t list) {
  for (auto& level : bits_) {
    std::uint64_t& word = level[list / 64];
    word &= ~(std::uint64_t{1} << (list % 64));
    if (word != 0) break;
    list /= 64;
  }
}

}  // namespace tetsculpt
