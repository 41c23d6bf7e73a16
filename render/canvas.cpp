#include "render/canvas.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <string>

#include "render/canvas_geometry.h"
#include "render/canvas_gpu.h"
#include "render/canvas_instances.h"
#include "render/svg.h"

namespace proofreel {
namespace {

bool all_finite(std::span<const Vec2d> points) {
  return std::all_of(points.begin(), points.end(), [](Vec2d p) { return is_finite(p); });
}

}  // namespace

struct Canvas::Impl {
  std::unique_ptr<CanvasGpu> gpu;  ///< without it, marks are written down
  PixelRect whole;
  PixelRect area;
  SvgWriter writer;
  InstanceWriter instances;
  Font font;
  DrawMode mode = DrawMode::colors;
  Color background{0, 0, 0, 255};
  const Image* behind = nullptr;  ///< in place of the colour

  /// Draws through the context, or without one writes down.
  Impl(GlContext* context, int width, int height)
      : gpu(context != nullptr ? std::make_unique<CanvasGpu>(*context, width, height) : nullptr),
        whole{0, 0, width, height},
        area(whole),
        writer(width, height),
        instances(width, height) {}

  /// Where marks are written down; null where they are drawn.
  SvgWriter* svg() { return gpu ? nullptr : &writer; }

  /// Ends what was asked for; what follows lies on `color`.
  void begin(Color color, DrawMode new_mode) {
    mode = new_mode;
    background = color;
    behind = nullptr;
    instances.begin(color, mode);
  }
};

Canvas::Canvas(GlContext& context, int width_px, int height_px)
    : impl_(std::make_unique<Impl>(&context, width_px, height_px)) {}

Canvas::Canvas(int width_px, int height_px) : impl_(std::make_unique<Impl>(nullptr, width_px, height_px)) {}

Canvas::~Canvas() = default;

int Canvas::width_px() const { return impl_->area.width_px; }

int Canvas::height_px() const { return impl_->area.height_px; }

void Canvas::enter(const PixelRect& area) {
  impl_->area = area;
  if (SvgWriter* svg = impl_->svg()) return svg->enter(area);
  impl_->instances.enter(area);
}

void Canvas::leave() {
  impl_->area = impl_->whole;
  if (SvgWriter* svg = impl_->svg()) return svg->leave();
  impl_->instances.leave();
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

void Canvas::own(std::uint32_t owner) { impl_->instances.own(owner); }

void Canvas::disc(Vec2d center, double radius, const Paint& paint) {
  if (!is_finite(center) || !(radius > 0)) return;
  if (SvgWriter* svg = impl_->svg()) return svg->disc(center, radius, paint);
  impl_->instances.disc(center, radius, paint);
}

void Canvas::polygon(std::span<const Vec2d> corners, double radius, const Paint& paint) {
  if (corners.size() < 3 || corners.size() > 16 || !all_finite(corners) || !(radius >= 0)) return;
  if (doubled_area(corners) == 0) return;
  if (SvgWriter* svg = impl_->svg()) return svg->polygon(corners, radius, paint);
  impl_->instances.polygon(corners, radius, paint);
}

void Canvas::capsule(Vec2d a, Vec2d b, double radius, const Paint& paint) {
  if (!is_finite(a) || !is_finite(b) || !(radius > 0)) return;
  if (SvgWriter* svg = impl_->svg()) return svg->capsule(a, b, radius, paint);
  impl_->instances.capsule(a, b, radius, paint);
}

void Canvas::line(Vec2d a, Vec2d b, double width, Color color) { capsule(a, b, 0.5 * width, {color, color, 0}); }

void Canvas::stroke(std::span<const Vec2d> line, double width, Color from, Color to) {
  if (line.size() < 2 || !all_finite(line) || !(width > 0)) return;
  if (SvgWriter* svg = impl_->svg()) return svg->stroke(line, width, from, to);
  impl_->instances.stroke(line, width, from, to);
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
  impl_->instances.rectangle(low, high, rounding, paint);
}

void Canvas::text(std::string_view utf8, Vec2d baseline, int size_px, Align align, Color color) {
  const TextLine line = impl_->font.layout(utf8, size_px);
  const double width = static_cast<double>(line.width) / pen_per_pixel;
  const double shift = align == Align::left ? 0 : align == Align::center ? 0.5 * width : width;
  const Vec2d left{baseline.x - shift, baseline.y};
  if (SvgWriter* svg = impl_->svg()) return svg->text(impl_->font, utf8, left, size_px, color);
  impl_->instances.text(impl_->font, line, left, size_px, color);
}

double Canvas::text_width(std::string_view utf8, int size_px) {
  return static_cast<double>(impl_->font.layout(utf8, size_px).width) / pen_per_pixel;
}

void Canvas::finish(Image& image) {
  impl_->gpu->draw({impl_->mode, impl_->background, impl_->behind, impl_->instances.marks()}, impl_->instances.atlas(),
                   image);
}

std::string Canvas::svg() const { return impl_->writer.document(); }

}  // namespace proofreel
