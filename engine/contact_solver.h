#pragma once

/// Contacts and friction, one contact after the other, sweep by sweep (projected Gauss-Seidel on impulses; "sequential
/// impulses", Catto, GDC 2006). Three ways to get overlap out:
///   soft_step            by a damped spring as stiff as the substep can carry; as many rigid sweeps take out again
///                        what velocity the push has left ("TGS Soft", Catto, Solver2D, box2d.org 2024)
///   sequential_impulses  a part of it per substep, by velocity, which stays as energy (Baumgarte 1972; as taught)
///   ngs                  not by velocity at all: afterwards the positions are moved (nonlinear Gauss-Seidel)
/// Under the verlet integrator there are sweeps before the drift and after it, and both get half of gravity each, so
/// that a body at rest reports v = 0.

#include <vector>

#include "engine/contact.h"
#include "engine/observer.h"
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
  Vec2 local_a;  ///< on the cores, in the bodies' axes from their centres of mass: roundings touch with other points
  Vec2 local_b;  ///< when they turn
  Vec2 arm_a;    ///< on the surfaces, at the start of the tick, world axes
  Vec2 arm_b;
  real base_separation = 0;  ///< separation less the part that the moving arms account for
  real normal_mass = 0;      ///< effective mass along the normal
  real tangent_mass = 0;
  real bias = 0;  ///< how fast the gap may close, m/s, as the last sweep has found it that looked; negative: is to open
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
  bool exact = false;    ///< solved by ExactContacts: no sweep touches it
  Patience patience;     ///< as in Contact
  Vec2 normal;
  real friction_at_rest = 0;
  real friction_sliding = 0;
  real restitution = 0;
  real length = 0;      ///< pair_length of its shapes
  real push_speed = 0;  ///< at most so fast overlap is driven out by velocity, m/s; 0 where it is by position
  real closed = 0;      ///< gaps below this are closed for those who want to know exactly (ExactContacts), m
  real radius_a = 0;    ///< of the shapes' roundings, m
  real radius_b = 0;
  ConstraintPoint points[2];
};

/// The separation of a point at the present positions.
real separation_of(const ContactConstraint& c, const ConstraintPoint& p, const Motion& a, const Motion& b);

/// Moves both bodies as if `impulse` (kg m, on B) acted on positions.
void shift(Motion& a, Motion& b, const ConstraintPoint& p, Vec2 impulse);

/// The coefficient that counts at present.
inline real friction_of(const ContactConstraint& c) { return c.sliding ? c.friction_sliding : c.friction_at_rest; }

/// Overlap is driven out at no more than this many times the pair's thickness per second, so that bodies that start
/// inside each other part gently whatever their size.
inline constexpr real push_rate = 3;

/// What of a contact's behaviour is solved; what is off is left out altogether.
struct ContactParts {
  bool friction = true;
  bool rolling_resistance = false;
  bool surface_speed = false;
};

/// Contacts that are swept are soft.
inline bool is_soft(ContactMethod method) {
  return method == ContactMethod::automatic || method == ContactMethod::soft_step;
}

class ContactSolver {
 public:
  explicit ContactSolver(ContactMethod method) : method_(method) {}
  /// Collects the contacts that have points.
  void prepare(const std::vector<Contact>& contacts, const std::vector<Shape>& shapes,
               const std::vector<Motion>& motions, Softness softness, ContactParts parts);
  /// Starts a substep: applies `share` of the impulses of the one before.
  void begin_substep(std::vector<Motion>& motions, real share);
  /// Adds the other share before the relaxing sweep.
  void add_share(std::vector<Motion>& motions, real share);
  /// A sweep that stops approach and, as far as the method does it by velocity, drives out overlap; soft contacts are
  /// swept twice. The observer sees ContactSwept.
  template <typename Observer = NoObserver>
  void solve(std::vector<Motion>& motions, real h, Observer observer = {});
  /// As many sweeps that only stop approach.
  void relax(std::vector<Motion>& motions, real h);
  /// One sweep over the positions that takes out a part of the overlap.
  void push_out(std::vector<Motion>& motions) const;
  /// Whether some bodies are still inside each other since they met. The push that drives them out would add up from
  /// body to body along a pile, and no relaxing sweep gets all of it back.
  bool parts_overlaps() const { return parts_overlaps_; }
  /// Call when others have changed what drives overlap out.
  void look_for_overlaps();
  /// Moves them out, by their push_rate at most, and leaves no other contact worse than it was. No velocity changes.
  void part(std::vector<Motion>& motions, real h) const;
  /// Looks at some of the contacts anew amid a tick; all others go on as they were prepared.
  void take_in(const std::vector<std::uint32_t>& which, const std::vector<Contact>& contacts,
               const std::vector<Shape>& shapes, const std::vector<Motion>& motions);
  /// By body, of so many: whether sweeps drive it out of something that it is deep inside at the start of the tick.
  /// Empty where there is none.
  std::vector<std::uint8_t> overlapping_bodies(const std::vector<Contact>& contacts, std::size_t body_count) const;
  /// Ends a substep: books its impulses and looks which contacts stick and which slide.
  void end_substep();
  /// Hands the impulses back to the contacts.
  void store(std::vector<Contact>& contacts) const;
  std::vector<ContactConstraint>& constraints() { return constraints_; }
  const std::vector<ContactConstraint>& constraints() const { return constraints_; }
  /// How fast friction wants the surfaces of every constraint to move along each other, m/s: B's against A's, along the
  /// normal turned a quarter counter-clockwise. Empty where no surface moves by itself.
  const std::vector<real>& surface_speeds() const { return surface_speeds_; }
  const std::vector<RollingRows::Row>& rolling() const { return rolling_.rows(); }
  std::vector<RollingRows::Row>& rolling() { return rolling_.rows(); }
  const ContactParts& parts() const { return parts_; }

 private:
  /// How a sweep treats overlap: it is driven out by a spring, or a part of it at once, or not by this sweep; or the
  /// sweep takes back what another one has pushed too much.
  enum class Push : std::uint8_t { softly, at_once, never, back };
  /// Whether a sweep looks how far points are apart, or knows it from the one before it: velocities move no body.
  enum class Look : std::uint8_t { anew, known };

  template <Push push, Look look, typename Observer = NoObserver>
  void sweep(std::vector<Motion>& motions, real h, Observer observer = {});
  void count_swept_rows(int at_point) const;
  ContactConstraint constraint_of(std::uint32_t index, const Contact& contact, const std::vector<Shape>& shapes,
                                  const std::vector<Motion>& motions) const;
  template <Push push, Look look, bool friction, bool moving, typename Observer>
  void sweep_all(std::vector<Motion>& motions, real h, Observer observer);
  template <Push push>
  void look_at_gaps(ContactConstraint& c, const Motion& a, const Motion& b, real h) const;
  template <Push push>
  void solve_normal(const ContactConstraint& c, ConstraintPoint& p, Mover& a, Mover& b) const;

  ContactMethod method_;
  std::vector<ContactConstraint> constraints_;
  std::vector<real> surface_speeds_;  ///< parallel to constraints_, or empty
  RollingRows rolling_;
  Softness softness_;
  ContactParts parts_;
  bool parts_overlaps_ = false;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
