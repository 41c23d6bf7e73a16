#include "lab/bench_engine_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace proofreel {
namespace {

constexpr double pi = 3.14159265358979323846;

Scene empty_scene() {
  Scene scene;
  scene.rate = 60;
  scene.method.substeps = 4;
  scene.method.precision = Precision::float32;
  return scene;
}

ShapeDef box_shape(double width, double height, Vec2d at = {}) {
  const double x = width / 2;
  const double y = height / 2;
  ShapeDef shape;
  for (const Vec2d corner : {Vec2d{-x, -y}, Vec2d{x, -y}, Vec2d{x, y}, Vec2d{-x, y}}) {
    shape.points.push_back(at + corner);
  }
  shape.friction = {0.6, 0.6};
  return shape;
}

ShapeDef disc_shape(double radius) {
  ShapeDef shape;
  shape.points = {{0, 0}};
  shape.radius = radius;
  shape.friction = {0.6, 0.6};
  return shape;
}

BodyDef body_with(const ShapeDef& shape, Vec2d position, BodyType type = BodyType::dynamic) {
  BodyDef body;
  body.type = type;
  body.position = position;
  body.shapes = {shape};
  return body;
}

JointDef pin(BodyId a, Vec2d anchor_a, BodyId b, Vec2d anchor_b) {
  JointDef joint;
  joint.a = a;
  joint.b = b;
  joint.anchor_a = anchor_a;
  joint.anchor_b = anchor_b;
  return joint;
}

template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

void keep_filters(BenchScene& bench) {
  for (const BodyDef& body : bench.scene.bodies) bench.filters.push_back(body.filter);
}

/// Of what should hang still.
std::string farthest_move(const Snapshot& start, const Snapshot& now) {
  double farthest = 0;
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    farthest = std::max(farthest, distance(start.bodies[i].state.center, now.bodies[i].state.center));
  }
  return text("the farthest disc has moved %.3g mm", 1e3 * farthest);
}

std::string count_below(double y, const Snapshot& now) {
  const auto below = std::count_if(now.bodies.begin(), now.bodies.end(), [y](const BodyView& body) {
    return body.type == BodyType::dynamic && !(body.state.center.y > y);
  });
  return text("%d bodies have left", static_cast<int>(below));
}

}  // namespace

BenchScene pyramid(int rows) {
  constexpr double side = 0.8;
  constexpr double pitch = 0.9;
  BenchScene bench;
  bench.scene = empty_scene();
  std::vector<BodyDef>& bodies = bench.scene.bodies;
  bodies.push_back(body_with(box_shape(2 * rows, 1), {0, -0.5}, BodyType::fixed));
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const Vec2d position{(i - 0.5 * (rows - row - 1)) * pitch, (row + 0.5) * side};
      bodies.push_back(body_with(box_shape(side, side), position));
    }
  }
  bench.name = text("pyramid of %d rows, %d boxes", rows, rows * (rows + 1) / 2);
  keep_filters(bench);
  bench.drift = [](const Snapshot& start, const Snapshot& now) {
    const Vec2d moved = now.bodies.back().state.center - start.bodies.back().state.center;
    return text("the top sank %.0f mm, moved %.0f mm sideways", -1e3 * moved.y, 1e3 * std::abs(moved.x));
  };
  return bench;
}

BenchScene joint_grid(int side) {
  BenchScene bench;
  bench.scene = empty_scene();
  const auto id = [side](int column, int row) { return static_cast<BodyId>(1 + column * side + row); };
  const auto is_held = [side](int column, int row) { return row == 0 && std::abs(column - side / 2) <= 3; };
  for (int column = 0; column < side; ++column) {
    for (int row = 0; row < side; ++row) {
      const bool held = is_held(column, row);
      BodyDef disc = body_with(disc_shape(0.4), {1.0 * column, -1.0 * row}, held ? BodyType::fixed : BodyType::dynamic);
      disc.filter.group = -1;
      bench.scene.bodies.push_back(disc);
      if (row > 0) bench.scene.joints.push_back(pin(id(column, row - 1), {0, -0.5}, id(column, row), {0, 0.5}));
      if (held && column > 0 && is_held(column - 1, row)) continue;
      if (column > 0) bench.scene.joints.push_back(pin(id(column - 1, row), {0.5, 0}, id(column, row), {-0.5, 0}));
    }
  }
  bench.name = text("joint grid of %d x %d discs, %d pins", side, side, static_cast<int>(bench.scene.joints.size()));
  keep_filters(bench);
  bench.drift = farthest_move;
  return bench;
}

BenchScene tumbler(int side) {
  constexpr double box = 0.25;
  const double half = 0.2 * side + 0.5;  // of the room inside
  BenchScene bench;
  bench.scene = empty_scene();
  BodyDef drum;
  drum.type = BodyType::kinematic;
  drum.spin = 25 * pi / 180;
  for (const double at : {-half - 0.5, half + 0.5}) {
    drum.shapes.push_back(box_shape(2 * half + 2, 1, {0, at}));
    drum.shapes.push_back(box_shape(1, 2 * half, {at, 0}));
  }
  bench.scene.bodies.push_back(drum);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec2d place{(column - 0.5 * (side - 1)) * 0.4, (row - 0.5 * (side - 1)) * 0.4};
      bench.scene.bodies.push_back(body_with(box_shape(box, box), place));
    }
  }
  bench.name = text("tumbler of %d boxes", side * side);
  keep_filters(bench);
  bench.drift = [half](const Snapshot&, const Snapshot& now) {
    const double corner = (half + 1) * std::sqrt(2.0);
    const auto out = std::count_if(now.bodies.begin(), now.bodies.end(),
                                   [corner](const BodyView& body) { return !(length(body.state.center) < corner); });
    return text("%d boxes have left the drum", static_cast<int>(out));
  };
  return bench;
}

