#include "engine/contact_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
/// Of the only round of a large group: its springs, those of its first guess, what counts as balance, and how often it
/// is looked for. Less exact balances are dearer in the end, for what is left is noise that no tick gets rid of.
constexpr double firm = 1e3;
constexpr double guessed = 1e4;
constexpr double balanced = 1e-7;
constexpr int most_steps_at_once = 60;
/// Farther than this from balance is none at all.
constexpr double unbalanced = 1e-3;
/// What may be left over of what was missing, where a step goes on with old factors: where a balance has to be exact,
/// and where it is looked for but once.
constexpr double left_over = 1e-4;
constexpr double left_over_at_once = 1e-2;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

/// Lets every row answer to how much its speed has changed, and sums up what the bodies are pushed by:
/// answer(number of the row, row, change) is the impulse.
template <typename Answer>
inline void ContactNewton::find_pushes(Answer&& answer) {
  std::fill(pushes_.begin(), pushes_.end(), Twist{});
  std::size_t i = 0;
  for (const Touch& touch : touches_) {
    const Twist a = speeds_[at(touch.a)];
    const Twist b = speeds_[at(touch.b)];
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    Twist push;
    double turn_a = 0;
    for (; i < touch.end; ++i) {
      Row& row = rows_[i];
      const double impulse = answer(i, row, (row.x * x + row.y * y) + (row.arm_b * b.turn - row.arm_a * a.turn));
      push.x += row.x * impulse;
      push.y += row.y * impulse;
      push.turn += row.arm_b * impulse;
      turn_a += row.arm_a * impulse;
    }
    Twist& on_a = pushes_[at(touch.a)];
    on_a = {on_a.x - push.x, on_a.y - push.y, on_a.turn - turn_a};
    Twist& on_b = pushes_[at(touch.b)];
    on_b = {on_b.x + push.x, on_b.y + push.y, on_b.turn + push.turn};
  }
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
    const double wanted = std::clamp(row.given - row.start * row.mass, row.least, row.most);
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
  const bool done = minimise_roughly();
  done ? static_cast<void>(take_impulses()) : sweep_instead(rows);
  apply(rows, motions);
  return done;
}

/// As if nothing could come apart or slide: what asks for the impossible gives what it may.
void ContactNewton::guess(const std::vector<ContactRow>& rows) {
  set_stiffness(guessed);
  find_speeds(change_);
  find_pushes([&rows](std::size_t i, Row& row, double change) {
    const std::size_t gap = rows[i].kind == RowKind::gap ? i : rows[i].first_gap;
    row.acts = rows[gap].closed && !rows[gap].off && row.mass > 0;
    row.impulse = row.acts ? row.from - row.stiffness * (row.start + change) : 0;
    return row.impulse - row.given;
  });
  find_residual();
  factored_with_ = 0;
  factor_if_changed();
  way_ = residual_;
  matrix_.solve(way_);
  for (std::size_t k = 0; k < way_.size(); ++k) change_[k] -= way_[k];
  find_speeds(change_);
  find_pushes([this, &rows](std::size_t i, Row& row, double change) {
    bound(rows[i], row);
    const double wanted = row.acts ? row.from - row.stiffness * (row.start + change) : 0;
    row.from = std::clamp(wanted, row.least, row.most);
    return 0.0;
  });
}

bool ContactNewton::minimise_roughly() {
  respond();
  for (int step = 0; step < most_steps_at_once; ++step) {
    if (off_balance_ <= balanced * scale_) return true;
    take_step(left_over_at_once);
  }
  return off_balance_ <= unbalanced * scale_;
}

void ContactNewton::sweep_instead(const std::vector<ContactRow>& rows) {
  std::fill(change_.begin(), change_.end(), 0.0);
  for (Row& row : rows_) row.from = row.given;
  sweep(rows, sweeps_before);
}

/// Which springs to begin with, after a look at how far from balance the impulses at hand are.
double ContactNewton::first_stiffness(const std::vector<ContactRow>& rows) {
  set_stiffness(stiffest);
  bound(rows);
  respond();
  if (off_balance_ <= settled * scale_) return stiffest;
  if (off_balance_ <= far_off * scale_) return middle;
  sweep(rows, sweeps_before);
  return softest;
}

/// The velocities in balance with what the rows answer to them. Returns how many steps that took, -1 when too many.
int ContactNewton::minimise() {
  respond();
  for (int step = 0; step < most_steps; ++step) {
    if (off_balance_ <= settled * scale_) return step;
    take_step(left_over);
  }
  return -1;
}

void ContactNewton::take_step(double may_be_left) {
  find_way(may_be_left);
  go_along();
}

void ContactNewton::begin(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) {
  std::fill(change_.begin(), change_.end(), 0.0);
  scale_ = 0;
  std::size_t i = 0;
  for (const Touch& touch : touches_) {
    const Motion& a = motions[touch.body_a];
    const Motion& b = motions[touch.body_b];
    const Vec2d parting = Vec2d(b.velocity) - Vec2d(a.velocity);
    const auto spin_a = static_cast<double>(a.spin);
    const auto spin_b = static_cast<double>(b.spin);
    for (; i < touch.end; ++i) {
      Row& row = rows_[i];
      row.start = row.x * parting.x + row.y * parting.y + row.arm_b * spin_b - row.arm_a * spin_a +
                  static_cast<double>(rows[i].bias);
      row.given = row.from = static_cast<double>(rows[i].given);
      scale_ = std::max(scale_, std::abs(row.given) * row.size);
      const double approach = rows[i].kind == RowKind::gap ? std::max(-row.start, 0.0) : std::abs(row.start);
      if (!rows[i].off) scale_ = std::max(scale_, approach * row.mass * row.size);
    }
  }
}

