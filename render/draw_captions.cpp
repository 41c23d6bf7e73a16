#include <algorithm>

#include "render/draw_layers.h"
#include "render/draw_text.h"
#include "render/typeset.h"

namespace proofreel {
namespace {

/// More would be a page to read, not a caption.
constexpr double most_lines = 5;

/// A caption set in lines.
struct Block {
  std::vector<TypesetLine> lines;
  int size_px = 0;
  double width = 0;
  double height = 0;
  bool fits = false;
};

Block block_of(Canvas& canvas, const Sizes& sizes, const std::string& text, int size_px) {
  constexpr double padding = 1.4;  // em, left and right
  constexpr double lines_to_em = 0.6;
  const double widest = canvas.width_px() - 2 * sizes.margin - padding * size_px;
  Block block{typeset(canvas, text, size_px, widest), size_px, 0, 0, false};
  for (const TypesetLine& line : block.lines) block.width = std::max(block.width, line.width);
  block.height = height_of(block.lines, size_px) + 1.1 * size_px;
  block.fits = block.width <= widest && block.height <= (line_height * most_lines + lines_to_em) * sizes.text;
  block.width += padding * size_px;
  return block;
}

/// A line at the top is a heading. What is too long for one is set as large as it fits, down to the smallest size of
/// the picture.
Block fitting_block(Canvas& canvas, const Sizes& sizes, const CaptionView& caption) {
  if (caption.at == Corner::top) {
    Block heading = block_of(canvas, sizes, caption.text, sizes.title);
    if (heading.lines.size() == 1 && heading.fits) return heading;
  }
  Block block = block_of(canvas, sizes, caption.text, sizes.text);
  for (int size = sizes.text - 1; size >= sizes.small && !block.fits; --size)
    block = block_of(canvas, sizes, caption.text, size);
  return block;
}

Align align_of(Corner at) {
  if (at == Corner::top_left || at == Corner::bottom_left) return Align::left;
  return at == Corner::top_right || at == Corner::bottom_right ? Align::right : Align::center;
}

void draw_caption(const Stage& stage, Cards& cards, const CaptionView& caption) {
  const Block block = fitting_block(stage.canvas, stage.sizes, caption);
  if (block.lines.empty()) return;
  const double size = block.size_px;
  const double padding = 0.7 * size;
  const Aabbd card = cards.place({block.width, block.height}, caption.at);
  stage.canvas.rectangle(card.lower, card.upper, 0.3 * size, {stage.palette.plate, stage.palette.plate_edge, 1});
  const Align align = align_of(caption.at);
  const double x = align == Align::left    ? card.lower.x + padding
                   : align == Align::right ? card.upper.x - padding
                                           : 0.5 * (card.lower.x + card.upper.x);
  draw_lines(stage.canvas, block.lines, block.size_px, {x, card.lower.y + 0.55 * size}, align, stage.palette.ink);
}

}  // namespace

void require_room(Canvas& canvas, const std::vector<CaptionView>& captions) {
  const int width = canvas.width_px(), height = canvas.height_px();
  for (const CaptionView& caption : captions) {
    if (fitting_block(canvas, sizes_of(width, height), caption).fits) continue;
    throw ScenarioError(
        caption.place + "the text of this caption does not fit into a picture of " + std::to_string(width) + "x" +
        std::to_string(height) +
        ", not even in its smallest letters: shorten it, or make captions of it that follow each other");
  }
}

void draw_captions(const Stage& stage, Cards& cards) {
  for (const CaptionView& caption : stage.frame.captions) {
    stage.own(OwnerKind::caption, caption.text);
    draw_caption(stage, cards, caption);
  }
}

}  // namespace proofreel
