#pragma once

/// Which effects a scene calls for. A scene pays only for what is on.

#include "engine/scene.h"

namespace proofreel {

/// Counts what a scene holds, to infer from it what must be simulated. Only ever grows: an effect that is on with
/// nothing to act on changes no bit of the motion.
class EffectCensus {
 public:
  explicit EffectCensus(Vec2d gravity) : gravity_(gravity) {}
  void add(const BodyDef& body);
  void add(const JointDef& joint);
  EffectSet inferred() const;

 private:
  Vec2d gravity_;
  int bodies_with_shapes_ = 0;
  bool dynamic_shape_ = false;
  bool friction_ = false;
  bool restitution_ = false;
  bool sensor_ = false;
  bool spring_ = false;
  bool rigid_joint_ = false;
};

/// The effects a simulation of this scene runs: its list, or what can be inferred from what it holds.
EffectSet effects_of(const Scene& scene);

/// As the scenario language writes it.
const char* name_of(Effect effect);

}  // namespace proofreel