void ContactNewton::set_stiffness(double stiffness) {
  if (stiffness == stiffness_) return;
  stiffness_ = stiffness;
  for (Row& row : rows_) row.stiffness = stiffness * row.mass;
}

void ContactNewton::bound(const std::vector<ContactRow>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) bound(rows[i], rows_[i]);
}

/// What a row may give at most; friction and rolling resistance follow the gaps.
void ContactNewton::bound(const ContactRow& row, Row& own) const {
  own.least = 0;
  own.most = row.off || own.mass <= 0 ? 0 : std::numeric_limits<double>::infinity();
  if (row.kind == RowKind::gap) return;
  own.most = 0;
  for (std::size_t k = row.first_gap; own.mass > 0 && k < row.first_gap + row.gap_count; ++k)
    own.most += static_cast<double>(row.coefficient) * rows_[k].from;
  own.least = -own.most;
}

void ContactNewton::find_speeds(const std::vector<double>& change) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Mover& m = movers_[i];
    speeds_[i] = {m.root_inv_mass * change[3 * i], m.root_inv_mass * change[3 * i + 1],
                  m.root_inv_inertia * change[3 * i + 2]};
  }
}

/// Impulses at the present velocities, and what is missing to balance.
void ContactNewton::respond() {
  count_row_updates(rows_.size());
  find_speeds(change_);
  std::size_t differing = 0;
  find_pushes([&differing](std::size_t, Row& row, double change) {
    const double wanted = row.from - row.stiffness * (row.start + change);
    row.acts = wanted > row.least && wanted < row.most;
    row.impulse = wanted < row.least ? row.least : wanted > row.most ? row.most : wanted;
    differing += row.acts != row.acted ? 1 : 0;
    return row.impulse - row.given;
  });
  differing_ = differing;
  find_residual();
}

/// What the change of the velocities and the impulses differ by.
void ContactNewton::find_residual() {
  off_balance_ = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Mover& m = movers_[i];
    const Twist& push = pushes_[i];
    const double pushed[3] = {m.root_inv_mass * push.x, m.root_inv_mass * push.y, m.root_inv_inertia * push.turn};
    for (std::size_t k = 0; k < 3; ++k) {
      residual_[3 * i + k] = change_[3 * i + k] - pushed[k];
      off_balance_ = std::max(off_balance_, std::abs(residual_[3 * i + k]));
    }
  }
}

/// Row after row takes the impulse it needs at the moment: nobody is far off after that.
void ContactNewton::sweep(const std::vector<ContactRow>& rows, int times) {
  find_speeds(change_);
  std::fill(pushes_.begin(), pushes_.end(), Twist{});
  const auto push = [this](int body, double x, double y, double turn) {
    const Mover& m = movers_[at(body)];
    Twist& speed = speeds_[at(body)];
    Twist& sum = pushes_[at(body)];
    const double inv_mass = m.root_inv_mass * m.root_inv_mass;
    const double inv_inertia = m.root_inv_inertia * m.root_inv_inertia;
    speed = {speed.x + inv_mass * x, speed.y + inv_mass * y, speed.turn + inv_inertia * turn};
    sum = {sum.x + x, sum.y + y, sum.turn + turn};
  };
  for (int sweep = 0; sweep < times; ++sweep) {
    std::size_t i = 0;
    for (const Touch& touch : touches_) {
      for (; i < touch.end; ++i) {
        Row& row = rows_[i];
        bound(rows[i], row);
        if (row.mass <= 0) continue;
        const Twist& a = speeds_[at(touch.a)];
        const Twist& b = speeds_[at(touch.b)];
        const double speed =
            row.start + row.x * (b.x - a.x) + row.y * (b.y - a.y) + row.arm_b * b.turn - row.arm_a * a.turn;
        const double impulse = std::clamp(row.from - speed * row.mass, row.least, row.most);
        const double gained = impulse - std::exchange(row.from, impulse);
        push(touch.a, -row.x * gained, -row.y * gained, -row.arm_a * gained);
        push(touch.b, row.x * gained, row.y * gained, row.arm_b * gained);
      }
    }
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    change_[3 * i] += movers_[i].root_inv_mass * pushes_[i].x;
    change_[3 * i + 1] += movers_[i].root_inv_mass * pushes_[i].y;
    change_[3 * i + 2] += movers_[i].root_inv_inertia * pushes_[i].turn;
  }
}

/// The springs' impulses become what they start from. True when that hardly changes anything: what acts gives way by no
/// more than `settled`, and what is cut off stays where it was.
bool ContactNewton::take_impulses() {
  const double give = 1 / stiffness_;
  double change = 0;
  for (Row& row : rows_) {
    change = std::max(change, std::abs(row.impulse - row.from) * row.size * (row.acts ? give : 1));
    row.from = row.impulse;
    scale_ = std::max(scale_, std::abs(row.from) * row.size);
  }
  return change <= settled * scale_;
}

void ContactNewton::apply(std::vector<ContactRow>& rows, std::vector<Motion>& motions) {
  find_pushes([](std::size_t, const Row& row, double) { return row.from - row.given; });
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].given = static_cast<real>(rows_[i].from);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Motion& m = motions[bodies_[i]];
    const auto inv_mass = static_cast<double>(m.inv_mass);
    m.velocity += Vec2(Vec2d{inv_mass * pushes_[i].x, inv_mass * pushes_[i].y});
    m.spin += static_cast<real>(static_cast<double>(m.inv_inertia) * pushes_[i].turn);
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
