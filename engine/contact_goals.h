#pragma once

/// What the rows of contacts have to reach before the drift so that gaps are closed, and friction holds, after it.

#include <vector>

#include "engine/contact_problem.h"
#include "engine/contact_solver.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The speed that would lead on to the contact is not the speed towards it: bodies turn on the way. What the way at
/// present speeds and a straight one differ by goes into the bias of the rows of gaps and slips. With `closed_only`
/// gaps that are open are off. Returns by how much that has changed the ways of closed points since the last call,
/// relative to what counts as closed.
real set_goals(std::vector<ContactRow>& rows, const ContactSolver& contacts, const std::vector<Motion>& motions, real h,
               bool closed_only);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
