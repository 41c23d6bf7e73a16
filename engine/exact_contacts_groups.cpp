// Which contacts make a group, and which groups are solved exactly.

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/exact_contacts.h"
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
/// The same for one that is larger, but hardly moves: a factorisation per tick is all that it takes.
constexpr double most_work_at_rest = 2e8;
constexpr std::size_t most_contacts_at_rest = 25000;
/// At rest nothing moves by its own thickness within so many seconds, on average.
constexpr real seconds_to_move = 10;
/// Of the thickness: soft contacts sink into each other by more, and to push so many out at once would hurl them about.
constexpr real visible_overlap = real(0.002);
/// Of the thickness: where gaps are known no better (in single precision always, else far out), each tick would begin
/// with other noise for which a large group would have to be balanced anew.
constexpr real hardly_known = real(1e-7);
/// A soft contact gives way by about 1.6 h times the speed that its impulse of a substep makes; a five hundredth of the
/// thickness shows.
constexpr real visible_load = real(0.00125);
/// Where stops take part contacts are solved exactly up to this speed between the surfaces, in thicknesses per second.
constexpr real fastest_with_stops = 3;
/// Thicknesses per second: bodies that press each other and slip faster jostle.
constexpr real jostling = real(0.5);
/// After so many ticks in which a group jostled and did not settle it is left to the sweeps for so many. (What is
/// struck hard settles before that: left alone amid a blow, a pile would sink under it.)
constexpr std::uint8_t most_failures = 10;
constexpr std::uint8_t soft_ticks_after_failures = 240;

BodyIndex moved_body(const ContactConstraint& c, const std::vector<Motion>& motions) {
  return is_moved(motions[c.body_a]) ? c.body_a : c.body_b;
}

real speed_at(const ContactConstraint& c, const ConstraintPoint& p, const std::vector<Motion>& motions) {
  return length(motions[c.body_b].velocity_at(p.arm_b) - motions[c.body_a].velocity_at(p.arm_a));
}

Term term_along(const ContactConstraint& c, const ConstraintPoint& p, Vec2 direction) {
  return {c.body_a, c.body_b, direction, cross(p.arm_a, direction), cross(p.arm_b, direction)};
}

/// Whether one moving body rubs along another one.
bool slips_within(const ContactConstraint& c, const std::vector<Motion>& motions) {
  const Motion& a = motions[c.body_a];
  const Motion& b = motions[c.body_b];
  if (!is_moved(a) || !is_moved(b)) return false;
  return std::any_of(c.points, c.points + c.count, [&](const ConstraintPoint& p) {
    const real slip = dot(b.velocity_at(p.arm_b) - a.velocity_at(p.arm_a), perp(c.normal));
    return p.normal_total > 0 && std::abs(slip) > jostling * c.length;
  });
}

}  // namespace

void ExactContacts::prepare(ContactSolver& contacts, const JointSolver* joints, const std::vector<Motion>& motions,
                            real h, Share share) {
  share_ = share;
  group_by_bodies(contacts, joints, motions);
  for (Group& group : groups()) group.left = share == Share::all ? Left::solved : first_look(group, joints);
  std::vector<ContactConstraint>& constraints = contacts.constraints();
  if (share == Share::affordable) {
    lose_patience(constraints);
    look_for_load(constraints, joints, motions, h);
  }
  for (std::size_t i = 0; i < group_of_.size(); ++i) {
    if (groups_[group_of_[i]].chosen()) add_contact(groups_[group_of_[i]], i, contacts);
  }
  add_rolling(contacts);
  for (Group& group : groups()) {
    if (!group.chosen()) continue;
    if (share == Share::affordable && group.lone_body != 0) continue;
    group.by_newton = group.joint_groups.empty() && group.newton.plan(group.rows, motions, most_work_for(group, share));
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
  if (group.large) return is_at_rest(group) ? Left::solved : Left::large;
  return group.joint_groups.empty() || group.contacts <= most_affordable_with_joints ? Left::solved : Left::large;
}

double ExactContacts::most_work_for(const Group& group, Share share) {
  if (share == Share::all) return most_work;
  return group.large ? most_work_at_rest : most_affordable_work;
}

bool ExactContacts::is_at_rest(const Group& group) {
  const auto contacts = static_cast<real>(group.contacts);
  const real most_haste = contacts / (seconds_to_move * seconds_to_move);
  return !group.has_sunk && !group.blurred && group.haste < most_haste && group.contacts <= most_contacts_at_rest;
}

/// What a large group is judged by.
void ExactContacts::note_rest(Group& group, const ContactConstraint& c, const std::vector<Motion>& motions) {
  const Motion& a = motions[c.body_a];
  const Motion& b = motions[c.body_b];
  group.haste += (length_squared(a.velocity) + length_squared(b.velocity)) / (c.length * c.length);
  group.blurred |= c.closed > hardly_known * c.length;
  for (int k = 0; k < c.count; ++k) {
    group.presses |= c.points[k].normal_impulse > 0;
    group.has_sunk |= separation_of(c, c.points[k], a, b) < -visible_overlap * c.length;
  }
}

/// A crowd that jostles and has not settled in several ticks is left alone for a while: exactness costs most there,
/// shows least, and is not what comes out.
void ExactContacts::lose_patience(const std::vector<ContactConstraint>& constraints) {
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    Patience& of_group = groups_[group_of_[i]].patience;
    of_group.failures = std::max(of_group.failures, constraints[i].patience.failures);
    of_group.soft_ticks = std::max(of_group.soft_ticks, constraints[i].patience.soft_ticks);
  }
  for (Group& group : groups()) {
    if (group.chosen() && is_patient_with(group) && group.patience.soft_ticks > 0) group.left = Left::jostling;
  }
}

