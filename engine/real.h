#pragma once

/// The engine is written once in terms of `real` and compiled twice. Its names live in an inline namespace that says
/// which precision they were compiled in, so that both fit in one program. Only Scene, Simulation and Snapshot, which
/// are always in double, are seen outside.

#include "engine/aabb.h"
#include "engine/mat2.h"
#include "engine/pose.h"
#include "engine/transform.h"

#if defined(PROOFREEL_FLOAT32)
#define PROOFREEL_PRECISION float32
#define PROOFREEL_REAL float
#elif defined(PROOFREEL_FLOAT64)
#define PROOFREEL_PRECISION float64
#define PROOFREEL_REAL double
#else
#error "Compile engine sources in one of the two precisions: -DPROOFREEL_FLOAT32 or -DPROOFREEL_FLOAT64."
#endif

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

using real = PROOFREEL_REAL;
using Vec2 = BasicVec2<real>;
using Mat2 = BasicMat2<real>;
using Rot = BasicRot<real>;
using Pose = BasicPose<real>;
using Transform = BasicTransform<real>;
using Aabb = BasicAabb<real>;

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
