#pragma once

/// Many bodies moved on by their own velocities.

#include <span>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The same bits as `drift` of each of them, several at once: what turns a body is a chain of divisions, which the
/// machine does for four numbers in the time of one.
void drift(std::span<Motion> motions, real h);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
