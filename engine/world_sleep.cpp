// How islands fall asleep when nothing in them moves any more (sleep.h says when that is), and how they wake.
//
// A sleeper is where it is: its velocity is exactly 0, no force is asked for (`Body::acts_as`), its joints and contacts
// are laid aside with the impulses that hold it, so that it wakes under the load under which it fell asleep.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr real most_rest_ticks = real(1e9);

int whole_ticks(real seconds, int rate) {
  return static_cast<int>(std::ceil(std::min(seconds * static_cast<real>(rate), most_rest_ticks)));
}

/// How long a body must be watched that hangs on this joint `arm` metres from its centre, s.
real rest_time_at(const Joint& joint, real arm, real mass, real gravity) {
  const real hanging = gravity > 0 ? half_swing(arm + joint.length, gravity) : 0;
  const bool sprung = is_springy(joint.kind) && joint.stiffness > 0;
  return sprung ? std::max(hanging, half_swing_on_spring(mass, joint.stiffness)) : hanging;
}

bool comes_first(const Contact& a, const Contact& b) { return a.number < b.number; }

/// Moves the contacts of which `moves` says so to where they belong by their numbers.
template <typename Moves>
void hand_over(std::vector<Contact>& from, std::vector<Contact>& to, const Moves& moves) {
  const auto first =
      std::stable_partition(from.begin(), from.end(), [&](const Contact& contact) { return !moves(contact); });
  const auto middle = to.insert(to.end(), first, from.end());
  std::inplace_merge(to.begin(), middle, to.end(), comes_first);
  from.erase(first, from.end());
}

}  // namespace

/// Bodies that attract others and move make a force that changes while nobody is there to feel it.
bool World::anything_pulls_that_moves() const {
  if (on(Effect::nbody)) return true;
  return on(Effect::attractor) && std::any_of(attractors_.begin(), attractors_.end(), [this](const AttractorDef& a) {
           return a.body && bodies_[static_cast<std::size_t>(*a.body)].type != BodyType::fixed;
         });
}

/// Whether the two surfaces will touch within the next tick as things look now.
bool World::will_press(const Contact& contact) const {
  if (contact.sensor) return false;
  const Motion& a = motions_[contact.body_a];
  const Motion& b = motions_[contact.body_b];
  const Vec2 gain = dt_ * (acceleration_of(contact.body_b) - acceleration_of(contact.body_a));
  for (int k = 0; k < contact.manifold.count; ++k) {
    const ManifoldPoint& p = contact.manifold.points[k];
    const Vec2 parting = b.velocity_at(p.point - contact.a_to_b) - a.velocity_at(p.point) + gain;
    if (p.separation <= dt_ * std::max(real(0), -dot(parting, contact.manifold.normal))) return true;
  }
  return false;
}

/// When joints, shapes or effects have changed.
void World::prepare_sleep() {
  const std::size_t n = bodies_.size();
  const real gravity = length(effective_gravity());
  std::vector<real> seconds(n, 0);
  sleep_.clocks.resize(n);
  sleep_.islands.resize(n, 0);
  sleep_.forces.resize(n);
  sleep_.scales.assign(n, {});
  for (BodyIndex i = 1; i < n; ++i) {
    real& reach = sleep_.scales[i].reach = 0;
    for (const ShapeIndex s : bodies_[i].shapes) reach = std::max(reach, shapes_[s].reach);
    seconds[i] = standing_rest_time(reach, gravity * std::abs(bodies_[i].gravity_scale));
    if (on(Effect::buoyancy)) seconds[i] *= 2;  // what swims swings as a pendulum as long as it is deep
  }
  for (const Joint& joint : joints_) {
    for (const bool at_b : {false, true}) {
      const BodyIndex i = at_b ? joint.body_b : joint.body_a;
      if (!is_solved(joint) || bodies_[i].type != BodyType::dynamic) continue;
      const real arm = length(at_b ? joint.local_b : joint.local_a);
      const real pull = gravity * std::abs(bodies_[i].gravity_scale);
      seconds[i] = std::max(seconds[i], rest_time_at(joint, arm, bodies_[i].mass, pull));
      if (bodies_[i].shapes.empty()) sleep_.scales[i].reach = std::max(sleep_.scales[i].reach, joint.size);
    }
  }
  for (BodyIndex i = 1; i < n; ++i) sleep_.scales[i].ticks = std::max(1, whole_ticks(seconds[i], rate_));
  if (sleep_.sleepers > 0) joint_solver_.lay_aside_sleepers(joints_);
}

/// Joints of sleepers keep the reaction they fell asleep with.
void World::begin_tick_of_sleepers() {
  sleep_.events = std::move(sleep_.next_events);
  sleep_.next_events.clear();
  for (Joint& joint : joints_) {
    if (joint.acts || !joint.alive) forget_reaction(joint);
  }
}

/// At the end of a tick.
void World::look_for_rest() {
  if (sleep_.sleepers > 0) settle_met_sleepers();
  Resting rests(bodies_.size(), 0);
  bool any = false;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    if (bodies_[i].acts_as != BodyType::dynamic) continue;
    bool still = sleep_.clocks[i].look(bodies_[i], motions_[i], sleep_.scales[i], dt_);
    if (still && on(Effect::field)) still = !field_changes(i);
    rests[i] = still ? 1 : 0;
    any |= still;
  }
  if (any && !anything_pulls_that_moves()) put_to_sleep(rests);
}

