#pragma once

/// Box2D's distance and time of impact by themselves, for the benchmark of ours. Many pairs per call, so that the call
/// costs neither side anything.

#include <memory>
#include <vector>

#include "engine/vec2.h"

namespace proofreel {

/// A polygon and how it moves during one step.
struct MovingPolygon {
  std::vector<Vec2d> corners;
  Vec2d position;
  double angle = 0;
  Vec2d displacement;
  double turn = 0;
};

struct MovingPair {
  MovingPolygon a, b;
};

class Box2dDistances {
 public:
  /// Polygons without Box2D's skin.
  explicit Box2dDistances(const std::vector<MovingPair>& pairs);
  ~Box2dDistances();
  Box2dDistances(const Box2dDistances&) = delete;
  Box2dDistances& operator=(const Box2dDistances&) = delete;

  /// What Box2D takes for an impact: a distance of `target`, give or take `tolerance`, metres.
  static float target();
  static float tolerance();

  /// The distances of all pairs: before the motion (`moved` false) or after it; from scratch or from where the last
  /// call ended.
  void distances(bool moved, bool warm, std::vector<float>& found);
  /// The fraction of the motion at which each pair meets; 1 when it does not.
  void times_of_impact(std::vector<float>& found);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
