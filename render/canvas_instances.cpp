#include "render/canvas_instances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/state_hash.h"
#include "render/canvas_geometry.h"

namespace proofreel {

/// `strength` is 0..1: shapes thinner than a pixel are drawn a pixel wide and paler.
struct Ink {
  Color fill;
  Color outline;
  double outline_px = 0;
  double strength = 1;
};

namespace {

/// Larger coordinates lose more than a thousandth of a pixel in float32.
constexpr double float_limit_px = 16000;
/// Discs beyond this are drawn as polygons.
constexpr double radius_limit_px = 1e6;
/// How far a pixel's centre may lie outside a shape that still colours it, rounded up.
constexpr double soft_edge_px = 1;

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

}  // namespace

struct InstanceWriter::StrokePart {
  Vec2d a;
  Vec2d b;
  Vec2d joint_a;  ///< normal of the line that halves the turn there; zero at an end of the stroke
  Vec2d joint_b;
  Color from;
  Color to;
};

InstanceWriter::InstanceWriter(int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px), batches_(width_px, height_px), area_(whole()) {}

void InstanceWriter::begin(Color ground, DrawMode mode) {
  const std::array<unsigned char, 5> bytes{ground.r, ground.g, ground.b, ground.a, static_cast<unsigned char>(mode)};
  leave();
  batches_.clear(hash_of(bytes.data(), bytes.size()));
  mode_ = mode;
  owner_ = 0;
}

void InstanceWriter::enter(const PixelRect& area) {
  area_ = area;
  origin_ = {static_cast<double>(area.x_px), static_cast<double>(area.y_px)};
}

void InstanceWriter::leave() { enter(whole()); }

void InstanceWriter::disc(Vec2d center, double radius, const Paint& paint) {
  Ink ink = ink_of(paint);
  center += origin_;
  if (radius > radius_limit_px) return add_edges(disc_near(center, radius, picture(0)), ink);
  if (radius < 0.5) {
    ink.strength = 4 * radius * radius;
    radius = 0.5;
  }
  add_box({center, {1, 0}, 0, 0}, radius, ink);
}

void InstanceWriter::polygon(std::span<const Vec2d> corners, double radius, const Paint& paint) {
  const std::vector<Vec2d> places = placed(corners);
  Quad box;
  if (is_rectangle(places, box) && within_float(box)) return add_box(box, radius, ink_of(paint));
  if (radius > 0) return add_rounded(oriented(places), radius, ink_of(paint));
  add_edges(oriented(places), ink_of(paint));
}

void InstanceWriter::capsule(Vec2d a, Vec2d b, double radius, const Paint& paint) {
  Ink ink = ink_of(paint);
  a += origin_;
  b += origin_;
  if (radius < 0.5) {
    ink.strength *= 2 * radius;
    radius = 0.5;
  }
  if (!clip_segment(a, b, picture(radius + ink.outline_px + 2 * soft_edge_px))) return;
  const double reach = distance(a, b);
  add_box({0.5 * (a + b), reach > 0 ? normalized(b - a) : Vec2d{1, 0}, 0.5 * reach, 0}, radius, ink);
}

void InstanceWriter::stroke(std::span<const Vec2d> line, double width, Color from, Color to) {
  const std::vector<Vec2d> points = placed(line);
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
    add_stroke_part({a, b, joint, next, mixed(from, to, gone / total), mixed(from, to, reached / total)}, width);
    joint = next;
    gone = reached;
  }
}

void InstanceWriter::rectangle(Vec2d low, Vec2d high, double radius, const Paint& paint) {
  low += origin_;
  high += origin_;
  const Aabbd seen{{std::max(low.x, -float_limit_px), std::max(low.y, -float_limit_px)},
                   {std::min(high.x, float_limit_px), std::min(high.y, float_limit_px)}};
  const Ink ink = ink_of(paint);
  if (ink.fill.a == 0 && radius == 0 && !invisible(ink)) return add_frame(seen, ink);
  add_box(grown(quad_of(seen), -radius), radius, ink);
}

void InstanceWriter::text(const Font& font, const TextLine& line, Vec2d left, int size_px, Color color) {
  left += origin_;
  const auto start = static_cast<Pen>(std::floor(left.x + 0.5)) * pen_per_pixel;
  const int y_px = static_cast<int>(std::floor(left.y + 0.5));
  for (const PlacedGlyph& placed : line.glyphs) {
    const Pen steps = (start + placed.x) * glyph_phases / pen_per_pixel;
    const auto phase = static_cast<int>(((steps % glyph_phases) + glyph_phases) % glyph_phases);
    const auto x_px = static_cast<int>((steps - phase) / glyph_phases);
    add_glyph(atlas_.glyph(font, placed.glyph, size_px, phase), x_px, y_px, color);
  }
}

/// Where points of the area lie in the picture.
std::vector<Vec2d> InstanceWriter::placed(std::span<const Vec2d> points) const {
  std::vector<Vec2d> places(points.begin(), points.end());
  for (Vec2d& place : places) place += origin_;
  return places;
}

/// What can be seen, with the pixels a soft edge reaches over.
Aabbd InstanceWriter::picture(double margin) const {
  const Vec2d size{static_cast<double>(area_.width_px), static_cast<double>(area_.height_px)};
  return expanded(Aabbd{origin_, origin_ + size}, margin);
}

