#pragma once

/// A peer's world behind our Simulation interface: keeps the scene's definitions beside it, applies the forces it does
/// not know, and tells what happened in our words.

#include "lab/peers/peer_forces.h"
#include "lab/peers/peer_world.h"
#include "lab/peers/peers.h"

namespace proofreel {

class PeerSimulation final : public Simulation {
 public:
  /// The scene has no problem for this peer; the world is empty but for body 0.
  PeerSimulation(Peer peer, const Scene& scene, std::unique_ptr<PeerWorld> world);

  void step() override;
  void apply(const Command& command) override;
  std::int64_t tick() const override { return tick_; }
  const std::vector<ContactEvent>& contact_events() const override { return world_->contact_events(); }
  const std::vector<SeparationEvent>& separation_events() const override { return world_->separation_events(); }
  const std::vector<BreakEvent>& break_events() const override { return break_events_; }
  bool exists(BodyId body) const override;
  bool exists(JointId joint) const override;
  BodyState body(BodyId body) const override;
  JointView joint(JointId joint) const override;
  std::vector<ContactView> contacts() const override { return world_->contacts(); }
  void observe(Snapshot& snapshot) const override;
  Energy energy() const override;
  bool books_work() const override { return false; }
  std::uint64_t state_hash() const override;
  const std::optional<Failure>& failure() const override { return failure_; }
  void keep_forces() override { forces_kept_ = true; }

 private:
  struct KeptBody {
    BodyDef def;
    MassProperties mass;
    bool alive = true;
    Vec2d velocity_before;  ///< at the start of the last tick
  };
  struct KeptJoint {
    JointDef def;
    bool alive = true;
    bool broken = false;
  };

  void execute(const CreateBody& command);
  void execute(const ChangeBody& command);
  void execute(const RemoveBody& command);
  void execute(const ApplyImpulse& command);
  void execute(const ApplyForce& command);
  void execute(const ApplyTorque& command);
  void execute(const CreateJoint& command);
  void execute(const RemoveJoint& command);
  void execute(const ChangeJoint& command);
  void execute(const WakeBody&) {}  // nothing sleeps
  void execute(const AllowSleep& command);

  void add_body(const BodyDef& def);
  void add_joint(const JointDef& def);
  void remove_joint(JointId id);
  void pull_all();
  void break_joints();
  void detect_failure();
  std::vector<LoadedBody> loaded_bodies(bool with_places) const;
  double potential_energy() const;
  Vec2d anchor(BodyId body, Vec2d local) const;
  KeptBody& kept(BodyId id) { return bodies_[static_cast<std::size_t>(id)]; }
  const KeptBody& kept(BodyId id) const { return bodies_[static_cast<std::size_t>(id)]; }
  void observe_body(BodyId id, Snapshot& snapshot) const;

  Peer peer_;
  int rate_;
  Vec2d gravity_;
  PeerForces forces_;
  std::unique_ptr<PeerWorld> world_;
  std::vector<KeptBody> bodies_;
  std::vector<KeptJoint> joints_;
  bool body_drags_ = false;  ///< some body has a drag of its own
  bool breakable_ = false;
  bool forces_kept_ = false;
  bool commanded_ = false;  ///< since the last tick
  double booked_work_ = 0;
  std::vector<BreakEvent> break_events_;
  std::int64_t tick_ = 0;
  std::optional<Failure> failure_;
};

}  // namespace proofreel
