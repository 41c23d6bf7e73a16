#include "engine/exact_contacts.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/islands.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Multiplications for a factorisation of a group.
constexpr double most_work = 2e7;
/// The same where others would do, if not as well; and contacts of a group, without joints and with them.
constexpr double most_affordable_work = 2e6;
constexpr std::size_t most_affordable_contacts = 150;
constexpr std::size_t most_affordable_with_joints = 16;
/// A soft contact gives way by about 1.6 h times the speed that its impulse of a substep makes; a five hundredth of the
/// thickness shows.
constexpr real visible_load = real(0.00125);
/// Where stops take part contacts are solved exactly up to this speed between the surfaces, in thicknesses per second.
constexpr real fastest_with_stops = 3;
/// Of Newton's method, which then has settled, or hardly will.
constexpr int most_newton_rounds = 40;
constexpr int most_affordable_rounds = 6;
constexpr int most_sweeps = 1000;
constexpr int most_affordable_sweeps = 60;
/// So often at most the ways of the contacts are looked at again, because bodies turn.
constexpr int most_rounds_of_turning = 3;
constexpr int affordable_rounds_of_turning = 2;
/// What responses are known to, where a row's own is 1: among bodies alone, and with joints that answer.
constexpr double noise_of_contacts = 1e-10;
constexpr double noise_of_joints = sizeof(real) == sizeof(double) ? 1e-9 : 1e-5;

BodyIndex moved_body(const ContactConstraint& c, const std::vector<Motion>& motions) {
  return is_moved(motions[c.body_a]) ? c.body_a : c.body_b;
}

real speed_at(const ContactConstraint& c, const ConstraintPoint& p, const std::vector<Motion>& motions) {
  return length(motions[c.body_b].velocity_at(p.arm_b) - motions[c.body_a].velocity_at(p.arm_a));
}

Term term_along(const ContactConstraint& c, const ConstraintPoint& p, Vec2 direction) {
  return {c.body_a, c.body_b, direction, cross(p.arm_a, direction), cross(p.arm_b, direction)};
}

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

/// A point's gap now and after drifting on for a while, and how far the surfaces slide along each other meanwhile.
struct Way {
  real gap = 0;
  real gap_after = 0;
  real slide = 0;
};

/// Cores turn about their centres, roundings roll off: their points of contact are others all the time.
Way way_of(const ContactConstraint& c, const ConstraintPoint& p, const std::vector<Motion>& motions, real h) {
  Motion a = motions[c.body_a];
  Motion b = motions[c.body_b];
  const auto apart = [&] {
    return (b.delta - a.delta) + rotate(b.rotation, p.local_b) - rotate(a.rotation, p.local_a);
  };
  const Vec2 before = apart();
  const real rolled = h * (c.radius_a * a.spin + c.radius_b * b.spin);
  drift(a, h);
  drift(b, h);
  const Vec2 after = apart();
  return {p.base_separation + dot(before, c.normal), p.base_separation + dot(after, c.normal),
          dot(after - before, perp(c.normal)) - rolled};
}

bool is_of_point(const ContactRow& row) { return row.kind == RowKind::gap || row.kind == RowKind::slip; }

}  // namespace

void ExactContacts::prepare(ContactSolver& contacts, const JointSolver* joints, const std::vector<Motion>& motions,
                            real h, Share share) {
  share_ = share;
  group_by_bodies(contacts, joints, motions);
  for (Group& group : groups()) group.left = share == Share::all ? Left::solved : first_look(group, joints);
  std::vector<ContactConstraint>& constraints = contacts.constraints();
  if (share == Share::affordable) look_for_load(constraints, joints, motions, h);
  for (std::size_t i = 0; i < group_of_.size(); ++i) {
    if (groups_[group_of_[i]].chosen()) add_contact(groups_[group_of_[i]], i, contacts);
  }
  add_rolling(contacts);
  for (Group& group : groups()) {
    if (!group.chosen()) continue;
    const double work = share == Share::all ? most_work : most_affordable_work;
    group.by_newton = group.joint_groups.empty() && group.newton.plan(group.rows, motions, work);
    if (share == Share::affordable) {
      const bool few = group.rows.size() + group.stops <= most_rows_to_pivot;
      if (!group.by_newton && (!few || group.joint_groups.empty())) group.left = Left::large;
    }
  }
  for (std::size_t i = 0; i < group_of_.size(); ++i) constraints[i].exact = groups_[group_of_[i]].chosen();
  chosen_groups_ = 0;
  moves_joints_ = false;
  for (const Group& group : groups()) {
    chosen_groups_ += group.chosen() ? 1 : 0;
    moves_joints_ |= group.chosen() && !group.joint_groups.empty();
  }
}

