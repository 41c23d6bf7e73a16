#pragma once

/// Force fields of any form: functions that tell the force on a body's centre of mass from where it is, how fast it
/// moves, and when.

#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Pushes every dynamic body with what all fields together say. A field may be a function of anything, so it has no
/// potential: what it does is work from outside, force times way.
///
/// A substep of verlet begins with one half kick and ends with another. The first has to come before all other forces
/// of the substep and the second after them: then the fields are asked about the velocities of the moments the kicks
/// belong to, and the scheme is of second order even where forces depend on velocity (a magnetic field, say).
class FieldForces {
 public:
  explicit FieldForces(std::vector<ForceField> fields) : fields_(std::move(fields)) {}

  /// N, on a body at a time, s.
  Vec2d force_on(const Body& body, const Motion& motion, Vec2d velocity, double time) const;
  /// Asks the fields once per body and pushes for `h` seconds.
  void kick_at_begin(const std::vector<Body>& bodies, std::vector<Motion>& motions, double time, real h);
  /// The bodies have just drifted for `h` seconds. Returns what the forces of the begin would have done by themselves
  /// along that way, J.
  double drifted(const std::vector<Motion>& motions, real h);
  /// The same as at the begin, with the forces at the end of the way, and returns what these would have done along it.
  /// The mean of both is the work (trapezoidal rule). The velocity that the fields are asked about is the one that the
  /// kick leads to, as far as the force of the begin foretells it.
  double kick_at_end(const std::vector<Body>& bodies, std::vector<Motion>& motions, double time, real h);

 private:
  double work() const;

  std::vector<ForceField> fields_;
  std::vector<Vec2d> forces_;  ///< N, by body
  std::vector<Vec2d> ways_;    ///< m, of the last drift
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
