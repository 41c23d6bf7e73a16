#include "engine/contact_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/elimination.h"
#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A row's spring is so many times stiffer than the bodies are heavy: the stiffer, the fewer rounds, but the more kinks
/// a way crosses, and the more digits of the impulse drown in rounding. Where little has changed since the impulses at
/// hand were found the first round takes the middle one, else the softest; what is easy makes the next one stiffer.
constexpr double softest = 100;
constexpr double middle = 1e3;
constexpr double stiffest = 1e7;
constexpr double stiffer = 30;
/// A round of so few steps was easy.
constexpr int easy = 2;
/// Of the largest impulse: what changes less has settled; what balances to this is in balance.
constexpr double settled = 1e-9;
/// What is farther than this from balance at the stiffest springs is swept so many times first.
constexpr double far_off = 1;
constexpr int sweeps_before = 10;
constexpr int most_failures = 6;
constexpr int most_steps = 40;
constexpr int most_trials = 12;
/// Of the only round of a large group: its springs, those of its first guess, what counts as balance, and how often it
/// is looked for. Less exact balances are dearer in the end, for what is left is noise that no tick gets rid of.
constexpr double firm = 1e3;
constexpr double guessed = 1e4;
constexpr double balanced = 1e-7;
constexpr int most_steps_at_once = 60;
/// Farther than this from balance is none at all.
constexpr double unbalanced = 1e-3;
/// Factors are kept while a step leaves less than this part of what it began with.
constexpr double gets_on = 0.4;
/// A way is gone to the end when the slope there is no steeper than this part of what it was at the start.
constexpr double flat = 0.1;

double product(const double (&a)[3], const double* x) { return a[0] * x[0] + a[1] * x[1] + a[2] * x[2]; }

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool ContactNewton::plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions, double most_work) {
  if (!is_planned_for(rows, motions)) {
    planned_ = make_plan(rows, motions, most_work);
    if (!planned_) return false;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) scale_row(rows_[i], rows[i].term, motions);
  stiffness_ = 0;
  return true;
}

/// Mostly the same bodies touch as in the tick before.
bool ContactNewton::is_planned_for(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) const {
  if (!planned_ || rows.size() != rows_.size()) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Term& t = rows[i].term;
    const Row& row = rows_[i];
    if (row.body_a != t.body_a || row.body_b != t.body_b) return false;
    if ((row.a >= 0) != is_moved(motions[t.body_a]) || (row.b >= 0) != is_moved(motions[t.body_b])) return false;
  }
  return true;
}

bool ContactNewton::make_plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions,
                              double most_work) {
  bodies_.clear();
  for (const ContactRow& row : rows) {
    if (is_moved(motions[row.term.body_a])) bodies_.push_back(row.term.body_a);
    if (is_moved(motions[row.term.body_b])) bodies_.push_back(row.term.body_b);
  }
  std::sort(bodies_.begin(), bodies_.end());
  bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
  rows_.assign(rows.size(), {});
  const std::vector<std::vector<int>> below = order_bodies(rows);
  if (!matrix_.plan(below, std::vector<int>(bodies_.size(), 3), most_work)) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[i];
    row.body_a = rows[i].term.body_a;
    row.body_b = rows[i].term.body_b;
    if (row.a >= 0) row.place_a = matrix_.place_of(row.a, row.a);
    if (row.b >= 0) row.place_b = matrix_.place_of(row.b, row.b);
    if (row.a >= 0 && row.b >= 0) row.place_between = matrix_.place_of(std::max(row.a, row.b), std::min(row.a, row.b));
  }
  change_.assign(3 * bodies_.size(), 0);
  return true;
}

/// Puts the bodies in order of elimination and tells the rows. Returns what stands below the diagonal.
std::vector<std::vector<int>> ContactNewton::order_bodies(const std::vector<ContactRow>& rows) {
  const auto number_of = [this](BodyIndex body) {
    const auto found = std::lower_bound(bodies_.begin(), bodies_.end(), body);
    return found != bodies_.end() && *found == body ? static_cast<int>(found - bodies_.begin()) : -1;
  };
  std::vector<std::vector<int>> neighbours(bodies_.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows_[i].a = number_of(rows[i].term.body_a);
    rows_[i].b = number_of(rows[i].term.body_b);
    if (rows_[i].a < 0 || rows_[i].b < 0) continue;
    neighbours[at(rows_[i].a)].push_back(rows_[i].b);
    neighbours[at(rows_[i].b)].push_back(rows_[i].a);
  }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  const std::vector<int> turn = elimination_turns(neighbours);
  std::vector<BodyIndex> ordered(bodies_.size());
  std::vector<std::vector<int>> below(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    ordered[at(turn[i])] = bodies_[i];
    for (const int other : neighbours[i]) {
      if (turn[at(other)] > turn[i]) below[at(turn[i])].push_back(turn[at(other)]);
    }
    std::sort(below[at(turn[i])].begin(), below[at(turn[i])].end());
  }
  bodies_ = std::move(ordered);
  for (Row& row : rows_) {
    if (row.a >= 0) row.a = turn[at(row.a)];
    if (row.b >= 0) row.b = turn[at(row.b)];
  }
  return below;
}

