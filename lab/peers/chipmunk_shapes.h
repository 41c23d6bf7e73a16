#pragma once

/// Our shapes as Chipmunk's, which has all of them.

#include <chipmunk/chipmunk.h>

#include <vector>

#include "engine/scene.h"

namespace proofreel {

inline cpVect to_cp(Vec2d v) { return cpv(v.x, v.y); }
inline Vec2d from_cp(cpVect v) { return {v.x, v.y}; }

/// The body's shapes, each owned by the caller and in no space yet. Where Chipmunk multiplies the coefficients of two
/// shapes, ours is sqrt(a b), so each gets the square root of its own. Its restitution has to be mixed at each contact.
std::vector<cpShape*> make_shapes(cpBody* body, const BodyDef& def);

}  // namespace proofreel
