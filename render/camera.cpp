#include "render/camera.h"

#include <cstdint>

namespace proofreel {

namespace {

double scale_of(const View& view, int width_px, int height_px) {
  if (!is_too_narrow(view, width_px, height_px)) return height_px / view.height;
  return width_px / (view.height * view.made_for.width_px / view.made_for.height_px);
}

}  // namespace

Camera::Camera(const View& view, int width_px, int height_px)
    : Camera(view, scale_of(view, width_px, height_px), {0.5 * width_px, 0.5 * height_px}) {}

Camera::Camera(const View& view, double px_per_metre, Vec2d middle_px)
    : scale_(px_per_metre), view_center_(view.center), picture_center_(middle_px) {}

Vec2d Camera::to_px(Vec2d world) const {
  const Vec2d offset = scale_ * (world - view_center_);
  return {picture_center_.x + offset.x, picture_center_.y - offset.y};
}

Vec2d Camera::to_world(Vec2d px) const {
  const Vec2d offset = px - picture_center_;
  return {view_center_.x + offset.x / scale_, view_center_.y - offset.y / scale_};
}

bool is_too_narrow(const View& view, int width_px, int height_px) {
  return std::int64_t{width_px} * view.made_for.height_px < std::int64_t{height_px} * view.made_for.width_px;
}

}  // namespace proofreel