void ContactNewton::scale_row(Row& row, const Term& t, const std::vector<Motion>& motions) {
  const auto set = [&](double(&on)[3], BodyIndex body, double sign, real arm) {
    const double root_mass = sign * std::sqrt(static_cast<double>(motions[body].inv_mass));
    on[0] = root_mass * static_cast<double>(t.direction.x);
    on[1] = root_mass * static_cast<double>(t.direction.y);
    on[2] = sign * std::sqrt(static_cast<double>(motions[body].inv_inertia)) * static_cast<double>(arm);
  };
  if (row.a >= 0) set(row.on_a, t.body_a, -1, t.arm_a);
  if (row.b >= 0) set(row.on_b, t.body_b, 1, t.arm_b);
  const double response = product(row.on_a, row.on_a) + product(row.on_b, row.on_b);
  row.size = std::sqrt(response);
}

bool ContactNewton::solve(std::vector<ContactRow>& rows, std::vector<Motion>& motions, int most_rounds) {
  begin(rows, motions);
  double stiffness = first_stiffness(rows);
  bool done = stiffness == stiffest && take_impulses();  // in balance already
  int failures = 0;
  for (int round = 0; round < most_rounds && !done && failures < most_failures; ++round) {
    set_stiffness(stiffness);
    bound(rows);
    before_ = change_;
    const int steps = minimise();
    if (steps < 0) {
      change_ = before_;
      stiffness = std::max(stiffness / stiffer, 1.0);
      ++failures;
      continue;
    }
    done = take_impulses();
    if (steps <= easy) stiffness = std::min(stiffness * stiffer, stiffest);
  }
  if (done) apply(rows, motions);
  return done;
}

/// None would change if its row were alone.
bool ContactNewton::is_in_balance(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions,
                                  double negligible) {
  begin(rows, motions);
  bound(rows);
  return std::all_of(rows_.begin(), rows_.end(), [&](const Row& row) {
    if (row.size <= 0) return true;
    const double wanted = std::clamp(row.given - row.start / (row.size * row.size), row.least, row.most);
    return std::abs(wanted - row.given) * row.size <= negligible * scale_;
  });
}

bool ContactNewton::solve_once(std::vector<ContactRow>& rows, std::vector<Motion>& motions) {
  begin(rows, motions);
  bool is_known = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].kind != RowKind::roll) rows_[i].from = static_cast<double>(rows[i].expected);
    is_known |= rows_[i].from != 0;
  }
  if (!is_known) guess(rows);
  set_stiffness(firm);
  bound(rows);
  const bool done = minimise_with_kept_factors();
  done ? static_cast<void>(take_impulses()) : sweep_instead(rows);
  apply(rows, motions);
  return done;
}

/// As if nothing could come apart or slide: what asks for the impossible gives what it may.
void ContactNewton::guess(const std::vector<ContactRow>& rows) {
  set_stiffness(guessed);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[i];
    const std::size_t gap = rows[i].kind == RowKind::gap ? i : rows[i].first_gap;
    row.acts = rows[gap].closed && !rows[gap].off && row.size > 0;
    row.impulse = row.acts ? row.from - row.stiffness * speed_of(row) : 0;
  }
  find_residual();
  factor_if_changed();
  way_ = residual_;
  matrix_.solve(way_);
  for (std::size_t k = 0; k < way_.size(); ++k) change_[k] -= way_[k];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[i];
    bound(rows[i], row);
    const double wanted = row.acts ? row.from - row.stiffness * speed_of(row) : 0;
    row.from = std::clamp(wanted, row.least, row.most);
  }
}

/// Steps with factors of a slightly different matrix lead downhill as well, if not as far.
bool ContactNewton::minimise_with_kept_factors() {
  respond();
  double off_balance = find_residual();
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps_at_once; ++step) {
    if (off_balance <= balanced * scale_) return true;
    if (off_balance > gets_on * before || rows_.front().factored == Factored::never) factor_if_changed();
    before = off_balance;
    take_step();
    off_balance = largest_residual();
  }
  return off_balance <= unbalanced * scale_;
}

