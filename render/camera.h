#pragma once

#include "scenarios/scenario.h"

namespace proofreel {

/// Metres of the world, y up, to pixels of a picture, y down.
class Camera {
 public:
  /// The view in the middle of the picture. In one of other proportions than it was made for nothing of it is lost:
  /// a wider one shows more at the sides, a narrower one more above and below.
  Camera(const View& view, int width_px, int height_px);
  /// `px_per_metre`, with the middle of the view at a place of the picture.
  Camera(const View& view, double px_per_metre, Vec2d middle_px);

  Vec2d to_px(Vec2d world) const;
  Vec2d to_world(Vec2d px) const;
  /// A length; negative ones stay negative.
  double px(double metres) const { return metres * scale_; }

 private:
  double scale_;  // pixels per metre
  Vec2d view_center_;
  Vec2d picture_center_;
};

/// Whether the picture's height would show the view at so large a scale that its sides were cut.
bool is_too_narrow(const View& view, int width_px, int height_px);

}  // namespace proofreel
