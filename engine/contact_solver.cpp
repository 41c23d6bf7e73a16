#include "engine/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr real two_pi = real(6.283185307179586);
/// Of the pair's thickness: so much overlap is left alone where it is driven out at once, so that contacts last.
constexpr real slop = real(0.005);
/// The part of the rest that is driven out in one substep.
constexpr real baumgarte = real(0.2);
/// Positions are moved by no more than this part of the thickness at a time.
constexpr real longest_move = real(0.2);

/// With more overlap than this part, pushing it out takes a good deal of what a contact gives.
constexpr real deep_part = real(0.03);

real inverse_or_zero(real x) { return x > 0 ? 1 / x : 0; }

real effective_mass(const Motion& a, const Motion& b, const ConstraintPoint& p, Vec2 direction) {
  const real arm_a = cross(p.arm_a, direction);
  const real arm_b = cross(p.arm_b, direction);
  return inverse_or_zero(a.inv_mass + b.inv_mass + a.inv_inertia * arm_a * arm_a + b.inv_inertia * arm_b * arm_b);
}

ConstraintPoint make_point(const ContactConstraint& c, const ManifoldPoint& p, const PointImpulse& impulse,
                           Vec2 center_a_to_b, const Motion& a, const Motion& b) {
  ConstraintPoint out;
  out.arm_a = p.point;
  out.arm_b = p.point - center_a_to_b;
  const Vec2 core_a = out.arm_a - c.radius_a * c.normal;
  const Vec2 core_b = out.arm_b + c.radius_b * c.normal;
  out.local_a = inverse_rotate(a.rotation, core_a);
  out.local_b = inverse_rotate(b.rotation, core_b);
  out.base_separation = p.separation - dot(core_b - core_a, c.normal);
  out.normal_mass = effective_mass(a, b, out, c.normal);
  out.tangent_mass = effective_mass(a, b, out, perp(c.normal));
  out.normal_impulse = impulse.normal;
  out.tangent_impulse = friction_of(c) > 0 ? impulse.tangent : 0;
  return out;
}

void push_apart(Mover& a, Mover& b, const ConstraintPoint& p, Vec2 impulse) {
  a.push(-impulse, p.arm_a);
  b.push(impulse, p.arm_b);
}

Vec2 relative_velocity(const Mover& a, const Mover& b, const ConstraintPoint& p) {
  return b.velocity_at(p.arm_b) - a.velocity_at(p.arm_a);
}

/// Sweeps work on copies, which stay in registers from row to row.
void take_speeds(Motion& motion, const Mover& from) {
  motion.velocity = from.velocity;
  motion.spin = from.spin;
}

/// `wanted_slip` is how fast the surfaces should move along each other: not at all, unless they are belts.
template <bool moving>
[[gnu::always_inline]] inline void solve_friction(const ContactConstraint& c, ConstraintPoint& p, Mover& a, Mover& b,
                                                  real wanted_slip) {
  const Vec2 tangent = perp(c.normal);
  real slip = dot(relative_velocity(a, b, p), tangent);
  if constexpr (moving) slip -= wanted_slip;
  const real wanted = p.tangent_impulse - p.tangent_mass * slip;
  const real limit = friction_of(c) * p.normal_impulse;
  const real impulse = std::clamp(wanted, -limit, limit);
  push_apart(a, b, p, (impulse - p.tangent_impulse) * tangent);
  p.tangent_impulse = impulse;
}

/// Coulomb's law with two coefficients: a contact sticks until it needs all that static friction can give at every
/// point, then slides against kinetic friction until that would be more than enough.
bool slides(const ContactConstraint& c) {
  const bool pressed = c.points[0].normal_impulse > 0 || (c.count > 1 && c.points[1].normal_impulse > 0);
  if (c.sliding && c.friction_sliding <= 0) return pressed;  // nothing brakes it
  real used = 0;
  real available = 0;
  for (int k = 0; k < c.count; ++k) {
    used += std::abs(c.points[k].tangent_impulse);
    available += friction_of(c) * c.points[k].normal_impulse;
  }
  return available > 0 && used >= real(0.999999) * available;
}

