#pragma once

/// What a peer lacks, as clauses: "it has rolling resistance, which Box2D does not know".

#include <optional>
#include <string>

#include "lab/peers/peers.h"

namespace proofreel {

using Problem = std::optional<std::string>;

// By the library alone (box2d_shapes.cpp, box2d_joints.cpp and so on).
Problem problem_for_box2d(const BodyDef& body);
Problem problem_for_box2d(const JointDef& joint);
Problem problem_for_chipmunk(const BodyDef& body);
Problem problem_for_chipmunk(const JointDef& joint);

/// With what no peer knows.
Problem problem_with(Peer peer, const BodyDef& body);
Problem problem_with(Peer peer, const JointDef& joint);

/// The whole sentence.
std::string sentence(Peer peer, const BodyDef& body, std::size_t number, const std::string& clause);
std::string sentence(Peer peer, const JointDef& joint, std::size_t number, const std::string& clause);

}  // namespace proofreel
