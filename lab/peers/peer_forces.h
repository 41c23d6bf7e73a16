#pragma once

/// Forces that Box2D and Chipmunk do not know. Users of theirs compute them before each step and hand them over, and so
/// do we: constant during the step, taken where the bodies are before it.

#include <optional>
#include <vector>

#include "engine/scene.h"
#include "engine/snapshot.h"

namespace proofreel {

/// A body that forces act on, and what they come to.
struct LoadedBody {
  BodyId id{};
  BodyType type = BodyType::dynamic;
  BodyState state;
  std::optional<DragDef> drag;  ///< its own
  Vec2d force;                  ///< N on the centre of mass
  double torque = 0;            ///< N m
};

class PeerForces {
 public:
  explicit PeerForces(const Scene& scene);
  /// Whether there are any on bodies without a drag of their own.
  bool act() const;
  /// Whether it matters where the bodies are, and not only how they move.
  bool need_places() const { return !attractors_.empty() || gravitational_constant_ > 0 || !fields_.empty(); }
  /// Adds to the loads of all bodies; `time` in s.
  void add_to(std::vector<LoadedBody>& bodies, double time) const;
  /// Of the attractions, J.
  double potential(const std::vector<LoadedBody>& bodies) const;

 private:
  void add_drag(LoadedBody& body) const;

  DragDef drag_;
  Vec2d wind_;
  std::vector<AttractorDef> attractors_;
  double gravitational_constant_ = 0;
  std::vector<ForceField> fields_;
};

}  // namespace proofreel