ContactSwept swept_event(const ContactConstraint& c) {
  ContactSwept event{c.contact, c.count, {}, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    event.normal[k] = static_cast<double>(c.points[k].normal_impulse);
    event.tangent[k] = static_cast<double>(c.points[k].tangent_impulse);
  }
  return event;
}

/// 0, 2, 4, ... 1, 3, 5, ... for i = 0 .. n - 1.
std::size_t every_other_first(std::size_t i, std::size_t n) {
  const std::size_t evens = n - n / 2;
  return i < evens ? 2 * i : 2 * (i - evens) + 1;
}

}  // namespace

Softness make_softness(real hertz, real damping_ratio, real h) {
  const real omega = two_pi * hertz;
  const real a1 = 2 * damping_ratio + h * omega;
  const real a2 = h * omega * a1;
  const real a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

real separation_of(const ContactConstraint& c, const ConstraintPoint& p, const Motion& a, const Motion& b) {
  const Vec2 arms = rotate(b.rotation, p.local_b) - rotate(a.rotation, p.local_a);
  return p.base_separation + dot((b.delta - a.delta) + arms, c.normal);
}

ContactConstraint ContactSolver::constraint_of(std::uint32_t index, const Contact& contact,
                                               const std::vector<Shape>& shapes,
                                               const std::vector<Motion>& motions) const {
  ContactConstraint c;
  c.contact = index;
  c.body_a = contact.body_a;
  c.body_b = contact.body_b;
  c.count = contact.manifold.count;
  c.sliding = contact.sliding;
  c.patience = contact.patience;
  c.normal = contact.manifold.normal;
  c.friction_at_rest = contact.friction_at_rest;
  c.friction_sliding = contact.friction_sliding;
  c.restitution = contact.restitution;
  c.length = pair_length(shapes[contact.shape_a], shapes[contact.shape_b]);
  c.push_speed = contact.parting && is_soft(method_) ? real(0) : push_rate * c.length;
  c.radius_a = shapes[contact.shape_a].hull.radius;
  c.radius_b = shapes[contact.shape_b].hull.radius;
  for (int k = 0; k < c.count; ++k) {
    c.points[k] = make_point(c, contact.manifold.points[k], contact.impulses[k], contact.a_to_b, motions[c.body_a],
                             motions[c.body_b]);
  }
  return c;
}

void shift(Motion& a, Motion& b, const ConstraintPoint& p, Vec2 impulse) {
  const auto move = [](Motion& m, Vec2 push, Vec2 arm) {
    const real turn = m.inv_inertia * cross(arm, push);
    m.delta += m.inv_mass * push;
    m.rotation = turned(m.rotation, turn);
    m.angle += turn;
  };
  move(a, -impulse, p.arm_a);
  move(b, impulse, p.arm_b);
}

void ContactSolver::prepare(const std::vector<Contact>& contacts, const std::vector<Shape>& shapes,
                            const std::vector<Motion>& motions, Softness softness, ContactParts parts) {
  softness_ = softness;
  parts_ = parts;
  constraints_.clear();
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].manifold.count == 0 || contacts[i].sensor) continue;
    constraints_.push_back(constraint_of(i, contacts[i], shapes, motions));
  }
  look_for_overlaps();
  surface_speeds_.clear();
  if (parts.surface_speed) {
    for (const ContactConstraint& c : constraints_) surface_speeds_.push_back(contacts[c.contact].surface_speed);
  }
  rolling_.clear();
  if (parts.rolling_resistance) rolling_.prepare(contacts, constraints_, motions);
}

void ContactSolver::look_for_overlaps() {
  parts_overlaps_ = std::any_of(constraints_.begin(), constraints_.end(),
                                [](const ContactConstraint& c) { return c.push_speed <= 0; });
}

