#include "render/canvas.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <memory>
#include <string>

#include "engine/state_hash.h"
#include "render/canvas_geometry.h"
#include "render/canvas_gpu.h"
#include "render/svg.h"

namespace proofreel {
namespace {

/// Larger coordinates lose more than a thousandth of a pixel in float32.
constexpr double float_limit_px = 16000;
/// Discs beyond this are drawn as polygons.
constexpr double radius_limit_px = 1e6;
/// How far a pixel's centre may lie outside a shape that still colours it, rounded up.
constexpr double soft_edge_px = 1;

/// Fill, outline and how wide it is, as the shaders take them.
struct Ink {
  Color fill;
  Color outline;
  double outline_px = 0;
  double strength = 1;  ///< 0..1: shapes thinner than a pixel are drawn a pixel wide and paler
};

Ink ink_of(const Paint& paint) {
  if (paint.outline_px <= 0) return {paint.fill, paint.fill, 0, 1};
  return {paint.fill, paint.outline, paint.outline_px, 1};
}

bool invisible(const Ink& ink) { return ink.fill.a == 0 && (ink.outline_px <= 0 || ink.outline.a == 0); }

void put_premultiplied(float* at, Color color, double strength) {
  const double alpha = color.a / 255.0 * strength;
  at[0] = static_cast<float>(color.r / 255.0 * alpha);
  at[1] = static_cast<float>(color.g / 255.0 * alpha);
  at[2] = static_cast<float>(color.b / 255.0 * alpha);
  at[3] = static_cast<float>(alpha);
}

/// The bytes of a number in the place of red, green and blue.
void put_number(float* at, std::uint32_t number, double alpha) {
  for (unsigned i = 0; i < 3; ++i) at[i] = static_cast<float>((number >> (8 * i)) & 255U) / 255.0F;
  at[3] = static_cast<float>(alpha);
}

void put(float* at, Vec2d v) {
  at[0] = static_cast<float>(v.x);
  at[1] = static_cast<float>(v.y);
}

template <std::size_t vectors>
using Instance = std::array<float, 4 * vectors>;

Quad grown(Quad quad, double by) {
  quad.half_x += by;
  quad.half_y += by;
  return quad;
}

Aabbd common_part(const Aabbd& a, const Aabbd& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)}};
}

bool within_float(const Quad& quad) {
  return std::max({std::abs(quad.center.x), std::abs(quad.center.y), quad.half_x, quad.half_y}) < float_limit_px;
}

/// How far past its end a stroke's segment may colour pixels, px: at a joint only up to the line that halves the turn,
/// whose normal is `joint` (zero at an end of the stroke).
double reach_beyond(Vec2d joint, Vec2d along, double radius) {
  constexpr double spare_px = 0.25;
  const double widest = radius + soft_edge_px;
  if (joint == Vec2d{}) return widest;
  return std::min(widest, widest * std::abs(cross(joint, along)) / dot(joint, along) + spare_px);
}

bool all_finite(std::span<const Vec2d> points) {
  return std::all_of(points.begin(), points.end(), [](Vec2d p) { return is_finite(p); });
}

}  // namespace

struct Canvas::Impl {
  std::unique_ptr<CanvasGpu> gpu;  ///< without it, marks are written down
  int width_px;
  int height_px;
  SvgWriter writer;
  Font font;
  FontAtlas atlas;
  BatchList batches;
  Color background{0, 0, 0, 255};
  const Image* behind = nullptr;  ///< in place of the colour
  DrawMode mode = DrawMode::colors;
  std::uint32_t owner = 0;

  PixelRect area;
  Vec2d origin;  ///< of the area: what is asked for counts from it

  /// Draws through the context, or without one writes down.
  Impl(GlContext* context, int width, int height)
      : gpu(context != nullptr ? std::make_unique<CanvasGpu>(*context, width, height) : nullptr),
        width_px(width),
        height_px(height),
        writer(width, height),
        batches(width, height),
        area(whole()) {}

  /// Where marks are written down; null where they are drawn.
  SvgWriter* svg() { return gpu ? nullptr : &writer; }

  /// Where points of the area lie in the picture.
  std::vector<Vec2d> placed(std::span<const Vec2d> points) const {
    std::vector<Vec2d> places(points.begin(), points.end());
    for (Vec2d& place : places) place += origin;
    return places;
  }

