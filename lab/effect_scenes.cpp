#include "lab/effect_scenes.h"

namespace proofreel {
namespace {

constexpr double spacing = 3;

/// Discs of 1 m in rows, far from each other, which never meet.
Scene discs(int bodies) {
  Scene scene;
  for (int i = 0; i < bodies; ++i) {
    ShapeDef disc;
    disc.points = {{0, 0}};
    disc.radius = 1;
    disc.friction = {0, 0};
    BodyDef body;
    body.position = {spacing * (i % 100), spacing * static_cast<double>(i / 100)};
    body.velocity = {0.5, 0.25};
    body.shapes = {disc};
    body.filter.group = -1;
    scene.bodies.push_back(body);
  }
  return scene;
}

Scene weightless(int bodies) {
  Scene scene = discs(bodies);
  scene.gravity = {0, 0};
  return scene;
}

Scene spinning(int bodies) {
  Scene scene = discs(bodies);
  for (BodyDef& body : scene.bodies) body.spin = 1;
  return scene;
}

Scene dragged(int bodies) {
  Scene scene = discs(bodies);
  scene.drag = {0.1, 0.01, 0};
  return scene;
}

Scene blown(int bodies) {
  Scene scene = dragged(bodies);
  scene.wind = {2, 0};
  return scene;
}

Scene attracted(int bodies) {
  Scene scene = discs(bodies);
  scene.attractors = {{std::nullopt, {0, -50}, 100, AttractionLaw::inverse_square}};
  return scene;
}

Scene on_springs(int bodies) {
  Scene scene = discs(bodies);
  for (int i = 0; i < bodies; ++i) {
    JointDef spring;
    spring.kind = JointKind::spring;
    spring.b = static_cast<BodyId>(i + 1);
    spring.anchor_a = scene.bodies[static_cast<std::size_t>(i)].position + Vec2d{0, 1};
    spring.length = 1;
    spring.stiffness = 50;
    scene.joints.push_back(spring);
  }
  return scene;
}

Scene on_pins(int bodies) {
  Scene scene = on_springs(bodies);
  for (JointDef& joint : scene.joints) joint.kind = JointKind::distance;
  return scene;
}

/// Each disc on a floor of its own.
Scene at_rest(int bodies) {
  Scene scene = discs(bodies);
  BodyDef floor;
  floor.type = BodyType::fixed;
  for (BodyDef& body : scene.bodies) {
    body.filter.group = 0;
    body.velocity = {};
    ShapeDef slab;
    slab.points = {body.position + Vec2d{-1.2, -1.4}, body.position + Vec2d{1.2, -1.4}, body.position + Vec2d{1.2, -1},
                   body.position + Vec2d{-1.2, -1}};
    slab.friction = {0, 0};
    floor.shapes.push_back(slab);
  }
  scene.bodies.push_back(floor);
  return scene;
}

Scene set_for_all(Scene scene, FrictionDef friction, double restitution) {
  for (BodyDef& body : scene.bodies) {
    for (ShapeDef& shape : body.shapes) {
      shape.friction = friction;
      shape.restitution = restitution;
    }
  }
  return scene;
}

Scene rubbing(int bodies) { return set_for_all(at_rest(bodies), {0.5, 0.5}, 0); }
Scene springy(int bodies) { return set_for_all(at_rest(bodies), {0, 0}, 0.5); }

Scene resisting(int bodies) {
  Scene scene = rubbing(bodies);
  for (BodyDef& body : scene.bodies) {
    for (ShapeDef& shape : body.shapes) shape.rolling_resistance = 0.01;
  }
  return scene;
}

Scene on_belts(int bodies) {
  Scene scene = rubbing(bodies);
  for (ShapeDef& slab : scene.bodies.back().shapes) slab.surface_speed = -0.2;
  return scene;
}

/// Half a second at rest is more than what is measured: this is what it takes to watch bodies that are awake. (Those
/// asleep take almost nothing.)
Scene drowsy(int bodies) {
  Scene scene = rubbing(bodies);
  scene.sleeping = true;
  return scene;
}

Scene floating(int bodies) {
  Scene scene = discs(bodies);
  scene.water = WaterDef{0, 3, 0.5};
  return scene;
}

Scene in_a_field(int bodies) {
  Scene scene = discs(bodies);
  scene.fields.emplace_back([](Vec2d, Vec2d velocity, double) { return Vec2d{2 * velocity.y, -2 * velocity.x}; });
  return scene;
}

/// Each disc on a hinge a metre above it.
Scene hinged(int bodies) {
  Scene scene = on_springs(bodies);
  for (JointDef& joint : scene.joints) {
    joint.kind = JointKind::revolute;
    joint.anchor_b = {0, 1};
  }
  return scene;
}

Scene stopped(int bodies) {
  Scene scene = hinged(bodies);
  for (JointDef& joint : scene.joints) joint.limits = LimitsDef{-0.02, 0.02};
  return scene;
}

Scene driven(int bodies) {
  Scene scene = hinged(bodies);
  for (JointDef& joint : scene.joints) joint.motor = MotorDef{1, 100};
  return scene;
}

Scene breakable(int bodies) {
  Scene scene = hinged(bodies);
  for (JointDef& joint : scene.joints) joint.break_force = 1e6;
  return scene;
}

}  // namespace

const std::vector<EffectScene>& effect_scenes() {
  static const std::vector<EffectScene> scenes{
      {"nothing", weightless},     {"gravity", discs},       {"gravity, turning", spinning},
      {"drag", dragged},           {"wind", blown},          {"attractor", attracted},
      {"springs", on_springs},     {"joints", on_pins},      {"contacts", at_rest},
      {"friction", rubbing},       {"restitution", springy}, {"rolling_resistance", resisting},
      {"surface_speed", on_belts}, {"buoyancy", floating},   {"field", in_a_field},
      {"hinges", hinged},          {"limits", stopped},      {"motors", driven},
      {"breakage", breakable},     {"sleeping", drowsy}};
  return scenes;
}

}  // namespace proofreel
