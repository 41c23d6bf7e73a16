#include "engine/joint_solver.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/elimination.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

using Ids = std::vector<std::uint32_t>;

/// Which joints hold which moving bodies, both ways.
class JointGraph {
 public:
  JointGraph(const std::vector<Joint>& joints, const std::vector<Motion>& motions)
      : at_body_(motions.size()), bodies_(joints.size()) {
    for (std::uint32_t i = 0; i < joints.size(); ++i) {
      if (!joints[i].alive || is_soft(joints[i].kind)) continue;
      const Terms terms = bodies_of(joints[i], joints);
      for (int t = 0; t < terms.count; ++t) {
        for (const BodyIndex body : {terms.terms[t].body_a, terms.terms[t].body_b}) {
          const bool known = std::find(bodies_[i].begin(), bodies_[i].end(), body) != bodies_[i].end();
          if (motions[body].inv_mass <= 0 || known) continue;
          bodies_[i].push_back(body);
          at_body_[body].push_back(i);
        }
      }
      if (!bodies_[i].empty()) joints_.push_back(i);
    }
  }

  /// Groups of joints that hang together, each from its leaves to its root: breadth-first search from an end of each
  /// chain, read backwards (George 1971). Trees fill in nothing in this order; where there are loops, those with the
  /// fewest neighbours come first.
  std::vector<Ids> groups() const {
    Ids starts = joints_;
    std::stable_sort(starts.begin(), starts.end(), [this](auto i, auto j) { return degree(i) < degree(j); });
    std::vector<bool> seen(bodies_.size(), false);
    std::vector<Ids> groups;
    for (const std::uint32_t start : starts) {
      if (seen[start]) continue;
      groups.push_back(group_from(start, seen));
      if (has_loops(groups.back())) groups.back() = by_fewest_neighbours(groups.back());
    }
    return groups;
  }

 private:
  std::size_t degree(std::uint32_t joint) const {
    std::size_t count = 0;
    for (const BodyIndex body : bodies_[joint]) count += at_body_[body].size();
    return count;
  }

  Ids group_from(std::uint32_t start, std::vector<bool>& seen) const {
    Ids group{start};
    seen[start] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (const BodyIndex body : bodies_[group[next]]) {
        for (const std::uint32_t neighbour : at_body_[body]) {
          if (!seen[neighbour]) group.push_back(neighbour);
          seen[neighbour] = true;
        }
      }
    }
    std::reverse(group.begin(), group.end());
    return group;
  }

  /// Joints that hang together and the bodies they move make a tree if there is one hold of a joint on a body less than
  /// there are joints and bodies.
  bool has_loops(const Ids& group) const {
    std::size_t held = 0;
    std::vector<BodyIndex> bodies;
    for (const std::uint32_t joint : group) {
      held += bodies_[joint].size();
      bodies.insert(bodies.end(), bodies_[joint].begin(), bodies_[joint].end());
    }
    std::sort(bodies.begin(), bodies.end());
    const auto end = std::unique(bodies.begin(), bodies.end());
    return held >= group.size() + static_cast<std::size_t>(end - bodies.begin());
  }

  /// Breadth first, a net fills in far more than by minimum degree (elimination.h).
  Ids by_fewest_neighbours(const Ids& group) const {
    std::vector<int> number(bodies_.size(), 0);
    for (std::size_t i = 0; i < group.size(); ++i) number[group[i]] = static_cast<int>(i);
    std::vector<std::vector<int>> neighbours(group.size());
    for (std::size_t i = 0; i < group.size(); ++i) {
      std::set<int> others;
      for (const BodyIndex body : bodies_[group[i]]) {
        for (const std::uint32_t other : at_body_[body]) others.insert(number[other]);
      }
      others.erase(static_cast<int>(i));
      neighbours[i].assign(others.begin(), others.end());
    }
    const std::vector<int> turns = elimination_turns(std::move(neighbours));
    Ids ordered(group.size());
    for (std::size_t i = 0; i < group.size(); ++i) ordered[static_cast<std::size_t>(turns[i])] = group[i];
    return ordered;
  }

  std::vector<Ids> at_body_;
  std::vector<std::vector<BodyIndex>> bodies_;  ///< of each joint
  Ids joints_;
};

}  // namespace

