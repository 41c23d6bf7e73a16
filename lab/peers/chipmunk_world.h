#pragma once

#include <memory>

#include "lab/peers/peer_world.h"
#include "lab/peers/peers.h"

namespace proofreel {

/// Chipmunk 7. `gravity` in m/s^2.
std::unique_ptr<PeerWorld> make_chipmunk_world(Vec2d gravity, PeerPreset preset);
PeerFacts chipmunk_facts(PeerPreset preset);

}  // namespace proofreel
