#include "lab/peer_box2d.h"

#include <box2d/box2d.h>

#include <vector>

namespace proofreel {
namespace {

b2Vec2 to_b2(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

/// Full size: shrunk by the skin Box2D keeps round polygons, a tall pyramid collapses, which would be no fair peer.
b2PolygonShape box_of(const ShapeDef& def) {
  const b2Vec2 corner = b2Abs(to_b2(def.points[0]));
  b2PolygonShape shape;
  shape.SetAsBox(corner.x, corner.y);
  return shape;
}

void add_shape(b2Body& body, const ShapeDef& def) {
  const b2PolygonShape shape = box_of(def);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = static_cast<float>(def.density);
  fixture.friction = static_cast<float>(def.friction.at_rest);  // Box2D has one coefficient
  fixture.restitution = static_cast<float>(def.restitution);
  body.CreateFixture(&fixture);
}

b2Body* add_body(b2World& world, const BodyDef& def) {
  b2BodyDef body;
  body.type = def.type == BodyType::dynamic ? b2_dynamicBody : b2_staticBody;
  body.position = to_b2(def.position);
  body.angle = static_cast<float>(def.angle);
  b2Body* added = world.CreateBody(&body);
  for (const ShapeDef& shape : def.shapes) add_shape(*added, shape);
  return added;
}

}  // namespace

struct Box2dPeer::Impl {
  b2World world;
  std::vector<b2Body*> bodies;  // owned by the world
};

Box2dPeer::Box2dPeer(const Scene& scene) : impl_(new Impl{b2World(to_b2(scene.gravity)), {}}) {
  impl_->world.SetAllowSleeping(false);
  for (const BodyDef& body : scene.bodies) impl_->bodies.push_back(add_body(impl_->world, body));
}

Box2dPeer::~Box2dPeer() = default;

void Box2dPeer::step() { impl_->world.Step(1.0F / rate, 8, 3); }

Vec2d Box2dPeer::position(BodyId body) const {
  const b2Vec2 p = impl_->bodies[static_cast<std::size_t>(body) - 1]->GetPosition();
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

}  // namespace proofreel
