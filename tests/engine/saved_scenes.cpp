#include "tests/engine/saved_scenes.h"

namespace proofreel::test {
namespace {

/// One body for each thing that bodies can be told apart by, and that commands may bring to light.
void add_peculiar_bodies(Scene& scene) {
  const auto add = [&](const ShapeDef& shape, Vec2d position) -> BodyDef& {
    return scene.bodies.emplace_back(body_with(shape, position));
  };
  add(box_shape(0.5, 0.5), {8, 3}).fixed_rotation = true;
  scene.bodies.back().angle = 0.3;
  BodyDef& bullet = add(disc_shape(0.1), {9, 60});  // it hits the plate, or is through it within a tick
  bullet.bullet = true;
  bullet.velocity = {0, -200};
  bullet.drag = DragDef{};
  add(box_shape(1, 1), {8, 1.5}).sensor = true;
  scene.bodies.back().type = BodyType::fixed;
  add(disc_shape(0.3), {10, 3}).gravity_scale = 0.25;
  scene.bodies.back().drag = DragDef{0.5, 0.1, 0.2};
  scene.bodies.back().color = 0x123456;
  for (int i = 0; i < 2; ++i) add(box_shape(0.6, 0.6), {12 + 0.2 * i, 4 + 1.0 * i}).filter.group = -3;
  add(box_shape(0.7, 0.3), {14, 2}).mass = 3;
  scene.bodies.back().inertia = 0.7;
  add(box_shape(0.5, 0.2), {16, 3}).type = BodyType::kinematic;
  scene.bodies.back().velocity = {-1, -0.5};
  add(disc_shape(0.2), {18, 3}).shapes[0].surface_speed = 0.5;
  scene.bodies.back().shapes.push_back(box_shape(0.3, 0.1));
  add(box_shape(2, 0.05), {9, 5});
}

/// One joint of every kind on discs that meet nothing, some of them twice held, and a rod pulled apart.
Scene linkage() {
  Scene scene;
  const auto add = [&](Vec2d position) {
    scene.bodies.push_back(body_with(disc_shape(0.4), position));
    scene.bodies.back().filter.group = -1;
    return static_cast<BodyId>(scene.bodies.size());
  };
  const auto join = [&](JointKind kind, BodyId a, Vec2d anchor_a, BodyId b, Vec2d anchor_b) -> JointDef& {
    return scene.joints.emplace_back(joint_between(kind, a, anchor_a, b, anchor_b));
  };
  const auto hang = [&](JointKind kind, Vec2d at, Vec2d from) -> JointDef& {
    return join(kind, BodyId::world, at, add(at - from), from);
  };
  hang(JointKind::rope, {-2, 1}, {}).length = 0.5;
  hang(JointKind::revolute, {0, 0}, {-0.3, 0.1});
  hang(JointKind::revolute, {2, 0}, {-0.3, 0});
  JointDef& gear = join(JointKind::gear, BodyId{2}, {}, BodyId{3}, {});
  gear.first = JointId{1};
  gear.second = JointId{2};
  gear.ratio = 1.5;
  JointDef& rail = hang(JointKind::prismatic, {4, 0}, {});
  scene.bodies.back().angle = 0.3;
  rail.axis = {0.6, 0.8};
  rail.limits = LimitsDef{-0.5, 0.5};
  JointDef& wheel = hang(JointKind::wheel, {6, 0}, {0, 0.2});
  wheel.axis = {0, 1};
  wheel.stiffness = 60;
  wheel.damping = 1;
  wheel.motor = MotorDef{3, 2};
  JointDef& pulley = join(JointKind::pulley, add({8, 0}), {}, add({9, 0}), {});
  pulley.pin_a = {8, 3};
  pulley.pin_b = {9.5, 3};
  pulley.ratio = 1.3;
  JointDef& pull = hang(JointKind::drag_to, {11, 0}, {0.1, 0});
  pull.target = {12, 1};
  pull.max_force = 30;
  JointDef& mover = join(JointKind::motor, BodyId::world, {}, add({14, 0}), {});
  mover.velocity = {0.5, 0.2};
  mover.max_force = 40;
  mover.motor = MotorDef{1, 2};
  const BodyId held = add({16, 0});  // by more than it takes
  for (const Vec2d at : {Vec2d{-0.2, 0}, Vec2d{0.2, 0.1}, Vec2d{0, -0.2}})
    join(JointKind::weld, BodyId::world, Vec2d{16, 0} + at, held, at);
  const BodyId torn = add({18, 0});  // a kinematic body leaves, and a rod lets nothing follow
  const BodyId leaving = add({19, 0});
  scene.bodies.back().type = BodyType::kinematic;
  scene.bodies.back().velocity = {1, 0};
  join(JointKind::distance, BodyId::world, {17, 0}, torn, {}).length = 1;
  join(JointKind::distance, torn, {}, leaving, {}).length = 1;
  hang(JointKind::distance, {24, 0}, {-1, 0}).break_force = 14;
  scene.joints.back().length = 1;
  hang(JointKind::rope, {22, 1}, {}).length = 0.5;
  return in_this_precision(scene);
}

void act_in_linkage(Simulation& simulation, std::int64_t tick) {
  if (tick == 50) simulation.apply(ChangeJoint{JointId{7}, Vec2d{10, 2}, {}, {}});
  if (tick == 60) simulation.apply(ChangeJoint{JointId{8}, {}, 2.0, Vec2d{-0.5, 0}});
  if (tick == 150) simulation.apply(RemoveJoint{JointId{11}});
}

/// A floor of many pieces, and what slides over its seams, one of it in pieces too.
Scene laid_floor() {
  Scene scene;
  for (int i = 0; i < 12; ++i) scene.bodies.push_back(body_with(box_shape(1, 0.5), {-2.0 + i, -0.25}, BodyType::fixed));
  for (int i = 0; i < 3; ++i) {
    BodyDef body = body_with(i == 1 ? disc_shape(0.3) : box_shape(0.8, 0.4), {-1.5 + 1.5 * i, 0.21 + 0.1 * i});
    body.velocity = {3.0 - 0.4 * i, 0};
    body.shapes[0].friction = {0.3, 0.2};
    if (i == 2) body.shapes.push_back(box_shape(0.8, 0.4));
    if (i == 2) {
      for (Vec2d& corner : body.shapes[1].points) corner.x += 0.8;
    }
    scene.bodies.push_back(body);
  }
  return in_this_precision(scene);
}

void act_on_laid_floor(Simulation& simulation, std::int64_t tick) {
  if (tick == 90) simulation.apply(CreateBody{body_with(disc_shape(0.2), {2, 2})});
  if (tick == 40) simulation.apply(RemoveBody{BodyId{5}});
  if (tick == 160) simulation.apply(CreateBody{body_with(box_shape(0.9, 0.5), {10, -0.25}, BodyType::fixed)});
}

/// Bodies that nothing couples, until a script makes something that does.
Scene free_bodies() {
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    scene.bodies.push_back(body_with(disc_shape(0.3), {1.0 * i, 0.2 * i}));
    scene.bodies.back().filter.group = -1;
    scene.bodies.back().spin = 0.5 * i;
  }
  return in_this_precision(scene);
}

void act_on_free_bodies(Simulation& simulation, std::int64_t tick) {
  if (tick == 45) {
    JointDef spring = joint_between(JointKind::spring, BodyId{1}, {0.1, 0}, BodyId{3}, {}, 1);
    spring.stiffness = 20;
    simulation.apply(CreateJoint{spring});
  }
  if (tick == 90) simulation.apply(CreateBody{body_with(box_shape(1, 0.4), {1, -3}, BodyType::fixed)});
  if (tick == 110) {  // from now on there are contacts, and the first pair meets
    ChangeBody change;
    change.body = BodyId{1};
    change.filter = FilterDef{};
    change.drag = DragDef{0.1, 0, 0};
    simulation.apply(change);
  }
  if (tick == 160) simulation.apply(CreateBody{body_with(disc_shape(0.2), {2, -2})});
}

}  // namespace

