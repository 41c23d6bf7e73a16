#pragma once

/// Our shapes as Box2D's.

#include <box2d/box2d.h>

#include <vector>

#include "engine/scene.h"

namespace proofreel {

inline b2Vec2 to_b2(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
inline Vec2d from_b2(b2Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// What has to be known of a fixture when it touches.
struct Box2dFixture {
  double skin = 0;  ///< m that Box2D's shape is larger than ours
  double surface_speed = 0;
};

/// Gives the body fixtures without mass, several where Box2D has no shape of the kind: polygons of more than 8 corners
/// are cut along chords, capsules become a box and two discs. Polygons keep their full size, with Box2D's skin outside:
/// shrunk by it, a tall pyramid collapses, which would be no fair peer. Appends what is to be remembered of each; its
/// place in the list is the fixture's user data.
void add_fixtures(b2Body& body, const BodyDef& def, std::vector<Box2dFixture>& fixtures);

}  // namespace proofreel
