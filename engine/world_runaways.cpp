// Bodies that within a tick have become faster than anybody foresaw (runaways): what rested when the pairs were looked
// for, and was struck since, would fly through a wall that nobody has told it of. At the end of every substep each such
// body is set back to where it first hit something unforeseen, as Box2D does at the end of a step; its speed stays.
// Then its pairs and contacts are looked for again, and the next substep solves them.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/time_of_impact.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Of a body's thickness: overlap to this depth is driven out to where the body came from, even by thinner walls.
constexpr real harmless_part = real(0.25);

real reach_of_turn(Vec2 velocity, real spin, real reach) {
  return std::abs(velocity.x) + std::abs(velocity.y) + std::abs(spin) * reach;
}

/// The way of a body through the substep of `h` seconds that has just moved it.
Sweep way_of(const Body& body, const Motion& m, real h) {
  const Vec2 way = h * m.velocity;
  const real turn = h * m.spin;
  return {{body.center + m.delta - way, turned(m.rotation, -turn)}, way, turn};
}

void set_back(Motion& m, real seconds) {
  if (seconds <= 0) return;
  m.delta -= seconds * m.velocity;
  turn_on(m, -seconds);
}

}  // namespace

/// The paces at which the tick's pairs are looked for.
void World::note_paces() {
  paces_.resize(bodies_.size());
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    Pace& pace = paces_[i];
    pace.velocity = motions_[i].velocity;
    pace.spin = motions_[i].spin;
    pace.reach = 0;
    pace.harmless = std::numeric_limits<real>::infinity();
    for (const ShapeIndex s : bodies_[i].shapes) {
      pace.reach = std::max(pace.reach, shapes_[s].reach);
      pace.harmless = std::min(pace.harmless, harmless_part / dt_ * shapes_[s].hull.thickness);
    }
  }
}

/// Most bodies are too slow for anything here to matter.
bool World::is_fast(BodyIndex i) const {
  return reach_of_turn(motions_[i].velocity, motions_[i].spin, paces_[i].reach) > paces_[i].harmless;
}

bool World::runs_away(BodyIndex i) const {
  const Motion& m = motions_[i];
  const Pace& pace = paces_[i];
  const real unforeseen = reach_of_turn(m.velocity - pace.velocity, m.spin - pace.spin, pace.reach);
  if (!std::isfinite(unforeseen)) return false;  // the tick fails
  return bodies_[i].acts_as == BodyType::dynamic && unforeseen > pace.harmless + fall_of(i) / dt_;
}

void World::catch_runaways(real h) {
  std::vector<BodyIndex> fast;
  for (BodyIndex i = 1; i < paces_.size(); ++i) {
    if (is_fast(i)) fast.push_back(i);
  }
  if (fast.empty()) return;
  const std::vector<std::uint8_t> jointed = jointed_bodies();
  keep_out_of_walls(jointed, h);
  std::erase_if(fast, [this](BodyIndex i) { return !runs_away(i); });
  if (!fast.empty()) look_again(fast, jointed, h);
}

/// What hangs on rigid joints is never moved by itself, since that would tear them apart.
std::vector<std::uint8_t> World::jointed_bodies() const {
  std::vector<std::uint8_t> jointed(bodies_.size(), 0);
  for (const Joint& joint : joints_) {
    if (on(Effect::joints) && joint.acts && !is_soft(joint.kind)) jointed[joint.body_a] = jointed[joint.body_b] = 1;
  }
  return jointed;
}

/// A sweep may leave what one fast body presses against a wall some speed into it, enough to pass it within a substep:
/// what nothing moves has the last word.
void World::keep_out_of_walls(const std::vector<std::uint8_t>& jointed, real h) {
  for (const ContactConstraint& c : contact_solver_.constraints()) {
    Motion& a = motions_[c.body_a];
    Motion& b = motions_[c.body_b];
    if ((a.inv_mass > 0) == (b.inv_mass > 0)) continue;
    const BodyIndex mover = a.inv_mass > 0 ? c.body_a : c.body_b;
    if (jointed[mover] != 0 || !is_fast(mover)) continue;
    for (int k = 0; k < c.count; ++k) {
      const ConstraintPoint& p = c.points[k];
      const real speed = dot(b.velocity_at(p.arm_b) - a.velocity_at(p.arm_a), c.normal);
      const real deeper = std::min(-separation_of(c, p, a, b), -h * speed);
      if (deeper > 0) shift(a, b, p, p.normal_mass * deeper * c.normal);
    }
  }
}