void ContactNewton::sweep_instead(const std::vector<ContactRow>& rows) {
  std::fill(change_.begin(), change_.end(), 0.0);
  for (Row& row : rows_) row.from = row.given;
  for (int sweep = 0; sweep < sweeps_before; ++sweep) sweep_once(rows);
}

/// Which springs to begin with, after a look at how far from balance the impulses at hand are.
double ContactNewton::first_stiffness(const std::vector<ContactRow>& rows) {
  set_stiffness(stiffest);
  bound(rows);
  respond();
  const double off_balance = find_residual();
  if (off_balance <= settled * scale_) return stiffest;
  if (off_balance <= far_off * scale_) return middle;
  for (int sweep = 0; sweep < sweeps_before; ++sweep) sweep_once(rows);
  return softest;
}

void ContactNewton::set_stiffness(double stiffness) {
  if (stiffness == stiffness_) return;
  stiffness_ = stiffness;
  for (Row& row : rows_) {
    row.stiffness = row.size > 0 ? stiffness / (row.size * row.size) : 0;
    row.factored = Factored::never;
  }
}

double ContactNewton::speed_of(const Row& row) const {
  double speed = row.start;
  if (row.a >= 0) speed += product(row.on_a, &change_[3 * at(row.a)]);
  if (row.b >= 0) speed += product(row.on_b, &change_[3 * at(row.b)]);
  return speed;
}

/// Row after row takes the impulse it needs at the moment: nobody is far off after that.
void ContactNewton::sweep_once(const std::vector<ContactRow>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[i];
    bound(rows[i], row);
    if (row.size <= 0) continue;
    const double impulse = std::clamp(row.from - speed_of(row) / (row.size * row.size), row.least, row.most);
    for (std::size_t k = 0; row.a >= 0 && k < 3; ++k) change_[3 * at(row.a) + k] += row.on_a[k] * (impulse - row.from);
    for (std::size_t k = 0; row.b >= 0 && k < 3; ++k) change_[3 * at(row.b) + k] += row.on_b[k] * (impulse - row.from);
    row.from = impulse;
  }
}

void ContactNewton::begin(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) {
  std::fill(change_.begin(), change_.end(), 0.0);
  scale_ = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[i];
    row.start = speed_in_double(rows[i].term, motions) + static_cast<double>(rows[i].bias);
    row.given = row.from = static_cast<double>(rows[i].given);
    scale_ = std::max(scale_, std::abs(row.given) * row.size);
    const double approach = rows[i].kind == RowKind::gap ? std::max(-row.start, 0.0) : std::abs(row.start);
    if (row.size > 0 && !rows[i].off) scale_ = std::max(scale_, approach / row.size);
  }
}

void ContactNewton::bound(const std::vector<ContactRow>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) bound(rows[i], rows_[i]);
}

/// What a row may give at most; friction and rolling resistance follow the gaps.
void ContactNewton::bound(const ContactRow& row, Row& own) const {
  own.least = 0;
  own.most = row.off || own.size <= 0 ? 0 : std::numeric_limits<double>::infinity();
  if (row.kind == RowKind::gap) return;
  own.most = 0;
  for (std::size_t k = row.first_gap; own.size > 0 && k < row.first_gap + row.gap_count; ++k)
    own.most += static_cast<double>(row.coefficient) * rows_[k].from;
  own.least = -own.most;
}

/// The velocities in balance with what the rows answer to them. Returns how many steps that took, -1 when too many.
int ContactNewton::minimise() {
  for (int step = 0; step < most_steps; ++step) {
    respond();
    if (find_residual() <= settled * scale_) return step;
    factor_if_changed();
    take_step();
  }
  return -1;
}

void ContactNewton::take_step() {
  way_ = residual_;
  for (double& x : way_) x = -x;
  matrix_.solve(way_);
  go_along();
}

/// Impulses at the present velocities.
void ContactNewton::respond() {
  count_row_updates(rows_.size());
  for (Row& row : rows_) {
    const double wanted = row.from - row.stiffness * speed_of(row);
    row.acts = wanted > row.least && wanted < row.most;
    row.impulse = std::clamp(wanted, row.least, row.most);
  }
}

