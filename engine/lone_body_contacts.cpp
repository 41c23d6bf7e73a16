#include "engine/lone_body_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A row's spring is so many times stiffer than the body is heavy: by each round it gives way by so much less.
constexpr double stiffness = 1e5;
/// Of the largest impulse: what is off by less has settled.
constexpr double settled = 1e-9;
constexpr int most_steps = 12;
constexpr int most_sweeps = 100;

using Vec3 = std::array<double, 3>;

double product(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void add(Vec3& sum, double factor, const Vec3& v) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += factor * v[k];
}

Vec3 cross_product(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

LoneBodyContacts::Outcome LoneBodyContacts::solve(std::vector<ContactRow>& rows, BodyIndex body,
                                                  std::vector<Motion>& motions, double negligible) {
  begin(rows, body, motions);
  count_row_updates(rows.size());
  if (is_in_balance(rows, negligible)) return Outcome::unchanged;
  if (!find_balance(rows)) {
    sweep(rows);
    if (!find_balance(rows)) return Outcome::unsolved;
  }
  apply(rows, motions[body]);
  return Outcome::solved;
}

void LoneBodyContacts::begin(const std::vector<ContactRow>& rows, BodyIndex body, const std::vector<Motion>& motions) {
  root_inv_mass_ = std::sqrt(static_cast<double>(motions[body].inv_mass));
  root_inv_inertia_ = std::sqrt(static_cast<double>(motions[body].inv_inertia));
  change_ = {};
  scale_ = 0;
  rows_.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Term& t = rows[i].term;
    Row& row = rows_[i];
    const bool is_a = t.body_a == body;
    const double push = is_a ? -root_inv_mass_ : root_inv_mass_;
    const double turn = is_a ? -root_inv_inertia_ : root_inv_inertia_;
    row.way = {push * static_cast<double>(t.direction.x), push * static_cast<double>(t.direction.y),
               turn * static_cast<double>(is_a ? t.arm_a : t.arm_b)};
    row.size = std::sqrt(product(row.way, row.way));
    const double per_size = row.size > 0 ? 1 / row.size : 0;
    for (double& x : row.way) x *= per_size;
    row.start = (speed_in_double(t, motions) + static_cast<double>(rows[i].bias)) * per_size;
    row.given = row.from = static_cast<double>(rows[i].given) * row.size;
    const double wrong = rows[i].kind == RowKind::gap ? -row.start : std::abs(row.start);
    scale_ = std::max(scale_, std::abs(row.given));
    if (!rows[i].off) scale_ = std::max(scale_, wrong);
  }
}

/// The bound of a row's impulse, where gaps press with what `impulse` names.
inline double LoneBodyContacts::most_of(const ContactRow& row, std::size_t i, double Row::*impulse) const {
  if (rows_[i].size <= 0 || row.off) return 0;
  if (row.kind == RowKind::gap) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t k = row.first_gap; k < row.first_gap + row.gap_count; ++k) {
    if (rows_[k].size > 0) sum += rows_[k].*impulse / rows_[k].size;
  }
  return static_cast<double>(row.coefficient) * rows_[i].size * sum;
}

/// Whether no impulse would change if its row were alone.
bool LoneBodyContacts::is_in_balance(const std::vector<ContactRow>& rows, double negligible) const {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows_[i];
    const double most = most_of(rows[i], i, &Row::given);
    const double least = rows[i].kind == RowKind::gap ? 0 : -most;
    const double wanted = std::clamp(row.given - row.start, least, most);
    if (std::abs(wanted - row.given) > negligible * scale_) return false;
  }
  return true;
}

bool LoneBodyContacts::find_balance(const std::vector<ContactRow>& rows) {
  for (int step = 0; step < most_steps; ++step) {
    const bool same = respond(rows) && step > 0;
    const Vec3 missing = find_missing();
    if (!same && !invert(rows)) return false;
    if (same && product(missing, missing) <= settled * settled * scale_ * scale_) {
      if (take_impulses()) return true;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) change_[k] += product(inverse_[k], missing);
  }
  return false;
}

