#pragma once

/// Box2D 2.4 stepping our scenes, to compare with. Only this file's source includes it.

#include <memory>

#include "engine/scene.h"

namespace proofreel {

/// Bodies that are one box centred on their origin; bodies never sleep. Box2D at its declared defaults: 60 steps per
/// second, 8 velocity and 3 position iterations.
class Box2dPeer {
 public:
  explicit Box2dPeer(const Scene& scene);
  ~Box2dPeer();
  Box2dPeer(const Box2dPeer&) = delete;
  Box2dPeer& operator=(const Box2dPeer&) = delete;

  static constexpr int rate = 60;
  void step();
  /// Of the body's origin.
  Vec2d position(BodyId body) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