/// Boxes and discs that fall onto a floor and into each other, a chain, a motor, a spring, a breaking pin, a rocket.
Scene busy_scene() {
  Scene scene;
  scene.bodies = {floor_body()};
  for (int i = 0; i < 6; ++i) {
    BodyDef body = body_with(i % 2 == 0 ? box_shape(1, 0.6) : disc_shape(0.4), {0.2 * i, 1 + 1.1 * i});
    body.shapes[0].restitution = i == 3 ? 0.5 : 0;
    body.shapes[0].rolling_resistance = i == 1 ? 0.01 : 0;
    body.spin = 0.3 * i;
    scene.bodies.push_back(body);
  }
  for (int i = 0; i < 5; ++i) scene.bodies.push_back(body_with(box_shape(0.5, 0.1), {-5.75 + 0.5 * i, 4}));
  const auto link = [&](unsigned a, Vec2d at_a, unsigned b, Vec2d at_b) -> JointDef& {
    scene.joints.push_back(
        joint_between(JointKind::revolute, static_cast<BodyId>(a), at_a, static_cast<BodyId>(b), at_b));
    return scene.joints.back();
  };
  link(0, {-6, 4}, 8, {-0.25, 0});
  for (unsigned i = 8; i < 12; ++i) link(i, {0.25, 0}, i + 1, {-0.25, 0});
  scene.joints[2].limits = LimitsDef{-0.3, 0.3};
  scene.joints[3].motor = MotorDef{2, 1};
  scene.joints[4].break_force = 60;
  scene.joints.push_back(joint_between(JointKind::spring, BodyId::world, {1, 9}, BodyId{7}, {0, 0}, 1));
  scene.joints.back().stiffness = 40;
  scene.joints.back().damping = 0.5;
  scene.bodies.push_back(body_with(box_shape(0.4, 1), {5, 1}));
  scene.rockets.push_back({BodyId{static_cast<std::uint32_t>(scene.bodies.size())}, 12, 0.2, 0.1, {0.01, -0.5}});
  scene.drag = {0.01, 0.02, 0.001};
  add_peculiar_bodies(scene);
  return in_this_precision(scene);
}

