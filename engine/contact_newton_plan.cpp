// Who moves, what touches, and in which order factors stay sparse.

#include <algorithm>
#include <cmath>

#include "engine/contact_newton.h"
#include "engine/elimination.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool ContactNewton::plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions, double most_work) {
  if (!is_planned_for(rows, motions)) {
    planned_ = make_plan(rows, motions, most_work);
    if (!planned_) return false;
  }
  scale_rows(rows, motions);
  stiffness_ = factored_with_ = 0;
  return true;
}

/// Mostly the same bodies touch as in the tick before.
bool ContactNewton::is_planned_for(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) const {
  if (!planned_ || rows.size() != rows_.size()) return false;
  std::size_t i = 0;
  for (const Touch& touch : touches_) {
    if (moves(touch.a) != is_moved(motions[touch.body_a]) || moves(touch.b) != is_moved(motions[touch.body_b]))
      return false;
    for (; i < touch.end; ++i) {
      if (rows[i].term.body_a != touch.body_a || rows[i].term.body_b != touch.body_b) return false;
    }
  }
  return true;
}

bool ContactNewton::make_plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions,
                              double most_work) {
  group_rows(rows, motions);
  const std::vector<std::vector<int>> below = order_bodies();
  if (!matrix_.plan(below, std::vector<int>(bodies_.size(), 3), most_work)) return false;
  for (Touch& touch : touches_) {
    if (moves(touch.a)) touch.place_a = matrix_.place_of(touch.a, touch.a);
    if (moves(touch.b)) touch.place_b = matrix_.place_of(touch.b, touch.b);
    if (moves(touch.a) && moves(touch.b))
      touch.place_between = matrix_.place_of(std::max(touch.a, touch.b), std::min(touch.a, touch.b));
  }
  movers_.assign(bodies_.size() + 1, {});
  speeds_.assign(bodies_.size() + 1, {});
  pushes_.assign(bodies_.size() + 1, {});
  change_.assign(3 * bodies_.size(), 0);
  residual_.assign(3 * bodies_.size(), 0);
  return true;
}

/// Finds who moves and what touches.
void ContactNewton::group_rows(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) {
  bodies_.clear();
  touches_.clear();
  rows_.assign(rows.size(), {});
  for (const ContactRow& row : rows) {
    const BodyIndex a = row.term.body_a;
    const BodyIndex b = row.term.body_b;
    const bool same = !touches_.empty() && touches_.back().body_a == a && touches_.back().body_b == b;
    if (!same) {
      Touch touch;
      touch.body_a = a;
      touch.body_b = b;
      touch.end = touches_.empty() ? 0 : touches_.back().end;
      touches_.push_back(touch);
      if (is_moved(motions[a])) bodies_.push_back(a);
      if (is_moved(motions[b])) bodies_.push_back(b);
    }
    ++touches_.back().end;
  }
  std::sort(bodies_.begin(), bodies_.end());
  bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
}

/// Puts the bodies in order of elimination and tells the touches. Returns what stands below the diagonal.
std::vector<std::vector<int>> ContactNewton::order_bodies() {
  const int count = static_cast<int>(bodies_.size());
  const auto number_of = [this, count](BodyIndex body) {
    const auto found = std::lower_bound(bodies_.begin(), bodies_.end(), body);
    return found != bodies_.end() && *found == body ? static_cast<int>(found - bodies_.begin()) : count;
  };
  std::vector<std::vector<int>> neighbours(bodies_.size());
  for (Touch& touch : touches_) {
    touch.a = number_of(touch.body_a);
    touch.b = number_of(touch.body_b);
    if (!moves(touch.a) || !moves(touch.b)) continue;
    neighbours[at(touch.a)].push_back(touch.b);
    neighbours[at(touch.b)].push_back(touch.a);
  }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  std::vector<int> turn = elimination_turns(neighbours);
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
  turn.push_back(count);
  for (Touch& touch : touches_) {
    touch.a = turn[at(touch.a)];
    touch.b = turn[at(touch.b)];
  }
  return below;
}

void ContactNewton::scale_rows(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    movers_[i].root_inv_mass = std::sqrt(static_cast<double>(motions[bodies_[i]].inv_mass));
    movers_[i].root_inv_inertia = std::sqrt(static_cast<double>(motions[bodies_[i]].inv_inertia));
  }
  std::size_t i = 0;
  for (const Touch& touch : touches_) {
    const Mover& a = movers_[at(touch.a)];
    const Mover& b = movers_[at(touch.b)];
    const double inv_mass = a.root_inv_mass * a.root_inv_mass + b.root_inv_mass * b.root_inv_mass;
    for (; i < touch.end; ++i) {
      const Term& term = rows[i].term;
      Row& row = rows_[i];
      row.x = static_cast<double>(term.direction.x);
      row.y = static_cast<double>(term.direction.y);
      row.arm_a = static_cast<double>(term.arm_a);
      row.arm_b = static_cast<double>(term.arm_b);
      const double turn_a = a.root_inv_inertia * row.arm_a;
      const double turn_b = b.root_inv_inertia * row.arm_b;
      const double response = inv_mass * (row.x * row.x + row.y * row.y) + turn_a * turn_a + turn_b * turn_b;
      row.size = std::sqrt(response);
      row.mass = response > 0 ? 1 / response : 0;
    }
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
