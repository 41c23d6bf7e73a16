#include "engine/exact_contacts.h"

#include <algorithm>
#include <limits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Of Newton's method, which then has settled, or hardly will.
constexpr int most_newton_rounds = 40;
constexpr int most_affordable_rounds = 6;
constexpr int most_sweeps = 1000;
constexpr int most_affordable_sweeps = 60;
/// So often at most the ways of the contacts are looked at again, because bodies turn.
constexpr int most_rounds_of_turning = 3;
constexpr int affordable_rounds_of_turning = 2;
/// Impulses at hand that are off by no more than this part of the largest are left as they are, before the drift and
/// after it: gaps that are found far from the origin flicker by as much, and speeds do not.
constexpr double negligible_gap = 1e-8;
constexpr double negligible_speed = 1e-12;
/// What responses are known to, where a row's own is 1: among bodies alone, and with joints that answer.
constexpr double noise_of_contacts = 1e-10;
constexpr double noise_of_joints = sizeof(real) == sizeof(double) ? 1e-9 : 1e-5;

/// How fast one row changes by a unit impulse along another one, where nothing but the bodies themselves answers. In
/// double precision: for the solution to exist the matrix has to be symmetric, and positive where it should be.
double response_between(const Term& one, const Term& other, const std::vector<Motion>& motions) {
  double speed = 0;
  for (const bool b : {false, true}) {
    for (const bool other_b : {false, true}) {
      const BodyIndex body = b ? one.body_b : one.body_a;
      if (body != (other_b ? other.body_b : other.body_a)) continue;
      const double arms =
          static_cast<double>(b ? one.arm_b : one.arm_a) * static_cast<double>(other_b ? other.arm_b : other.arm_a);
      const Motion& m = motions[body];
      const double sum = static_cast<double>(m.inv_mass) * dot(Vec2d(one.direction), Vec2d(other.direction)) +
                         static_cast<double>(m.inv_inertia) * arms;
      speed += b == other_b ? sum : -sum;
    }
  }
  return speed;
}

bool is_of_point(const ContactRow& row) { return row.kind == RowKind::gap || row.kind == RowKind::slip; }

}  // namespace

/// Where joints answer they have to answer first, before the ways are looked at again. What turning leaves open in a
/// large group, which hardly turns, the next substep closes.
void ExactContacts::solve_positions(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene, real h,
                                    Reach reach) {
  const int most_rounds = share_ == Share::all ? most_rounds_of_turning : affordable_rounds_of_turning;
  for (Group& group : groups()) {
    if (!group.chosen()) continue;
    const bool once = !group.joint_groups.empty() || (group.large && share_ == Share::affordable);
    const int rounds = once ? 1 : most_rounds;
    for (int round = 0; round < rounds; ++round) {
      if (goals_.set(group.rows, contacts, scene.motions, h, reach == Reach::closed) <= 1 && round > 0) break;
      take_in_stops(group, joints, scene, h);
      if (!solve(group, contacts, joints, scene, Stage::before_drift)) break;
    }
  }
}

/// What pressed before the drift touches after it, whatever rounding and turning have left open. What has not arrived
/// yet, be it by a hair, must not be braked: it may be about to bounce.
void ExactContacts::solve_velocities(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene,
                                     Reach reach) {
  const std::vector<real>& belts = contacts.surface_speeds();
  for (Group& group : groups()) {
    if (!group.chosen()) continue;
    take_in_stops(group, joints, scene, 0);
    for (ContactRow& row : group.rows) {
      if (!is_of_point(row)) continue;
      const ContactConstraint& c = contacts.constraints()[row.constraint];
      const ConstraintPoint& p = c.points[row.place];
      row.expected = row.kind == RowKind::gap ? p.warm_normal : p.warm_tangent;
      if (row.kind == RowKind::slip) {
        row.bias = belts.empty() ? real(0) : -belts[row.constraint];
        continue;
      }
      row.bias = 0;
      if (reach == Reach::closed) continue;
      row.off = p.normal_impulse <= 0 && separation_of(c, p, scene.motions[c.body_a], scene.motions[c.body_b]) > 0;
    }
    solve(group, contacts, joints, scene, Stage::after_drift);
  }
}

/// The stops of its joints take part as rows after those of the contacts: those in reach of a drift of `h`, or without
/// one those that held at the last.
void ExactContacts::take_in_stops(Group& group, JointSolver* joints, const JointedBodies& scene, real h) {
  std::erase_if(group.rows, [](const ContactRow& row) { return row.kind == RowKind::stop; });
  for (const std::size_t g : group.joint_groups) {
    JointGroup& jointed = joints->group(g);
    if (!jointed.has_stops()) continue;
    stops_.clear();
    h > 0 ? jointed.find_stops(scene, h, stops_) : jointed.find_touched_stops(scene, stops_);
    for (const Stop& stop : stops_) {
      ContactRow& row = group.rows.emplace_back(ContactRow{RowKind::stop, g, stop.row, stop.term});
      row.bias = stop.bias;
      row.given = stop.given;
    }
    jointed.release_stops(scene);
  }
}