/// What else happens in the busy scene at some ticks, as a script would make it.
void act_in_busy_scene(Simulation& simulation, std::int64_t tick) {
  if (tick == 40) simulation.apply(CreateBody{body_with(disc_shape(0.3), {0.1, 6})});
  if (tick == 70) simulation.apply(RemoveBody{BodyId{3}});
  if (tick == 90) {
    ChangeBody change;
    change.body = BodyId{4};
    change.shapes = {box_shape(0.9, 0.9)};
    simulation.apply(change);
  }
  if (tick == 100) simulation.apply(CreateJoint{joint_between(JointKind::rope, BodyId{2}, {}, BodyId{5}, {}, 1.5)});
  if (tick == 120) simulation.apply(RemoveJoint{JointId{0}});
  // Every body is made anew from what is known of it, now and then another one; late ones meet them all.
  if (tick % 3 == 0) {
    ChangeBody change;
    change.body = static_cast<BodyId>(14 + tick / 3 % 9);
    change.density = 1 + 0.01 * static_cast<double>(tick);
    simulation.apply(change);
  }
  if (tick == 60) simulation.apply(CreateBody{body_with(box_shape(0.4, 0.4), {8, 1.7})});
  if (tick % 7 == 0) simulation.apply(ApplyForce{BodyId{6}, {3, 1}, Vec2d{0, 1}});
}

/// Small things that soon fall asleep, two of them hinged together, and a disc that wakes some.
Scene sleepers() {
  Scene scene;
  scene.sleeping = true;
  scene.bodies = {floor_body()};
  for (int i = 0; i < 3; ++i) scene.bodies.push_back(body_with(box_shape(0.3, 0.3), {0, 0.15 + 0.3 * i}));
  for (const double x : {2.0, 2.3}) scene.bodies.push_back(body_with(box_shape(0.3, 0.2), {x, 0.1}));
  scene.joints = {joint_between(JointKind::revolute, BodyId(5), {0.15, 0.1}, BodyId(6), {-0.15, 0.1})};
  scene.bodies.push_back(body_with(disc_shape(0.15), {0.05, 2.8}));
  return scene;
}

Scene solved_by(Scene scene, ContactMethod contacts, JointMethod joints) {
  scene.method.contact_solver = contacts;
  scene.method.joint_solver = joints;
  return scene;
}

const std::vector<SavedScene>& saved_scenes() {
  using enum ContactMethod;
  using enum JointMethod;
  const auto nothing = [](Simulation&, std::int64_t) {};
  static const std::vector<SavedScene> scenes{
      {"busy", busy_scene(), nothing},
      {"busy, with commands", busy_scene(), act_in_busy_scene},
      {"linkage", linkage(), act_in_linkage},
      {"laid floor", laid_floor(), act_on_laid_floor},
      {"free bodies", free_bodies(), act_on_free_bodies},
      {"exact", solved_by(busy_scene(), exact, direct), nothing},
      {"event", solved_by(laid_floor(), event, direct), act_on_laid_floor},
      {"sleepers", sleepers(), nothing},
      {"sleepers, iterated", solved_by(sleepers(), soft_step, iterative), nothing},
      {"iterated", solved_by(linkage(), ngs, iterative), act_in_linkage}};
  return scenes;
}

}  // namespace proofreel::test