/// What the change of the velocities and the impulses differ by. Returns the largest.
double ContactNewton::find_residual() {
  residual_ = change_;
  for (const Row& row : rows_) {
    const double impulse = row.impulse - row.given;
    if (impulse == 0) continue;
    for (std::size_t k = 0; row.a >= 0 && k < 3; ++k) residual_[3 * at(row.a) + k] -= row.on_a[k] * impulse;
    for (std::size_t k = 0; row.b >= 0 && k < 3; ++k) residual_[3 * at(row.b) + k] -= row.on_b[k] * impulse;
  }
  return largest_residual();
}

double ContactNewton::largest_residual() const {
  double largest = 0;
  for (const double r : residual_) largest = std::max(largest, std::abs(r));
  return largest;
}

/// The matrix depends on which rows act, and on nothing else.
void ContactNewton::factor_if_changed() {
  bool same = true;
  for (const Row& row : rows_) same = same && row.factored == (row.acts ? Factored::acting : Factored::cut_off);
  if (same) return;
  matrix_.clear();
  for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
    const auto block = matrix_.block(matrix_.place_of(body, body));
    for (int k = 0; k < 3; ++k) block(k, k) = 1;
  }
  for (Row& row : rows_) {
    row.factored = row.acts ? Factored::acting : Factored::cut_off;
    if (row.acts) add_to_matrix(row);
  }
  matrix_.factor();
}

void ContactNewton::add_to_matrix(const Row& row) {
  const auto add = [&](int place, const double(&left)[3], const double(&top)[3]) {
    const auto block = matrix_.block(place);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) block(i, j) += row.stiffness * left[i] * top[j];
    }
  };
  if (row.a >= 0) add(row.place_a, row.on_a, row.on_a);
  if (row.b >= 0) add(row.place_b, row.on_b, row.on_b);
  if (row.a < 0 || row.b < 0) return;
  row.a > row.b ? add(row.place_between, row.on_a, row.on_b) : add(row.place_between, row.on_b, row.on_a);
}

/// Along the way to where the slope is 0, or nearly: mostly that is its end.
void ContactNewton::go_along() {
  const auto slope = [this] {
    double sum = 0;
    for (std::size_t k = 0; k < way_.size(); ++k) sum += way_[k] * residual_[k];
    return sum;
  };
  double gone = 0;
  const auto go_to = [&](double share) {
    for (std::size_t k = 0; k < way_.size(); ++k) change_[k] += (share - gone) * way_[k];
    gone = share;
    respond();
    find_residual();
    return slope();
  };
  const double steepest = std::abs(slope());
  double low = 0;
  double high = 1;
  double slope_low = -steepest;
  double slope_high = go_to(1);
  for (int trial = 0; trial < most_trials && slope_high > flat * steepest; ++trial) {
    const double between = low + (high - low) * std::clamp(slope_low / (slope_low - slope_high), 0.1, 0.9);
    const double slope_there = go_to(between);
    if (std::abs(slope_there) <= flat * steepest) return;
    if (slope_there < 0) {
      low = between;
      slope_low = slope_there;
    } else {
      high = between;
      slope_high = slope_there;
    }
  }
}

/// The springs' impulses become what they start from. True when that hardly changes anything: what acts gives way by no
/// more than `settled`, and what is cut off stays where it was.
bool ContactNewton::take_impulses() {
  double change = 0;
  for (Row& row : rows_) {
    change = std::max(change, std::abs(row.impulse - row.from) * row.size / (row.acts ? stiffness_ : 1));
    row.from = row.impulse;
    scale_ = std::max(scale_, std::abs(row.from) * row.size);
  }
  return change <= settled * scale_;
}

void ContactNewton::apply(std::vector<ContactRow>& rows, std::vector<Motion>& motions) const {
  std::vector<double> gained(3 * bodies_.size(), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows_[i];
    const double impulse = row.from - row.given;
    for (std::size_t k = 0; row.a >= 0 && k < 3; ++k) gained[3 * at(row.a) + k] += row.on_a[k] * impulse;
    for (std::size_t k = 0; row.b >= 0 && k < 3; ++k) gained[3 * at(row.b) + k] += row.on_b[k] * impulse;
    rows[i].given = static_cast<real>(row.from);
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Motion& m = motions[bodies_[i]];
    const double root_mass = std::sqrt(static_cast<double>(m.inv_mass));
    m.velocity += Vec2(Vec2d{root_mass * gained[3 * i], root_mass * gained[3 * i + 1]});
    m.spin += static_cast<real>(std::sqrt(static_cast<double>(m.inv_inertia)) * gained[3 * i + 2]);
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
