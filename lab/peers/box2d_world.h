#pragma once

#include <memory>

#include "lab/peers/peer_world.h"
#include "lab/peers/peers.h"

namespace proofreel {

/// Box2D 2.4. `gravity` in m/s^2.
std::unique_ptr<PeerWorld> make_box2d_world(Vec2d gravity, PeerPreset preset);
PeerFacts box2d_facts(PeerPreset preset);

}  // namespace proofreel
