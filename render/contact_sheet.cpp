#include "render/contact_sheet.h"

#include <algorithm>
#include <cstring>

#include "render/lettering.h"
#include "render/output_file.h"
#include "render/png.h"
#include "render/theme.h"

namespace proofreel {
namespace {

constexpr SheetGrid usual_grid{4, 3};

/// Lengths of a sheet, px, by the width of its pictures.
struct SheetLayout {
  SheetGrid grid;
  Size size;  ///< of a picture
  int gap = 0;
  int letters = 0;
  int title = 0;
  int head = 0;   ///< above the first row
  int label = 0;  ///< below a picture

  SheetLayout(SheetGrid the_grid, Size the_size) : grid(the_grid), size(the_size) {
    const int unit = std::min(size.width_px, 2 * size.height_px);
    gap = std::max(8, unit / 20);
    letters = std::max(11, unit / 27);
    title = std::max(16, unit / 14);
    head = gap + 2 * title;
    label = 2 * letters;
  }
  int left(int column) const { return gap + column * (size.width_px + gap); }
  int top(int row) const { return head + row * (size.height_px + label + gap / 2); }
  std::int64_t width() const { return gap + std::int64_t{grid.columns} * (size.width_px + gap); }
  std::int64_t height() const { return head + std::int64_t{grid.rows} * (size.height_px + label + gap / 2) + gap / 2; }
};

void fill(Image& image, const PixelRect& rect, Color color) {
  for (int y = rect.y_px; y < rect.y_px + rect.height_px; ++y) {
    std::uint8_t* pixel = image.row(y) + 4 * static_cast<std::size_t>(rect.x_px);
    for (int x = 0; x < rect.width_px; ++x, pixel += 4) {
      pixel[0] = color.r;
      pixel[1] = color.g;
      pixel[2] = color.b;
      pixel[3] = 255;
    }
  }
}

class ContactSheetSink final : public Sink {
 public:
  ContactSheetSink(std::string path, const SheetLayout& layout, Theme theme, SheetText text)
      : path_(std::move(path)),
        layout_(layout),
        palette_(palette_of(theme)),
        text_(std::move(text)),
        sheet_(Image::uncleared(static_cast<int>(layout.width()), static_cast<int>(layout.height()))) {
    const OutputFile removed_at_once(path_);  // an unwritable folder is to be found before anything is drawn
    fill(sheet_, {0, 0, sheet_.width_px, sheet_.height_px}, palette_.background);
    const LetterLine line{layout_.gap, layout_.gap + layout_.title, sheet_.width_px - layout_.gap};
    write(text_.title, layout_.title, line, palette_.ink);
  }

  void frame(const Image& image) override {
    const int column = static_cast<int>(taken_) % layout_.grid.columns;
    const int left = layout_.left(column), top = layout_.top(static_cast<int>(taken_) / layout_.grid.columns);
    fill(sheet_, {left - 1, top - 1, image.width_px + 2, image.height_px + 2}, palette_.plate_edge);
    for (int y = 0; y < image.height_px; ++y)
      std::memcpy(sheet_.row(top + y) + 4 * static_cast<std::size_t>(left), image.row(y), image.row_bytes());
    label(left, top + image.height_px + 3 * layout_.letters / 2);
    ++taken_;
  }

  void finish() override { write_png(path_, sheet_); }

 private:
  /// The time at the right; the name has what is left.
  void label(int left, int baseline) {
    const int size = layout_.letters;
    const std::string& time = text_.times[taken_];
    const std::string name = taken_ < text_.names.size() ? text_.names[taken_] : std::string();
    const int time_width = letters_.width_px(time, size);
    const int room = layout_.size.width_px - time_width - size;
    const int time_left = name.empty() ? left : left + layout_.size.width_px - time_width;
    if (!name.empty()) write(name, size, {left, baseline, left + room}, palette_.ink);
    letters_.write(sheet_, time, size, {time_left, baseline, sheet_.width_px}, palette_.quiet_ink);
  }