namespace {

/// A limb of a figure, where it hangs, and how far it bends either way.
struct Limb {
  int parent = 0;
  double width = 0;
  double height = 0;
  Vec2d center;
  Vec2d joint;
  double bend = 0;  ///< rad
};

/// The first is the hip; metres from its centre.
const std::vector<Limb>& limbs() {
  static const std::vector<Limb> all{{-1, 0.35, 0.30, {0, 0}, {}, 0},
                                     {0, 0.40, 0.45, {0, 0.375}, {0, 0.15}, 0.4},
                                     {1, 0.22, 0.25, {0, 0.725}, {0, 0.6}, 0.6},
                                     {1, 0.12, 0.32, {-0.28, 0.42}, {-0.28, 0.56}, 2.5},
                                     {3, 0.10, 0.30, {-0.28, 0.11}, {-0.28, 0.26}, 2.0},
                                     {1, 0.12, 0.32, {0.28, 0.42}, {0.28, 0.56}, 2.5},
                                     {5, 0.10, 0.30, {0.28, 0.11}, {0.28, 0.26}, 2.0},
                                     {0, 0.16, 0.42, {-0.1, -0.36}, {-0.1, -0.15}, 1.2},
                                     {7, 0.13, 0.42, {-0.1, -0.78}, {-0.1, -0.57}, 1.2},
                                     {0, 0.16, 0.42, {0.1, -0.36}, {0.1, -0.15}, 1.2},
                                     {9, 0.13, 0.42, {0.1, -0.78}, {0.1, -0.57}, 1.2}};
  return all;
}

/// `first` is the id of its hip, `number` tells the figures apart.
void add_figure(std::vector<Command>& commands, std::uint32_t first, int number, Vec2d at) {
  for (const Limb& limb : limbs()) {
    BodyDef body = body_with(box_shape(limb.width, limb.height), at + limb.center);
    body.velocity = {0, -6};
    body.filter.group = -1 - number;
    commands.emplace_back(CreateBody{body});
  }
  for (std::uint32_t i = 1; i < limbs().size(); ++i) {
    const Limb& limb = limbs()[i];
    const auto parent = static_cast<std::uint32_t>(limb.parent);
    JointDef joint = pin(static_cast<BodyId>(first + parent), limb.joint - limbs()[parent].center,
                         static_cast<BodyId>(first + i), limb.joint - limb.center);
    joint.limits = LimitsDef{-limb.bend, limb.bend};
    commands.emplace_back(CreateJoint{joint});
  }
}

}  // namespace

BenchScene ragdoll_rain(int count) {
  constexpr int per_row = 5;
  constexpr std::int64_t pause = 20;  // ticks between rows, in which one gets out of the next one's way
  BenchScene bench;
  bench.scene = empty_scene();
  bench.scene.bodies = {body_with(box_shape(14, 1), {0, -0.5}, BodyType::fixed),
                        body_with(box_shape(1, 40), {-7.5, 19}, BodyType::fixed),
                        body_with(box_shape(1, 40), {7.5, 19}, BodyType::fixed)};
  keep_filters(bench);
  const std::size_t before = bench.filters.size();
  for (int i = 0; i < count; ++i) {
    FilterDef filter;
    filter.group = -1 - i;
    bench.filters.insert(bench.filters.end(), limbs().size(), filter);
  }
  bench.name = text("rain of %d ragdolls, %d bodies", count, static_cast<int>(bench.filters.size() - before));
  bench.seconds = 10;
  bench.commands = [count, before](std::int64_t tick) {
    std::vector<Command> commands;
    const auto row = static_cast<int>(tick / pause);
    if (tick % pause != 0) return commands;
    for (int i = row * per_row; i < std::min(count, (row + 1) * per_row); ++i) {
      const auto first = static_cast<std::uint32_t>(before + 1 + limbs().size() * static_cast<std::size_t>(i));
      const double x = (i % per_row - 0.5 * (per_row - 1)) * 2.4 + 0.3 * (row % 3 - 1);
      add_figure(commands, first, i, {x, 14});
    }
    return commands;
  };
  bench.drift = [](const Snapshot&, const Snapshot& now) { return count_below(-0.5, now); };
  return bench;
}

BenchScene free_bodies(int count) {
  constexpr int per_row = 100;
  constexpr double drag = 0.5;
  BenchScene bench;
  bench.scene = empty_scene();
  bench.scene.drag.linear = drag;
  for (int i = 0; i < count; ++i) {
    BodyDef body = body_with(box_shape(1, 1), {3.0 * (i % per_row), 3.0 * static_cast<double>(i / per_row)});
    body.velocity = {0.1 * (i % 7), 0.1 * (i % 11)};
    body.spin = 0.1 * (i % 5);
    body.filter.group = -1;
    bench.scene.bodies.push_back(body);
  }
  bench.name = text("%d free bodies under gravity and drag", count);
  keep_filters(bench);
  // m dv/dt = m g - c v; m = 1 kg
  bench.drift = [gravity = bench.scene.gravity](const Snapshot& start, const Snapshot& now) {
    const double left = 1 - std::exp(-drag * now.time);
    double farthest = 0;
    for (std::size_t i = 0; i < now.bodies.size(); ++i) {
      const Vec2d terminal = (1 / drag) * gravity;
      const BodyState& began = start.bodies[i].state;
      const Vec2d place = began.center + now.time * terminal + left / drag * (began.velocity - terminal);
      farthest = std::max(farthest, distance(place, now.bodies[i].state.center));
    }
    return text("off the exact path by up to %.3f mm", 1e3 * farthest);
  };
  return bench;
}

}  // namespace proofreel
