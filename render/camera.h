#pragma once

#include "scenarios/scenario.h"

namespace proofreel {

/// Metres of the world, y up, to pixels of a picture, y down.
class Camera {
 public:
  Camera(const View& view, int width_px, int height_px);

  Vec2d to_px(Vec2d world) const;
  Vec2d to_world(Vec2d px) const;
  /// A length; negative ones stay negative.
  double px(double metres) const { return metres * scale_; }

 private:
  double scale_;  // pixels per metre
  Vec2d view_center_;
  Vec2d picture_center_;
};

}  // namespace proofreel