void World::look_again(const std::vector<BodyIndex>& runaways, const std::vector<std::uint8_t>& jointed, real h) {
  std::vector<std::uint8_t> runs(bodies_.size(), 0);
  for (const BodyIndex i : runaways) {
    runs[i] = 1;
    const Sweep way = way_of(bodies_[i], motions_[i], h);
    for (const ShapeIndex s : bodies_[i].shapes) {
      const real margin = std::abs(way.turn) * shapes_[s].reach + fall_of(i) + near_part * shapes_[s].hull.thickness;
      broad_phase_.move(s, shapes_[s], expanded(bounds(shapes_[s].hull, way.start), margin),
                        (h + dt_) * motions_[i].velocity);
    }
    paces_[i].velocity = motions_[i].velocity;
    paces_[i].spin = motions_[i].spin;
  }
  add_new_pairs();
  const std::vector<std::uint32_t> unforeseen = unforeseen_contacts(runs);
  for (BodyIndex i = 0; i < bodies_.size(); ++i) runs[i] &= static_cast<std::uint8_t>(1 - jointed[i]);
  hold_back(unforeseen, runs, h);
  for (const std::uint32_t i : unforeseen) {
    update_manifold(contacts_[i], shapes_, bodies_, motions_, {dt_, true, accelerations_});
  }
  contact_solver_.take_in(unforeseen, contacts_, shapes_, motions_);
  if (may_be_exact()) prepare_exact_contacts();
}

/// The contacts of these bodies that have not pressed in this tick yet, in order.
std::vector<std::uint32_t> World::unforeseen_contacts(const std::vector<std::uint8_t>& runs) const {
  std::vector<std::uint8_t> presses(contacts_.size(), 0);
  for (const ContactConstraint& c : contact_solver_.constraints()) {
    for (int k = 0; k < c.count; ++k) {
      if (c.points[k].normal_total > 0 || c.points[k].normal_impulse > 0) presses[c.contact] = 1;
    }
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < contacts_.size(); ++i) {
    const Contact& c = contacts_[i];
    const bool concerned = runs[c.body_a] != 0 || runs[c.body_b] != 0;
    if (concerned && presses[i] == 0 && !c.sensor && !hinged_together(c.body_a, c.body_b)) found.push_back(i);
  }
  return found;
}

/// Sets runaways back to the time of their first hit within the last `h` seconds. Contacts that have points were
/// solved.
void World::hold_back(const std::vector<std::uint32_t>& unforeseen, const std::vector<std::uint8_t>& runs, real h) {
  std::vector<real> free_part(bodies_.size(), 1);
  for (const std::uint32_t i : unforeseen) {
    const Contact& c = contacts_[i];
    if (c.manifold.count > 0 || (runs[c.body_a] == 0 && runs[c.body_b] == 0)) continue;
    const real tolerance = real(0.25) * near_part * pair_length(shapes_[c.shape_a], shapes_[c.shape_b]);
    const TimeOfImpact hit =
        time_of_impact(shapes_[c.shape_a].hull, way_of(bodies_[c.body_a], motions_[c.body_a], h),
                       shapes_[c.shape_b].hull, way_of(bodies_[c.body_b], motions_[c.body_b], h), tolerance, tolerance);
    if (hit.state == ImpactState::separated || hit.state == ImpactState::touching_at_start) continue;
    for (const BodyIndex body : {c.body_a, c.body_b}) {
      if (runs[body] != 0) free_part[body] = std::min(free_part[body], hit.fraction);
    }
  }
  for (BodyIndex i = 1; i < bodies_.size(); ++i) set_back(motions_[i], (1 - free_part[i]) * h);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