/// A first look, before anything is made. What a moving body presses against another one that does not give way has no
/// solution; joints that are swept would be left out of the matrix; what is inside each other since it met is moved
/// apart more gently than by velocities.
ExactContacts::Left ExactContacts::first_look(const Group& group, const JointSolver* joints) {
  if (group.movers > 0 && group.immovables.size() > 1) return Left::squeezed;
  if (group.parts) return Left::overlaps;
  if (joints != nullptr && joints->sweeps()) return Left::nets;
  const std::size_t most = group.joint_groups.empty() ? most_affordable_contacts : most_affordable_with_joints;
  return group.contacts <= most ? Left::solved : Left::large;
}

/// Soft contacts give way by what they bear. Where joints answer, exactness costs a solution of all of them per point:
/// it is bought only where that giving way would show, by the impulses of the last substep; and with stops, each of
/// which is a row more, only once what touches has slowed down: what tumbles shows nothing.
void ExactContacts::look_for_load(const std::vector<ContactConstraint>& constraints, const JointSolver* joints,
                                  const std::vector<Motion>& motions, real h) {
  for (Group& group : groups()) {
    group.loaded = group.joint_groups.empty();
    group.stops = 0;
    group.tumbles = false;
    for (const std::size_t g : group.joint_groups) group.stops += joints->stops_of(g);
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const ContactConstraint& c = constraints[i];
    Group& group = groups_[group_of_[i]];
    for (int k = 0; k < c.count; ++k) {
      const ConstraintPoint& p = c.points[k];
      if (h * p.normal_impulse > visible_load * c.length * p.normal_mass) group.loaded = true;
      if (group.stops > 0 && speed_at(c, p, motions) > fastest_with_stops * c.length) group.tumbles = true;
    }
  }
  for (Group& group : groups()) {
    if (group.chosen() && !group.loaded) group.left = Left::unloaded;
    if (group.chosen() && group.tumbles) group.left = Left::tumbling;
  }
}

void ExactContacts::note_immovable(Group& group, BodyIndex body, const std::vector<Motion>& motions) {
  std::vector<BodyIndex>& known = group.immovables;
  if (is_moved(motions[body]) || std::find(known.begin(), known.end(), body) != known.end()) return;
  known.push_back(body);
  group.movers += is_mover(motions[body]) ? 1 : 0;
}

const char* ExactContacts::reason(Left left) {
  switch (left) {
    case Left::solved:
      return "";
    case Left::squeezed:
      return "a body that moves regardless presses them against another";
    case Left::overlaps:
      return "bodies of theirs overlap since they met";
    case Left::tumbling:
      return "their joints have stops, and they move too fast for it to show";
    case Left::nets:
      return "their joints are solved one by one";
    case Left::large:
      return "their islands are too large";
    case Left::unloaded:
      return "they bear too little to give way visibly";
  }
  return "";
}

std::string ExactContacts::told() const {
  if (group_of_.empty()) return "nothing touched at the last tick";
  std::size_t counts[static_cast<std::size_t>(Left::tumbling) + 1] = {};
  for (const Group& group : std::span(groups_.data(), used_))
    counts[static_cast<std::size_t>(group.left)] += group.contacts;
  std::string text = "at the last tick " + std::to_string(counts[0]) + " of " + std::to_string(group_of_.size()) +
                     " contacts were solved exactly";
  if (chosen_groups_ > 0)
    text += ", in " + std::to_string(chosen_groups_) + (chosen_groups_ == 1 ? " island" : " islands");
  for (std::size_t left = 1; left < std::size(counts); ++left) {
    if (counts[left] == 0) continue;
    text += ", " + std::to_string(counts[left]) + " softly: " + reason(static_cast<Left>(left));
  }
  return text;
}