void ExactContacts::end_tick(ContactSolver& contacts, const std::vector<Motion>& motions) {
  std::vector<ContactConstraint>& constraints = contacts.constraints();
  for (std::size_t i = 0; i < group_of_.size(); ++i) {
    Group& group = groups_[group_of_[i]];
    if (group.failed && !group.jostles) group.jostles = slips_within(constraints[i], motions);
  }
  const auto after = [](const Group& group) {
    Patience next = group.patience;
    if (next.soft_ticks > 0) {
      --next.soft_ticks;
    } else if (group.failed && group.jostles) {
      if (++next.failures >= most_failures) next = {most_failures - 1, soft_ticks_after_failures};
    } else if (next.failures > 0 && !group.failed) {
      --next.failures;
    }
    return next;
  };
  for (std::size_t i = 0; i < group_of_.size(); ++i) {
    const Group& group = groups_[group_of_[i]];
    constraints[i].patience = is_patient_with(group) ? after(group) : Patience{};
  }
}

/// Soft contacts give way by what they bear. Where joints answer, exactness costs a solution of all of them per point:
/// it is bought only where that giving way would show, by the impulses of the last substep; and with stops, each of
/// which is a row more, only once what touches has slowed down: what tumbles shows nothing. Large groups have to bear
/// visibly much as well; where nothing presses yet, nobody knows.
void ExactContacts::look_for_load(const std::vector<ContactConstraint>& constraints, const JointSolver* joints,
                                  const std::vector<Motion>& motions, real h) {
  for (Group& group : groups()) {
    group.loaded = group.large ? !group.presses : group.joint_groups.empty();
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
    case Left::jostling:
      return "they jostle, and did not settle lately";
    case Left::nets:
      return "their joints are solved one by one";
    case Left::large:
      return "their islands are too large for how they move";
    case Left::unloaded:
      return "they bear too little to give way visibly";
  }
  return "";
}

std::string ExactContacts::told() const {
  if (group_of_.empty()) return "nothing touched at the last tick";
  std::size_t counts[static_cast<std::size_t>(Left::jostling) + 1] = {};
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
  std::vector<std::uint8_t> takes_part(motions.size());
  std::transform(motions.begin(), motions.end(), takes_part.begin(), is_moved);
  std::vector<Link> links;
  links.reserve(contacts.constraints().size());
  const std::size_t joint_groups = joints != nullptr ? joints->group_count() : 0;
  // Joints first: as long as bodies stand alone they are united at a glance.
  for (std::size_t g = 0; g < joint_groups; ++g) {
    for (const BodyIndex body : joints->bodies_of(g)) links.push_back({joints->bodies_of(g).front(), body});
  }
  for (const ContactConstraint& c : contacts.constraints()) links.push_back({c.body_a, c.body_b});
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
      groups_[group].lone_body = moved_body(c, motions);
    }
    ++groups_[group].contacts;
    if (is_moved(motions[c.body_a]) && is_moved(motions[c.body_b])) groups_[group].lone_body = 0;
    note_immovable(groups_[group], c.body_a, motions);
    note_immovable(groups_[group], c.body_b, motions);
    groups_[group].parts |= c.push_speed <= 0;
    group_of_.push_back(group);
  }
  for (std::size_t g = 0; g < joint_groups; ++g) {
    const std::size_t group = group_of_island[island[joints->bodies_of(g).front()]];
    if (group == none) continue;
    groups_[group].joint_groups.push_back(g);
    groups_[group].lone_body = 0;
  }
  for (Group& group : groups()) group.large = group.contacts > most_affordable_contacts && group.joint_groups.empty();
  for (std::size_t i = 0; i < group_of_.size(); ++i) {
    if (groups_[group_of_[i]].large) note_rest(groups_[group_of_[i]], contacts.constraints()[i], motions);
  }
}

/// In the place of one of the tick before: what that one has room for serves again.
void ExactContacts::add_group() {
  if (used_ == groups_.size()) groups_.emplace_back();
  Group& group = groups_[used_++];
  group.contacts = 0;
  group.patience = {};
  group.failed = false;
  group.jostles = false;
  group.movers = 0;
  group.parts = false;
  group.presses = group.has_sunk = group.blurred = false;
  group.haste = 0;
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

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
