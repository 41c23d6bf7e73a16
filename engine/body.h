#pragma once

/// Bodies inside the engine. What the solver touches again and again (Motion) lies apart from what a step reads once
/// (Body).

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/real.h"
#include "engine/scene.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Position of a body in the arrays: its BodyId as a number. 0 is the immovable world.
using BodyIndex = std::uint32_t;

/// What impulses act on. The masses come in this order because compilers load `inv_mass` together with its neighbour:
/// if that were `spin`, which the constraint before has just stored by itself, the load would have to wait for the
/// memory.
struct Mover {
  Vec2 velocity;  ///< of the centre of mass
  real spin = 0;  ///< rad/s
  real inv_inertia = 0;
  real inv_mass = 0;  ///< 1/kg; 0 for what nothing pushes

  Vec2 velocity_at(Vec2 arm) const { return velocity + cross(spin, arm); }
  /// `arm` is the point's position relative to the centre of mass, world axes.
  void push(Vec2 impulse, Vec2 arm) {
    velocity += inv_mass * impulse;
    spin += inv_inertia * cross(arm, impulse);
  }
};

/// The moving part of a body. During a tick positions are kept as the way gone since the tick began: differences of
/// these stay exact even where the coordinates themselves are large.
struct Motion : Mover {
  Vec2 delta;  ///< of the centre of mass, since the tick began
  Rot rotation;
  real angle = 0;  ///< of `rotation`, continuous
};

struct Body {
  std::string name;
  BodyType type = BodyType::fixed;
  BodyType acts_as = BodyType::fixed;  ///< its type; `fixed` while it sleeps, so that no force is asked for
  bool alive = true;
  bool fixed_rotation = false;
  bool bullet = false;
  bool sensor = false;
  Vec2 center;        ///< of mass, world, at the start of the tick
  Vec2 local_center;  ///< of mass, in the coordinates of the definition
  real mass = 0;
  real inertia = 0;
  real gravity_scale = 1;
  FilterDef filter;
  std::optional<DragDef> drag;  ///< without it, the scene's
  std::optional<std::uint32_t> color;
  std::vector<std::uint32_t> shapes;  ///< indices of its shapes
  std::vector<ShapeDef> defs;         ///< what the shapes and the mass were made from
  std::optional<double> given_mass;
  std::optional<double> given_inertia;

  bool asleep() const { return acts_as != type; }
};

/// Cosine and sine, of one angle or of several (lanes.h).
template <typename T>
struct SmallTurn {
  T c;
  T s;
};

/// Angles from here on take the full functions.
inline constexpr real largest_small_turn = real(0.25);

/// Of small angles: Taylor to the 11th power, so that below 1/4 rad the rest is under 1e-18.
template <typename T>
inline SmallTurn<T> small_turn(T angle) {
  constexpr real one = 1;
  const T a2 = angle * angle;
  const T s =
      angle *
      (one -
       a2 / real(6) * (one - a2 / real(20) * (one - a2 / real(42) * (one - a2 / real(72) * (one - a2 / real(110))))));
  const T c =
      one -
      a2 / real(2) *
          (one - a2 / real(12) *
                     (one - a2 / real(30) * (one - a2 / real(56) * (one - a2 / real(90) * (one - a2 / real(132))))));
  return {c, s};
}

/// Turns `q` by `angle` radians. Small angles, the usual case within a step, take a short series instead of the full
/// functions.
inline Rot turned(Rot q, real angle) {
  if (!(std::abs(angle) < largest_small_turn)) return normalized(Rot(angle) * q);
  const SmallTurn<real> turn = small_turn(angle);
  return normalized(Rot{turn.c, turn.s} * q);
}

/// Turns a body by its own spin for `h` seconds.
inline void turn_on(Motion& m, real h) {
  m.rotation = turned(m.rotation, h * m.spin);
  m.angle += h * m.spin;
}

/// Moves and turns a body by its own velocity for `h` seconds.
inline void drift(Motion& m, real h) {
  m.delta += h * m.velocity;
  if (m.spin != 0) turn_on(m, h);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
