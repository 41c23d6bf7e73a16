#pragma once

/// Which parts of a picture have to be drawn when it follows upon another one in the same place.
///
/// A tile on which the same marks lie in the same order looks as it did. So each tile is told by a number, a hash of
/// all that is drawn on it, and only where that number is another one the picture is drawn.

#include <cstdint>
#include <span>
#include <vector>

#include "render/tile_grid.h"

namespace proofreel {

/// Disjoint rectangles that hold all tiles of the grid that are marked (not 0). They are few: a rectangle may hold
/// others, too, where drawing them is cheaper than one more rectangle.
std::vector<TileSpan> parts_that_hold(const TileGrid& grid, std::span<const unsigned char> marked);

/// What is known of the pictures that were drawn in one place. Every picture is begun and then settled. One that is
/// not, because drawing it failed, leaves nothing known: the next is drawn in full, as the first of a new series.
class ChangedTiles {
 public:
  explicit ChangedTiles(const TileGrid& grid);

  /// Where to draw so that the picture becomes the one these hashes tell, one for every tile: nowhere when it is that
  /// already, everywhere when much has changed.
  std::vector<TileSpan> begin(std::span<const std::uint64_t> hashes);
  /// The picture that was begun has been drawn.
  void settle() { known_ = true; }
  /// What is in the place is not what hashes told.
  void forget() { known_ = false; }

  /// Of the picture begun last.
  Edition edition() const { return {series_, number_, changes_}; }
  /// Where the picture begun last may differ from another edition; everywhere when that is of another series.
  std::vector<TileSpan> parts_since(const Edition& held) const;

 private:
  TileGrid grid_;
  bool known_ = false;
  std::uint64_t series_ = 0;
  std::uint64_t number_ = 0;
  std::vector<std::uint64_t> hashes_;    // by tile
  std::vector<std::uint64_t> drawn_in_;  // by tile, the last number that it was drawn in
  std::vector<PixelRect> changes_;
};

}  // namespace proofreel