void ExactContacts::group_by_bodies(const ContactSolver& contacts, const JointSolver* joints,
                                    const std::vector<Motion>& motions) {
  std::vector<std::uint8_t> takes_part;
  for (const Motion& m : motions) takes_part.push_back(is_moved(m) ? 1 : 0);
  std::vector<Link> links;
  for (const ContactConstraint& c : contacts.constraints()) links.push_back({c.body_a, c.body_b});
  const std::size_t joint_groups = joints != nullptr ? joints->group_count() : 0;
  for (std::size_t g = 0; g < joint_groups; ++g) {
    for (const BodyIndex body : joints->bodies_of(g)) links.push_back({joints->bodies_of(g).front(), body});
  }
  used_ = 0;
  const std::vector<std::uint32_t> island = number_islands(takes_part, links);
  const std::size_t none = motions.size();
  std::vector<std::size_t> group_of_island(motions.size() + 1, none);
  group_of_.clear();
  for (const ContactConstraint& c : contacts.constraints()) {
    std::size_t& group = group_of_island[island[moved_body(c, motions)]];
    if (group == none) {
      group = used_;
      add_group();
    }
    ++groups_[group].contacts;
    note_immovable(groups_[group], c.body_a, motions);
    note_immovable(groups_[group], c.body_b, motions);
    groups_[group].parts |= c.push_speed <= 0;
    group_of_.push_back(group);
  }
  for (std::size_t g = 0; g < joint_groups; ++g) {
    const std::size_t group = group_of_island[island[joints->bodies_of(g).front()]];
    if (group == none) continue;
    groups_[group].joint_groups.push_back(g);
  }
}

/// In the place of one of the tick before: what that one has room for serves again.
void ExactContacts::add_group() {
  if (used_ == groups_.size()) groups_.emplace_back();
  Group& group = groups_[used_++];
  group.contacts = 0;
  group.movers = 0;
  group.parts = false;
  group.immovables.clear();
  group.rows.clear();
  group.joint_groups.clear();
  group.response.clear();
}

void ExactContacts::add_contact(Group& group, std::size_t constraint, const ContactSolver& contacts) const {
  const ContactConstraint& c = contacts.constraints()[constraint];
  const std::size_t first = group.rows.size();
  const auto count = static_cast<std::size_t>(c.count);
  for (std::size_t k = 0; k < count; ++k)
    group.rows.push_back({RowKind::gap, constraint, k, term_along(c, c.points[k], c.normal)});
  if (!contacts.parts().friction || std::max(c.friction_at_rest, c.friction_sliding) <= 0) return;
  for (std::size_t k = 0; k < count; ++k) {
    ContactRow& row =
        group.rows.emplace_back(ContactRow{RowKind::slip, constraint, k, term_along(c, c.points[k], perp(c.normal))});
    row.first_gap = first + k;
    row.gap_count = 1;
  }
}

void ExactContacts::add_rolling(const ContactSolver& contacts) {
  const std::vector<RollingRows::Row>& rolling = contacts.rolling();
  for (std::size_t i = 0; i < rolling.size(); ++i) {
    Group& group = groups_[group_of_[rolling[i].constraint]];
    if (!group.chosen()) continue;
    std::vector<ContactRow>& rows = group.rows;
    const auto of_same = [&](const ContactRow& row) { return row.constraint == rolling[i].constraint; };
    const auto first = std::find_if(rows.begin(), rows.end(), of_same);
    ContactRow row{RowKind::roll, rolling[i].constraint, i, {rolling[i].body_a, rolling[i].body_b, {}, 1, 1}};
    row.first_gap = static_cast<std::size_t>(first - rows.begin());
    row.gap_count = static_cast<std::size_t>(contacts.constraints()[rolling[i].constraint].count);
    row.coefficient = rolling[i].lever;
    rows.push_back(row);
  }
}

void ExactContacts::solve_positions(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene, real h,
                                    Reach reach) {
  const int most_rounds = share_ == Share::all ? most_rounds_of_turning : affordable_rounds_of_turning;
  for (int round = 0; round < most_rounds; ++round) {
    if (set_goals(contacts, scene.motions, h, reach) <= 1 && round > 0) return;
    for (Group& group : groups()) {
      group.settled = round > 0 && !group.joint_groups.empty();
      if (group.chosen() && !group.settled) take_in_stops(group, joints, scene, h);
    }
    solve_all(contacts, joints, scene, false);
  }
}

