#pragma once

/// A film at a glance: pictures of it in rows, with a title above and time and name under each.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/film.h"
#include "render/sink.h"
#include "scenarios/timeline.h"

namespace proofreel {

/// How many pictures lie beside and below each other.
struct SheetGrid {
  int columns = 0;
  int rows = 0;
};

struct SheetPicture {
  std::int64_t frame = 0;
  std::string name;  ///< of the section it ends; empty without sections
};

/// What a sheet shows of the frames in `range`: where sections lie in it the last frame of each, else frames at even
/// distances from the first to the last, as many as the grid has places. The grid is four by three unless told, or what
/// the sections need; it shrinks to what there is. Throws UsageError when there are more sections than places.
std::vector<SheetPicture> sheet_pictures(FrameRange range, const std::vector<FilmSection>& sections,
                                         std::optional<SheetGrid>& grid);

/// What is written on a sheet.
struct SheetText {
  std::string title;
  std::vector<std::string> names;  ///< under each picture, at the left; may be empty
  std::vector<std::string> times;  ///< at the right
};

/// Takes the pictures in their order and writes the sheet as PNG. `size` is that of each. Throws UsageError when the
/// sheet would be larger than pictures may be.
std::unique_ptr<Sink> make_contact_sheet(const std::string& path, SheetGrid grid, Size size, Theme theme,
                                         SheetText text);

}  // namespace proofreel
