#include <algorithm>

#include "render/draw_layers.h"
#include "render/typeset.h"

namespace proofreel {
namespace {

struct Block {
  std::vector<TypesetLine> lines;
  int size_px = 0;
  double width = 0;
};

Block block_of(const Stage& stage, const CaptionView& caption, int size_px) {
  constexpr double padding = 1.4;  // em, left and right
  const double widest = stage.safe_area().upper.x - stage.safe_area().lower.x - padding * size_px;
  Block block{typeset(stage.canvas, caption.text, size_px, widest), size_px, 0};
  for (const TypesetLine& line : block.lines) block.width = std::max(block.width, line.width);
  block.width += padding * size_px;
  return block;
}

/// A line at the top is a heading.
Block fitting_block(const Stage& stage, const CaptionView& caption) {
  if (caption.at == Corner::top) {
    Block heading = block_of(stage, caption, stage.sizes.title);
    if (heading.lines.size() == 1) return heading;
  }
  return block_of(stage, caption, stage.sizes.text);
}

Align align_of(Corner at) {
  if (at == Corner::top_left || at == Corner::bottom_left) return Align::left;
  return at == Corner::top_right || at == Corner::bottom_right ? Align::right : Align::center;
}

void draw_caption(const Stage& stage, Cards& cards, const CaptionView& caption) {
  const Block block = fitting_block(stage, caption);
  if (block.lines.empty()) return;
  const double size = block.size_px;
  const double padding = 0.7 * size;
  const double height = height_of(block.lines, block.size_px);
  const Aabbd card = cards.place({block.width, height + 1.1 * size}, caption.at);
  stage.canvas.rectangle(card.lower, card.upper, 0.3 * size, {stage.palette.plate, stage.palette.plate_edge, 1});
  const Align align = align_of(caption.at);
  const double x = align == Align::left    ? card.lower.x + padding
                   : align == Align::right ? card.upper.x - padding
                                           : 0.5 * (card.lower.x + card.upper.x);
  draw_lines(stage.canvas, block.lines, block.size_px, {x, card.lower.y + 0.55 * size}, align, stage.palette.ink);
}

}  // namespace

void draw_captions(const Stage& stage, Cards& cards) {
  for (const CaptionView& caption : stage.frame.captions) {
    stage.own(OwnerKind::caption, caption.text);
    draw_caption(stage, cards, caption);
  }
}

}  // namespace proofreel
