#pragma once

/// Everything a picture may show at one tick, copied out of a simulation: plain values that stay true while the
/// simulation goes on. What a simulation does not offer stays empty.

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/aabb.h"
#include "engine/pose.h"
#include "engine/scene.h"

namespace proofreel {

/// Joules. `potential` counts gravity (zero at y = 0), springs, attraction, and the water pushed away. `booked_work` is
/// what kinematic bodies, moving surfaces, force fields, rockets and commands have put in since the start: kinetic +
/// potential - booked_work stays constant where nothing dissipates.
struct Energy {
  double kinetic = 0;
  double potential = 0;
  double booked_work = 0;
  double total() const { return kinetic + potential; }
};

/// The motion of one body.
struct BodyState {
  Vec2d position;    ///< of the body's origin
  Vec2d center;      ///< of mass
  double angle = 0;  ///< continuous, never wrapped
  Vec2d velocity;    ///< of the centre of mass
  double spin = 0;
  double mass = 0;     ///< kg; 0 for what is not dynamic
  double inertia = 0;  ///< kg m^2 about the centre of mass; 0 for what is not dynamic
};

struct BodyView {
  BodyId id = BodyId::world;
  BodyType type = BodyType::dynamic;
  Posed pose;  ///< body coordinates to world
  BodyState state;
  Vec2d force;  ///< N, mean over the last tick: mass times the change of velocity over time, gravity and contacts
                ///< included
  bool asleep = false;
  std::uint32_t island =
      0;  ///< 1, 2, ... in order of the least id in it; 0 for what is not dynamic, or where none asked
  bool sensor = false;
  std::uint32_t color = 0;  ///< 0xRRGGBB, valid when has_color
  bool has_color = false;
  std::uint32_t first_shape = 0;  ///< into Snapshot::shapes
  std::uint32_t shape_count = 0;
};

/// The convex hull of `point_count` points, rounded by `radius`; body coordinates.
struct ShapeView {
  std::uint32_t first_point = 0;  ///< into Snapshot::points
  std::uint32_t point_count = 0;
  double radius = 0;
};

struct ContactPoint {
  Vec2d point;                 ///< world, midway between the two surfaces
  double separation = 0;       ///< m at the start of the last tick, negative on overlap
  double normal_impulse = 0;   ///< N s over the last tick
  double tangent_impulse = 0;  ///< N s over the last tick, along the normal turned a quarter counter-clockwise
  bool touching() const { return separation <= 0 || normal_impulse > 0; }
};

struct ContactView {
  BodyId a = BodyId::world;
  BodyId b = BodyId::world;
  Vec2d normal;  ///< unit, from a to b
  ContactPoint points[2];
  int point_count = 0;
};

struct JointView {
  JointId id{};
  JointKind kind = JointKind::revolute;
  BodyId a = BodyId::world;
  BodyId b = BodyId::world;
  Vec2d anchor_a;     ///< world
  Vec2d anchor_b;     ///< world
  Vec2d reaction;     ///< N on b, mean over the last tick
  double torque = 0;  ///< N m on b beside the reaction (of limits, motors, welds), mean over the last tick
  double ratio = 1;   ///< gear, pulley
  double gap = 0;     ///< m by which the joint is violated; 0 for what is soft
  Vec2d axis;         ///< prismatic, wheel: unit, world
  double length = 0;  ///< distance, spring, rope: m
  Vec2d pin_a;        ///< pulley: world
  Vec2d pin_b;
  bool broken = false;  ///< it is gone, because its load was too much
};

/// One box of the broad phase's tree.
struct TreeBoxView {
  Aabbd box;
  int depth = 0;  ///< 0 at the root
  bool leaf = false;
};

struct Snapshot {
  std::int64_t tick = 0;
  double time = 0;               ///< s, tick / rate
  std::vector<BodyView> bodies;  ///< in order of id, the removed ones left out, the world not listed
  std::vector<ShapeView> shapes;
  std::vector<Vec2d> points;
  std::vector<ContactView> contacts;
  std::vector<JointView> joints;
  std::vector<TreeBoxView> tree;      ///< parents before children
  std::vector<Aabbd> aabbs;           ///< the tight boxes of all shapes
  std::optional<double> water_level;  ///< y of the surface, where bodies float
  Energy energy;
};

/// The body of this id, or null when the snapshot does not hold it.
const BodyView* find_body(const Snapshot& snapshot, BodyId id);

}  // namespace proofreel
