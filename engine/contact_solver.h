#pragma once

/// Contacts and friction by soft steps with relaxation ("TGS Soft", Catto, Solver2D, box2d.org 2024): overlap is driven
/// out by a damped spring as stiff as the substep can carry, and a second, rigid sweep takes the velocity of the push
/// out again. Under the verlet integrator both sweeps get half of gravity each, so that a body at rest reports v = 0.

#include <vector>

#include "engine/contact.h"
#include "engine/rolling.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// How a soft constraint of given frequency and damping acts in one substep.
struct Softness {
  real bias_rate = 0;      ///< 1/s: part of the overlap driven out per second
  real mass_scale = 1;     ///< of the rigid impulse
  real impulse_scale = 0;  ///< of the impulse so far, taken back
};

/// `hertz` in 1/s, `damping_ratio` 1 is critical, `h` the substep in s.
Softness make_softness(real hertz, real damping_ratio, real h);

struct ConstraintPoint {
  Vec2 local_a;  ///< in the bodies' axes, from their centres of mass
  Vec2 local_b;
  Vec2 arm_a;  ///< the same at the start of the tick, world axes
  Vec2 arm_b;
  real base_separation = 0;  ///< separation less the part that the moving arms account for
  real normal_mass = 0;      ///< effective mass along the normal
  real tangent_mass = 0;
  real normal_impulse = 0;  ///< of this substep so far
  real tangent_impulse = 0;
  real warm_normal = 0;  ///< of the substep before: where this one starts from
  real warm_tangent = 0;
  real normal_total = 0;  ///< of this tick so far
  real tangent_total = 0;
};

struct ContactConstraint {
  std::uint32_t contact = 0;
  BodyIndex body_a = 0;
  BodyIndex body_b = 0;
  int count = 0;
  bool sliding = false;  ///< as in Contact
  Vec2 normal;
  real friction_at_rest = 0;
  real friction_sliding = 0;
  real restitution = 0;
  real length = 0;  ///< pair_length of its shapes
  ConstraintPoint points[2];
};

/// The separation of a point at the present positions.
real separation_of(const ContactConstraint& c, const ConstraintPoint& p, const Motion& a, const Motion& b);

/// What of a contact's behaviour is solved; what is off is left out altogether.
struct ContactParts {
  bool friction = true;
  bool rolling_resistance = false;
  bool surface_speed = false;
};

class ContactSolver {
 public:
  /// Collects the contacts that have points.
  void prepare(const std::vector<Contact>& contacts, const std::vector<Shape>& shapes,
               const std::vector<Motion>& motions, Softness softness, ContactParts parts);
  /// Starts a substep: applies `share` of the impulses of the one before.
  void begin_substep(std::vector<Motion>& motions, real share);
  /// Adds the other share before the relaxing sweep.
  void add_share(std::vector<Motion>& motions, real share);
  /// One sweep that also drives out overlap.
  void solve(std::vector<Motion>& motions, real h) { sweep<true>(motions, h); }
  /// One sweep that only stops approach.
  void relax(std::vector<Motion>& motions, real h) { sweep<false>(motions, h); }
  /// Ends a substep: books its impulses and looks which contacts stick and which slide.
  void end_substep();
  /// Hands the impulses back to the contacts.
  void store(std::vector<Contact>& contacts) const;
  std::vector<ContactConstraint>& constraints() { return constraints_; }
  /// How fast friction wants the surfaces of every constraint to move along each other, m/s: B's against A's, along the
  /// normal turned a quarter counter-clockwise. Empty where no surface moves by itself.
  const std::vector<real>& surface_speeds() const { return surface_speeds_; }
  const std::vector<RollingRows::Row>& rolling() const { return rolling_.rows(); }

 private:
  template <bool driving_out>
  void sweep(std::vector<Motion>& motions, real h);
  template <bool driving_out, bool friction, bool moving>
  void sweep_all(std::vector<Motion>& motions, real h);

  std::vector<ContactConstraint> constraints_;
  std::vector<real> surface_speeds_;  ///< parallel to constraints_, or empty
  RollingRows rolling_;
  Softness softness_;
  ContactParts parts_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
