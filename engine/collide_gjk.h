#pragma once

/// The narrow phase a second time, by other means: normal and depth from GJK (gjk.h) and EPA (epa.h), points by
/// clipping. It knows nothing of separating axes, so what it agrees on with collide (collide.h) is right.

#include "engine/clip.h"
#include "engine/epa.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The contract of collide: points farther apart than `margin` are left out, the poses are those of the centres of
/// mass, all is computed in A's frame. Where several directions are equally short ways out, the normal may be another
/// of them; features are named by the same rule, single points by the pair of faces they lie on.
template <typename Observer = NoObserver>
Manifold collide_gjk(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, real margin,
                     Observer observer = {});

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