void ContactSolver::take_in(const std::vector<std::uint32_t>& which, const std::vector<Contact>& contacts,
                            const std::vector<Shape>& shapes, const std::vector<Motion>& motions) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> place(contacts.size(), none);
  for (std::size_t i = 0; i < constraints_.size(); ++i) place[constraints_[i].contact] = i;
  for (const std::uint32_t i : which) {
    if (place[i] == none && contacts[i].manifold.count == 0) continue;
    ContactConstraint c = constraint_of(i, contacts[i], shapes, motions);
    const Vec2 moved = motions[c.body_b].delta - motions[c.body_a].delta;
    for (ConstraintPoint& p : c.points) p.base_separation -= dot(moved, c.normal);
    parts_overlaps_ |= c.push_speed <= 0;
    if (place[i] != none) {
      constraints_[place[i]] = c;
    } else {
      constraints_.push_back(c);
      if (parts_.surface_speed) surface_speeds_.push_back(contacts[i].surface_speed);
    }
  }
}

namespace {

void begin(ContactConstraint& c) {
  for (int k = 0; k < c.count; ++k) {
    ConstraintPoint& p = c.points[k];
    p.warm_normal = std::exchange(p.normal_impulse, real(0));
    p.warm_tangent = std::exchange(p.tangent_impulse, real(0));
  }
}

void give_share(ContactConstraint& c, Motion& motion_a, Motion& motion_b, real share) {
  Mover a = motion_a;
  Mover b = motion_b;
  for (int k = 0; k < c.count; ++k) {
    ConstraintPoint& p = c.points[k];
    const real normal = share * p.warm_normal;
    const real tangent = share * p.warm_tangent;
    p.normal_impulse += normal;
    p.tangent_impulse += tangent;
    push_apart(a, b, p, normal * c.normal + tangent * perp(c.normal));
  }
  take_speeds(motion_a, a);
  take_speeds(motion_b, b);
}

}  // namespace

void ContactSolver::begin_substep(std::vector<Motion>& motions, real share) {
  for (ContactConstraint& c : constraints_) {
    begin(c);
    give_share(c, motions[c.body_a], motions[c.body_b], share);
  }
  rolling_.begin_substep();
  rolling_.add_share(motions, share);
}

void ContactSolver::add_share(std::vector<Motion>& motions, real share) {
  for (ContactConstraint& c : constraints_) give_share(c, motions[c.body_a], motions[c.body_b], share);
  rolling_.add_share(motions, share);
}

/// What is apart may come as close as touching, and no closer.
template <ContactSolver::Push push>
[[gnu::always_inline]] inline void ContactSolver::look_at_gaps(ContactConstraint& c, const Motion& a, const Motion& b,
                                                               real h) const {
  for (int k = 0; k < c.count; ++k) {
    ConstraintPoint& p = c.points[k];
    const real separation = separation_of(c, p, a, b);
    p.bias = 0;
    if (separation > 0) {
      p.bias = separation / h;
    } else if constexpr (push == Push::softly) {
      p.bias = std::max(softness_.bias_rate * separation, -c.push_speed);
    } else if constexpr (push == Push::at_once) {
      p.bias = std::max(baumgarte / h * std::min(separation + slop * c.length, real(0)), -c.push_speed);
    }
  }
}

// Left to itself the compiler stops inlining this when there are several kinds of sweep: 6 % more instructions.
template <ContactSolver::Push push>
[[gnu::always_inline]] inline void ContactSolver::solve_normal(const ContactConstraint& c, ConstraintPoint& p, Mover& a,
                                                               Mover& b) const {
  const bool apart = p.bias > 0;
  const bool soft = push == Push::softly && !apart;
  const real mass_scale = soft ? softness_.mass_scale : real(1);
  const real impulse_scale = soft ? softness_.impulse_scale : real(0);
  const real approach = dot(relative_velocity(a, b, p), c.normal);
  const real change = -p.normal_mass * mass_scale * (approach + p.bias) - impulse_scale * p.normal_impulse;
  real impulse = std::max(p.normal_impulse + change, real(0));
  // What has not arrived yet must not be braked when speeds are relaxed: the next substep will, or bounces it.
  if (push == Push::back && apart) impulse = std::min(impulse, p.normal_impulse);
  push_apart(a, b, p, (impulse - p.normal_impulse) * c.normal);
  p.normal_impulse = impulse;
}

