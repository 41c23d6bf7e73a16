#pragma once

/// Draws flat, anti-aliased shapes in pixels, and gives the same bytes on every thread count, vector width and
/// instruction set of one Mesa version. Coordinates: pixels from the top left corner, y down; a pixel's centre is at +
/// 0.5.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/vec2.h"
#include "render/color.h"
#include "render/context.h"
#include "render/image.h"

namespace proofreel {

/// How a closed shape is painted: the outline lies inside the shape's edge, `outline_px` wide (0: none).
struct Paint {
  Color fill;
  Color outline;
  double outline_px = 0;
};

enum class Align : std::uint8_t { left, center, right };

/// What is drawn later lies on top. Nothing reaches the image before `finish`.
class Canvas {
 public:
  /// Draws through `context`, which must outlive the canvas and be used from one thread at a time.
  /// Throws EnvironmentError when the size or the context does not work.
  Canvas(GlContext& context, int width_px, int height_px);
  /// Draws no pixels but an SVG document, for which it needs no OpenGL: see `svg`.
  Canvas(int width_px, int height_px);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Of the picture, or of the area that was entered.
  int width_px() const;
  int height_px() const;

  /// From now on only this part of the picture is drawn on, as if it were all: coordinates count from its top left
  /// corner. Areas do not nest; `clear` and `leave` end them.
  void enter(const PixelRect& area);
  void leave();

  void clear(Color background);
  /// Begins with a picture of the canvas' size, which is looked at by `finish`, and must live until then: what is drawn
  /// lies on it as if all of it had been drawn in one go.
  void clear(const Image& background);
  /// Starts a picture of owners instead: every pixel that a mark colours, however faintly, becomes the number of the
  /// mark's owner (red is the lowest byte), that of the topmost; the rest 0. Without smoothing or blending.
  void clear_for_owners();
  /// The owner of what is asked for from now on, 0 to 2^24 - 1; matters to a picture of owners only.
  void own(std::uint32_t owner);
  void disc(Vec2d center, double radius, const Paint& paint);
  /// The convex hull of `corners` (3 to max_polygon_vertices, either orientation) rounded outward by `radius`.
  void polygon(std::span<const Vec2d> corners, double radius, const Paint& paint);
  /// All points within `radius` of the segment.
  void capsule(Vec2d a, Vec2d b, double radius, const Paint& paint);
  /// A stroke with round ends.
  void line(Vec2d a, Vec2d b, double width, Color color);
  /// A polyline with round ends and joints, fading from one colour to the other along its length. Translucent strokes
  /// have no beads at their joints.
  void stroke(std::span<const Vec2d> points, double width, Color from, Color to);
  /// A shaft and a filled head that ends exactly in `to`; a short arrow shrinks its head, never its length.
  void arrow(Vec2d from, Vec2d to, double width, Color color);
  /// Axis-aligned, with corners rounded by `radius`.
  void rectangle(Vec2d low, Vec2d high, double radius, const Paint& paint);
  /// UTF-8 on a baseline at whole pixels; what the font lacks is drawn as a box. `size_px` is the height of the em.
  void text(std::string_view utf8, Vec2d baseline, int size_px, Align align, Color color);
  /// How wide `text` would be, in pixels.
  double text_width(std::string_view utf8, int size_px);

  /// Draws all that was asked for since `clear` and reads it into `image`, resized to fit.
  void finish(Image& image);
  /// Of a canvas without OpenGL: all that was asked for since `clear`, as a document.
  std::string svg() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
