#pragma once

/// The pins among the joints that are swept (joint_sweeps.h): two equations each, that two points do not part to either
/// side. A sweep solves both at once, which is cheaper than one after the other and leaves nothing open between them.

#include <cstdint>
#include <vector>

#include "engine/contact_solver.h"
#include "engine/joint_rows.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class JointPins {
 public:
  /// Whether two rows of a joint are those of a pin.
  static bool is_pin(const RowPlan& row, const RowPlan& next);
  void clear();
  /// `slot` is the place of the first of the pin's two rows in the joint's memory.
  void add(std::uint32_t joint, std::uint32_t slot, const std::vector<Joint>& joints);
  std::size_t size() const { return pins_.size(); }
  /// Looks where the anchors are, and takes up the joints' impulses. Call at the start of every tick, and then
  /// `linearize`.
  void begin_tick(const JointedBodies& scene);
  void linearize(const JointedBodies& scene);
  /// Starts a substep with this share of the impulses of the one before.
  void begin_substep(real share, std::vector<Motion>& motions);
  /// Gives as much again.
  void add_share(real share, std::vector<Motion>& motions);
  /// One sweep from the first pin to the last, with the give of springs that close the gaps.
  void sweep_softly(Softness spring, std::vector<Motion>& motions);
  /// One sweep back, rigid.
  void sweep_back(std::vector<Motion>& motions);
  /// Keeps the impulses for the next substep. Call after every sweep back.
  void keep();
  /// Hands the impulses back to the joints, which lie far apart: so this is done once a tick only. Comes back with what
  /// moving kinematic bodies have put in since the last call, J.
  double take_work(const JointedBodies& scene);

 private:
  /// What every sweep goes through: as little as it can be, for there may be tens of thousands of them.
  struct Pin {
    BodyIndex body_a = 0;
    BodyIndex body_b = 0;
    Vec2 arm_a;
    Vec2 arm_b;
    real mass_x = 0;   ///< impulse along x per speed along x ...
    real mass_xy = 0;  ///< ... or along y
    real mass_y = 0;
    Vec2 gap;
    Vec2 given;  ///< impulse of this substep so far
  };
  struct Source {
    std::uint32_t joint = 0;
    std::uint32_t slot = 0;
    Anchors anchors;  ///< in this tick
    Vec2 warm;        ///< impulse of the substep before
    Vec2 kept;        ///< the part of this substep's impulse that is in both
    Vec2 total;       ///< impulse since work was last taken
  };

  static void push(const Pin& pin, Vec2 impulse, std::vector<Motion>& motions);
  static Vec2 parting_speed(const Pin& pin, const std::vector<Motion>& motions);
  static Vec2 impulse_for(const Pin& pin, Vec2 speed);
  static void give(Pin& pin, Vec2 impulse, std::vector<Motion>& motions);

  std::vector<Pin> pins_;
  std::vector<Source> sources_;  ///< parallel to pins_
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
