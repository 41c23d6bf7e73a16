#include "engine/pose.h"
#include "scenarios/effects.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr std::size_t most_joints = 200'000;

/// The first two positional entries of the table at index 1.
JointDef between(lua_State* state, const Fields& fields, JointKind kind) {
  JointDef joint;
  joint.kind = kind;
  const std::string& word = fields.word();
  lua_rawgeti(state, 1, 1);
  joint.a = existing_body(state, -1, word + "{a, b, ...}: a");
  lua_rawgeti(state, 1, 2);
  joint.b = existing_body(state, -1, word + "{a, b, ...}: b");
  lua_pop(state, 2);
  const Model& model = model_of(state);
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

int push_new_joint(lua_State* state, const JointDef& joint) {
  Model& model = model_of(state);
  charge_for_making(state);
  if (model.joints.size() >= most_joints) {
    throw Problem("a scene holds at most " + std::to_string(most_joints) + " joints");
  }
  const auto id = static_cast<JointId>(model.joints.size());
  model.warn_of_omissions(called_for_by(joint));
  if (model.simulation != nullptr) model.simulation->apply(CreateJoint{joint});
  model.joints.push_back({joint, false});
  if (model.simulation != nullptr) model.check_method();
  model.touch();
  push_joint(state, id);
  return 1;
}

int revolute(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"limits", false}, {"motor", false}, {"break_force", false}};
  const Fields fields(state, 1, "revolute", keys, 2);
  Model& model = model_of(state);
  model.must_act("revolute");
  JointDef joint = between(state, fields, JointKind::revolute);
  const Vec2d at = fields.required("at", fields.vector("at"));
  joint.anchor_a = anchor_on(model, joint.a, at);
  joint.anchor_b = anchor_on(model, joint.b, at);
  return push_new_joint(state, joint);
}

/// The ends `from` and `to`, and the length, which is their distance now unless given.
JointDef stretched(lua_State* state, const Fields& fields, JointKind kind) {
  Model& model = model_of(state);
  model.must_act(fields.word());
  JointDef joint = between(state, fields, kind);
  const Vec2d from = fields.required("from", fields.vector("from"));
  const Vec2d to = fields.required("to", fields.vector("to"));
  joint.anchor_a = anchor_on(model, joint.a, from);
  joint.anchor_b = anchor_on(model, joint.b, to);
  const Range range = kind == JointKind::spring ? Range::not_negative : Range::positive;
  joint.length = fields.number("length", range).value_or(distance(from, to));
  return joint;
}

int distance_joint(lua_State* state) {
  static constexpr Name keys[] = {{"from"}, {"to"}, {"length"}};
  const Fields fields(state, 1, "distance", keys, 2);
  const JointDef joint = stretched(state, fields, JointKind::distance);
  if (joint.length <= 0) throw Problem("distance: from and to are the same point; use revolute, or give length=");
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

int remove(lua_State* state) {
  const JointId joint = existing_joint(state, 1);
  Model& model = model_of(state);
  model.must_act("j:remove");
  if (model.simulation != nullptr) {
    model.simulation->apply(RemoveJoint{joint});
  } else {
    model.joints[static_cast<std::size_t>(joint)].removed = true;
    model.touch();
  }
  return 0;
}

int reaction(lua_State* state) {
  const JointId joint = existing_joint(state, 1);
  push_vector(state, observed(state).joint(joint).reaction);
  return 1;
}

int gap(lua_State* state) {
  const JointId joint = existing_joint(state, 1);
  lua_pushnumber(state, observed(state).joint(joint).gap);
  return 1;
}

}  // namespace

void open_joints(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<revolute>(state, "revolute");
  set_word<distance_joint>(state, "distance");
  set_word<spring>(state, "spring");
  lua_pop(state, 1);
  luaL_getsubtable(state, LUA_REGISTRYINDEX, joint_methods);
  set_word<remove>(state, "remove");
  set_word<reaction>(state, "reaction");
  set_word<gap>(state, "gap");
  lua_pop(state, 1);
}

}  // namespace proofreel