  /// Ends what was asked for; what follows lies on `color`.
  void begin(Color color, DrawMode new_mode) {
    const std::array<unsigned char, 5> ground{color.r, color.g, color.b, color.a, static_cast<unsigned char>(new_mode)};
    batches.clear(hash_of(ground.data(), ground.size()));
    background = color;
    behind = nullptr;
    mode = new_mode;
    owner = 0;
  }

  PixelRect whole() const { return {0, 0, width_px, height_px}; }

  void enter(const PixelRect& part) {
    area = part;
    origin = {static_cast<double>(part.x_px), static_cast<double>(part.y_px)};
  }

  /// What can be seen, with the pixels a soft edge reaches over.
  Aabbd picture(double margin) const {
    const Vec2d size{static_cast<double>(area.width_px), static_cast<double>(area.height_px)};
    return expanded(Aabbd{origin, origin + size}, margin);
  }

  bool is_whole() const { return area.width_px == width_px && area.height_px == height_px; }

  /// What to rasterise for a shape inside `quad`: the quad, or what of its bounds is in the picture when that is less.
  /// False when nothing of it can be seen.
  bool visible_part(const Quad& quad, Quad& part) const {
    const Aabbd bounds = bounds_of(quad);
    const bool whole_picture = is_whole();  // whose edges OpenGL keeps by itself
    const Aabbd frame = picture(whole_picture ? soft_edge_px : 0);
    if (!overlaps(bounds, frame)) return false;
    const bool inside = whole_picture || contains(frame, bounds);
    part = quad_of(common_part(bounds, frame));
    if (inside && within_float(quad) && proofreel::area(quad) < proofreel::area(part)) part = quad;
    return true;
  }

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
  void add_capsule(Vec2d a, Vec2d b, double radius, Ink ink);
  void add_stroke_segment(Vec2d a, Vec2d b, Vec2d joint_a, Vec2d joint_b, double width, Color from, Color to);
  void add_glyph(const AtlasGlyph& glyph, int x_px, int y_px, Color color);
};

void Canvas::Impl::put_color(float* at, Color color, double strength) const {
  if (mode == DrawMode::owners) return put_number(at, owner, color.a / 255.0 * strength);
  put_premultiplied(at, color, strength);
}

/// The four vectors all kinds begin with.
void Canvas::Impl::put_common(float* at, const Quad& quad, double radius, const Ink& ink) const {
  put(at, quad.center);
  put(at + 2, quad.axis);
  at[4] = static_cast<float>(quad.half_x);
  at[5] = static_cast<float>(quad.half_y);
  at[6] = ink.outline_px > 0 ? static_cast<float>(ink.outline_px) : -1e9F;
  at[7] = static_cast<float>(radius);
  put_color(at + 8, ink.fill, ink.strength);
  put_color(at + 12, ink.outline, ink.strength);
}

void Canvas::Impl::add_box(const Quad& box, double radius, const Ink& ink) {
  Quad part;
  if (invisible(ink) || !visible_part(grown(box, radius + soft_edge_px), part)) return;
  add_box_part(box, radius, ink, part);
}

void Canvas::Impl::add_box_part(const Quad& box, double radius, const Ink& ink, const Quad& part) {
  Instance<6> values{};
  put_common(values.data(), part, radius, ink);
  put(&values[16], box.center);
  put(&values[18], box.axis);
  values[20] = static_cast<float>(box.half_x);
  values[21] = static_cast<float>(box.half_y);
  batches.add(ShapeKind::box, values, part);
}

/// An outline alone, as four strips at whole pixels: what a large empty box encloses costs nothing.
void Canvas::Impl::add_frame(const Aabbd& box, const Ink& ink) {
  const Aabbd outer{{std::floor(box.lower.x) - 1, std::floor(box.lower.y) - 1},
                    {std::ceil(box.upper.x) + 1, std::ceil(box.upper.y) + 1}};
  const double depth = ink.outline_px + soft_edge_px;
  const Aabbd inner{{std::ceil(box.lower.x + depth), std::ceil(box.lower.y + depth)},
                    {std::floor(box.upper.x - depth), std::floor(box.upper.y - depth)}};
  if (inner.lower.x >= inner.upper.x || inner.lower.y >= inner.upper.y) return add_box(quad_of(box), 0, ink);
  const std::array<Aabbd, 4> strips{Aabbd{outer.lower, {outer.upper.x, inner.lower.y}},
                                    {{outer.lower.x, inner.upper.y}, outer.upper},
                                    {{outer.lower.x, inner.lower.y}, {inner.lower.x, inner.upper.y}},
                                    {{inner.upper.x, inner.lower.y}, {outer.upper.x, inner.upper.y}}};
  for (const Aabbd& strip : strips) {
    Quad part;
    if (visible_part(quad_of(strip), part)) add_box_part(quad_of(box), 0, ink, part);
  }
}

