#include "tests/render/sample_frame.h"

namespace proofreel {
namespace {

struct Part {
  std::vector<Vec2d> points;
  double radius = 0;
};

const Part disc{{{0, 0}}, 0.4};
const Part bar{{{-0.5, -0.3}, {0.5, -0.3}, {0.5, 0.3}, {-0.5, 0.3}}, 0};
const Part hexagon{{{0.4, 0}, {0.2, 0.35}, {-0.2, 0.35}, {-0.4, 0}, {-0.2, -0.35}, {0.2, -0.35}}, 0};
const Part capsule{{{-0.3, 0}, {0.3, 0}}, 0.25};
const Part pebble{{{-0.3, -0.2}, {0.3, -0.2}, {0.1, 0.3}}, 0.12};
const Part left_half{{{-0.4, -0.4}, {0, -0.4}, {0, 0.4}, {-0.4, 0.4}}, 0};
const Part right_half{{{0, -0.4}, {0.6, 0}, {0, 0.4}}, 0};
const Part ground{{{-2000, -100}, {2000, -100}, {2000, 0}, {-2000, 0}}, 0};

void add_body(Snapshot& snapshot, BodyType type, Vec2d at, double angle, const std::vector<Part>& parts) {
  BodyView body;
  body.id = static_cast<BodyId>(snapshot.bodies.size() + 1);
  body.type = type;
  body.pose = Posed(at, Rotd(angle));
  body.state.position = at;
  body.state.center = at;
  body.state.mass = type == BodyType::dynamic ? 1 : 0;
  body.first_shape = static_cast<std::uint32_t>(snapshot.shapes.size());
  body.shape_count = static_cast<std::uint32_t>(parts.size());
  for (const Part& part : parts) {
    Aabbd box;
    snapshot.shapes.push_back({static_cast<std::uint32_t>(snapshot.points.size()),
                               static_cast<std::uint32_t>(part.points.size()), part.radius});
    for (const Vec2d point : part.points) {
      snapshot.points.push_back(point);
      box = merged(box, to_world(body.pose, point));
    }
    snapshot.aabbs.push_back(expanded(box, part.radius));
  }
  snapshot.bodies.push_back(body);
}

void add_bodies(Snapshot& snapshot) {
  add_body(snapshot, BodyType::fixed, {0, 0}, 0, {ground});
  const std::vector<std::vector<Part>> kinds{{disc}, {bar}, {hexagon}, {capsule}, {pebble}, {left_half, right_half}};
  for (int i = 0; i < 18; ++i) {
    const auto kind = static_cast<std::size_t>(i) % kinds.size();
    add_body(snapshot, BodyType::dynamic, {-4.5 + 1.1 * (i % 9), 0.5 + i / 9}, 0.37 * i, kinds[kind]);
  }
  add_body(snapshot, BodyType::kinematic, {3, 3.4}, 0.2, {bar});
  add_body(snapshot, BodyType::fixed, {-3.2, 3.4}, 0, {bar});
  snapshot.bodies[2].asleep = true;
  snapshot.bodies[4].has_color = true;
  snapshot.bodies[4].color = 0xC08020;
  snapshot.bodies.back().sensor = true;
  std::uint32_t island = 0;
  for (BodyView& body : snapshot.bodies) {
    if (body.type == BodyType::dynamic) body.island = ++island;
  }
  snapshot.energy = {20, 60, 0};
}

void add_engine_parts(Snapshot& snapshot) {
  for (int depth = 0; depth < 5; ++depth) {
    const double half = 5.0 - depth;
    snapshot.tree.push_back({{{-half, 0.2}, {half, 0.8 * half}}, depth, depth == 4});
  }
  for (int i = 0; i < 9; ++i) {
    snapshot.contacts.push_back({static_cast<BodyId>(i + 2), static_cast<BodyId>(1), {0, -1}, {}, 1});
    snapshot.contacts.back().points[0] = {{-4.5 + 1.1 * i, 0}, -0.001, 0.01 * i, 0};
  }
  for (const JointKind kind : {JointKind::revolute, JointKind::distance, JointKind::spring}) {
    const auto index = static_cast<std::uint32_t>(snapshot.joints.size());
    const double x = -1.0 + index;
    JointView& joint = snapshot.joints.emplace_back();
    joint.id = static_cast<JointId>(index);
    joint.kind = kind;
    joint.b = static_cast<BodyId>(index + 11);
    joint.anchor_a = {x, 4};
    joint.anchor_b = {x, 2.6};
  }
}

PlotView sample_plot(Corner at) {
  PlotView plot{"energy", {"kinetic", "total"}, 4, at, {}, {{}, {}}};
  for (int i = 0; i < 240; ++i) {
    plot.times.push_back(i / 60.0);
    plot.values[0].push_back(2 + 1.5 * elementary::sin(0.1 * i));
    plot.values[1].push_back(4);
  }
  return plot;
}

}  // namespace

Frame sample_frame() {
  Frame frame;
  frame.view = {{0, 2.4}, 6};
  frame.layers = all_layers();
  frame.snapshot.tick = 480;
  frame.snapshot.time = 2;
  add_bodies(frame.snapshot);
  add_engine_parts(frame.snapshot);
  TrailView trail{static_cast<BodyId>(3), {}};
  for (int i = 0; i < 50; ++i) trail.points.push_back({-4 + 0.05 * i, 3 + elementary::sin(0.2 * i)});
  frame.trails.push_back(trail);
  frame.arrows = {{VectorOf::velocity, {-2, 2}, {-1, 2.8}}, {VectorOf::force, {1, 1.6}, {1, 0.8}}};
  frame.force_scale = 0.15;
  frame.energy = {90, 0, 100};
  frame.highlights = {{static_cast<BodyId>(8), {}, 0, 1, "this one"}, {BodyId::world, Vec2d{4, 3}, 0.2, 0.5, ""}};
  frame.labels = {{frame.snapshot.bodies[5].state.center, 0.4, "α"}, {{2.2, 1.5}, 0.5, "hexagon"}};
  frame.captions = {{"All that a picture may show", Corner::top}, {"and a line below", Corner::bottom}};
  frame.plots = {sample_plot(Corner::top_right), sample_plot(Corner::top_right)};
  return frame;
}

std::vector<Layer> all_layers() {
  std::vector<Layer> layers;
  for (int i = 0; i < layer_count; ++i) layers.push_back(static_cast<Layer>(i));
  return layers;
}

Frame with_layers(Frame frame, std::vector<Layer> layers) {
  frame.layers = std::move(layers);
  return frame;
}

}  // namespace proofreel
