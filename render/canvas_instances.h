#pragma once

/// Marks in pixels as instances for the GPU: which program draws a mark, what it is told, and which part of the picture
/// it may change. What float32 cannot hold is cut off before it is handed over: shapes may be as large and as far away
/// as they like.

#include <cstdint>
#include <span>
#include <vector>

#include "render/canvas.h"
#include "render/canvas_batches.h"
#include "render/font_atlas.h"

namespace proofreel {

struct Ink;  // fill and outline as the shaders take them

/// Writes marks one after the other, as SvgWriter does; coordinates and marks are those of Canvas, which refuses what
/// is not finite or has no extent.
class InstanceWriter {
 public:
  InstanceWriter(int width_px, int height_px);

  /// Forgets all marks; what follows lies on `ground`, outside all areas, and is nobody's (owner 0).
  void begin(Color ground, DrawMode mode);
  /// Marks from here on are cut at this area's edges and counted from its corner, until `leave`.
  void enter(const PixelRect& area);
  void leave();
  /// The owner of marks from here on; see Canvas.
  void own(std::uint32_t owner) { owner_ = owner; }

  void disc(Vec2d center, double radius, const Paint& paint);
  /// Corners as of Canvas, in either orientation.
  void polygon(std::span<const Vec2d> corners, double radius, const Paint& paint);
  void capsule(Vec2d a, Vec2d b, double radius, const Paint& paint);
  void stroke(std::span<const Vec2d> points, double width, Color from, Color to);
  void rectangle(Vec2d low, Vec2d high, double radius, const Paint& paint);
  /// `left` is where the baseline begins; letters stand on whole pixels.
  void text(const Font& font, const TextLine& line, Vec2d left, int size_px, Color color);

  const BatchList& marks() const { return batches_; }
  /// The letters that the marks show.
  FontAtlas& atlas() { return atlas_; }

 private:
  struct StrokePart;

  PixelRect whole() const { return {0, 0, width_px_, height_px_}; }
  bool is_whole() const { return area_.width_px == width_px_ && area_.height_px == height_px_; }
  std::vector<Vec2d> placed(std::span<const Vec2d> points) const;
  Aabbd picture(double margin) const;
  bool visible_part(const Quad& quad, Quad& part) const;

  void put_color(float* at, Color color, double strength) const;
  void put_common(float* at, const Quad& quad, double radius, const Ink& ink) const;
  void add_box(const Quad& box, double radius, const Ink& ink);
  void add_box_part(const Quad& box, double radius, const Ink& ink, const Quad& part);
  void add_frame(const Aabbd& box, const Ink& ink);
  void add_edges(const std::vector<Vec2d>& corners, const Ink& ink);
  template <std::size_t edges>
  void add_half_planes(ShapeKind kind, const std::vector<Vec2d>& corners, const Quad& part, const Ink& ink);
  template <std::size_t places>
  void add_corners(ShapeKind kind, const std::vector<Vec2d>& corners, const Quad& part, double radius, const Ink& ink);
  void add_rounded(const std::vector<Vec2d>& corners, double radius, const Ink& ink);
  void add_stroke_part(StrokePart stroke, double width);
  void add_glyph(const AtlasGlyph& glyph, int x_px, int y_px, Color color);

  int width_px_;
  int height_px_;
  FontAtlas atlas_;
  BatchList batches_;
  DrawMode mode_ = DrawMode::colors;
  std::uint32_t owner_ = 0;
  PixelRect area_;
  Vec2d origin_;  // of the area
};

}  // namespace proofreel