void Canvas::Impl::add_edges(const std::vector<Vec2d>& corners, const Ink& ink) {
  if (invisible(ink)) return;
  const std::vector<Vec2d> seen = clipped(corners, picture(soft_edge_px));
  if (seen.empty()) return;
  Quad part;
  if (!visible_part(grown(smallest_quad(seen), soft_edge_px), part)) return;
  if (corners.size() <= 8) {
    add_half_planes<8>(ShapeKind::edges8, corners, part, ink);
  } else {
    add_half_planes<16>(ShapeKind::edges16, corners, part, ink);
  }
}

/// Half-planes relative to the middle of what is seen: an edge may be as far away as it likes without costing
/// precision where pixels are.
template <std::size_t edges>
void Canvas::Impl::add_half_planes(ShapeKind kind, const std::vector<Vec2d>& corners, const Quad& part,
                                   const Ink& ink) {
  Instance<4 + edges * 3 / 4> values{};
  put_common(values.data(), part, 0, ink);
  Vec2d normal;
  double offset = 0;
  for (std::size_t i = 0; i < edges; ++i) {  // spare places repeat the last edge
    if (i < corners.size()) {
      const Vec2d a = corners[i];
      const Vec2d along = normalized(corners[(i + 1) % corners.size()] - a);
      if (along == Vec2d{}) continue;
      normal = -perp(along);
      offset = dot(normal, a - part.center);
    }
    put(&values[16 + 2 * i], normal);
    values[16 + 2 * edges + i] = static_cast<float>(offset);
  }
  batches.add(kind, values, part);
}

void Canvas::Impl::add_rounded(const std::vector<Vec2d>& corners, double radius, const Ink& ink) {
  const std::vector<Vec2d> seen = clipped(corners, picture(radius + ink.outline_px + 2 * soft_edge_px));
  Quad part;
  if (invisible(ink) || seen.empty()) return;
  if (!visible_part(grown(smallest_quad(seen), radius + soft_edge_px), part)) return;
  if (seen.size() <= 8) {
    add_corners<8>(ShapeKind::rounded8, seen, part, radius, ink);
  } else {
    add_corners<20>(ShapeKind::rounded20, seen, part, radius, ink);
  }
}

template <std::size_t places>
void Canvas::Impl::add_corners(ShapeKind kind, const std::vector<Vec2d>& corners, const Quad& part, double radius,
                               const Ink& ink) {
  Instance<4 + places / 2> values{};
  put_common(values.data(), part, radius, ink);
  const std::size_t last = corners.size() - 1;
  for (std::size_t i = 0; i < places; ++i) {  // spare corners divide the last edge
    const std::size_t past = i - std::min(i, last);
    const double way = static_cast<double>(past) / static_cast<double>(places - last);
    put(&values[16 + 2 * i], lerp(corners[std::min(i, last)], corners[0], way) - part.center);
  }
  batches.add(kind, values, part);
}

void Canvas::Impl::add_capsule(Vec2d a, Vec2d b, double radius, Ink ink) {
  if (radius < 0.5) {
    ink.strength *= 2 * radius;
    radius = 0.5;
  }
  if (!clip_segment(a, b, picture(radius + ink.outline_px + 2 * soft_edge_px))) return;
  const double reach = distance(a, b);
  add_box({0.5 * (a + b), reach > 0 ? normalized(b - a) : Vec2d{1, 0}, 0.5 * reach, 0}, radius, ink);
}

void Canvas::Impl::add_stroke_segment(Vec2d a, Vec2d b, Vec2d joint_a, Vec2d joint_b, double width, Color from,
                                      Color to) {
  const double radius = 0.5 * std::max(width, 1.0);
  const Vec2d whole_a = a;
  const Vec2d whole_b = b;
  if (!clip_segment(a, b, picture(float_limit_px))) return;
  if (a != whole_a) joint_a = {};
  if (b != whole_b) joint_b = {};
  const double reach = distance(a, b);
  if (reach == 0) return;
  const Vec2d along = normalized(b - a);
  const Vec2d first = a - reach_beyond(joint_a, along, radius) * along;
  const Vec2d last = b + reach_beyond(joint_b, along, radius) * along;
  const Quad share{0.5 * (first + last), along, 0.5 * distance(first, last), radius + soft_edge_px};
  Quad part;
  if (!visible_part(share, part)) return;
  Instance<6> values{};
  put_common(values.data(), part, radius, {from, to, 0, std::min(width, 1.0)});
  values[6] = joint_b == Vec2d{} ? 1.0F : 0.0F;
  put(&values[16], a);
  put(&values[18], b);
  put(&values[20], joint_a);
  put(&values[22], joint_b);
  batches.add(ShapeKind::stroke, values, part);
}

