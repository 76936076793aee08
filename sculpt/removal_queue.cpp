#include "sculpt/removal_queue.h"

#include <cassert>

namespace tetsculpt {

RankQueue::RankQueue(const TetComplex& complex, std::size_t ranks)
    : complex_(&complex), ranks_(ranks), first_(2 * ranks, kNone) {
  std::size_t count = first_.size();
  for (auto& level : bits_) {
    count = (count + 63) / 64;
    level.assign(count, 0);
  }
  assert(count <= 1);
}

void RankQueue::push(const RemovalEntry& entry) {
  const std::size_t list = list_of(entry.key);
  std::uint32_t item = free_;
  if (item == kNone) {
    item = static_cast<std::uint32_t>(items_.size());
    items_.emplace_back();
  } else {
    free_ = items_[item].next;
  }
  mark(list);  // whether it is already is known later than this is done
  items_[item] = {entry.tet, first_[list]};
  first_[list] = item;
  ++size_;
}

RemovalEntry RankQueue::pop() {
  assert(!empty());
  const std::size_t list = first_list();
  std::uint32_t* least = &first_[list];
  for (std::uint32_t* link = &items_[*least].next; *link != kNone; link = &items_[*link].next) {
    if (corners_less(*complex_, items_[*link].tet, items_[*least].tet)) least = link;
  }
  const std::uint32_t item = *least;
  *least = items_[item].next;
  items_[item].next = free_;
  free_ = item;
  if (first_[list] == kNone) unmark(list);
  --size_;
  return {key_of(list), items_[item].tet};
}

void RankQueue::clear() {
  while (!empty()) pop();
}

std::size_t RankQueue::first_list() const {
  std::size_t at = 0;
  for (std::size_t level = kLevels; level-- > 0;) {
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
