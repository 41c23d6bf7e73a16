#include "scenarios/lua_joints.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

/// Whether the joint was there until its load became too much.
bool has_broken(const Model& model, JointId joint) {
  return model.simulation != nullptr && model.simulation->joint(joint).broken;
}

/// The receiver of a method that also answers for a broken joint.
JointId receiver(lua_State* state) {
  const auto joint = to_joint(state, 1);
  return joint && has_broken(model_of(state), *joint) ? *joint : existing_joint(state, 1);
}

/// What has broken is removed already.
int remove(lua_State* state) {
  const JointId joint = receiver(state);
  Model& model = model_of(state);
  model.must_act("j:remove");
  if (!model.exists(joint)) return 0;
  if (model.simulation != nullptr) {
    model.apply(RemoveJoint{joint});
  } else {
    model.joints[static_cast<std::size_t>(joint)].removed = true;
    model.touch();
  }
  return 0;
}

int reaction(lua_State* state) {
  const JointId joint = receiver(state);
  push_vector(state, observed(state).joint(joint).reaction);
  return 1;
}

int gap(lua_State* state) {
  const JointId joint = receiver(state);
  lua_pushnumber(state, observed(state).joint(joint).gap);
  return 1;
}

/// Throws a Problem unless the joint is driven in the way the key says.
void check_driven(const Fields& fields, const JointDef& def) {
  if (fields.has("target") && def.kind != JointKind::drag_to) {
    fields.refuse("target", "belongs to drag_to, which this joint is not");
  }
  if (fields.has("speed") && !def.motor)
    fields.refuse("speed", "belongs to a motor, and this joint was made without one");
  if (fields.has("velocity") && def.max_force <= 0) {
    fields.refuse("velocity", "belongs to a motor made with max_force, which this joint is not");
  }
}

int set(lua_State* state) {
  static constexpr Name keys[] = {{"target"}, {"speed"}, {"velocity"}};
  const JointId joint = existing_joint(state, 1);
  Model& model = model_of(state);
  model.must_act("j:set");
  const Fields fields(state, 2, "set", keys);
  JointDef& def = model.joints[static_cast<std::size_t>(joint)].def;
  check_driven(fields, def);
  const ChangeJoint change{joint, fields.vector("target", Range::place), fields.number("speed"),
                           fields.vector("velocity")};
  def.target = change.target.value_or(def.target);
  def.velocity = change.velocity.value_or(def.velocity);
  if (change.speed) def.motor->speed = *change.speed;
  model.touch();
  if (model.simulation != nullptr) model.apply(change);
  return 0;
}

int on_break(lua_State* state) {
  Model& model = model_of(state);
  model.must_act("on_break");
  charge_for_making(state);
  if (lua_gettop(state) != 2) throw Problem("on_break needs a joint and a function");
  const auto joint = to_joint(state, 1);
  if (!joint) throw Problem("on_break(joint, fn): joint must be a joint, got " + described(state, 1));
  if (!model.exists(*joint)) throw Problem("on_break(joint, fn): the joint was removed");
  if (!model.joints[static_cast<std::size_t>(*joint)].def.break_force) {
    throw Problem("on_break(joint, fn): the joint never breaks; make it with break_force=");
  }
  model.break_handlers.push_back({*joint, keep_function(state, 2, "on_break(joint, fn): fn")});
  return 0;
}

}  // namespace

void open_joint_methods(lua_State* state) {
  luaL_getsubtable(state, LUA_REGISTRYINDEX, joint_methods);
  set_word<remove>(state, "remove");
  set_word<reaction>(state, "reaction");
  set_word<gap>(state, "gap");
  set_word<set>(state, "set");
  lua_pop(state, 1);
  lua_pushglobaltable(state);
  set_word<on_break>(state, "on_break");
  lua_pop(state, 1);
}

}  // namespace proofreel
