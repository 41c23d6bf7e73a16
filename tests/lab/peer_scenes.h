#pragma once

/// What is claimed of every peer.

#include <catch2/catch.hpp>

#include "lab/peers/peers.h"
#include "tests/lab/lab_scenes.h"

namespace proofreel::test {

inline constexpr double g = 9.81;
inline constexpr auto first = static_cast<BodyId>(1);
inline constexpr auto second = static_cast<BodyId>(2);

/// Whose turn it is: every claim holds for both.
inline Peer each_peer() { return GENERATE(Peer::box2d, Peer::chipmunk); }

}  // namespace proofreel::test
