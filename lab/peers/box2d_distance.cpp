#include "lab/peers/box2d_distance.h"

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include <cstddef>

namespace proofreel {
namespace {

b2Vec2 to_box2d(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

std::vector<b2Vec2> corners_of(const MovingPolygon& polygon) {
  std::vector<b2Vec2> corners;
  for (const Vec2d corner : polygon.corners) corners.push_back(to_box2d(corner));
  return corners;
}

b2DistanceProxy proxy_of(const std::vector<b2Vec2>& corners) {
  b2DistanceProxy proxy;
  proxy.Set(corners.data(), static_cast<int32>(corners.size()), 0);
  return proxy;
}

b2Transform transform_of(const MovingPolygon& polygon, bool moved) {
  const double part = moved ? 1 : 0;
  b2Transform transform;
  transform.Set(to_box2d(polygon.position + part * polygon.displacement),
                static_cast<float>(polygon.angle + part * polygon.turn));
  return transform;
}

b2Sweep sweep_of(const MovingPolygon& polygon) {
  b2Sweep sweep;
  sweep.localCenter.SetZero();
  sweep.c0 = to_box2d(polygon.position);
  sweep.c = to_box2d(polygon.position + polygon.displacement);
  sweep.a0 = static_cast<float>(polygon.angle);
  sweep.a = static_cast<float>(polygon.angle + polygon.turn);
  sweep.alpha0 = 0;
  return sweep;
}

/// All that Box2D wants to be given, made before the clock starts.
struct Inputs {
  std::vector<b2Vec2> corners_a, corners_b;
  b2DistanceInput before, after;
  b2TOIInput motion;
};

void fill(const MovingPair& pair, Inputs& inputs) {
  inputs.corners_a = corners_of(pair.a);
  inputs.corners_b = corners_of(pair.b);
  const b2DistanceProxy proxy_a = proxy_of(inputs.corners_a);
  const b2DistanceProxy proxy_b = proxy_of(inputs.corners_b);
  inputs.before = {proxy_a, proxy_b, transform_of(pair.a, false), transform_of(pair.b, false), false};
  inputs.after = {proxy_a, proxy_b, transform_of(pair.a, true), transform_of(pair.b, true), false};
  inputs.motion = {proxy_a, proxy_b, sweep_of(pair.a), sweep_of(pair.b), 1};
}

}  // namespace

struct Box2dDistances::Impl {
  std::vector<Inputs> inputs;
  std::vector<b2SimplexCache> caches;
};

Box2dDistances::Box2dDistances(const std::vector<MovingPair>& pairs) : impl_(std::make_unique<Impl>()) {
  impl_->inputs.resize(pairs.size());  // before filling: the proxies point to the corners
  impl_->caches.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) fill(pairs[i], impl_->inputs[i]);
}

Box2dDistances::~Box2dDistances() = default;

float Box2dDistances::target() { return b2_linearSlop; }
float Box2dDistances::tolerance() { return 0.25F * b2_linearSlop; }

void Box2dDistances::distances(bool moved, bool warm, std::vector<float>& found) {
  for (std::size_t i = 0; i < impl_->inputs.size(); ++i) {
    b2SimplexCache& cache = impl_->caches[i];
    if (!warm) cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, moved ? &impl_->inputs[i].after : &impl_->inputs[i].before);
    found[i] = output.distance;
  }
}

void Box2dDistances::times_of_impact(std::vector<float>& found) {
  for (std::size_t i = 0; i < impl_->inputs.size(); ++i) {
    b2TOIOutput output;
    b2TimeOfImpact(&output, &impl_->inputs[i].motion);
    found[i] = output.t;
  }
}

}  // namespace proofreel
