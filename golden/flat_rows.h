#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace proofreel {

/// Where two pictures of one size are flat: pixels with three or more neighbours of their very colour in both. Beyond
/// the border lies one equal neighbour. Kept are the three rows round one row at a time.
class FlatRows {
 public:
  FlatRows(const Image& a, const Image& b);

  /// Makes `y` the middle row. Cheap when it was `y` or `y` - 1 before.
  void move_to(int y);

  /// Of the middle row or one beside it.
  bool is_flat(int x, int y) const { return row(y)[static_cast<std::size_t>(x)] != 0; }
  /// Whether any pixel of the 3 x 3 round this one of the middle row is flat.
  bool has_flat_neighbour(int x) const { return near_[static_cast<std::size_t>(x)] != 0; }

 private:
  using Row = std::vector<std::uint8_t>;
  const Row& row(int y) const { return rows_[static_cast<std::size_t>(y % 3)]; }
  void compute(int y);

  const Image& a_;
  const Image& b_;
  std::array<Row, 3> rows_;               ///< row y at y % 3
  std::array<int, 3> known_{-1, -1, -1};  ///< which row lies there
  Row near_;
  int middle_ = -1;
};

}  // namespace proofreel
