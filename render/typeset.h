#pragma once

/// Sets text with formulas (scenarios/formula.h) in lines: sub- and superscripts, fractions, vectors.

#include <string>
#include <string_view>
#include <vector>

#include "render/canvas.h"

namespace proofreel {

/// Text or strokes at a place of a line; the origin is where the line begins on its baseline, y down, pixels.
struct TypesetText {
  std::string text;
  Vec2d at;
  int size_px = 0;
};
struct TypesetStroke {
  Vec2d from;
  Vec2d to;
  double width = 1;
  bool arrow = false;
};

struct TypesetLine {
  std::vector<TypesetText> texts;
  std::vector<TypesetStroke> strokes;
  double width = 0;
  double ascent = 0;   ///< above the baseline; of capital letters at least
  double descent = 0;  ///< below it; of nothing but letters: 0
};

/// Breaks where words end and a line would become wider than `width`; formulas that are wider than that break at their
/// spaces. A text that cannot be read as formulas is set as it is.
std::vector<TypesetLine> typeset(Canvas& canvas, std::string_view text, int size_px, double width);

/// The same in as few lines as that takes, all about equally long: no word stands alone.
std::vector<TypesetLine> balanced(Canvas& canvas, std::string_view text, int size_px, double width);

/// One line, however wide.
TypesetLine typeset_line(Canvas& canvas, std::string_view text, int size_px);

/// From the top of the first line to the bottom of the last.
double height_of(const std::vector<TypesetLine>& lines, int size_px);

void draw_line(Canvas& canvas, const TypesetLine& line, Vec2d start, Color color);

/// All lines below each other from `top` on, aligned at `x`.
void draw_lines(Canvas& canvas, const std::vector<TypesetLine>& lines, int size_px, Vec2d top, Align align,
                Color color);

}  // namespace proofreel
