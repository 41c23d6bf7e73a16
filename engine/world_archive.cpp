// Saving a world and taking it up again. What is stored is all that lives from tick to tick, with its order; what a
// tick makes anew is not, and groups of joints are made anew from what is stored.

#include <algorithm>
#include <iterator>

#include "engine/scene_archive.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr Mark mark{'p', 'r', 'o', 'o', 'f', 'r', 's', 't'};
/// Changes with every change of what is stored.
constexpr std::uint32_t version = 5;

}  // namespace

template <typename Archive, Exchanged<Mover> T>
void exchange(Archive& archive, T& mover) {
  auto& [velocity, spin, inv_inertia, inv_mass] = mover;
  archive(velocity, spin, inv_mass, inv_inertia);
}

template <typename Archive, Exchanged<Motion> T>
void exchange(Archive& archive, T& motion) {
  std::conditional_t<std::is_const_v<T>, const Mover, Mover>& mover = motion;
  static_assert(sizeof motion == sizeof mover + sizeof motion.delta + sizeof motion.rotation + sizeof motion.angle);
  archive(mover, motion.delta, motion.rotation, motion.angle);
}

template <typename Archive, Exchanged<Body> T>
void exchange(Archive& archive, T& body) {
  auto& [name, type, acts_as, alive, fixed_rotation, bullet, sensor, center, local_center, mass, inertia, gravity_scale,
         filter, drag, color, shapes, defs, given_mass, given_inertia] = body;
  archive(name, type, acts_as, alive, fixed_rotation, bullet, sensor, center, local_center, mass, inertia,
          gravity_scale, filter, drag, color, shapes, defs, given_mass, given_inertia);
}

template <typename Archive, Exchanged<Hull> T>
void exchange(Archive& archive, T& hull) {
  auto& [points, normals, count, radius, thickness, detail] = hull;
  archive(count, radius, thickness, detail);
  const int used = std::clamp(count, 1, max_polygon_vertices);
  for (int i = 0; i < used; ++i) archive(points[i], normals[i]);
  if constexpr (Archive::reads) {  // as make_hull fills it
    std::fill(points + used, std::end(points), points[0]);
    std::fill(normals + used, std::end(normals), normals[0]);
  }
}

template <typename Archive, Exchanged<CornerSeam> T>
void exchange(Archive& archive, T& corner) {
  auto& [joined, before_exposed, after_exposed, before_convex, after_convex, before_concave, after_concave,
         before_until, after_from, before_free, after_free] = corner;
  archive(joined, before_exposed, after_exposed, before_convex, after_convex, before_concave, after_concave,
          before_until, after_from, before_free, after_free);
}

template <typename Archive, Exchanged<Seam> T>
void exchange(Archive& archive, T& seam) {
  auto& [corners, hidden_from_start, hidden_to_end] = seam;
  archive(corners, hidden_from_start, hidden_to_end);
}

template <typename Archive, Exchanged<Shape> T>
void exchange(Archive& archive, T& shape) {
  auto& [hull, seam, body, alive, density, friction_at_rest, friction_sliding, restitution, rolling_resistance,
         surface_speed, reach, proxy] = shape;
  std::optional<Seam> seam_value;
  if (seam != nullptr) seam_value = *seam;
  archive(hull, seam_value, body, alive, density, friction_at_rest, friction_sliding, restitution, rolling_resistance,
          surface_speed, reach, proxy);
  if constexpr (Archive::reads) seam = seam_value ? std::make_shared<Seam>(*seam_value) : nullptr;
}

template <typename Archive, Exchanged<RowMemory> T>
void exchange(Archive& archive, T& memory) {
  auto& [impulse, engaged, missed] = memory;
  archive(impulse, engaged, missed);
}

template <typename Archive, Exchanged<JointLimits> T>
void exchange(Archive& archive, T& limits) {
  auto& [lower, upper] = limits;
  archive(lower, upper);
}

