#include "lab/mixed_scenes.h"

namespace proofreel {
namespace {

/// Discs, capsules, triangles and rounded boxes that fall into a heap, with everything contacts can do.
Scene heap(int count) {
  const std::vector<std::vector<Vec2d>> outlines{{{0, 0}},
                                                 {{-0.3, 0}, {0.3, 0}},
                                                 {{-0.4, -0.3}, {0.4, -0.3}, {0, 0.5}},
                                                 {{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}}};
  Scene scene;
  BodyDef floor;
  floor.type = BodyType::fixed;
  floor.shapes.emplace_back().points = {{-20, -1}, {20, -1}, {20, 0}, {-20, 0}};
  scene.bodies.push_back(floor);
  for (int i = 0; i < count; ++i) {
    BodyDef body;
    body.position = {0.3 * (i % 4), 1 + 0.7 * i};
    body.spin = 1 - 0.1 * i;
    ShapeDef& shape = body.shapes.emplace_back();
    shape.points = outlines[static_cast<std::size_t>(i) % outlines.size()];
    shape.radius = shape.points.size() == 3 ? 0 : 0.2;
    shape.friction = {0.6, 0.4};
    shape.restitution = i % 3 == 0 ? 0.5 : 0;
    scene.bodies.push_back(body);
  }
  return scene;
}

/// One joint of every kind that no other scene has, each on a disc of its own.
Scene linkage(int) {
  Scene scene;
  for (int i = 0; i < 10; ++i) {
    BodyDef disc;
    disc.position = {2.0 * i, 0};
    disc.filter.group = -1;
    disc.shapes.emplace_back().points = {{0, 0}};
    disc.shapes.back().radius = 0.5;
    scene.bodies.push_back(disc);
  }
  const auto join = [&](JointKind kind, unsigned body) -> JointDef& {
    JointDef& joint = scene.joints.emplace_back();
    joint.kind = kind;
    joint.b = static_cast<BodyId>(body + 1);
    joint.anchor_a = scene.bodies[body].position;
    return joint;
  };
  join(JointKind::rope, 0).length = 1;
  join(JointKind::prismatic, 1).axis = {0.6, 0.8};
  JointDef& wheel = join(JointKind::wheel, 2);
  wheel.axis = {0, 1};
  wheel.stiffness = 200;
  wheel.damping = 5;
  for (const unsigned body : {3U, 4U}) join(JointKind::revolute, body).anchor_b = {0.3, 0};
  for (JointDef& hinge : scene.joints) {
    if (hinge.kind == JointKind::revolute) hinge.anchor_a.x += 0.3;
  }
  JointDef& gear = join(JointKind::gear, 4);
  gear.a = BodyId{4};
  gear.ratio = 2;
  gear.first = JointId{3};
  gear.second = JointId{4};
  join(JointKind::weld, 5).a = BodyId{7};
  scene.joints.back().anchor_a = {-2, 0};
  JointDef& pulley = join(JointKind::pulley, 8);
  pulley.a = BodyId{8};
  pulley.anchor_a = {0, 0};
  pulley.pin_a = {14, 3};
  pulley.pin_b = {16, 3};
  pulley.ratio = 2;
  JointDef& pull = join(JointKind::drag_to, 9);
  pull.target = {19, 1};
  pull.max_force = 20;
  join(JointKind::motor, 9).motor = MotorDef{3, 5};
  return scene;
}

Scene solved_by(Scene scene, ContactMethod contacts, JointMethod joints) {
  scene.method.contact_solver = contacts;
  scene.method.joint_solver = joints;
  return scene;
}

Scene taught(int count) { return solved_by(heap(count), ContactMethod::sequential_impulses, JointMethod::direct); }
Scene moved(int count) { return solved_by(heap(count), ContactMethod::ngs, JointMethod::direct); }
Scene exact(int) { return solved_by(heap(6), ContactMethod::exact, JointMethod::direct); }
Scene event(int) { return solved_by(heap(6), ContactMethod::event, JointMethod::direct); }
Scene iterated(int count) { return solved_by(linkage(count), ContactMethod::soft_step, JointMethod::iterative); }

}  // namespace

const std::vector<EffectScene>& mixed_scenes() {
  static const std::vector<EffectScene> scenes{
      {"heap", heap},       {"sequential_impulses", taught}, {"ngs", moved}, {"exact", exact}, {"event", event},
      {"linkage", linkage}, {"iterative", iterated}};
  return scenes;
}

}  // namespace proofreel
