#include "scenarios/lua_model.h"

#include <algorithm>

#include "scenarios/effects.h"
#include "scenarios/lua_sandbox.h"
#include "scenarios/lua_values.h"
#include "scenarios/suggest.h"

namespace proofreel {

void Model::bind(Simulation* to) {
  bound_ = to;
  simulation = to;
}

void Model::apply(const Command& command) {
  bound_->apply(command);
  if (log != nullptr) log->push_back(command);
}

void Model::adopt(const Command& command) {
  if (const auto* body = std::get_if<CreateBody>(&command)) {
    scenario.body_names.push_back(body->def.name);
    bodies.push_back({body->def, {}, false});
  } else if (const auto* joint = std::get_if<CreateJoint>(&command)) {
    joints.push_back({joint->def, false});
  }
}

std::string Model::name(BodyId body) const {
  const auto index = static_cast<std::size_t>(body);
  if (index > bodies.size()) return "body " + std::to_string(index);  // a resumed run may hold some nobody told of
  return body == BodyId::world ? "world" : bodies[index - 1].def.name;
}

bool Model::exists(BodyId body) const {
  if (body == BodyId::world) return true;
  if (simulation != nullptr) return simulation->exists(body);
  return !bodies[static_cast<std::size_t>(body) - 1].removed;
}

bool Model::exists(JointId joint) const {
  if (simulation != nullptr) return simulation->exists(joint);
  const JointRecord& record = joints[static_cast<std::size_t>(joint)];
  if (record.removed || !exists(record.def.a) || !exists(record.def.b)) return false;
  return record.def.kind != JointKind::gear || (exists(record.def.first) && exists(record.def.second));
}

BodyState Model::state(BodyId body) const {
  if (body == BodyId::world) return {};
  if (simulation != nullptr) return simulation->body(body);
  return initial_state(bodies[static_cast<std::size_t>(body) - 1].def);
}

BodyType Model::type(BodyId body) const {
  return body == BodyId::world ? BodyType::fixed : bodies[static_cast<std::size_t>(body) - 1].def.type;
}

const Simulation& Model::preview() {
  if (preview_ == nullptr) {
    preview_ = make_simulation(scene_so_far());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].removed) preview_->apply(RemoveBody{static_cast<BodyId>(i + 1)});
    }
  }
  return *preview_;
}

Scene Model::scene_so_far() const {
  Scene scene = scenario.scene;
  scene.bodies.clear();
  scene.joints.clear();
  for (const BodyRecord& body : bodies) scene.bodies.push_back(body.def);
  for (const JointRecord& joint : joints) scene.joints.push_back(joint.def);
  return scene;
}

void Model::must_act(const std::string& what) const {
  if (phase != Phase::looking) return;
  throw Problem(what +
                " acts on the scene; functions of measure, reference, expect, plot and field may only look at it");
}

void Model::must_load(const std::string& what) const {
  if (phase == Phase::loading) return;
  throw Problem(what + " belongs at the top level of the file, not in a callback");
}

void Model::warn_of_omissions(EffectSet wanted) {
  if (phase == Phase::loading || !scenario.scene.effects) return;
  for (std::string& warning : omission_warnings(wanted, *scenario.scene.effects)) {
    auto& warnings = scenario.warnings;
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(std::move(warning));
  }
}

void Model::check_method() const {
  if (steps_everything(scenario.scene.method)) return;
  if (const auto problem = problem_with_method(scene_so_far())) throw Problem(*problem);
}

Model& model_of(lua_State* state) { return *static_cast<Model*>(sandbox_of(state).client()); }

void charge_for_making(lua_State* state) {
  constexpr std::uint64_t cost = 200;  // about a kilobyte of data per thing made: a million of them end the turn
  sandbox_of(state).charge(cost);
}

const Simulation& observed(lua_State* state) {
  constexpr std::uint64_t cost_per_body = 1000;
  Model& model = model_of(state);
  if (model.needs_preview()) sandbox_of(state).charge(cost_per_body * (1 + model.bodies.size()));
  return model.simulation != nullptr ? *model.simulation : model.preview();
}

BodyId existing_body(lua_State* state, int index, const std::string& what) {
  const auto body = to_body(state, index);
  if (!body) throw Problem(what + " must be a body, got " + described(state, index));
  const Model& model = model_of(state);
  if (!model.exists(*body)) throw Problem(what + ": body " + quote(model.name(*body)) + " was removed");
  return *body;
}

BodyId own_body(lua_State* state, int index, const std::string& what) {
  const BodyId body = existing_body(state, index, what);
  if (body == BodyId::world) throw Problem(what + " must be a body of the scene, not the world");
  return body;
}

JointId existing_joint(lua_State* state, int index) {
  const auto joint = to_joint(state, index);
  if (!joint) throw Problem("a method of joints needs a joint: write j:gap(), not j.gap()");
  if (!model_of(state).exists(*joint)) {
    throw Problem("joint " + std::to_string(static_cast<unsigned>(*joint)) + " was removed");
  }
  return *joint;
}

}  // namespace proofreel
