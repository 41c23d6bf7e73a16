#include "scenarios/lua_joints.h"

#include <cmath>

#include "engine/pose.h"
#include "scenarios/effects.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

constexpr std::size_t most_joints = 200'000;

/// The positional entry `place` of the table at index 1.
BodyId body_at(lua_State* state, int place, const std::string& what) {
  lua_rawgeti(state, 1, place);
  const BodyId body = existing_body(state, -1, what);
  lua_pop(state, 1);
  return body;
}

/// The first two positional entries of the table at index 1.
JointDef between(lua_State* state, const Fields& fields, JointKind kind) {
  JointDef joint;
  joint.kind = kind;
  const std::string& word = fields.word();
  const Model& model = model_of(state);
  model.must_act(word);
  joint.a = body_at(state, 1, word + "{a, b, ...}: a");
  joint.b = body_at(state, 2, word + "{a, b, ...}: b");
  if (joint.a == joint.b) throw Problem(word + " joins body " + quote(model.name(joint.a)) + " to itself");
  if (model.type(joint.a) != BodyType::dynamic && model.type(joint.b) != BodyType::dynamic) {
    throw Problem(word + " joins " + quote(model.name(joint.a)) + " and " + quote(model.name(joint.b)) +
                  ", neither of which is dynamic");
  }
  return joint;
}

/// A world point in the coordinates of a body as it is now.
Vec2d anchor_on(const Model& model, BodyId body, Vec2d point) {
  if (body == BodyId::world) return point;
  const BodyState now = model.state(body);
  return to_local(Posed{now.position, Rotd{now.angle}}, point);
}

void anchor_both(const Model& model, JointDef& joint, Vec2d from, Vec2d to) {
  joint.anchor_a = anchor_on(model, joint.a, from);
  joint.anchor_b = anchor_on(model, joint.b, to);
}

int push_new_joint(lua_State* state, const JointDef& joint) {
  Model& model = model_of(state);
  charge_for_making(state);
  if (model.joints.size() >= most_joints) {
    throw Problem("a scene holds at most " + std::to_string(most_joints) + " joints");
  }
  const auto id = static_cast<JointId>(model.joints.size());
  model.warn_of_omissions(called_for_by(joint));
  if (model.simulation != nullptr) model.apply(CreateJoint{joint});
  model.joints.push_back({joint, false});
  if (model.simulation != nullptr) model.check_method();
  model.touch();
  push_joint(state, id);
  return 1;
}

std::optional<double> read_break_force(const Fields& fields) { return fields.number("break_force", Range::positive); }

std::optional<LimitsDef> read_limits(const Fields& fields) {
  if (!fields.push("limits")) return std::nullopt;
  const auto limits = to_vector(fields.state(), -1);
  lua_pop(fields.state(), 1);
  if (!limits) fields.refuse("limits", "must be {lowest, highest}");
  if (!is_finite(*limits)) fields.refuse("limits", "must be finite");
  if (limits->x > limits->y) fields.refuse("limits", "must be {lowest, highest}, and the first is above the second");
  return LimitsDef{limits->x, limits->y};
}

/// motor={speed=, max_torque=} or motor={speed=, max_force=}.
std::optional<MotorDef> read_motor(const Fields& fields, const char* strongest) {
  if (!fields.push("motor")) return std::nullopt;
  const Name keys[] = {{"speed"}, {strongest}};
  const Fields motor(fields.state(), -1, fields.word() + ": motor", keys);
  MotorDef def;
  def.speed = motor.required("speed", motor.number("speed"));
  def.strongest = motor.required(strongest, motor.number(strongest, Range::positive));
  lua_pop(fields.state(), 1);
  return def;
}

/// The axis, of any length but zero, as a unit vector in the coordinates of `a`.
Vec2d read_axis(const Model& model, const Fields& fields, BodyId a) {
  const Vec2d axis = fields.required("axis", fields.vector("axis"));
  if (!(length(axis) > 0) || !std::isfinite(length(axis))) fields.refuse("axis", "must have a direction");
  const Vec2d unit = (1 / length(axis)) * axis;
  return a == BodyId::world ? unit : inverse_rotate(Rotd{model.state(a).angle}, unit);
}

int revolute(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"limits"}, {"motor"}, {"break_force"}};
  const Fields fields(state, 1, "revolute", keys, 2);
  JointDef joint = between(state, fields, JointKind::revolute);
  const Vec2d at = fields.required("at", fields.vector("at", Range::place));
  anchor_both(model_of(state), joint, at, at);
  joint.limits = read_limits(fields);
  joint.motor = read_motor(fields, "max_torque");
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

