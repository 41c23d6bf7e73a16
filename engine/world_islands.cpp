// Islands (islands.h) of the bodies in a world, and whether what holds or drives them lets them fall asleep.

#include <algorithm>

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

bool holds(const Joint& joint) { return !(joint.impulse == Vec2{}) || joint.twist != 0; }

}  // namespace

bool World::moves_unpushed(BodyIndex i) const {
  const bool moves = !(motions_[i].velocity == Vec2{}) || motions_[i].spin != 0;
  return bodies_[i].type == BodyType::kinematic && moves;
}

bool World::is_solved(const Joint& joint) const {
  if (joint.kind == JointKind::spring) return joint.alive && on(Effect::springs);
  return joint.alive && on(joint.kind == JointKind::drag_to ? Effect::motors : Effect::joints);
}

bool World::is_driven(const Joint& joint) const {
  const Terms terms = bodies_of(joint, joints_);
  for (int t = 0; t < terms.count; ++t) {
    if (moves_unpushed(terms.terms[t].body_a) || moves_unpushed(terms.terms[t].body_b)) return true;
  }
  if (!on(Effect::motors)) return false;
  const bool turns = joint.motor && joint.motor->speed != 0 && joint.motor->strongest > 0;
  return turns || (joint.kind == JointKind::motor && joint.max_force > 0 && !(joint.velocity == Vec2{}));
}

std::vector<std::uint32_t> World::find_islands(bool sleepers_too) const {
  std::vector<std::uint8_t> takes_part(bodies_.size(), 0);
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    const bool dynamic = (sleepers_too ? bodies_[i].type : bodies_[i].acts_as) == BodyType::dynamic;
    takes_part[i] = dynamic && bodies_[i].alive ? 1 : 0;
  }
  std::vector<Link> links;
  const auto add = [&](const Contact& contact) {
    if (contact.touching && !contact.sensor) links.push_back({contact.body_a, contact.body_b});
  };
  for (const Contact& contact : contacts_) add(contact);
  if (sleepers_too) std::for_each(sleep_.contacts.begin(), sleep_.contacts.end(), add);
  for (const Joint& joint : joints_) {
    if (is_solved(joint)) add_links(joint, links);
  }
  return number_islands(takes_part, links);
}

/// A gear couples what two other joints hold; of all these bodies those that forces move hang together.
void World::add_links(const Joint& joint, std::vector<Link>& links) const {
  const Terms terms = bodies_of(joint, joints_);
  BodyIndex first = 0;
  for (int t = 0; t < terms.count; ++t) {
    for (const BodyIndex i : {terms.terms[t].body_a, terms.terms[t].body_b}) {
      if (bodies_[i].type != BodyType::dynamic) continue;
      if (first != 0) links.push_back({first, i});
      first = i;
    }
  }
}

/// By number; 0 stands for all that is no part of any.
std::vector<IslandState> World::judge_islands(const std::vector<std::uint32_t>& islands, const Resting& rests) const {
  std::vector<IslandState> states(bodies_.size());
  const auto look_at = [&](BodyIndex i, BodyIndex other, bool held, bool driven) {
    IslandState& state = states[islands[i]];
    state.held |= held && bodies_[other].type != BodyType::dynamic;
    state.driven |= driven || moves_unpushed(other);
  };
  for (BodyIndex i = 1; i < bodies_.size(); ++i) states[islands[i]].rests &= rests[i] != 0;
  for (const Contact& c : contacts_) {
    if (c.sensor || c.manifold.count == 0) continue;
    const auto restless = [&](BodyIndex i) { return islands[i] != 0 && rests[i] == 0; };
    const bool rubs = on(Effect::surface_speed) && c.touching && c.surface_speed != 0;
    // What lifts off for a moment will be back.
    look_at(c.body_a, c.body_b, pushes(c), rubs || restless(c.body_b));
    look_at(c.body_b, c.body_a, pushes(c), rubs || restless(c.body_a));
  }
  for (const Joint& joint : joints_) {
    if (!is_solved(joint)) continue;
    const Terms terms = bodies_of(joint, joints_);
    const bool driven = is_driven(joint);
    for (int t = 0; t < terms.count; ++t) {
      look_at(terms.terms[t].body_a, terms.terms[t].body_b, holds(joint), driven);
      look_at(terms.terms[t].body_b, terms.terms[t].body_a, holds(joint), driven);
    }
  }
  for (const Rocket& rocket : rockets_) states[islands[rocket.body]].driven |= on(Effect::rocket) && rocket.fuel > 0;
  return states;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
