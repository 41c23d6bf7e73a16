#include "render/camera.h"

namespace proofreel {

Camera::Camera(const View& view, int width_px, int height_px)
    : scale_(height_px / view.height), view_center_(view.center), picture_center_(0.5 * width_px, 0.5 * height_px) {}

Vec2d Camera::to_px(Vec2d world) const {
  const Vec2d offset = scale_ * (world - view_center_);
  return {picture_center_.x + offset.x, picture_center_.y - offset.y};
}

Vec2d Camera::to_world(Vec2d px) const {
  const Vec2d offset = px - picture_center_;
  return {view_center_.x + offset.x / scale_, view_center_.y - offset.y / scale_};
}

}  // namespace proofreel