int prismatic(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"axis"}, {"limits"}, {"motor"}, {"break_force"}};
  const Fields fields(state, 1, "prismatic", keys, 2);
  JointDef joint = between(state, fields, JointKind::prismatic);
  const Vec2d at = fields.required("at", fields.vector("at", Range::place));
  anchor_both(model_of(state), joint, at, at);
  joint.axis = read_axis(model_of(state), fields, joint.a);
  joint.limits = read_limits(fields);
  joint.motor = read_motor(fields, "max_force");
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

/// Without a point, bodies are welded midway between their centres of mass.
int weld(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"break_force"}};
  const Fields fields(state, 1, "weld", keys, 2);
  JointDef joint = between(state, fields, JointKind::weld);
  const Model& model = model_of(state);
  const Vec2d center_b = model.state(joint.b == BodyId::world ? joint.a : joint.b).center;
  const Vec2d center_a = joint.a == BodyId::world ? center_b : model.state(joint.a).center;
  const Vec2d at = fields.vector("at", Range::place).value_or(0.5 * (center_a + center_b));
  anchor_both(model, joint, at, at);
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

int wheel(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"axis"}, {"stiffness"}, {"damping"}, {"motor"}, {"break_force"}};
  const Fields fields(state, 1, "wheel", keys, 2);
  JointDef joint = between(state, fields, JointKind::wheel);
  const Vec2d at = fields.required("at", fields.vector("at", Range::place));
  anchor_both(model_of(state), joint, at, at);
  joint.axis = read_axis(model_of(state), fields, joint.a);
  joint.stiffness = fields.required("stiffness", fields.number("stiffness", Range::positive));
  joint.damping = fields.number("damping", Range::not_negative).value_or(0);
  joint.motor = read_motor(fields, "max_torque");
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

/// The ends `from` and `to`, and the length, which is their distance now unless given.
JointDef stretched(lua_State* state, const Fields& fields, JointKind kind) {
  JointDef joint = between(state, fields, kind);
  const Vec2d from = fields.required("from", fields.vector("from", Range::place));
  const Vec2d to = fields.required("to", fields.vector("to", Range::place));
  anchor_both(model_of(state), joint, from, to);
  const Range range = kind == JointKind::spring ? Range::not_negative : Range::positive;
  joint.length = fields.number("length", range).value_or(distance(from, to));
  return joint;
}

