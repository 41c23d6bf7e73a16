#include "scenarios/replay.h"

#include <cmath>

namespace proofreel {
namespace {

class Sense {
 public:
  explicit Sense(const Simulation& simulation) : simulation_(simulation) {}

  bool operator()(const CreateBody& c) const { return !problem_with(c.def); }
  bool operator()(const ChangeBody& c) const {
    BodyDef def;
    def.type = BodyType::fixed;
    def.position = c.position.value_or(def.position);
    def.angle = c.angle.value_or(0);
    def.shapes = c.shapes.value_or(def.shapes);
    def.mass = c.mass;
    def.inertia = c.inertia;
    return is_own(c.body) && !problem_with(def);
  }
  bool operator()(const RemoveBody& c) const { return is_own(c.body); }
  bool operator()(const ApplyImpulse& c) const { return is_own(c.body) && is_finite(c.impulse); }
  bool operator()(const ApplyForce& c) const { return is_own(c.body) && is_finite(c.force); }
  bool operator()(const ApplyTorque& c) const { return is_own(c.body) && std::isfinite(c.torque); }
  bool operator()(const CreateJoint& c) const {
    if (!simulation_.exists(c.def.a) || !simulation_.exists(c.def.b)) return false;
    return c.def.kind != JointKind::gear || (has_coordinate(c.def.first) && has_coordinate(c.def.second));
  }
  bool operator()(const WakeBody& c) const { return is_own(c.body); }
  bool operator()(const AllowSleep&) const { return true; }
  bool operator()(const RemoveJoint& c) const { return simulation_.exists(c.joint); }
  bool operator()(const ChangeJoint& c) const { return simulation_.exists(c.joint); }

 private:
  bool is_own(BodyId body) const { return body != BodyId::world && simulation_.exists(body); }
  bool has_coordinate(JointId joint) const {
    if (!simulation_.exists(joint)) return false;
    const JointKind kind = simulation_.joint(joint).kind;
    return kind == JointKind::revolute || kind == JointKind::prismatic;
  }

  const Simulation& simulation_;
};

}  // namespace

bool makes_sense(const Command& command, const Simulation& simulation) {
  return std::visit(Sense(simulation), command);
}

void Replay::act(bool heard, Simulation& simulation, Script& script) {
  const std::vector<LoggedCommand>& log = run_.log;
  for (; next_ < log.size() && log[next_].tick == simulation.tick() && log[next_].heard == heard; ++next_) {
    const Command& command = log[next_].command;
    if (!makes_sense(command, simulation))
      throw ScenarioError(file_ + " cannot be resumed: a command in it makes no sense");
    simulation.apply(command);
    script.adopt(command);
  }
}

bool Replay::ended_elsewhere(const Simulation& simulation, std::uint64_t trajectory_hash) const {
  const bool comparable = simulation.failure() || simulation.tick() == run_.logged_until;
  return comparable && trajectory_hash != run_.last_trajectory_hash;
}

}  // namespace proofreel
