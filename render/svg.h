#pragma once

/// Pictures as SVG, for print: the same marks that a canvas draws in pixels, as shapes that stay sharp at any size.
/// Letters are outlines, so that the picture needs no font where it is shown.

#include <span>
#include <string>
#include <string_view>

#include "engine/vec2.h"
#include "render/canvas.h"
#include "render/font.h"

namespace proofreel {

/// Writes marks one after the other; what is written later lies on top. Coordinates as in Canvas.
class SvgWriter {
 public:
  SvgWriter(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}

  void clear(Color background);
  void disc(Vec2d center, double radius, const Paint& paint);
  void polygon(std::span<const Vec2d> corners, double radius, const Paint& paint);
  void capsule(Vec2d a, Vec2d b, double radius, const Paint& paint);
  void stroke(std::span<const Vec2d> points, double width, Color from, Color to);
  void rectangle(Vec2d low, Vec2d high, double radius, const Paint& paint);
  /// `left` is where the baseline begins.
  void text(const Font& font, std::string_view utf8, Vec2d left, int size_px, Color color);
  /// Marks from here on are cut at this area's edges and counted from its corner, until `leave`.
  void enter(const PixelRect& area);
  void leave();

  /// The whole document.
  std::string document() const;

 private:
  std::string new_clip(const std::string& shape);

  int width_px_;
  int height_px_;
  std::string body_;
  int clips_ = 0;
  bool inside_area_ = false;
};

}  // namespace proofreel
