#pragma once

/// What the rows of contacts have to reach before the drift so that gaps are closed, and friction holds, after it.

#include <cstdint>
#include <vector>

#include "engine/contact_problem.h"
#include "engine/contact_solver.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class ContactGoals {
 public:
  /// The speed that would lead on to the contact is not the speed towards it: bodies turn on the way. What the way at
  /// present speeds and a straight one differ by goes into the bias of the rows of gaps and slips. With `closed_only`
  /// gaps that are open are off. Returns by how much that has changed the ways of closed points since the last call,
  /// relative to what counts as closed.
  real set(std::vector<ContactRow>& rows, const ContactSolver& contacts, const std::vector<Motion>& motions, real h,
           bool closed_only);

 private:
  /// A point's gap now and after drifting on for a while, and how far the surfaces slide along each other meanwhile.
  struct Way {
    real gap = 0;
    real gap_after = 0;
    real slide = 0;
  };
  /// A body after the drift.
  struct Later {
    std::uint64_t call = 0;  ///< in which it was found
    Vec2 delta;
    Rot rotation;
  };

  const Later& later(BodyIndex body, const std::vector<Motion>& motions, real h);
  void find_ways(const ContactConstraint& c, const std::vector<Motion>& motions, real h);

  std::vector<Later> later_;  ///< of all bodies: each is in several contacts
  std::uint64_t call_ = 0;
  Way ways_[2];  ///< of the points of one contact
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
