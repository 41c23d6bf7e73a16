#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "engine/simulation.h"
#include "lab/bench.h"
#include "lab/bench_process.h"
#include "lab/peer_box2d.h"

namespace proofreel {
namespace {

constexpr int rows = 100;
constexpr int seconds = 5;
constexpr double side = 0.8;
constexpr double pitch = 0.9;

BodyDef box(double width, double height, Vec2d position, BodyType type) {
  const double x = width / 2;
  const double y = height / 2;
  ShapeDef shape;
  shape.points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  shape.friction = {0.6, 0.6};
  BodyDef body;
  body.type = type;
  body.position = position;
  body.shapes = {shape};
  return body;
}

/// The last body is the top.
Scene pyramid(Precision precision) {
  Scene scene;
  scene.method.precision = precision;
  scene.bodies.push_back(box(2 * rows, 1, {0, -0.5}, BodyType::fixed));
  for (int row = 0; row < rows; ++row) {
    const int boxes = rows - row;
    for (int i = 0; i < boxes; ++i) {
      const Vec2d position{(i - 0.5 * (boxes - 1)) * pitch, (row + 0.5) * side};
      scene.bodies.push_back(box(side, side, position, BodyType::dynamic));
    }
  }
  return scene;
}

/// One engine with its pyramid.
struct Side {
  std::string name;
  std::function<void()> simulate_second;
  std::function<Vec2d()> top;
  std::vector<double> cpu_ms;  ///< of each simulated second
};

Side our_side(const std::string& name, Precision precision) {
  const Scene scene = pyramid(precision);
  const std::shared_ptr<Simulation> simulation = make_simulation(scene);
  const auto top = static_cast<BodyId>(scene.bodies.size());
  const auto simulate_second = [simulation, rate = scene.rate] {
    for (int i = 0; i < rate; ++i) simulation->step();
  };
  return {name, simulate_second, [simulation, top] { return simulation->body(top).position; }, {}};
}

Side box2d_side() {
  const Scene scene = pyramid(Precision::float32);
  const auto peer = std::make_shared<Box2dPeer>(scene);
  const auto top = static_cast<BodyId>(scene.bodies.size());
  const auto simulate_second = [peer] {
    for (int i = 0; i < Box2dPeer::rate; ++i) peer->step();
  };
  return {"Box2D 2.4, single, 60 Hz, 8/3 iterations", simulate_second, [peer, top] { return peer->position(top); }, {}};
}

void print_side(const Side& side_run, double peer_cpu_ms) {
  const Vec2d start{0, (rows - 0.5) * side};
  const Vec2d end = side_run.top();
  const double cpu_ms = median(side_run.cpu_ms);
  std::printf("  %-42s %6.0f ms, %5.2f times Box2D; the top sank %5.0f mm, moved %4.0f mm sideways\n",
              side_run.name.c_str(), cpu_ms, cpu_ms / peer_cpu_ms, 1e3 * (start.y - end.y), 1e3 * std::abs(end.x));
}

}  // namespace

void bench_pyramid() {
  const Method defaults;
  const std::string ours = std::to_string(Scene{}.rate) + " Hz, " + std::to_string(defaults.substeps) + " substeps";
  std::vector<Side> sides;
  sides.push_back(box2d_side());
  sides.push_back(our_side("proofreel, double, " + ours, Precision::float64));
  sides.push_back(our_side("proofreel, single, " + ours, Precision::float32));
  std::printf("  %d rows, %d boxes, one thread, nothing sleeps; CPU per simulated second, in turns, median of %d\n",
              rows, rows * (rows + 1) / 2, seconds);
  for (int i = 0; i < seconds; ++i) {
    for (Side& one : sides) {
      const Stopwatch watch;
      one.simulate_second();
      one.cpu_ms.push_back(1e3 * watch.elapsed().cpu_s);
    }
  }
  for (const Side& one : sides) print_side(one, median(sides.front().cpu_ms));
}

}  // namespace proofreel
