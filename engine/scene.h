#pragma once

/// A scene is what is simulated, as plain data in double precision: no pointers, no script, nothing of the solver.
/// SI units, radians, y up. Ids are positions in the order of creation and are never used again.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "engine/vec2.h"

namespace proofreel {

/// Body 0 is the immovable world; the first body of a scene is body 1.
enum class BodyId : std::uint32_t { world = 0 };
/// The first joint of a scene is joint 0.
enum class JointId : std::uint32_t {};

enum class BodyType : std::uint8_t {
  fixed,      ///< "static": never moves
  kinematic,  ///< moves as its velocity says, nothing pushes it
  dynamic     ///< moved by forces and contacts
};

/// Coulomb's two coefficients: the larger one holds a resting contact, the smaller one brakes a sliding one.
struct FrictionDef {
  double at_rest = 0.5;
  double sliding = 0.5;
  friend bool operator==(const FrictionDef&, const FrictionDef&) = default;
};

/// The most vertices one convex polygon may have.
inline constexpr int max_polygon_vertices = 16;

/// Every shape is the set of points within `radius` of the convex hull of `points`, in body coordinates:
/// one point is a disc, two a capsule (a segment when the radius is 0), three and more a polygon (rounded when radius >
/// 0). Polygons are listed counter-clockwise. A concave polygon, or one of more corners, is several shapes of one body:
/// clean_polygon (outline.h) and then convex_parts (decompose.h) make their points.
struct ShapeDef {
  std::vector<Vec2d> points;
  double radius = 0;
  double density = 1;  ///< kg/m^2
  FrictionDef friction;
  double restitution = 0;
  double rolling_resistance = 0;  ///< lever, m: what rolls is braked by a torque of lever * normal force
  double surface_speed = 0;       ///< of a belt round the shape, m/s along the tangent, counter-clockwise positive
};

/// What meets what: bodies of the same negative group never do; otherwise both masks must hold the other's category.
struct FilterDef {
  std::int32_t group = 0;
  std::uint64_t category = 1;
  std::uint64_t mask = ~std::uint64_t{0};
  friend bool operator==(const FilterDef&, const FilterDef&) = default;
};

/// Whether two bodies may meet at all.
inline bool filters_agree(const FilterDef& a, const FilterDef& b) {
  if (a.group == b.group && a.group < 0) return false;
  return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

/// Resistance of the medium against motion relative to it: force -(linear + quadratic |v|) v, torque -angular w.
struct DragDef {
  double linear = 0;     ///< N s/m
  double quadratic = 0;  ///< N s^2/m^2
  double angular = 0;    ///< N m s
  bool acts() const { return linear > 0 || quadratic > 0 || angular > 0; }
};

struct BodyDef {
  std::string name;
  BodyType type = BodyType::dynamic;
  Vec2d position;  ///< of the origin the shapes' coordinates are written in
  double angle = 0;
  Vec2d velocity;  ///< of the centre of mass; a kinematic body's is its origin
  double spin = 0;
  std::vector<ShapeDef> shapes;
  std::optional<double> mass;     ///< kg; without it, density times area
  std::optional<double> inertia;  ///< kg m^2 about the centre of mass; without it, from the shapes, scaled to `mass`
  double gravity_scale = 1;
  bool fixed_rotation = false;
  bool bullet = false;  ///< looks ahead for what it meets within a tick, moving bodies included
  bool sensor = false;  ///< reports contacts but pushes nothing
  FilterDef filter;
  std::optional<DragDef> drag;         ///< without it, the scene's
  std::optional<std::uint32_t> color;  ///< 0xRRGGBB; without it, by body type
};

enum class JointKind : std::uint8_t {
  revolute,   ///< keeps two anchors together
  distance,   ///< keeps two anchors `length` apart, as a massless rod
  spring,     ///< pulls two anchors towards `length` apart
  rope,       ///< keeps two anchors within `length` of each other
  prismatic,  ///< b slides along `axis` of a and does not turn against it
  weld,       ///< makes two bodies one
  wheel,      ///< b turns freely, and moves along `axis` of a on a spring
  gear,       ///< couples the coordinates of two other joints
  pulley,     ///< two ropes over two fixed pins: what one side gains the other loses
  drag_to,    ///< pulls a point of body b softly to a point of the world
  motor       ///< drives b relative to a, with nothing else holding them
};

/// Lowest and highest value of a joint's coordinate, counted from where it was when the joint was made: rad, or m.
struct LimitsDef {
  double lower = 0;
  double upper = 0;
};

/// Drives a coordinate at a speed with as much as it takes, but no more than `strongest`: rad/s and N m, or m/s and N.
struct MotorDef {
  double speed = 0;
  double strongest = 0;
};

/// Anchors are in the coordinates of their bodies (world coordinates for the world body). Speeds and limits are of b
/// relative to a.
struct JointDef {
  JointKind kind = JointKind::revolute;
  BodyId a = BodyId::world;
  BodyId b = BodyId::world;
  Vec2d anchor_a;
  Vec2d anchor_b;
  double length = 0;                  ///< distance, spring, rope: m
  double stiffness = 0;               ///< spring, wheel: N/m
  double damping = 0;                 ///< spring, wheel: N s/m along the spring
  Vec2d axis{1, 0};                   ///< prismatic, wheel: unit, in the coordinates of a
  std::optional<LimitsDef> limits;    ///< revolute (rad), prismatic (m)
  std::optional<MotorDef> motor;      ///< revolute, wheel, motor (rad/s, N m), prismatic (m/s, N)
  std::optional<double> break_force;  ///< N: the joint goes when its mean reaction over a tick is larger
  double ratio = 1;                   ///< gear, pulley
  JointId first{};                    ///< gear: two of revolute and prismatic
  JointId second{};
  Vec2d pin_a;           ///< pulley: world
  Vec2d pin_b;           ///< pulley: world
  Vec2d target;          ///< drag_to: world
  Vec2d velocity;        ///< motor: m/s of b's centre as seen from a, world axes
  double max_force = 0;  ///< drag_to, motor: N (motor: along each axis; 0 drives no translation)
};

/// Whether the joint holds by force alone, like a spring, and has no equation that must be met.
inline bool is_soft(JointKind kind) { return kind == JointKind::spring || kind == JointKind::drag_to; }
/// Whether the joint has a spring, and a damper.
inline bool is_springy(JointKind kind) { return kind == JointKind::spring || kind == JointKind::wheel; }
/// Whether the joint's two bodies may overlap: they do not collide with each other.
inline bool lets_overlap(JointKind kind) {
  return kind == JointKind::revolute || kind == JointKind::prismatic || kind == JointKind::weld ||
         kind == JointKind::wheel;
}

enum class AttractionLaw : std::uint8_t {
  inverse_square,  ///< m * strength / r^2, strength in m^3/s^2
  linear           ///< m * strength * r, strength in 1/s^2
};

/// Pulls every dynamic body's centre of mass towards a point, or towards another body, which feels it in return.
struct AttractorDef {
  std::optional<BodyId> body;
  Vec2d at;  ///< without a body
  double strength = 0;
  AttractionLaw law = AttractionLaw::inverse_square;
};

/// Pushes a body along its own +y and takes from its mass what it burns, until the fuel is gone.
struct RocketDef {
  BodyId body{};
  double thrust = 0;     ///< N
  double burn_rate = 0;  ///< kg/s, above 0
  double fuel = 0;       ///< kg, less than the body's mass
  Vec2d at;              ///< where it pushes, in body coordinates
};

/// Water at rest that fills everything below a height. Gravity must point down (x = 0, y <= 0): its level is one.
struct WaterDef {
  double level = 0;    ///< y of its surface, m
  double density = 0;  ///< kg/m^2
  double drag = 0;     ///< N s/m for every square metre of a body that is wet
};

/// A force in N on a centre of mass that is at a place, m, with a velocity, m/s, at a time, s. Must give the same for
/// the same: nothing else may decide.
using ForceField = std::function<Vec2d(Vec2d at, Vec2d velocity, double time)>;

/// Contacts take the first two, rigid joints the first three; scenes with neither take all (`problem_with_method`).
enum class Integrator : std::uint8_t { symplectic_euler, verlet, suzuki4, rk4, implicit_midpoint, gauss_legendre6 };
enum class Precision : std::uint8_t { float32, float64 };

/// How contacts and their friction are solved.
enum class ContactMethod : std::uint8_t {
  automatic,            ///< exact where that is affordable, island by island, and soft_step for the others
  soft_step,            ///< contacts are stiff damped springs, and what they push too much is taken back
  sequential_impulses,  ///< one contact after the other, overlap driven out by velocity (as taught: Baumgarte)
  ngs,                  ///< the same, overlap taken out of the positions afterwards (nonlinear Gauss-Seidel)
  exact,                ///< all contacts of an island at once, exactly: the truth the others are measured against
  event                 ///< as exact, and every impact at its own time
};

/// How rigid joints are solved.
enum class JointMethod : std::uint8_t {
  direct,    ///< all rows of a connected group at once, exactly
  iterative  ///< one row after the other (as taught)
};

/// How a scene is solved.
struct Method {
  Integrator integrator = Integrator::verlet;
  ContactMethod contact_solver = ContactMethod::automatic;
  JointMethod joint_solver = JointMethod::direct;
  int substeps = 2;                  ///< per tick, at least 1
  std::optional<int> iterations;     ///< solver sweeps per substep, at least 1; without it, see `sweeps_per_substep`
  std::optional<double> contact_hz;  ///< stiffness of soft contacts, which then all are; without it, 0.2 per substep
  Precision precision = Precision::float64;
};

/// How many sweeps the solvers make in a substep: as many as the method says, else 8 for those that approach the
/// solution sweep by sweep, and 1 for the others.
inline int sweeps_per_substep(const Method& method) {
  const bool approaches = method.contact_solver == ContactMethod::sequential_impulses ||
                          method.contact_solver == ContactMethod::ngs || method.joint_solver == JointMethod::iterative;
  return method.iterations.value_or(approaches ? 8 : 1);
}

/// What acts in a scene. A stage nobody needs is not run.
enum class Effect : std::uint8_t {
  gravity,
  drag,
  wind,
  attractor,
  nbody,
  buoyancy,
  field,
  springs,
  rocket,
  contacts,
  friction,
  rolling_resistance,
  restitution,
  surface_speed,
  ccd,
  joints,
  limits,
  motors,
  breakage,
  sensors,
  sleeping
};
inline constexpr int effect_count = 21;

/// A set of effects.
class EffectSet {
 public:
  constexpr EffectSet() = default;
  constexpr EffectSet(std::initializer_list<Effect> effects) {
    for (const Effect e : effects) add(e);
  }
  constexpr bool has(Effect e) const { return (bits_ >> static_cast<unsigned>(e) & 1U) != 0; }
  constexpr bool has_only(EffectSet others) const { return (bits_ & ~others.bits_) == 0; }
  constexpr void add(Effect e) { bits_ |= 1U << static_cast<unsigned>(e); }
  friend bool operator==(EffectSet, EffectSet) = default;
  /// For archives (archive.h).
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& set) {
    archive(set.bits_);
  }

 private:
  std::uint32_t bits_ = 0;
};

struct Scene {
  int rate = 240;  ///< ticks per second
  Vec2d gravity{0, -9.81};
  Method method;
  std::optional<EffectSet> effects;  ///< exactly these; without it, inferred from what the scene holds
  std::vector<BodyDef> bodies;       ///< body i + 1 is bodies[i]
  std::vector<JointDef> joints;      ///< joint i is joints[i]
  DragDef drag;                      ///< of bodies that have none of their own
  Vec2d wind;                        ///< m/s, the velocity of the medium that drags
  std::vector<AttractorDef> attractors;
  std::optional<double> gravitational_constant;  ///< m^3/(kg s^2): dynamic bodies attract each other
  std::vector<RocketDef> rockets;
  std::optional<WaterDef> water;
  bool sleeping = false;           ///< somebody asks when bodies fall asleep: those that rest may
  std::vector<ForceField> fields;  ///< add up; what they refer to must outlive the simulation
};

}  // namespace proofreel