/// False where the impulses at hand are the solution.
bool ExactContacts::solve(Group& group, ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene,
                          Stage stage) {
  const auto impulse_of = [&contacts](const ContactRow& row) -> real& {
    if (row.kind == RowKind::roll) return contacts.rolling()[row.place].impulse;
    ConstraintPoint& p = contacts.constraints()[row.constraint].points[row.place];
    return row.kind == RowKind::gap ? p.normal_impulse : p.tangent_impulse;
  };
  before_.clear();
  for (ContactRow& row : group.rows) {
    if (row.kind != RowKind::stop) row.given = impulse_of(row);
    if (row.kind == RowKind::slip) row.coefficient = friction_of(contacts.constraints()[row.constraint]);
    before_.push_back(row.given);
  }
  const bool after = stage == Stage::after_drift;
  const bool changed = group.large && share_ == Share::affordable
                           ? solve_large(group, contacts, scene.motions)
                           : solve_rows(group, joints, scene.motions, after ? negligible_speed : negligible_gap);
  if (!changed) return false;
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    const ContactRow& row = group.rows[i];
    if (row.kind != RowKind::stop) {
      impulse_of(row) = row.given;
    } else {
      joints->group(row.constraint).set_stop({row.place, row.term, 0, before_[i]}, row.given, after, scene);
    }
  }
  return true;
}

/// Where exactness is what was asked for: by pivots, where they are few; else by Newton's method; else by sweeps.
bool ExactContacts::solve_rows(Group& group, const JointSolver* joints, std::vector<Motion>& motions,
                               double negligible) {
  if (share_ == Share::affordable && group.joint_groups.empty()) return solve_cheaply(group, motions, negligible);
  const bool few = group.rows.size() <= most_rows_to_pivot;
  if (few) find_responses(group, joints, motions);
  const double noise = group.joint_groups.empty() ? noise_of_contacts : noise_of_joints;
  if (few && solve_by_pivots(group.rows, group.response, noise, motions)) return true;
  if (group.by_newton && group.newton.solve(group.rows, motions, most_newton_rounds)) return true;
  if (few && !group.joint_groups.empty()) {
    solve_by_sweeps(group.rows, group.response, motions, share_ == Share::all ? most_sweeps : most_affordable_sweeps);
  } else {
    solve_by_sweeps(group.rows, motions, most_sweeps);
  }
  return true;
}

/// What finds no balance is on the move: its contacts are soft for the rest of the tick.
bool ExactContacts::solve_large(Group& group, ContactSolver& contacts, std::vector<Motion>& motions) {
  if (group.newton.solve_once(group.rows, motions)) return true;
  group.left = Left::large;
  for (const ContactRow& row : group.rows) contacts.constraints()[row.constraint].exact = false;
  return true;
}

/// The next substep goes on with what has not settled: unless it never will, because something that does not give way
/// presses.
bool ExactContacts::solve_cheaply(Group& group, std::vector<Motion>& motions, double negligible) {
  if (group.lone_body != 0) {
    const auto outcome = lone_body_contacts_.solve(group.rows, group.lone_body, motions, negligible);
    if (outcome != LoneBodyContacts::Outcome::unsolved) return outcome == LoneBodyContacts::Outcome::solved;
    group.newton.plan(group.rows, motions, std::numeric_limits<double>::infinity());
  } else if (group.newton.is_in_balance(group.rows, motions, negligible)) {
    return false;
  }
  if (group.newton.solve(group.rows, motions, most_affordable_rounds)) return true;
  group.failed = true;
  if (has_mover(group.rows, motions)) {
    solve_by_sweeps(group.rows, motions, most_affordable_sweeps);
  } else {
    group.newton.apply(group.rows, motions);
  }
  return true;
}

/// What every impulse does to every row. Without joints nothing changes within a tick.
void ExactContacts::find_responses(Group& group, const JointSolver* joints, const std::vector<Motion>& motions) {
  const std::size_t n = group.rows.size();
  if (!group.joint_groups.empty()) return try_responses(group, *joints, motions);
  if (group.response.size() == n * n) return;
  group.response.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      group.response[i * n + j] = group.response[j * n + i] =
          response_between(group.rows[i].term, group.rows[j].term, motions);
    }
  }
}

/// Where joints answer, it is found by trying: all bodies are brought to rest and pushed.
void ExactContacts::try_responses(Group& group, const JointSolver& joints, const std::vector<Motion>& motions) {
  const std::size_t n = group.rows.size();
  group.response.resize(n * n);
  scratch_ = motions;
  std::vector<BodyIndex> bodies;
  for (const ContactRow& row : group.rows) bodies.insert(bodies.end(), {row.term.body_a, row.term.body_b});
  for (const std::size_t g : group.joint_groups)
    bodies.insert(bodies.end(), joints.bodies_of(g).begin(), joints.bodies_of(g).end());
  for (std::size_t j = 0; j < n; ++j) {
    for (const BodyIndex body : bodies) {
      scratch_[body].velocity = {};
      scratch_[body].spin = 0;
    }
    push(group.rows[j].term, 1, scratch_);
    for (const std::size_t g : group.joint_groups) joints.hold(g, scratch_);
    for (std::size_t i = 0; i < n; ++i)
      group.response[i * n + j] = static_cast<double>(speed_of(group.rows[i].term, scratch_));
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