void World::put_to_sleep(const Resting& rests) {
  const std::vector<std::uint32_t> islands = find_islands(false);
  const std::vector<IslandState> states = judge_islands(islands, rests);
  std::vector<BodyIndex> least(states.size(), 0);
  const int before = sleep_.sleepers;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    const std::uint32_t island = islands[i];
    if (island == 0 || !states[island].may_sleep()) continue;
    if (least[island] == 0) least[island] = i;
    fall_asleep(i, least[island]);
  }
  if (sleep_.sleepers > before) lay_aside_sleepers();
}

void World::fall_asleep(BodyIndex i, BodyIndex island) {
  motions_[i].velocity = {};
  motions_[i].spin = 0;
  set_acting(i, BodyType::fixed);
  sleep_.islands[i] = island;
  sleep_.clocks[i] = {};
  sleep_.events.push_back({static_cast<BodyId>(i), true});
  ++sleep_.sleepers;
}

void World::set_acting(BodyIndex i, BodyType acts_as) {
  bodies_[i].acts_as = acts_as;
  if (i < accelerations_.size()) accelerations_[i] = acceleration_of(i);
  if (i < drags_.size()) drags_[i] = drag_of(i);
}

void World::lay_aside_sleepers() {
  const auto is_still = [this](BodyIndex i) { return bodies_[i].acts_as != BodyType::dynamic && !moves_unpushed(i); };
  hand_over(contacts_, sleep_.contacts, [&](const Contact& c) {
    return (bodies_[c.body_a].asleep() || bodies_[c.body_b].asleep()) && is_still(c.body_a) && is_still(c.body_b);
  });
  sort_out_joints();
}

/// Those of sleepers act no more, those of the awake do.
void World::sort_out_joints() {
  for (Joint& joint : joints_) {
    const Terms terms = bodies_of(joint, joints_);
    bool asleep = false;
    for (int t = 0; t < terms.count; ++t) {
      asleep |= bodies_[terms.terms[t].body_a].asleep() || bodies_[terms.terms[t].body_b].asleep();
    }
    joint.acts = joint.alive && !asleep;
  }
  joint_solver_.lay_aside_sleepers(joints_);
}

/// Contacts with the awake have been solved as if their sleepers could move. What nothing foresaw (a ball that another
/// one passes its momentum on to within one tick) shows when the tick is over, and wakes; what was not pushed in the
/// end has nothing but rounding errors left of it.
void World::settle_met_sleepers() {
  std::vector<BodyIndex> pushed;
  for (const Contact& c : contacts_) {
    for (const BodyIndex i : {c.body_a, c.body_b}) {
      if (!bodies_[i].asleep() || c.sensor || !pushes(c)) continue;
      pushed.push_back(i);
    }
  }
  wake(pushed, Moment::after);
  for (const Contact& c : contacts_) {
    for (const BodyIndex i : {c.body_a, c.body_b}) {
      if (!bodies_[i].asleep()) continue;
      motions_[i].velocity = {};
      motions_[i].spin = 0;
    }
  }
}

/// Asks for the force on a body at rest; true when it is not what it was the last time.
bool World::field_changes(BodyIndex i) {
  const Vec2d before = sleep_.forces[i];
  sleep_.forces[i] = fields_.force_on(bodies_[i], motions_[i], {}, field_time());
  return !(sleep_.forces[i] == before);
}

void World::wake_in_changed_fields() {
  std::vector<BodyIndex> pushed;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    if (bodies_[i].asleep() && field_changes(i)) pushed.push_back(i);
  }
  wake(pushed, Moment::amid);
}

/// Within a tick, when its contacts are known and before they are solved: what wakes one island may reach the next one.
void World::wake_what_is_touched() {
  if (sleep_.sleepers == 0) return;
  if (on(Effect::field)) wake_in_changed_fields();
  for (bool any = true; any;) {
    std::vector<BodyIndex> touched;
    for (const Contact& c : contacts_) {
      const bool meets_sleeper = bodies_[c.body_a].asleep() || bodies_[c.body_b].asleep();
      if (!meets_sleeper || !will_press(c)) continue;
      touched.push_back(c.body_a);
      touched.push_back(c.body_b);
    }
    any = !touched.empty();
    wake(touched, Moment::amid);
  }
}

/// Wakes the islands of those of these bodies that sleep. Amid a tick their contacts must be looked at at once: for all
/// others that was done already.
void World::wake(const std::vector<BodyIndex>& bodies, Moment moment) {
  std::vector<std::uint8_t> wakes(bodies_.size(), 0);  // by the island's least body
  bool any = false;
  for (const BodyIndex i : bodies) {
    if (!bodies_[i].asleep()) continue;
    wakes[sleep_.islands[i]] = 1;
    any = true;
  }
  if (!any) return;
  for (BodyIndex i = 1; i < sleep_.islands.size(); ++i) {
    if (wakes[sleep_.islands[i]] == 0) continue;
    sleep_.islands[i] = 0;
    set_acting(i, bodies_[i].type);
    (moment == Moment::before ? sleep_.next_events : sleep_.events).push_back({static_cast<BodyId>(i), false});
    --sleep_.sleepers;
  }
  const auto is_awake = [this](BodyIndex i) { return bodies_[i].acts_as == BodyType::dynamic; };
  std::vector<Contact> taken_up;
  hand_over(sleep_.contacts, taken_up, [&](const Contact& c) { return is_awake(c.body_a) || is_awake(c.body_b); });
  if (moment == Moment::amid) update_manifolds(taken_up);
  hand_over(taken_up, contacts_, [](const Contact&) { return true; });
  sort_out_joints();
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
