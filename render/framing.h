#pragma once

/// How a frame is laid into pictures of any proportions.

#include <vector>

#include "engine/aabb.h"
#include "render/camera.h"
#include "render/canvas.h"
#include "render/theme.h"
#include "scenarios/frame.h"

namespace proofreel {

/// Where the world and the plots lie.
struct Framing {
  Camera camera;
  std::vector<Aabbd> plots;  ///< px, of the frame's plots in their order; empty where they lie in their corners
};

/// Upright and square pictures of a view that was made wider have room above and below the action: there the plots lie,
/// as wide as the picture, those of upper corners above. Beyond them some lines are left for what is written. Where the
/// room is short, plots of one side lie two and two, and the action gives way and becomes smaller.
Framing framing_of(Canvas& canvas, const Frame& frame, const Sizes& sizes);

}  // namespace proofreel
