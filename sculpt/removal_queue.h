#pragma once

#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "kernel/large_array.h"
#include "sculpt/priority.h"

/// Queues of tetrahedra that may be removed: smallest key first, equal keys in the lexicographic
/// order of corners. An entry may be in a queue several times.
namespace tetsculpt {

struct RemovalEntry {
  double key;
  TetId tet;
};

/// Added to a key it puts an entry behind all others: ranks are below 2^32.
inline constexpr double kBehindAll = 0x1p40;

/// For any keys.
class KeyQueue {
 public:
  /// Made as a RankQueue is.
  KeyQueue(const ManifoldSolid& solid, std::size_t) : heap_(Later{&solid}) {}

  bool empty() const { return heap_.empty(); }
  void push(const RemovalEntry& entry) { heap_.push(entry); }
  RemovalEntry pop() {
    const RemovalEntry first = heap_.top();
    heap_.pop();
    return first;
  }
  void clear() {
    while (!empty()) heap_.pop();
  }
  TetId next() const { return heap_.top().tet; }

 private:
  struct Later {
    const ManifoldSolid* solid;
    bool operator()(const RemovalEntry& a, const RemovalEntry& b) const {
      return a.key != b.key ? a.key > b.key
                            : corners_less(solid->vertices(b.tet), solid->vertices(a.tet));
    }
  };
  std::priority_queue<RemovalEntry, std::vector<RemovalEntry>, Later> heap_;
};

/// For keys that are -r or kBehindAll - r, of ranks r below a bound: one list per key, and a tree
/// of bits for which lists are not empty. A push or pop takes a few steps, whatever the size.
class RankQueue {
 public:
  RankQueue(const ManifoldSolid& solid, std::size_t ranks);

  bool empty() const { return size_ == 0; }
  void push(const RemovalEntry& entry);
  RemovalEntry pop();
  void clear();
  /// Probably the next to be popped. Precondition: not empty.
  TetId next() const { return lists_[first_list_].tet; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// Most lists hold one item, so the first is in the table itself.
  struct Item {
    TetId tet;
    std::uint32_t next;
  };

  /// The list of a key: the higher, the earlier.
  std::size_t list_of(double key) const {
    return static_cast<std::size_t>(key <= 0 ? static_cast<double>(ranks_) - key
                                             : kBehindAll - key);
  }
  double key_of(std::size_t list) const {
    return list >= ranks_ ? static_cast<double>(ranks_) - static_cast<double>(list)
                          : kBehindAll - static_cast<double>(list);
  }
  /// Is the list not empty? Told by what is in the nearest caches, unlike the list itself.
  bool marked(std::size_t list) const { return (bits_[0][list / 64] >> (list % 64) & 1) != 0; }
  std::size_t highest_marked() const;
  void mark(std::size_t list);
  void unmark(std::size_t list);
  /// Room for an item that is not the first of its list.
  std::uint32_t take_place();

  const ManifoldSolid* solid_;
  std::size_t ranks_;
  std::size_t size_ = 0;
  std::size_t first_list_ = 0;  ///< the highest that is not empty
  LargeArray<Item> lists_;      ///< the first item of each, if it is marked
  std::vector<Item> more_;
  std::uint32_t free_ = kNone;                    ///< list of places in more_ that hold nothing
  std::vector<std::vector<std::uint64_t>> bits_;  ///< a level has one bit per word below
};

}  // namespace tetsculpt
