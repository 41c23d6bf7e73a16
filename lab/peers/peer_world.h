#pragma once

/// What a peer's library has to offer to be stepped as a Simulation; the rest, which is the same for all of them, is
/// PeerSimulation's. Units, frames and signs are ours; ids count up from 0 (the world) in order of creation.

#include <vector>

#include "engine/mass.h"
#include "engine/simulation.h"

namespace proofreel {

/// How a body moves.
struct PeerMotion {
  Vec2d position;  ///< of the origin
  double angle = 0;
  Vec2d velocity;  ///< of the centre of mass
  double spin = 0;
};

/// What a joint does to b, mean over the last step.
struct PeerReaction {
  Vec2d force;  ///< N
  double torque = 0;
};

class PeerWorld {
 public:
  virtual ~PeerWorld() = default;
  /// The next id. `mass` is what our engine would give the body.
  virtual void add_body(const BodyDef& def, const MassProperties& mass) = 0;
  /// Its type, shapes, filter and mass become those of `def`; its motion has to be set anew.
  virtual void change_body(BodyId id, const BodyDef& def, const MassProperties& mass) = 0;
  /// It has no joints any more.
  virtual void remove_body(BodyId id) = 0;
  virtual PeerMotion motion(BodyId id) const = 0;
  virtual void set_motion(BodyId id, const PeerMotion& motion) = 0;
  /// N s at a world point.
  virtual void push(BodyId id, Vec2d impulse, Vec2d at) = 0;
  /// During the next step, besides what else does: N on the centre of mass, N m.
  virtual void pull(BodyId id, Vec2d force, double torque) = 0;

  /// The next id. `turn` is the present angle of b against a.
  virtual void add_joint(const JointDef& def, double turn) = 0;
  virtual void remove_joint(JointId id) = 0;
  virtual void set_speed(JointId id, double speed) = 0;
  virtual PeerReaction reaction(JointId id) const = 0;

  /// `dt` in s.
  virtual void step(double dt) = 0;
  /// Of the last step; always in the same order.
  virtual std::vector<ContactView> contacts() const = 0;
  /// What began to touch in the last step.
  virtual const std::vector<ContactEvent>& contact_events() const = 0;
  /// What touched before the last step, or before the commands that led to it, and does not any more.
  virtual const std::vector<SeparationEvent>& separation_events() const = 0;
};

}  // namespace proofreel
