#pragma once

/// The resistance of the medium, air or water, that everything moves through: against the motion relative to the
/// medium, in proportion to the speed (linear: slow, thick media) and to its square (quadratic: most of what flies).
/// It takes energy out of the scene and puts none back.

#include "engine/smooth_motion.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What drag does to a body's velocity in `h` seconds, if nothing else acts: the exact solution of
///     m dv/dt = -(linear + quadratic |v|) v,  I dw/dt = -angular w,
/// where v is relative to the wind. Exact, not a force times h, so that no drag however strong can turn a body round,
/// and a composition of halves around the other forces (Strang 1968) stays second order.
/// Bodies that nothing pushes keep their velocity.
void apply_drag(Motion& motion, const DragDef& drag, Vec2 wind, real h);

/// Adds what drag decelerates a body by now, for integrators that take it as one force among others.
void add_drag(const Motion& motion, const DragDef& drag, Vec2 wind, Slope& slope);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
