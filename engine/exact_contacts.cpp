#include "engine/exact_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lcp.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Pivoting takes time in proportion to the cube of the rows. Larger groups are swept until nothing changes any more.
constexpr std::size_t most_rows_to_pivot = 64;
constexpr int most_sweeps = 1000;
/// What changes less than this part of the largest impulse does not change.
constexpr real settled = 4 * std::numeric_limits<real>::epsilon();
/// So often at most the ways of the contacts are looked at again, because bodies turn.
constexpr int most_rounds_of_turning = 3;
/// Where there is no solution, because something is squeezed by what does not give way, impulses must not grow without
/// bound: contacts give way themselves, by this part of their own response.
constexpr real give_of_squeezed = real(1e-3);
/// What the responses of jointed bodies are known to, where a row's own response is 1.
constexpr double noise_of_joints = sizeof(real) == sizeof(double) ? 1e-9 : 1e-5;

/// Numbers the groups of whatever hangs together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = of(i);
    j = of(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

bool moves(const Motion& m) { return m.inv_mass > 0 || m.inv_inertia > 0; }

/// Goes its way whatever pushes back.
bool is_mover(const Motion& m) { return !moves(m) && (!(m.velocity == Vec2{}) || m.spin != 0); }

BodyIndex moving_body(const ContactConstraint& c, const std::vector<Motion>& motions) {
  return moves(motions[c.body_a]) ? c.body_a : c.body_b;
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

}  // namespace

void ExactContacts::prepare(const ContactSolver& contacts, const JointSolver* joints,
                            const std::vector<Motion>& motions) {
  groups_.clear();
  group_by_bodies(contacts, joints, motions);
  for (std::size_t i = 0; i < group_of_.size(); ++i) add_contact(groups_[group_of_[i]], i, contacts);
  add_rolling(contacts);
}

void ExactContacts::group_by_bodies(const ContactSolver& contacts, const JointSolver* joints,
                                    const std::vector<Motion>& motions) {
  Groups bodies(motions.size());
  for (const ContactConstraint& c : contacts.constraints()) {
    if (moves(motions[c.body_a]) && moves(motions[c.body_b])) bodies.join(c.body_a, c.body_b);
  }
  const std::size_t joint_groups = joints != nullptr ? joints->group_count() : 0;
  for (std::size_t g = 0; g < joint_groups; ++g) {
    for (const BodyIndex body : joints->bodies_of(g)) bodies.join(joints->bodies_of(g).front(), body);
  }
  const std::size_t none = motions.size();
  std::vector<std::size_t> number(motions.size(), none);
  group_of_.clear();
  for (const ContactConstraint& c : contacts.constraints()) {
    std::size_t& group = number[bodies.of(moving_body(c, motions))];
    if (group == none) {
      group = groups_.size();
      groups_.emplace_back();
    }
    group_of_.push_back(group);
  }
  moves_joints_ = false;
  for (std::size_t g = 0; g < joint_groups; ++g) {
    const std::size_t group = number[bodies.of(joints->bodies_of(g).front())];
    if (group == none) continue;
    groups_[group].joint_groups.push_back(g);
    moves_joints_ = true;
  }
}

void ExactContacts::add_contact(Group& group, std::size_t constraint, const ContactSolver& contacts) const {
  const ContactConstraint& c = contacts.constraints()[constraint];
  const std::size_t first = group.rows.size();
  const auto count = static_cast<std::size_t>(c.count);
  for (std::size_t k = 0; k < count; ++k)
    group.rows.push_back({Kind::gap, constraint, k, term_along(c, c.points[k], c.normal)});
  if (!contacts.parts().friction || friction_of(c) <= 0) return;
  for (std::size_t k = 0; k < count; ++k) {
    Row& row = group.rows.emplace_back(Row{Kind::slip, constraint, k, term_along(c, c.points[k], perp(c.normal))});
    row.first_gap = first + k;
    row.gap_count = 1;
    row.coefficient = friction_of(c);
  }
}

void ExactContacts::add_rolling(const ContactSolver& contacts) {
  const std::vector<RollingRows::Row>& rolling = contacts.rolling();
  for (std::size_t i = 0; i < rolling.size(); ++i) {
    std::vector<Row>& rows = groups_[group_of_[rolling[i].constraint]].rows;
    const auto of_same = [&](const Row& row) { return row.constraint == rolling[i].constraint; };
    const auto first = std::find_if(rows.begin(), rows.end(), of_same);
    Row row{Kind::roll, rolling[i].constraint, i, {rolling[i].body_a, rolling[i].body_b, {}, 1, 1}};
    row.first_gap = static_cast<std::size_t>(first - rows.begin());
    row.gap_count = static_cast<std::size_t>(contacts.constraints()[rolling[i].constraint].count);
    row.coefficient = rolling[i].lever;
    rows.push_back(row);
  }
}

void ExactContacts::solve_positions(ContactSolver& contacts, const JointSolver* joints, std::vector<Motion>& motions,
                                    real h, Reach reach) {
  for (int round = 0; round < most_rounds_of_turning; ++round) {
    if (set_goals(contacts, motions, h, reach) <= closed_gap && round > 0) return;
    solve_all(contacts, joints, motions);
  }
}

/// The speed that would lead on to the contact is not the speed towards it: bodies turn on the way. What the way at
/// present speeds and a straight one differ by goes into the bias. Returns by how much that has changed the ways of
/// closed points since the last call, relative to the thickness of their pairs.
real ExactContacts::set_goals(const ContactSolver& contacts, const std::vector<Motion>& motions, real h, Reach reach) {
  real largest = 0;
  for (Group& group : groups_) {
    for (Row& row : group.rows) {
      if (row.kind == Kind::roll) continue;
      const ContactConstraint& c = contacts.constraints()[row.constraint];
      const Way way = way_of(c, c.points[row.place], motions, h);
      const real straight = speed_of(row.term, motions);
      const real before = row.bias;
      if (row.kind == Kind::gap) {
        row.off = reach == Reach::closed && way.gap > closed_gap * c.length;
        row.bias = std::max(way.gap_after / h - straight, -push_rate * c.length);
      } else {
        const std::vector<real>& belts = contacts.surface_speeds();
        row.bias = way.slide / h - straight - (belts.empty() ? real(0) : belts[row.constraint]);
      }
      if (!row.off && way.gap <= closed_gap * c.length)
        largest = std::max(largest, h * std::abs(row.bias - before) / c.length);
    }
  }
  return largest;
}

/// What pressed before the drift touches after it, whatever rounding and turning have left open.
void ExactContacts::solve_velocities(ContactSolver& contacts, const JointSolver* joints, std::vector<Motion>& motions,
                                     Reach reach) {
  const std::vector<real>& belts = contacts.surface_speeds();
  for (Group& group : groups_) {
    for (Row& row : group.rows) {
      if (row.kind == Kind::roll) continue;
      const ContactConstraint& c = contacts.constraints()[row.constraint];
      const ConstraintPoint& p = c.points[row.place];
      if (row.kind == Kind::slip) {
        row.bias = belts.empty() ? real(0) : -belts[row.constraint];
        continue;
      }
      row.bias = 0;
      if (reach == Reach::closed) continue;
      row.off =
          p.normal_impulse <= 0 && separation_of(c, p, motions[c.body_a], motions[c.body_b]) > closed_gap * c.length;
    }
  }
  solve_all(contacts, joints, motions);
}

void ExactContacts::solve_all(ContactSolver& contacts, const JointSolver* joints, std::vector<Motion>& motions) {
  const auto impulse_of = [&contacts](const Row& row) -> real& {
    if (row.kind == Kind::roll) return contacts.rolling()[row.place].impulse;
    ConstraintPoint& p = contacts.constraints()[row.constraint].points[row.place];
    return row.kind == Kind::gap ? p.normal_impulse : p.tangent_impulse;
  };
  for (Group& group : groups_) {
    for (Row& row : group.rows) row.given = impulse_of(row);
    const bool few = group.rows.size() <= most_rows_to_pivot;
    if (few) find_responses(group, joints, motions);
    if (!few || !solve_by_pivots(group, motions)) solve_by_sweeps(group, motions);
    for (const Row& row : group.rows) impulse_of(row) = row.given;
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
  for (const Row& row : group.rows) bodies.insert(bodies.end(), {row.term.body_a, row.term.body_b});
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

/// The rows as unknowns that are never negative: the impulse of a gap; of a bounded row the impulses forwards and
/// backwards, and the speed that is left once they have given all they may. In units in which every row's own response
/// is 1, so that pivots can be compared.
class ExactContacts::Problem {
 public:
  Problem(const Group& group, const std::vector<Motion>& motions) : rows_(group.rows), response_(group.response) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const bool takes_part = !rows_[i].off && response(i, i) > 0;
      scale_.push_back(takes_part ? 1 / std::sqrt(response(i, i)) : 0);
      first_.push_back(takes_part ? count_ : -1);
      if (takes_part) count_ += is_gap(i) ? 1 : 3;
    }
    lcp_.emplace(count_);
    if (!group.joint_groups.empty()) lcp_->noise = noise_of_joints;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (first_[i] < 0) continue;
      set_speed(i, motions);
      for (std::size_t j = 0; j < rows_.size(); ++j) {
        if (first_[j] >= 0) couple(i, j);
      }
      if (!is_gap(i)) bound(i);
    }
    for (double& q : lcp_->offset) q /= unit_ > 0 ? unit_ : 1;
  }

  /// The impulse of every row, or nothing when no solution was found.
  std::optional<std::vector<real>> impulses() const {
    const std::optional<std::vector<double>> z = proofreel::solve(*lcp_);
    if (!z) return std::nullopt;
    std::vector<real> impulses;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto part = [&](int k) { return (*z)[static_cast<std::size_t>(first_[i] + k)]; };
      const double sum = first_[i] < 0 ? 0 : is_gap(i) ? part(0) : part(0) - part(1);
      impulses.push_back(static_cast<real>(unit_ * scale_[i] * sum));
    }
    return impulses;
  }

 private:
  bool is_gap(std::size_t i) const { return rows_[i].kind == Kind::gap; }
  double response(std::size_t i, std::size_t j) const { return static_cast<double>(response_[i * rows_.size() + j]); }

  /// What the speed would be without any of these impulses.
  void set_speed(std::size_t i, const std::vector<Motion>& motions) {
    double speed = static_cast<double>(speed_of(rows_[i].term, motions) + rows_[i].bias);
    for (std::size_t j = 0; j < rows_.size(); ++j) speed -= response(i, j) * static_cast<double>(rows_[j].given);
    lcp_->q(first_[i]) = scale_[i] * speed;
    if (!is_gap(i)) lcp_->q(first_[i] + 1) = -scale_[i] * speed;
    unit_ = std::max(unit_, std::abs(scale_[i] * speed));
  }

  void couple(std::size_t i, std::size_t j) {
    const double entry = scale_[i] * scale_[j] * response(i, j);
    lcp_->m(first_[i], first_[j]) = entry;
    if (!is_gap(j)) lcp_->m(first_[i], first_[j] + 1) = -entry;
    if (!is_gap(i)) lcp_->m(first_[i] + 1, first_[j]) = -entry;
    if (!is_gap(i) && !is_gap(j)) lcp_->m(first_[i] + 1, first_[j] + 1) = entry;
  }

  void bound(std::size_t i) {
    const int at = first_[i];
    lcp_->m(at, at + 2) = lcp_->m(at + 1, at + 2) = 1;
    lcp_->m(at + 2, at) = lcp_->m(at + 2, at + 1) = -1;
    for (std::size_t k = rows_[i].first_gap; k < rows_[i].first_gap + rows_[i].gap_count; ++k) {
      if (first_[k] >= 0)
        lcp_->m(at + 2, first_[k]) = static_cast<double>(rows_[i].coefficient) * scale_[k] / scale_[i];
    }
  }

  const std::vector<Row>& rows_;
  const std::vector<double>& response_;
  std::vector<int> first_;     ///< unknown of every row; -1 for those that take no part
  std::vector<double> scale_;  ///< of every row: impulse = unit * scale * unknown
  double unit_ = 0;
  int count_ = 0;
  std::optional<Lcp> lcp_;
};

