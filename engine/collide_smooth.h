#pragma once

/// The narrow phase where shapes join to smooth ground (see seam.h).

#include "engine/collide.h"
#include "engine/seam.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// A shape and what its neighbours hide of it; null: nothing.
struct SeamedHull {
  const Hull& hull;
  const Seam* seam = nullptr;
};

/// As `collide`, but only with normals along which the common outlines can push. It tries every separating axis (thesis
/// chapter 4.2) and keeps the best of those that are admitted at both shapes; touching nothing else than a hidden edge
/// or corner is touching nothing.
Manifold collide_smooth(const SeamedHull& a, const Pose& pose_a, const SeamedHull& b, const Pose& pose_b, real margin);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
