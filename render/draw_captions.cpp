#include <algorithm>
#include <array>

#include "render/draw_layers.h"
#include "render/draw_text.h"
#include "render/typeset.h"

namespace proofreel {
namespace {

/// How high captions may be, in em of the text's size.
struct Room {
  double above = 0;
  double below = 0;
};

/// Of five lines; more would be a page to read, not a caption.
constexpr Room usual_room{5 * line_height + 0.6, 5 * line_height + 0.6};
/// Of the bands that a split screen keeps free of panes.
constexpr Room split_room{3.3, 3.9};

/// A caption set in lines.
struct Block {
  std::vector<TypesetLine> lines;
  int size_px = 0;
  double width = 0;
  double height = 0;
  bool fits = false;
};

Block block_of(Canvas& canvas, const Sizes& sizes, const std::string& text, int size_px, double most_em) {
  constexpr double padding = 1.4;  // em, left and right
  const double widest = canvas.width_px() - 2 * sizes.margin - padding * size_px;
  Block block{balanced(canvas, text, size_px, widest), size_px, 0, 0, false};
  for (const TypesetLine& line : block.lines) block.width = std::max(block.width, line.width);
  block.height = height_of(block.lines, size_px) + 1.1 * size_px;
  block.fits = block.width <= widest && block.height <= most_em * sizes.text;
  block.width += padding * size_px;
  return block;
}

/// A line at the top is a heading. What is too long for one is set as large as it fits, down to the smallest size of
/// the picture.
Block fitting_block(Canvas& canvas, const Sizes& sizes, const CaptionView& caption, const Room& room) {
  const double most_em = is_at_top(caption.at) ? room.above : room.below;
  if (caption.at == Corner::top) {
    Block heading = block_of(canvas, sizes, caption.text, sizes.title, most_em);
    if (heading.lines.size() == 1 && heading.fits) return heading;
  }
  Block block = block_of(canvas, sizes, caption.text, sizes.text, most_em);
  for (int size = sizes.text - 1; size >= sizes.small && !block.fits; --size)
    block = block_of(canvas, sizes, caption.text, size, most_em);
  return block;
}

Align align_of(Corner at) {
  if (at == Corner::top_left || at == Corner::bottom_left) return Align::left;
  return at == Corner::top_right || at == Corner::bottom_right ? Align::right : Align::center;
}

[[noreturn]] void refuse(const Canvas& canvas, const CaptionView& caption) {
  const std::string size = std::to_string(canvas.width_px()) + "x" + std::to_string(canvas.height_px());
  throw ScenarioError(caption.place + "the text of this caption does not fit into a picture of " + size +
                      ", not even in its smallest letters: shorten it, or make captions of it that follow each other");
}

/// Returns how high it is, in em of the text's size.
double draw_caption(const Stage& stage, Cards& cards, const CaptionView& caption, const Room& room) {
  const Block block = fitting_block(stage.canvas, stage.sizes, caption, room);
  if (block.lines.empty()) return 0;
  if (!block.fits) refuse(stage.canvas, caption);
  const double size = block.size_px;
  const double padding = 0.7 * size;
  const Aabbd card = cards.place({block.width, block.height}, caption.at);
  stage.canvas.rectangle(card.lower, card.upper, 0.3 * size, {stage.palette.plate, stage.palette.plate_edge, 1});
  const Align align = align_of(caption.at);
  const double x = align == Align::left    ? card.lower.x + padding
                   : align == Align::right ? card.upper.x - padding
                                           : 0.5 * (card.lower.x + card.upper.x);
  draw_lines(stage.canvas, block.lines, block.size_px, {x, card.lower.y + 0.55 * size}, align, stage.palette.ink);
  return block.height / stage.sizes.text;
}

}  // namespace

void require_room(Canvas& canvas, const std::vector<CaptionView>& captions) {
  const Sizes sizes = sizes_of(canvas.width_px(), canvas.height_px());
  for (const CaptionView& caption : captions) {
    if (!fitting_block(canvas, sizes, caption, usual_room).fits) refuse(canvas, caption);
  }
}

void draw_captions(const Stage& stage, Cards& cards) {
  const bool split = !stage.frame.other_panes.empty();
  constexpr std::size_t corners = static_cast<std::size_t>(Corner::bottom_right) + 1;
  std::array<double, corners> taken{};  // by those of the same place, em: on a band they lie below each other
  for (const CaptionView& caption : stage.frame.captions) {
    double& height = taken[static_cast<std::size_t>(caption.at)];
    const Room room = split ? Room{split_room.above - height, split_room.below - height} : usual_room;
    stage.own(OwnerKind::caption, caption.text);
    height += draw_caption(stage, cards, caption, room) + 0.4;
  }
}

}  // namespace proofreel
