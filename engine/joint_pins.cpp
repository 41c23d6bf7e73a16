#include "engine/joint_pins.h"

#include <utility>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

bool JointPins::is_pin(const RowPlan& row, const RowPlan& next) {
  const auto is_row = [](const RowPlan& plan, Coordinate coordinate) {
    return plan.coordinate == coordinate && plan.bound == Bound::equal && plan.sign == 1 && plan.offset == 0;
  };
  return is_row(row, Coordinate::anchor_x) && is_row(next, Coordinate::anchor_y);
}

void JointPins::clear() {
  pins_.clear();
  sources_.clear();
}

void JointPins::add(std::uint32_t joint, std::uint32_t slot, const std::vector<Joint>& joints) {
  Pin& pin = pins_.emplace_back();
  pin.body_a = joints[joint].body_a;
  pin.body_b = joints[joint].body_b;
  Source& source = sources_.emplace_back();
  source.joint = joint;
  source.slot = slot;
}

void JointPins::begin_tick(const JointedBodies& scene) {
  for (Source& source : sources_) {
    const Joint& joint = scene.joints[source.joint];
    source.anchors = anchors_of(joint, scene.bodies);
    source.warm = {joint.memory[source.slot].impulse, joint.memory[source.slot + 1].impulse};
  }
}

/// The response of both points together is a symmetric matrix of 2 x 2, inverted by Cramer's rule.
void JointPins::linearize(const JointedBodies& scene) {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    Pin& pin = pins_[i];
    const Motion& a = scene.motions[pin.body_a];
    const Motion& b = scene.motions[pin.body_b];
    const JointPlace place = place_of(sources_[i].anchors, a, b);
    pin.arm_a = place.arm_a;
    pin.arm_b = place.arm_b;
    pin.gap = place.gap;
    const real inv_mass = a.inv_mass + b.inv_mass;
    const real x = inv_mass + a.inv_inertia * pin.arm_a.y * pin.arm_a.y + b.inv_inertia * pin.arm_b.y * pin.arm_b.y;
    const real y = inv_mass + a.inv_inertia * pin.arm_a.x * pin.arm_a.x + b.inv_inertia * pin.arm_b.x * pin.arm_b.x;
    const real xy = a.inv_inertia * pin.arm_a.x * pin.arm_a.y + b.inv_inertia * pin.arm_b.x * pin.arm_b.y;
    const real determinant = x * y - xy * xy;
    const real inverse = determinant > 0 ? 1 / determinant : 0;
    pin.mass_x = inverse * y;
    pin.mass_xy = inverse * xy;  // the response's own is negative
    pin.mass_y = inverse * x;
  }
}

inline void JointPins::push(const Pin& pin, Vec2 impulse, std::vector<Motion>& motions) {
  motions[pin.body_a].push(-impulse, pin.arm_a);
  motions[pin.body_b].push(impulse, pin.arm_b);
}

inline void JointPins::give(Pin& pin, Vec2 impulse, std::vector<Motion>& motions) {
  pin.given += impulse;
  push(pin, impulse, motions);
}

void JointPins::begin_substep(real share, std::vector<Motion>& motions) {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    pins_[i].given = {};
    sources_[i].kept = {};
    give(pins_[i], share * sources_[i].warm, motions);
  }
}

void JointPins::add_share(real share, std::vector<Motion>& motions) {
  for (std::size_t i = 0; i < pins_.size(); ++i) give(pins_[i], share * sources_[i].warm, motions);
}

inline Vec2 JointPins::parting_speed(const Pin& pin, const std::vector<Motion>& motions) {
  return motions[pin.body_b].velocity_at(pin.arm_b) - motions[pin.body_a].velocity_at(pin.arm_a);
}

/// The impulse that changes the speed of the points by so much.
inline Vec2 JointPins::impulse_for(const Pin& pin, Vec2 speed) {
  return {pin.mass_x * speed.x + pin.mass_xy * speed.y, pin.mass_xy * speed.x + pin.mass_y * speed.y};
}

/// Each pin waits for the one before it, so every operation counts: what springs do is left out where there are none.
void JointPins::sweep_softly(Softness spring, std::vector<Motion>& motions) {
  for (Pin& pin : pins_) {
    const Vec2 lacking = -(spring.bias_rate * pin.gap) - parting_speed(pin, motions);
    give(pin, spring.mass_scale * impulse_for(pin, lacking) - spring.impulse_scale * pin.given, motions);
  }
}

void JointPins::sweep_back(std::vector<Motion>& motions) {
  for (std::size_t i = pins_.size(); i-- > 0;) {
    Pin& pin = pins_[i];
    give(pin, impulse_for(pin, -parting_speed(pin, motions)), motions);
  }
}

void JointPins::keep() {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    Source& source = sources_[i];
    source.warm = pins_[i].given;
    source.total += pins_[i].given - std::exchange(source.kept, pins_[i].given);
  }
}

double JointPins::take_work(const JointedBodies& scene) {
  double work = 0;
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    const Pin& pin = pins_[i];
    const Source& source = sources_[i];
    const Vec2 impulse = std::exchange(sources_[i].total, Vec2{});
    Joint& joint = scene.joints[source.joint];
    joint.impulse += impulse;
    joint.memory[source.slot].impulse = source.warm.x;
    joint.memory[source.slot + 1].impulse = source.warm.y;
    const Term along_x{pin.body_a, pin.body_b, {1, 0}, -pin.arm_a.y, -pin.arm_b.y};
    const Term along_y{pin.body_a, pin.body_b, {0, 1}, pin.arm_a.x, pin.arm_b.x};
    work += work_of_movers({{along_x, {}}, 1}, impulse.x, scene) + work_of_movers({{along_y, {}}, 1}, impulse.y, scene);
  }
  return work;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
