#pragma once

/// Rigid joints, solved directly: all joints of the scene in one linear system, factored exactly (no iteration to
/// converge, whatever the masses), with its rows numbered along the chains so that the factors stay sparse.
///
/// In time it is RATTLE (Andersen 1983): the velocities at the start of a substep get just the impulses that make the
/// positions at its end obey the joints, and after the second half of the forces the velocities are made to obey them
/// too. Second order, time-reversible, and free of energy drift.

#include <vector>

#include "engine/joint.h"
#include "engine/skyline.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class JointSolver {
 public:
  /// Numbers the rows anew. Call when joints or bodies come or go.
  void rebuild(const std::vector<Joint>& joints, const std::vector<Motion>& motions);
  bool empty() const { return rows_.empty(); }
  /// Takes directions and effective masses from the present positions. Call after every drift.
  void linearize(const std::vector<Joint>& joints, const std::vector<Body>& bodies, const std::vector<Motion>& motions);
  /// Starts a substep from the impulses of the one before.
  void begin_substep(std::vector<Joint>& joints, std::vector<Motion>& motions);
  /// Changes velocities so that drifting for `h` ends on the joints.
  void solve_positions(std::vector<Joint>& joints, const std::vector<Body>& bodies, std::vector<Motion>& motions,
                       real h);
  /// Changes velocities so that no joint is opening.
  void solve_velocities(std::vector<Joint>& joints, std::vector<Motion>& motions);

 private:
  struct Row {
    std::uint32_t joint = 0;
    int component = 0;  ///< of a revolute joint: 0 for x, 1 for y
    BodyIndex body_a = 0;
    BodyIndex body_b = 0;
    Vec2 direction;  ///< of the force on b
    real arm_a = 0;  ///< cross(arm, direction)
    real arm_b = 0;
    real goal = 0;  ///< what is left of the row's violation after this substep, m
  };
  /// Two rows that move a common body: the body's contribution to their matrix entry is sign * (...).
  struct Coupling {
    int row = 0;
    int column = 0;
    BodyIndex body = 0;
    bool row_is_b = false;
    bool column_is_b = false;
  };

  std::vector<std::uint32_t> ordered_joints(const std::vector<Joint>& joints, const std::vector<Motion>& motions) const;
  void couple(const std::vector<Motion>& motions);
  real row_violation(const Row& row, const Joint& joint, Vec2 gap) const;
  real row_speed(const Row& row, const std::vector<Motion>& motions) const;
  void apply(const Row& row, real impulse, std::vector<Joint>& joints, std::vector<Motion>& motions) const;
  void add_solution(std::vector<Joint>& joints, std::vector<Motion>& motions) const;
  void take_back(std::vector<Joint>& joints, std::vector<Motion>& motions) const;
  void set_goals(const std::vector<Joint>& joints, const std::vector<Body>& bodies, const std::vector<Motion>& motions,
                 real h);
  real predict(const std::vector<Joint>& joints, const std::vector<Body>& bodies, const std::vector<Motion>& motions,
               real h);

  std::vector<Row> rows_;
  std::vector<Coupling> couplings_;
  SkylineMatrix matrix_;
  std::vector<real> right_side_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