// Never inlined, so that it costs the same whether or not there are sweeps that are watched.
template <ContactSolver::Push push, ContactSolver::Look look, bool friction, bool moving, typename Observer>
[[gnu::noinline]] void ContactSolver::sweep_all(std::vector<Motion>& motions, real h, Observer observer) {
  const std::size_t n = constraints_.size();
  for (std::size_t i = 0; i < n; ++i) {
    // Up through the pile, and down again by every other one first: neither direction, nor the side the pile was built
    // from, is favoured. In plain order down a pyramid of fifteen rows rocks for ever.
    const std::size_t at = push == Push::back ? every_other_first(n - 1 - i, n) : i;
    ContactConstraint& c = constraints_[at];
    if (c.exact) continue;
    Motion& motion_a = motions[c.body_a];
    Motion& motion_b = motions[c.body_b];
    if constexpr (look == Look::anew) look_at_gaps<push>(c, motion_a, motion_b, h);
    Mover a = motion_a;
    Mover b = motion_b;
    for (int k = 0; k < c.count; ++k) solve_normal<push>(c, c.points[k], a, b);
    if constexpr (friction) {
      real wanted_slip = 0;
      if constexpr (moving) wanted_slip = surface_speeds_[at];
      for (int k = 0; k < c.count; ++k) solve_friction<moving>(c, c.points[k], a, b, wanted_slip);
    }
    take_speeds(motion_a, a);
    take_speeds(motion_b, b);
    if constexpr (Observer::watches) observer([&] { return swept_event(c); });
  }
}

template <ContactSolver::Push push, ContactSolver::Look look, typename Observer>
void ContactSolver::sweep(std::vector<Motion>& motions, real h, Observer observer) {
  if (!parts_.friction) {
    sweep_all<push, look, false, false>(motions, h, observer);
  } else if (parts_.surface_speed) {
    sweep_all<push, look, true, true>(motions, h, observer);
  } else {
    sweep_all<push, look, true, false>(motions, h, observer);
  }
  rolling_.sweep(constraints_, motions);
  count_swept_rows(parts_.friction ? 2 : 1);
}

/// As many rows at every point, and one for every rolling resistance.
void ContactSolver::count_swept_rows(int at_point) const {
  if (counted_work == nullptr) return;
  int rows = static_cast<int>(rolling_.rows().size());
  for (const ContactConstraint& c : constraints_) rows += c.exact ? 0 : at_point * c.count;
  count_row_updates(static_cast<std::size_t>(rows));
}

void ContactSolver::relax(std::vector<Motion>& motions, real h) {
  sweep<Push::back, Look::anew>(motions, h);
  if (is_soft(method_)) sweep<Push::back, Look::known>(motions, h);
}

/// Springs this stiff need two sweeps; and were there fewer to take the push out again than there are to push, a large
/// pile would gain energy.
template <typename Observer>
void ContactSolver::solve(std::vector<Motion>& motions, real h, Observer observer) {
  switch (method_) {
    case ContactMethod::automatic:
    case ContactMethod::soft_step:
      sweep<Push::softly, Look::anew>(motions, h, observer);
      return sweep<Push::softly, Look::known>(motions, h, observer);
    case ContactMethod::sequential_impulses:
      return sweep<Push::at_once, Look::anew>(motions, h, observer);
    case ContactMethod::ngs:
      return sweep<Push::never, Look::anew>(motions, h, observer);
    case ContactMethod::exact:  // solves them otherwise (exact_contacts.h)
    case ContactMethod::event:
      return;
  }
}