/// Row after row takes the impulse it needs at the moment, from those given on: slow, but it never goes in circles, and
/// soon has found out which rows act.
void LoneBodyContacts::sweep(const std::vector<ContactRow>& rows) {
  change_ = {};
  for (Row& row : rows_) row.from = row.given;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[i];
      const double most = most_of(rows[i], i, &Row::from);
      const double least = rows[i].kind == RowKind::gap ? 0 : -most;
      const double impulse = std::clamp(row.from - row.start - product(row.way, change_), least, most);
      add(change_, impulse - row.from, row.way);
      row.from = impulse;
    }
  }
}

/// Impulses at the present speed. True where every row has kept its role.
bool LoneBodyContacts::respond(const std::vector<ContactRow>& rows) {
  bool same = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[i];
    row.speed = row.start + product(row.way, change_);
    const double most = most_of(rows[i], i, &Row::impulse);
    const double least = rows[i].kind == RowKind::gap ? 0 : -most;
    const double wanted = row.from - stiffness * row.speed;
    Role role = Role::acts;
    if (most <= 0 || (wanted <= least && least >= 0)) {
      role = Role::cut_off;
    } else if (wanted >= most) {
      role = Role::slides_forwards;
    } else if (wanted <= least) {
      role = Role::slides_backwards;
    }
    row.impulse = std::clamp(wanted, least, most);
    same = same && role == row.role;
    row.role = role;
  }
  return same;
}

/// What the rows give and the body does not have yet.
LoneBodyContacts::Vec3 LoneBodyContacts::find_missing() const {
  Vec3 missing = {-change_[0], -change_[1], -change_[2]};
  for (const Row& row : rows_) add(missing, row.impulse - row.given, row.way);
  return missing;
}

/// Of the matrix that tells what is missing less for a change: 1, and the springs of the rows that act. That of a gap
/// pushes along all rows that slide by it.
bool LoneBodyContacts::invert(const std::vector<ContactRow>& rows) {
  std::array<Vec3, 3> matrix = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const auto add_spring = [&matrix](double factor, const Vec3& pushes, const Vec3& feels) {
    for (std::size_t k = 0; k < 3; ++k) add(matrix[k], stiffness * factor * pushes[k], feels);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows_[i].role == Role::acts) add_spring(1, rows_[i].way, rows_[i].way);
    if (rows_[i].role == Role::acts || rows_[i].role == Role::cut_off) continue;
    const double sign = rows_[i].role == Role::slides_forwards ? 1 : -1;
    const double bound = sign * static_cast<double>(rows[i].coefficient) * rows_[i].size;
    for (std::size_t k = rows[i].first_gap; k < rows[i].first_gap + rows[i].gap_count; ++k) {
      if (rows_[k].role == Role::acts) add_spring(bound / rows_[k].size, rows_[i].way, rows_[k].way);
    }
  }
  const Vec3 first = cross_product(matrix[1], matrix[2]);
  const Vec3 second = cross_product(matrix[2], matrix[0]);
  const Vec3 third = cross_product(matrix[0], matrix[1]);
  const double determinant = product(matrix[0], first);
  if (!(determinant > 0)) return false;
  for (std::size_t k = 0; k < 3; ++k)
    inverse_[k] = {first[k] / determinant, second[k] / determinant, third[k] / determinant};
  return true;
}

/// The springs' impulses become what they start from. True when nothing gives way any more.
bool LoneBodyContacts::take_impulses() {
  double change = 0;
  for (Row& row : rows_) {
    if (row.role == Role::acts) change = std::max(change, std::abs(row.impulse - row.from));
    row.from = row.impulse;
    scale_ = std::max(scale_, std::abs(row.from));
  }
  return change <= settled * stiffness * scale_;
}

void LoneBodyContacts::apply(std::vector<ContactRow>& rows, Motion& motion) const {
  Vec3 gained = {};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows_[i];
    if (row.size <= 0) continue;
    add(gained, row.from - row.given, row.way);
    rows[i].given = static_cast<real>(row.from / row.size);
  }
  motion.velocity += Vec2(Vec2d{root_inv_mass_ * gained[0], root_inv_mass_ * gained[1]});
  motion.spin += static_cast<real>(root_inv_inertia_ * gained[2]);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
