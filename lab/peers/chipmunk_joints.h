#pragma once

/// Our joints as Chipmunk's constraints.

#include <chipmunk/chipmunk.h>

#include <vector>

#include "engine/scene.h"
#include "lab/peers/peer_world.h"

namespace proofreel {

using ChipmunkParts = std::vector<cpConstraint*>;

/// One joint is often several constraints: a slider is a groove and a gear that keeps it from turning, a wheel a groove
/// and a spring along it; stops and motors are constraints of their own. Owned by the caller, in no space yet. `turn`
/// is the present angle of b against a.
ChipmunkParts make_joint(const JointDef& def, cpBody* a, cpBody* b, double turn);
/// Of its motor.
void set_motor_speed(const ChipmunkParts& joint, double speed);
/// What all parts did to b in the last step of `dt` seconds.
PeerReaction reaction_of(const ChipmunkParts& joint, double dt);

}  // namespace proofreel