template <typename Archive, Exchanged<JointMotor> T>
void exchange(Archive& archive, T& motor) {
  auto& [speed, strongest] = motor;
  archive(speed, strongest);
}

template <typename Archive, Exchanged<Joint> T>
void exchange(Archive& archive, T& joint) {
  auto& [kind, alive, acts, broken, body_a, body_b, local_a, local_b, local_axis, length, angle, offset, size,
         stiffness, damping, ratio, limits, motor, break_force, first, second, pin_a, pin_b, target, velocity,
         max_force, impulse, soft_impulse, twist, memory] = joint;
  archive(kind, alive, acts, broken, body_a, body_b, local_a, local_b, local_axis, length, angle, offset, size,
          stiffness, damping, ratio, limits, motor, break_force, first, second, pin_a, pin_b, target, velocity,
          max_force, impulse, soft_impulse, twist, memory);
}

template <typename Archive, Exchanged<Rocket> T>
void exchange(Archive& archive, T& rocket) {
  auto& [body, thrust, burn_rate, fuel, at] = rocket;
  archive(body, thrust, burn_rate, fuel, at);
}

template <typename Archive, Exchanged<ManifoldPoint> T>
void exchange(Archive& archive, T& manifold_point) {
  auto& [point, separation, feature] = manifold_point;
  archive(point, separation, feature);
}

template <typename Archive, Exchanged<Manifold> T>
void exchange(Archive& archive, T& manifold) {
  auto& [normal, points, count] = manifold;
  archive(normal, points, count);
}

template <typename Archive, Exchanged<PointImpulse> T>
void exchange(Archive& archive, T& impulse) {
  auto& [normal, tangent, normal_total, tangent_total] = impulse;
  archive(normal, tangent, normal_total, tangent_total);
}

template <typename Archive, Exchanged<Patience> T>
void exchange(Archive& archive, T& patience) {
  auto& [failures, soft_ticks] = patience;
  archive(failures, soft_ticks);
}

template <typename Archive, Exchanged<Contact> T>
void exchange(Archive& archive, T& contact) {
  auto& [shape_a, shape_b, body_a, body_b, sensor, touching, parting, sliding, patience, number, friction_at_rest,
         friction_sliding, restitution, rolling_resistance, surface_speed, approach, manifold, a_to_b, impulses,
         rolling_impulse] = contact;
  archive(shape_a, shape_b, body_a, body_b, sensor, touching, parting, sliding, patience, number, friction_at_rest,
          friction_sliding, restitution, rolling_resistance, surface_speed, approach, manifold, a_to_b, impulses,
          rolling_impulse);
}

/// The children share their place with the owner.
template <typename Archive, typename Self>
void DynamicTree::Node::exchange(Archive& archive, Self& node) {
  archive(node.box, node.parent, node.height);
  if (node.is_leaf()) {
    archive(node.owner);
  } else {
    archive(node.children);
  }
}

template <typename Archive, typename Self>
void DynamicTree::exchange(Archive& archive, Self& tree) {
  auto& [nodes, root, first_free] = tree;
  archive(nodes, root, first_free);
}

template <typename Archive, typename Self>
void BroadPhase::exchange(Archive& archive, Self& broad_phase) {
  auto& [tree, moved, is_moved, moves_since_rebuild, known] = broad_phase;
  archive(tree, moved, is_moved, moves_since_rebuild, known);
}

template <typename Archive, typename Self>
void JointGroup::exchange(Archive& archive, Self& group) {
  [[maybe_unused]] auto& [rows, links, bounded, on, links_on, bodies, seen, ahead, ahead_places, factored_with,
                          couplings, matrix, levers, right_side, scales, too_dense, renumber, stale, redundant, uneven,
                          strained, in_turns, share, equal, one_sided, driven, work, moved_from] = group;
  archive(redundant, uneven, strained);
}

