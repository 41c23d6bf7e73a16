#pragma once

#include <memory>

#include "lab/peers/peer_world.h"
#include "lab/peers/peers.h"

namespace proofreel {

/// Chipmunk 7. `gravity` in m/s^2.
std::unique_ptr<PeerWorld> make_chipmunk_world(Vec2d gravity);
PeerFacts chipmunk_facts();

}  // namespace proofreel