/// The speed that would lead on to the contact is not the speed towards it: bodies turn on the way. What the way at
/// present speeds and a straight one differ by goes into the bias. Returns by how much that has changed the ways of
/// closed points since the last call, relative to what counts as closed.
real ExactContacts::set_goals(const ContactSolver& contacts, const std::vector<Motion>& motions, real h, Reach reach) {
  real largest = 0;
  for (Group& group : groups()) {
    if (!group.chosen()) continue;
    for (ContactRow& row : group.rows) {
      if (!is_of_point(row)) continue;
      const ContactConstraint& c = contacts.constraints()[row.constraint];
      const Way way = way_of(c, c.points[row.place], motions, h);
      const real straight = speed_of(row.term, motions);
      const real before = row.bias;
      if (row.kind == RowKind::gap) {
        row.off = reach == Reach::closed && way.gap > c.closed;
        row.bias = std::max(way.gap_after / h - straight, -push_rate * c.length);
      } else {
        const std::vector<real>& belts = contacts.surface_speeds();
        row.bias = way.slide / h - straight - (belts.empty() ? real(0) : belts[row.constraint]);
      }
      if (!row.off && way.gap <= c.closed) largest = std::max(largest, h * std::abs(row.bias - before) / c.closed);
    }
  }
  return largest;
}

/// What pressed before the drift touches after it, whatever rounding and turning have left open. What has not arrived
/// yet, be it by a hair, must not be braked: it may be about to bounce.
void ExactContacts::solve_velocities(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene,
                                     Reach reach) {
  const std::vector<real>& belts = contacts.surface_speeds();
  for (Group& group : groups()) {
    if (!group.chosen()) continue;
    group.settled = false;
    take_in_stops(group, joints, scene, 0);
    for (ContactRow& row : group.rows) {
      if (!is_of_point(row)) continue;
      const ContactConstraint& c = contacts.constraints()[row.constraint];
      const ConstraintPoint& p = c.points[row.place];
      if (row.kind == RowKind::slip) {
        row.bias = belts.empty() ? real(0) : -belts[row.constraint];
        continue;
      }
      row.bias = 0;
      if (reach == Reach::closed) continue;
      row.off = p.normal_impulse <= 0 && separation_of(c, p, scene.motions[c.body_a], scene.motions[c.body_b]) > 0;
    }
  }
  solve_all(contacts, joints, scene, true);
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

void ExactContacts::solve_all(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene,
                              bool after_drift) {
  const auto impulse_of = [&contacts](const ContactRow& row) -> real& {
    if (row.kind == RowKind::roll) return contacts.rolling()[row.place].impulse;
    ConstraintPoint& p = contacts.constraints()[row.constraint].points[row.place];
    return row.kind == RowKind::gap ? p.normal_impulse : p.tangent_impulse;
  };
  for (Group& group : groups()) {
    if (!group.chosen() || group.settled) continue;
    before_.clear();
    for (ContactRow& row : group.rows) {
      if (row.kind != RowKind::stop) row.given = impulse_of(row);
      if (row.kind == RowKind::slip) row.coefficient = friction_of(contacts.constraints()[row.constraint]);
      before_.push_back(row.given);
    }
    solve_group(group, joints, scene.motions);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
      const ContactRow& row = group.rows[i];
      if (row.kind != RowKind::stop) {
        impulse_of(row) = row.given;
      } else {
        joints->group(row.constraint).set_stop({row.place, row.term, 0, before_[i]}, row.given, after_drift, scene);
      }
    }
  }
}

/// Where exactness is what was asked for: by pivots, where they are few; else by Newton's method; else by sweeps.
void ExactContacts::solve_group(Group& group, const JointSolver* joints, std::vector<Motion>& motions) {
  if (share_ == Share::affordable && group.by_newton) return solve_cheaply(group, motions);
  const bool few = group.rows.size() <= most_rows_to_pivot;
  if (few) find_responses(group, joints, motions);
  const double noise = group.joint_groups.empty() ? noise_of_contacts : noise_of_joints;
  if (few && solve_by_pivots(group.rows, group.response, noise, motions)) return;
  if (group.by_newton && group.newton.solve(group.rows, motions, most_newton_rounds)) return;
  if (few && !group.joint_groups.empty()) {
    solve_by_sweeps(group.rows, group.response, motions, share_ == Share::all ? most_sweeps : most_affordable_sweeps);
  } else {
    solve_by_sweeps(group.rows, motions, most_sweeps);
  }
}

/// The next substep goes on with what has not settled: unless it never will, because something that does not give way
/// presses.
void ExactContacts::solve_cheaply(Group& group, std::vector<Motion>& motions) {
  if (group.newton.solve(group.rows, motions, most_affordable_rounds)) return;
  if (has_mover(group.rows, motions)) {
    solve_by_sweeps(group.rows, motions, most_affordable_sweeps);
  } else {
    group.newton.apply(group.rows, motions);
  }
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