template <typename Archive, typename Self>
void JointSolver::exchange(Archive& archive, Self& solver) {
  for (auto& group : solver.groups_) archive(group);
  for (auto& group : solver.asleep_) archive(group);
}

template <typename Archive, typename Self>
void RestClock::exchange(Archive& archive, Self& clock) {
  auto& [center, angle, fastest, ticks] = clock;
  archive(center, angle, fastest, ticks);
}

template <typename Archive, Exchanged<RestScale> T>
void exchange(Archive& archive, T& scale) {
  auto& [reach, ticks] = scale;
  archive(reach, ticks);
}

template <typename Archive, Exchanged<Sleep> T>
void exchange(Archive& archive, T& sleep) {
  auto& [scales, clocks, islands, forces, contacts, events, next_events, sleepers] = sleep;
  archive(scales, clocks, islands, forces, contacts, events, next_events, sleepers);
}

template <typename Archive, typename Self>
void World::Push::exchange(Archive& archive, Self& push) {
  auto& [body, force, torque, angle_before] = push;
  archive(body, force, torque, angle_before);
}

template <typename Archive, typename Self>
void World::exchange(Archive& archive, Self& world) {
  // Not stored: what it was made with, which the fresh one has; what every tick begins with making; who looks on.
  [[maybe_unused]] auto& [scene_hash, method, rate, dt, h, substeps, most_substeps, gravity, drag, wind, attractors,
                          gravitational_constant, listed_effects, census, effects, structure_changed, ground_changed,
                          has_broad_phase, bodies_are_free, forces_kept, islands_kept, commanded, bodies, motions,
                          accelerations, drags, pushed, velocities_before, paces, shapes, free_shapes, joints, rockets,
                          broad_phase, contacts, contacts_made, contact_solver, exact_contacts, joint_solver,
                          smooth_integrator, pulled, diverged, hinged, touches, locating, events, separation_events,
                          separated_by_commands, break_events, water, wetted, fields, sleep, drifts, booked_work, tick,
                          failure, times, work] = world;
  archive(census, effects, structure_changed, ground_changed, has_broad_phase, bodies_are_free, commanded, bodies,
          motions, accelerations, drags, pushed, velocities_before, shapes, free_shapes, joints, rockets, broad_phase,
          contacts, contacts_made, diverged, events, separation_events, separated_by_commands, break_events, sleep,
          substeps, most_substeps, drifts, booked_work, tick, failure);
  if constexpr (Archive::reads) world.h_ = dt / static_cast<real>(std::max(substeps, 1));
  if (structure_changed) return;  // the next tick groups the joints anew
  if constexpr (Archive::reads) {
    if (archive.spoilt() || !world.joints_are_sound()) return archive.spoil();
    world.rebuild_joints();
    if (sleep.sleepers > 0) joint_solver.lay_aside_sleepers(joints);
  }
  archive(joint_solver);
}

std::vector<std::byte> World::save() const {
  ArchiveWriter archive;
  archive(method_.precision, scene_hash_, *this);
  return sealed(mark, version, archive.bytes());
}

/// Into a copy first, so that nothing has changed where it fails.
std::optional<std::string> World::restore(std::span<const std::byte> bytes) {
  const auto content = unsealed(mark, version, bytes);
  if (const auto* problem = std::get_if<std::string>(&content)) return *problem;
  ArchiveReader archive(std::get<std::span<const std::byte>>(content));
  Precision precision{};
  std::uint64_t scene_hash = 0;
  archive(precision, scene_hash);
  if (!archive.spoilt() && precision != method_.precision)
    return std::string("is in ") + (precision == Precision::float32 ? "single" : "double") + " precision";
  if (!archive.spoilt() && scene_hash != scene_hash_) return "is of another scene";
  World restored = *this;
  archive(restored);
  if (!archive.ended_well() || !restored.is_sound(bodies_.size())) return "contradicts itself";
  *this = std::move(restored);
  return std::nullopt;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