/// What to rasterise for a shape inside `quad`: the quad, or what of its bounds is in the picture when that is less.
/// False when nothing of it can be seen.
bool InstanceWriter::visible_part(const Quad& quad, Quad& part) const {
  const Aabbd bounds = bounds_of(quad);
  const bool whole_picture = is_whole();  // whose edges OpenGL keeps by itself
  const Aabbd frame = picture(whole_picture ? soft_edge_px : 0);
  if (!overlaps(bounds, frame)) return false;
  const bool inside = whole_picture || contains(frame, bounds);
  part = quad_of(common_part(bounds, frame));
  if (inside && within_float(quad) && area(quad) < area(part)) part = quad;
  return true;
}

void InstanceWriter::put_color(float* at, Color color, double strength) const {
  if (mode_ == DrawMode::owners) return put_number(at, owner_, color.a / 255.0 * strength);
  put_premultiplied(at, color, strength);
}

/// The four vectors all kinds begin with.
void InstanceWriter::put_common(float* at, const Quad& quad, double radius, const Ink& ink) const {
  put(at, quad.center);
  put(at + 2, quad.axis);
  at[4] = static_cast<float>(quad.half_x);
  at[5] = static_cast<float>(quad.half_y);
  at[6] = ink.outline_px > 0 ? static_cast<float>(ink.outline_px) : -1e9F;
  at[7] = static_cast<float>(radius);
  put_color(at + 8, ink.fill, ink.strength);
  put_color(at + 12, ink.outline, ink.strength);
}

void InstanceWriter::add_box(const Quad& box, double radius, const Ink& ink) {
  Quad part;
  if (invisible(ink) || !visible_part(grown(box, radius + soft_edge_px), part)) return;
  add_box_part(box, radius, ink, part);
}

void InstanceWriter::add_box_part(const Quad& box, double radius, const Ink& ink, const Quad& part) {
  Instance<6> values{};
  put_common(values.data(), part, radius, ink);
  put(&values[16], box.center);
  put(&values[18], box.axis);
  values[20] = static_cast<float>(box.half_x);
  values[21] = static_cast<float>(box.half_y);
  batches_.add(ShapeKind::box, values, part);
}

/// An outline alone, as four strips at whole pixels: what a large empty box encloses costs nothing.
void InstanceWriter::add_frame(const Aabbd& box, const Ink& ink) {
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

void InstanceWriter::add_edges(const std::vector<Vec2d>& corners, const Ink& ink) {
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
void InstanceWriter::add_half_planes(ShapeKind kind, const std::vector<Vec2d>& corners, const Quad& part,
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
  batches_.add(kind, values, part);
}

void InstanceWriter::add_rounded(const std::vector<Vec2d>& corners, double radius, const Ink& ink) {
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
void InstanceWriter::add_corners(ShapeKind kind, const std::vector<Vec2d>& corners, const Quad& part, double radius,
                                 const Ink& ink) {
  Instance<4 + places / 2> values{};
  put_common(values.data(), part, radius, ink);
  const std::size_t last = corners.size() - 1;
  for (std::size_t i = 0; i < places; ++i) {  // spare corners divide the last edge
    const std::size_t past = i - std::min(i, last);
    const double way = static_cast<double>(past) / static_cast<double>(places - last);
    put(&values[16 + 2 * i], lerp(corners[std::min(i, last)], corners[0], way) - part.center);
  }
  batches_.add(kind, values, part);
}

void InstanceWriter::add_stroke_part(StrokePart stroke, double width) {
  const double radius = 0.5 * std::max(width, 1.0);
  const auto [whole_a, whole_b] = std::pair(stroke.a, stroke.b);
  if (!clip_segment(stroke.a, stroke.b, picture(float_limit_px))) return;
  if (stroke.a != whole_a) stroke.joint_a = {};
  if (stroke.b != whole_b) stroke.joint_b = {};
  const double reach = distance(stroke.a, stroke.b);
  if (reach == 0) return;
  const Vec2d along = normalized(stroke.b - stroke.a);
  const Vec2d first = stroke.a - reach_beyond(stroke.joint_a, along, radius) * along;
  const Vec2d last = stroke.b + reach_beyond(stroke.joint_b, along, radius) * along;
  const Quad share{0.5 * (first + last), along, 0.5 * distance(first, last), radius + soft_edge_px};
  Quad part;
  if (!visible_part(share, part)) return;
  Instance<6> values{};
  put_common(values.data(), part, radius, {stroke.from, stroke.to, 0, std::min(width, 1.0)});
  values[6] = stroke.joint_b == Vec2d{} ? 1.0F : 0.0F;
  put(&values[16], stroke.a);
  put(&values[18], stroke.b);
  put(&values[20], stroke.joint_a);
  put(&values[22], stroke.joint_b);
  batches_.add(ShapeKind::stroke, values, part);
}

void InstanceWriter::add_glyph(const AtlasGlyph& glyph, int x_px, int y_px, Color color) {
  if (glyph.width_px == 0) return;
  const Vec2d low{static_cast<double>(x_px + glyph.left_px), static_cast<double>(y_px + glyph.top_px)};
  const Aabbd box{low, low + Vec2d{static_cast<double>(glyph.width_px), static_cast<double>(glyph.height_px)}};
  const Aabbd frame = picture(0);
  if (!overlaps(box, frame)) return;
  const Aabbd seen = is_whole() ? box : common_part(box, frame);
  Instance<4> values{};
  put_common(values.data(), quad_of(seen), 0, {color, color, 0, 1});
  put(&values[12], Vec2d{static_cast<double>(glyph.x_px), static_cast<double>(glyph.y_px)} - low);
  batches_.add(ShapeKind::glyph, values, quad_of(seen));
}

}  // namespace proofreel