template void ContactSolver::solve<NoObserver>(std::vector<Motion>&, real, NoObserver);
template void ContactSolver::solve<Observer>(std::vector<Motion>&, real, Observer);

/// Separations are those of the moment: what one contact moves the next one sees.
void ContactSolver::push_out(std::vector<Motion>& motions) const {
  for (const ContactConstraint& c : constraints_) {
    Motion& a = motions[c.body_a];
    Motion& b = motions[c.body_b];
    for (int k = 0; k < c.count; ++k) {
      const ConstraintPoint& p = c.points[k];
      const real overlap = separation_of(c, p, a, b) + slop * c.length;
      if (overlap >= 0) continue;
      const real way = std::max(baumgarte * overlap, -longest_move * c.length);
      shift(a, b, p, -p.normal_mass * way * c.normal);
    }
  }
  count_swept_rows(1);
}

namespace {

constexpr int parting_sweeps = 4;

/// How far a point is to be open after bodies have been moved apart for `h` seconds.
real goal_of_parting(const ContactConstraint& c, real separation, real h) {
  const real goal = c.push_speed > 0 ? separation : separation + push_rate * c.length * h;
  return std::min(goal, real(0));
}

}  // namespace

/// What nothing moves has the last word, so that nobody is pushed into the ground.
void ContactSolver::part(std::vector<Motion>& motions, real h) const {
  std::vector<real> goals;
  for (const ContactConstraint& c : constraints_) {
    for (const ConstraintPoint& p : c.points)
      goals.push_back(goal_of_parting(c, separation_of(c, p, motions[c.body_a], motions[c.body_b]), h));
  }
  const auto move = [&](std::size_t i) {
    const ContactConstraint& c = constraints_[i];
    Motion& a = motions[c.body_a];
    Motion& b = motions[c.body_b];
    for (int k = 0; k < c.count; ++k) {
      const real missing = goals[2 * i + static_cast<std::size_t>(k)] - separation_of(c, c.points[k], a, b);
      if (missing > 0) shift(a, b, c.points[k], c.points[k].normal_mass * missing * c.normal);
    }
  };
  for (int sweep = 0; sweep < parting_sweeps; ++sweep) {
    for (std::size_t i = 0; i < constraints_.size(); ++i) move(i);
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      if (motions[constraints_[i].body_a].inv_mass <= 0 || motions[constraints_[i].body_b].inv_mass <= 0) move(i);
    }
  }
}

std::vector<std::uint8_t> ContactSolver::overlapping_bodies(const std::vector<Contact>& contacts,
                                                            std::size_t body_count) const {
  std::vector<std::uint8_t> overlapping;
  for (const ContactConstraint& c : constraints_) {
    if (c.exact || deepest(contacts[c.contact].manifold) >= -deep_part * c.length) continue;
    overlapping.resize(body_count);
    overlapping[c.body_a] = overlapping[c.body_b] = 1;
  }
  return overlapping;
}

void ContactSolver::end_substep() {
  for (ContactConstraint& c : constraints_) {
    for (int k = 0; k < c.count; ++k) {
      c.points[k].normal_total += c.points[k].normal_impulse;
      c.points[k].tangent_total += c.points[k].tangent_impulse;
    }
    c.sliding = slides(c);
  }
  rolling_.end_substep();
}

void ContactSolver::store(std::vector<Contact>& contacts) const {
  for (const ContactConstraint& c : constraints_) {
    contacts[c.contact].sliding = c.sliding;
    contacts[c.contact].patience = c.patience;
    for (int k = 0; k < c.count; ++k) {
      const ConstraintPoint& p = c.points[k];
      contacts[c.contact].impulses[k] = {p.normal_impulse, p.tangent_impulse, p.normal_total, p.tangent_total};
    }
  }
  rolling_.store(constraints_, contacts);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