  /// On one line; what is too long ends in three dots.
  void write(std::string text, int size_px, const LetterLine& line, Color color) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::string whole = text;
    for (std::size_t end = whole.size(); line.x_px + letters_.width_px(text, size_px) > line.end_px && end > 0;) {
      do --end;
      while (end > 0 && (static_cast<unsigned char>(whole[end]) & 0xC0U) == 0x80U);  // no half characters
      text = whole.substr(0, end) + "\u2026";
    }
    letters_.write(sheet_, text, size_px, {line.x_px, line.baseline_px, sheet_.width_px}, color);
  }

  std::string path_;
  SheetLayout layout_;
  const Palette& palette_;
  SheetText text_;
  Lettering letters_;
  Image sheet_;
  std::size_t taken_ = 0;
};

/// As wide as high, or one wider.
SheetGrid grid_for(std::size_t pictures) {
  SheetGrid grid{1, 1};
  while (static_cast<std::size_t>(grid.columns * grid.columns) < pictures) ++grid.columns;
  grid.rows = (static_cast<int>(pictures) + grid.columns - 1) / grid.columns;
  return grid;
}

std::vector<SheetPicture> ends_of(FrameRange range, const std::vector<FilmSection>& sections) {
  std::vector<SheetPicture> pictures;
  for (const FilmSection& section : sections) {
    if (section.first <= range.last && section.last >= range.first)
      pictures.push_back({std::min(section.last, range.last), section.name});
  }
  return pictures;
}

std::vector<SheetPicture> evenly_spread(FrameRange range, std::int64_t places) {
  const std::int64_t frames = range.last - range.first + 1;
  const std::int64_t count = std::min(places, frames);
  std::vector<SheetPicture> pictures;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t gaps = std::max<std::int64_t>(1, count - 1);
    pictures.push_back({range.first + (i * (frames - 1) + gaps / 2) / gaps, {}});
  }
  return pictures;
}

}  // namespace

std::vector<SheetPicture> sheet_pictures(FrameRange range, const std::vector<FilmSection>& sections,
                                         std::optional<SheetGrid>& grid) {
  std::vector<SheetPicture> pictures = ends_of(range, sections);
  if (!grid) grid = pictures.empty() ? usual_grid : grid_for(pictures.size());
  const std::int64_t places = std::int64_t{grid->columns} * grid->rows;
  if (static_cast<std::int64_t>(pictures.size()) > places) {
    const SheetGrid enough = grid_for(pictures.size());
    throw UsageError("--contact-sheet=" + std::to_string(grid->columns) + "x" + std::to_string(grid->rows) + " has " +
                     std::to_string(places) + (places == 1 ? " place" : " places") + ", but the film has " +
                     std::to_string(pictures.size()) + " sections: " + std::to_string(enough.columns) + "x" +
                     std::to_string(enough.rows) + " has enough.");
  }
  if (pictures.empty()) pictures = evenly_spread(range, places);
  const int count = static_cast<int>(pictures.size());
  grid->columns = std::min(grid->columns, count);
  grid->rows = (count + grid->columns - 1) / grid->columns;
  return pictures;
}

std::unique_ptr<Sink> make_contact_sheet(const std::string& path, SheetGrid grid, Size size, Theme theme,
                                         SheetText text) {
  const SheetLayout layout(grid, size);
  if (layout.width() > max_image_side_px || layout.height() > max_image_side_px ||
      layout.width() * layout.height() > max_image_pixels)
    throw UsageError("A contact sheet of " + std::to_string(grid.columns) + "x" + std::to_string(grid.rows) +
                     " pictures of " + std::to_string(size.width_px) + "x" + std::to_string(size.height_px) +
                     " would be too large: choose a smaller --size, which is that of each picture.");
  return std::make_unique<ContactSheetSink>(path, layout, theme, std::move(text));
}

}  // namespace proofreel