int distance_joint(lua_State* state) {
  static constexpr Name keys[] = {{"from"}, {"to"}, {"length"}, {"break_force"}};
  const Fields fields(state, 1, "distance", keys, 2);
  JointDef joint = stretched(state, fields, JointKind::distance);
  if (joint.length <= 0) throw Problem("distance: from and to are the same point; use revolute, or give length=");
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

int rope(lua_State* state) {
  static constexpr Name keys[] = {{"from"}, {"to"}, {"length"}, {"break_force"}};
  const Fields fields(state, 1, "rope", keys, 2);
  JointDef joint = stretched(state, fields, JointKind::rope);
  if (joint.length <= 0) throw Problem("rope: from and to are the same point; give length=");
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

int spring(lua_State* state) {
  static constexpr Name keys[] = {{"from"}, {"to"}, {"length"}, {"stiffness"}, {"damping"}};
  const Fields fields(state, 1, "spring", keys, 2);
  JointDef joint = stretched(state, fields, JointKind::spring);
  joint.stiffness = fields.required("stiffness", fields.number("stiffness", Range::not_negative));
  joint.damping = fields.number("damping", Range::not_negative).value_or(0);
  return push_new_joint(state, joint);
}

/// A joint with a coordinate that a gear can couple.
JointId geared_joint(lua_State* state, int place) {
  lua_rawgeti(state, 1, place);
  const std::string what = "gear{j1, j2, ...}: j" + std::to_string(place);
  const auto joint = to_joint(state, -1);
  if (!joint) throw Problem(what + " must be a joint, got " + described(state, -1));
  lua_pop(state, 1);
  const Model& model = model_of(state);
  if (!model.exists(*joint)) throw Problem(what + " was removed");
  const JointKind kind = model.joints[static_cast<std::size_t>(*joint)].def.kind;
  if (kind != JointKind::revolute && kind != JointKind::prismatic) {
    throw Problem(what + " must be a revolute or a prismatic joint: only these have a coordinate to couple");
  }
  return *joint;
}

int gear(lua_State* state) {
  static constexpr Name keys[] = {{"ratio"}};
  const Fields fields(state, 1, "gear", keys, 2);
  Model& model = model_of(state);
  model.must_act("gear");
  JointDef joint;
  joint.kind = JointKind::gear;
  joint.first = geared_joint(state, 1);
  joint.second = geared_joint(state, 2);
  if (joint.first == joint.second) throw Problem("gear couples a joint to itself");
  const JointDef& first = model.joints[static_cast<std::size_t>(joint.first)].def;
  const JointDef& second = model.joints[static_cast<std::size_t>(joint.second)].def;
  joint.a = first.b;
  joint.anchor_a = first.anchor_b;
  joint.b = second.b;
  joint.anchor_b = second.anchor_b;
  joint.ratio = fields.number("ratio").value_or(1);
  if (joint.ratio == 0) fields.refuse("ratio", "must not be 0");
  return push_new_joint(state, joint);
}

int pulley(lua_State* state) {
  static constexpr Name keys[] = {{"from_a"}, {"from_b"}, {"to_a"}, {"to_b"}, {"ratio"}, {"break_force"}};
  const Fields fields(state, 1, "pulley", keys, 2);
  JointDef joint = between(state, fields, JointKind::pulley);
  joint.pin_a = fields.required("from_a", fields.vector("from_a", Range::place));
  joint.pin_b = fields.required("from_b", fields.vector("from_b", Range::place));
  const Vec2d to_a = fields.required("to_a", fields.vector("to_a", Range::place));
  const Vec2d to_b = fields.required("to_b", fields.vector("to_b", Range::place));
  if (joint.pin_a == to_a) throw Problem("pulley: from_a and to_a are the same point, so the rope has no direction");
  if (joint.pin_b == to_b) throw Problem("pulley: from_b and to_b are the same point, so the rope has no direction");
  anchor_both(model_of(state), joint, to_a, to_b);
  joint.ratio = fields.number("ratio", Range::positive).value_or(1);
  joint.break_force = read_break_force(fields);
  return push_new_joint(state, joint);
}

int drag_to(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"target"}, {"max_force"}};
  const Fields fields(state, 1, "drag_to", keys, 1);
  const Model& model = model_of(state);
  model.must_act("drag_to");
  JointDef joint;
  joint.kind = JointKind::drag_to;
  lua_rawgeti(state, 1, 1);
  joint.b = own_body(state, -1, "drag_to{body, ...}: body");
  lua_pop(state, 1);
  if (model.type(joint.b) != BodyType::dynamic) {
    throw Problem("drag_to: body " + quote(model.name(joint.b)) + " is not dynamic, so nothing can pull it");
  }
  joint.target = fields.required("target", fields.vector("target", Range::place));
  joint.max_force = fields.required("max_force", fields.number("max_force", Range::positive));
  joint.anchor_b = anchor_on(model, joint.b, fields.vector("at", Range::place).value_or(model.state(joint.b).center));
  return push_new_joint(state, joint);
}

int motor(lua_State* state) {
  static constexpr Name keys[] = {{"speed"}, {"max_torque"}, {"velocity"}, {"max_force"}};
  const Fields fields(state, 1, "motor", keys, 2);
  JointDef joint = between(state, fields, JointKind::motor);
  const auto speed = fields.number("speed");
  const auto velocity = fields.vector("velocity");
  const auto max_torque = fields.number("max_torque", Range::positive);
  const auto max_force = fields.number("max_force", Range::positive);
  if (!speed && !velocity) throw Problem("motor needs speed= with max_torque=, or velocity= with max_force=, or both");
  if (speed.has_value() != max_torque.has_value()) fields.missing(speed ? "max_torque" : "speed");
  if (velocity.has_value() != max_force.has_value()) fields.missing(velocity ? "max_force" : "velocity");
  if (speed) joint.motor = {*speed, *max_torque};
  joint.velocity = velocity.value_or(Vec2d{});
  joint.max_force = max_force.value_or(0);
  return push_new_joint(state, joint);
}

}  // namespace

void open_joints(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<revolute>(state, "revolute");
  set_word<distance_joint>(state, "distance");
  set_word<rope>(state, "rope");
  set_word<spring>(state, "spring");
  set_word<prismatic>(state, "prismatic");
  set_word<weld>(state, "weld");
  set_word<wheel>(state, "wheel");
  set_word<gear>(state, "gear");
  set_word<pulley>(state, "pulley");
  set_word<drag_to>(state, "drag_to");
  set_word<motor>(state, "motor");
  lua_pop(state, 1);
  open_joint_methods(state);
}

}  // namespace proofreel
