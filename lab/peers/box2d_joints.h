#pragma once

/// Our joints as Box2D's.

#include <box2d/box2d.h>

#include "engine/scene.h"

namespace proofreel {

/// What a new joint holds on to.
struct Box2dJointEnds {
  b2Body* a = nullptr;
  b2Body* b = nullptr;
  double turn = 0;           ///< present angle of b against a
  b2Joint* first = nullptr;  ///< of a gear
  b2Joint* second = nullptr;
};

b2Joint* add_joint(b2World& world, const JointDef& def, const Box2dJointEnds& ends);
/// Of its motor.
void set_motor_speed(b2Joint& joint, double speed);

}  // namespace proofreel
