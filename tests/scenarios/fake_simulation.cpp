#include "fake_simulation.h"

namespace proofreel {

FakeSimulation::FakeSimulation(const Scene& scene) : rate_(scene.rate) {
  for (const BodyDef& def : scene.bodies) add(def);
  for (const JointDef& joint : scene.joints) joints_.emplace_back(joint, true);
}

void FakeSimulation::add(const BodyDef& def) { fliers_.push_back({initial_state(def), false}); }

void FakeSimulation::step() {
  ++tick_;
  for (Flier& f : fliers_) {
    f.state.position += (1.0 / rate_) * f.state.velocity;
    f.state.center += (1.0 / rate_) * f.state.velocity;
    f.state.angle += f.state.spin / rate_;
  }
  separations_ = separations_at.contains(tick_) ? separations_at[tick_] : std::vector<SeparationEvent>{};
  events_ = events_at.contains(tick_) ? events_at[tick_] : std::vector<ContactEvent>{};
  if (fails_at == tick_) failure_ = Failure{tick_, static_cast<BodyId>(1), "the drift"};
}

void FakeSimulation::apply(const Command& command) {
  log.push_back(command);
  if (const auto* create = std::get_if<CreateBody>(&command)) add(create->def);
  if (const auto* joint = std::get_if<CreateJoint>(&command)) joints_.emplace_back(joint->def, true);
  if (const auto* remove = std::get_if<RemoveBody>(&command)) flier(remove->body).removed = true;
  if (const auto* remove = std::get_if<RemoveJoint>(&command)) {
    joints_[static_cast<std::size_t>(remove->joint)].second = false;
  }
  if (const auto* change = std::get_if<ChangeBody>(&command)) {
    BodyState& state = flier(change->body).state;
    state.velocity = change->velocity.value_or(state.velocity);
    state.spin = change->spin.value_or(state.spin);
    state.position = change->position.value_or(state.position);
  }
}

bool FakeSimulation::exists(BodyId body) const {
  const auto index = static_cast<std::size_t>(body);
  return index == 0 || (index <= fliers_.size() && !fliers_[index - 1].removed);
}

bool FakeSimulation::exists(JointId joint) const {
  const auto& [def, there] = joints_[static_cast<std::size_t>(joint)];
  return there && exists(def.a) && exists(def.b);
}

BodyState FakeSimulation::body(BodyId body) const { return fliers_[static_cast<std::size_t>(body) - 1].state; }

JointView FakeSimulation::joint(JointId joint) const {
  JointView view;
  view.id = joint;
  view.reaction = {3, 4};
  view.gap = 0.25;
  return view;
}

void FakeSimulation::observe(Snapshot& snapshot) const {
  snapshot = {};
  snapshot.tick = tick_;
  snapshot.time = static_cast<double>(tick_) / rate_;
  snapshot.contacts = touching;
  for (std::size_t i = 0; i < fliers_.size(); ++i) {
    if (fliers_[i].removed) continue;
    BodyView view;
    view.id = static_cast<BodyId>(i + 1);
    view.state = fliers_[i].state;
    view.pose = Posed{view.state.position, Rotd{view.state.angle}};
    view.force = {0, -2};
    view.first_shape = static_cast<std::uint32_t>(snapshot.shapes.size());
    view.shape_count = 1;
    snapshot.shapes.push_back({static_cast<std::uint32_t>(snapshot.points.size()), 1, 0.5});
    snapshot.points.push_back({});
    snapshot.bodies.push_back(view);
  }
}

Energy FakeSimulation::energy() const {
  Energy energy;
  for (const Flier& f : fliers_) energy.kinetic += 0.5 * f.state.mass * length_squared(f.state.velocity);
  return energy;
}

std::uint64_t FakeSimulation::state_hash() const { return static_cast<std::uint64_t>(tick_) + 1000 * fliers_.size(); }

}  // namespace proofreel