bool ExactContacts::solve_by_pivots(Group& group, std::vector<Motion>& motions) const {
  const std::optional<std::vector<real>> impulses = Problem(group, motions).impulses();
  if (!impulses) return false;
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    Row& row = group.rows[i];
    push(row.term, (*impulses)[i] - row.given, motions);
    row.given = (*impulses)[i];
  }
  return true;
}

/// Row after row takes the impulse it needs at the moment, until nothing changes any more.
void ExactContacts::solve_by_sweeps(Group& group, std::vector<Motion>& motions) const {
  std::vector<Row>& rows = group.rows;
  const auto inverse_mass = [&motions](const Term& t) {
    const Motion& a = motions[t.body_a];
    const Motion& b = motions[t.body_b];
    return (a.inv_mass + b.inv_mass) * dot(t.direction, t.direction) + a.inv_inertia * t.arm_a * t.arm_a +
           b.inv_inertia * t.arm_b * t.arm_b;
  };
  const bool has_mover = std::any_of(rows.begin(), rows.end(), [&motions](const Row& row) {
    return is_mover(motions[row.term.body_a]) || is_mover(motions[row.term.body_b]);
  });
  // Pivots find the solution of a small group if there is one.
  const real give = has_mover || rows.size() <= most_rows_to_pivot ? give_of_squeezed : real(0);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    real largest = 0;
    real change = 0;
    for (Row& row : rows) {
      real most = row.off ? real(0) : std::numeric_limits<real>::max();
      if (row.kind != Kind::gap) {
        most = 0;
        for (std::size_t k = row.first_gap; k < row.first_gap + row.gap_count; ++k)
          most += row.coefficient * rows[k].given;
      }
      const real least = row.kind == Kind::gap ? real(0) : -most;
      const real response = inverse_mass(row.term);
      const real speed = speed_of(row.term, motions) + row.bias + give * response * row.given;
      const real wanted = row.given - speed / ((1 + give) * response);
      const real impulse = std::clamp(wanted, least, most);
      push(row.term, impulse - row.given, motions);
      change = std::max(change, std::abs(impulse - row.given));
      largest = std::max(largest, std::abs(impulse));
      row.given = impulse;
    }
    if (change <= settled * largest) return;
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