namespace {

/// Groups move no bodies of each other, so their order decides nothing; but sums over them shall not depend on who
/// slept when.
void put_in_order(std::vector<JointGroup>& groups) {
  std::sort(groups.begin(), groups.end(),
            [](const JointGroup& a, const JointGroup& b) { return a.first_joint() < b.first_joint(); });
}

}  // namespace

void JointSolver::rebuild(const std::vector<Joint>& joints, const std::vector<Motion>& motions, RowsWanted wanted) {
  wanted_ = wanted;
  direct_.clear();
  swept_.clear();
  groups_.clear();
  asleep_.clear();
  for (const Ids& ids : JointGraph(joints, motions).groups()) {
    JointGroup group;
    if (method_ == JointMethod::direct) group = JointGroup(ids, joints, motions, wanted);
    if (method_ == JointMethod::iterative || group.too_dense()) {
      swept_.insert(swept_.end(), ids.begin(), ids.end());
    } else if (!group.empty()) {
      direct_.insert(direct_.end(), ids.begin(), ids.end());
      groups_.push_back(std::move(group));
    }
  }
  std::sort(direct_.begin(), direct_.end());
  std::sort(swept_.begin(), swept_.end());
  sweeps_.rebuild(joints, swept_, wanted);
  put_in_order(groups_);
}

void JointSolver::lay_aside_sleepers(const std::vector<Joint>& joints) {
  sweeps_.rebuild(joints, swept_, wanted_);
  const auto move_if = [&](std::vector<JointGroup>& from, std::vector<JointGroup>& to, bool acts) {
    const auto moved = std::stable_partition(from.begin(), from.end(),
                                             [&](const JointGroup& group) { return group.acts(joints) != acts; });
    std::move(moved, from.end(), std::back_inserter(to));
    from.erase(moved, from.end());
  };
  move_if(groups_, asleep_, false);
  move_if(asleep_, groups_, true);
  put_in_order(groups_);
  put_in_order(asleep_);
}

void JointSolver::begin_tick(const JointedBodies& scene, std::span<const std::uint8_t> overlapping) {
  for (JointGroup& group : groups_) group.begin_tick(scene, overlapping);
  sweeps_.begin_tick(scene);
  linearize(scene);
}

void JointSolver::linearize(const JointedBodies& scene) {
  for (JointGroup& group : groups_) group.linearize(scene);
  sweeps_.linearize(scene);
}

void JointSolver::begin_substep(const JointedBodies& scene, real h, real share) {
  for (JointGroup& group : groups_) group.begin_substep(scene, h, share);
  sweeps_.begin_substep(scene, share);
}

void JointSolver::add_share(const JointedBodies& scene, real share) {
  for (JointGroup& group : groups_) group.add_share(scene);
  sweeps_.add_share(scene, share);
}

bool JointSolver::solve_positions(const JointedBodies& scene, real h) {
  bool moved = false;
  for (JointGroup& group : groups_) moved |= group.solve_positions(scene, h);
  sweeps_.solve_positions(scene, h);
  return moved;
}

void JointSolver::take_back_moves(std::vector<Motion>& motions) {
  for (JointGroup& group : groups_) group.take_back_moves(motions);
}

void JointSolver::solve_velocities(const JointedBodies& scene, real h) {
  for (JointGroup& group : groups_) group.solve_velocities(scene, h);
  sweeps_.solve_velocities(scene, h);
}

void JointSolver::end_substep(const JointedBodies& scene) {
  for (JointGroup& group : groups_) group.end_substep(scene);
}

real JointSolver::fastest_swing(const JointedBodies& scene, real dt) {
  return tension_.fastest_swing(direct_, scene, dt);
}

double JointSolver::take_work(const JointedBodies& scene) {
  double work = sweeps_.take_work(scene);
  for (JointGroup& group : groups_) work += group.take_work(scene);
  return work;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