void Canvas::Impl::add_glyph(const AtlasGlyph& glyph, int x_px, int y_px, Color color) {
  if (glyph.width_px == 0) return;
  const Vec2d low{static_cast<double>(x_px + glyph.left_px), static_cast<double>(y_px + glyph.top_px)};
  const Aabbd box{low, low + Vec2d{static_cast<double>(glyph.width_px), static_cast<double>(glyph.height_px)}};
  const Aabbd frame = picture(0);
  if (!overlaps(box, frame)) return;
  const Aabbd seen = is_whole() ? box : common_part(box, frame);
  Instance<4> values{};
  put_common(values.data(), quad_of(seen), 0, {color, color, 0, 1});
  put(&values[12], Vec2d{static_cast<double>(glyph.x_px), static_cast<double>(glyph.y_px)} - low);
  batches.add(ShapeKind::glyph, values, quad_of(seen));
}

Canvas::Canvas(GlContext& context, int width_px, int height_px)
    : impl_(std::make_unique<Impl>(&context, width_px, height_px)) {}

Canvas::Canvas(int width_px, int height_px) : impl_(std::make_unique<Impl>(nullptr, width_px, height_px)) {}

Canvas::~Canvas() = default;

int Canvas::width_px() const { return impl_->area.width_px; }

int Canvas::height_px() const { return impl_->area.height_px; }

void Canvas::enter(const PixelRect& area) {
  impl_->enter(area);
  if (SvgWriter* svg = impl_->svg()) svg->enter(area);
}

void Canvas::leave() {
  impl_->enter(impl_->whole());
  if (SvgWriter* svg = impl_->svg()) svg->leave();
}

void Canvas::clear(Color background) {
  leave();
  impl_->begin(background, DrawMode::colors);
  if (SvgWriter* svg = impl_->svg()) svg->clear(background);
}

void Canvas::clear(const Image& background) {
  assert(background.width_px == width_px() && background.height_px == height_px());
  clear(Color{0, 0, 0, 255});
  impl_->behind = &background;
}

void Canvas::clear_for_owners() {
  leave();
  impl_->begin({0, 0, 0, 255}, DrawMode::owners);
}

void Canvas::own(std::uint32_t owner) { impl_->owner = owner; }

void Canvas::disc(Vec2d center, double radius, const Paint& paint) {
  Ink ink = ink_of(paint);
  if (!is_finite(center) || !(radius > 0)) return;
  if (SvgWriter* svg = impl_->svg()) return svg->disc(center, radius, paint);
  center += impl_->origin;
  if (radius > radius_limit_px) return impl_->add_edges(disc_near(center, radius, impl_->picture(0)), ink);
  if (radius < 0.5) {
    ink.strength = 4 * radius * radius;
    radius = 0.5;
  }
  impl_->add_box({center, {1, 0}, 0, 0}, radius, ink);
}

void Canvas::polygon(std::span<const Vec2d> corners, double radius, const Paint& paint) {
  if (corners.size() < 3 || corners.size() > 16 || !all_finite(corners) || !(radius >= 0)) return;
  if (doubled_area(corners) == 0) return;
  if (SvgWriter* svg = impl_->svg()) return svg->polygon(corners, radius, paint);
  const std::vector<Vec2d> places = impl_->placed(corners);
  Quad box;
  if (is_rectangle(places, box) && within_float(box)) return impl_->add_box(box, radius, ink_of(paint));
  if (radius > 0) return impl_->add_rounded(oriented(places), radius, ink_of(paint));
  impl_->add_edges(oriented(places), ink_of(paint));
}

void Canvas::capsule(Vec2d a, Vec2d b, double radius, const Paint& paint) {
  if (!is_finite(a) || !is_finite(b) || !(radius > 0)) return;
  if (SvgWriter* svg = impl_->svg()) return svg->capsule(a, b, radius, paint);
  impl_->add_capsule(a + impl_->origin, b + impl_->origin, radius, ink_of(paint));
}

void Canvas::line(Vec2d a, Vec2d b, double width, Color color) { capsule(a, b, 0.5 * width, {color, color, 0}); }

void Canvas::stroke(std::span<const Vec2d> line, double width, Color from, Color to) {
  if (line.size() < 2 || !all_finite(line) || !(width > 0)) return;
  if (SvgWriter* svg = impl_->svg()) return svg->stroke(line, width, from, to);
  const std::vector<Vec2d> points = impl_->placed(line);
  double total = 0;
  for (std::size_t i = 1; i < points.size(); ++i) total += distance(points[i - 1], points[i]);
  double gone = 0;
  Vec2d joint;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2d a = points[i - 1];
    const Vec2d b = points[i];
    const Vec2d along = normalized(b - a);
    if (along == Vec2d{}) continue;
    const Vec2d ahead = i + 1 < points.size() ? normalized(points[i + 1] - b) : Vec2d{};
    // At a turn of more than a right angle the two overlap, like two strokes.
    const Vec2d next = dot(along, ahead) > 0 ? along + ahead : Vec2d{};
    const double reached = gone + distance(a, b);
    impl_->add_stroke_segment(a, b, joint, next, width, mixed(from, to, gone / total),
                              mixed(from, to, reached / total));
    joint = next;
    gone = reached;
  }
}

void Canvas::arrow(Vec2d from, Vec2d to, double width, Color color) {
  const double reach = distance(from, to);
  if (!is_finite(from) || !is_finite(to) || !(reach > 0) || !(width > 0)) return;
  const Vec2d along = normalized(to - from);
  const double head = std::min(4.5 * width, 0.6 * reach);
  const Vec2d neck = to - head * along;
  const Vec2d side = 0.42 * head * perp(along);
  const Vec2d half = 0.5 * std::min(width, 0.5 * head) * perp(along);
  const Vec2d inside = neck + 0.3 * head * along;  // under the head, so that no seam shows
  polygon(std::array<Vec2d, 4>{from + half, from - half, inside - half, inside + half}, 0, {color, color, 0});
  polygon(std::array<Vec2d, 3>{to, neck + side, neck - side}, 0, {color, color, 0});
}

void Canvas::rectangle(Vec2d low, Vec2d high, double radius, const Paint& paint) {
  const double most = 0.5 * std::min(high.x - low.x, high.y - low.y);
  if (!is_finite(low) || !is_finite(high) || !(most > 0)) return;
  const double rounding = std::clamp(radius, 0.0, most);
  if (SvgWriter* svg = impl_->svg()) return svg->rectangle(low, high, rounding, paint);
  low += impl_->origin;
  high += impl_->origin;
  const Aabbd seen{{std::max(low.x, -float_limit_px), std::max(low.y, -float_limit_px)},
                   {std::min(high.x, float_limit_px), std::min(high.y, float_limit_px)}};
  const Ink ink = ink_of(paint);
  if (ink.fill.a == 0 && rounding == 0 && !invisible(ink)) return impl_->add_frame(seen, ink);
  impl_->add_box(grown(quad_of(seen), -rounding), rounding, ink);
}

void Canvas::text(std::string_view utf8, Vec2d baseline, int size_px, Align align, Color color) {
  const TextLine line = impl_->font.layout(utf8, size_px);
  const double width = static_cast<double>(line.width) / pen_per_pixel;
  const double shift = align == Align::left ? 0 : align == Align::center ? 0.5 * width : width;
  if (SvgWriter* svg = impl_->svg())
    return svg->text(impl_->font, utf8, {baseline.x - shift, baseline.y}, size_px, color);
  baseline += impl_->origin;
  const auto left = static_cast<Pen>(std::floor(baseline.x - shift + 0.5)) * pen_per_pixel;
  const int y_px = static_cast<int>(std::floor(baseline.y + 0.5));
  for (const PlacedGlyph& placed : line.glyphs) {
    const Pen steps = (left + placed.x) * glyph_phases / pen_per_pixel;
    const auto phase = static_cast<int>(((steps % glyph_phases) + glyph_phases) % glyph_phases);
    const auto x_px = static_cast<int>((steps - phase) / glyph_phases);
    impl_->add_glyph(impl_->atlas.glyph(impl_->font, placed.glyph, size_px, phase), x_px, y_px, color);
  }
}

double Canvas::text_width(std::string_view utf8, int size_px) {
  return static_cast<double>(impl_->font.layout(utf8, size_px).width) / pen_per_pixel;
}

void Canvas::finish(Image& image) {
  impl_->gpu->draw({impl_->mode, impl_->background, impl_->behind, impl_->batches}, impl_->atlas, image);
}

std::string Canvas::svg() const { return impl_->writer.document(); }

}  // namespace proofreel
