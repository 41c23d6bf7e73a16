#include "scenarios/lua_forces.h"

#include <cmath>
#include <utility>

#include "engine/mass.h"
#include "engine/outline.h"
#include "scenarios/lua_model.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr Name drag_keys[] = {{"linear"}, {"quadratic"}, {"angular"}};
constexpr std::size_t most_forces = 1000;

DragDef drag_of(const Fields& fields) {
  DragDef drag;
  drag.linear = fields.number("linear", Range::not_negative).value_or(0);
  drag.quadratic = fields.number("quadratic", Range::not_negative).value_or(0);
  drag.angular = fields.number("angular", Range::not_negative).value_or(0);
  return drag;
}

/// The scene, of which the force becomes a part; only while the file is being loaded.
Scene& scene_to_build(lua_State* state, const Fields& fields) {
  Model& model = model_of(state);
  model.must_load(fields.word());
  charge_for_making(state);
  model.touch();
  return model.scenario.scene;
}

int drag(lua_State* state) {
  const Fields fields(state, 1, "drag", drag_keys);
  const DragDef drag = drag_of(fields);
  if (!drag.acts()) throw Problem("drag needs a number above 0 for linear, quadratic or angular");
  scene_to_build(state, fields).drag = drag;
  return 0;
}

int wind(lua_State* state) {
  static constexpr Name keys[] = {{"velocity"}};
  const Fields fields(state, 1, "wind", keys);
  scene_to_build(state, fields).wind = fields.required("velocity", fields.vector("velocity"));
  return 0;
}

std::optional<BodyId> body_field(const Fields& fields) {
  if (!fields.push("body")) return std::nullopt;
  const BodyId body = own_body(fields.state(), -1, fields.word() + ": body");
  lua_pop(fields.state(), 1);
  return body;
}

int attractor(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"body"}, {"strength"}, {"law"}};
  static constexpr Name laws[] = {{"inverse_square"}, {"linear"}};
  const Fields fields(state, 1, "attractor", keys);
  if (fields.has("at") == fields.has("body")) throw Problem("attractor needs either at={x, y} or body=");
  AttractorDef def;
  def.body = body_field(fields);
  def.at = fields.vector("at").value_or(Vec2d{});
  def.strength = fields.required("strength", fields.number("strength"));
  def.law = fields.choice("law", laws).value_or(0) == 0 ? AttractionLaw::inverse_square : AttractionLaw::linear;
  Scene& scene = scene_to_build(state, fields);
  if (scene.attractors.size() >= most_forces) throw Problem("a scene holds at most 1000 attractors");
  scene.attractors.push_back(def);
  return 0;
}

int nbody(lua_State* state) {
  static constexpr Name keys[] = {{"G"}};
  const Fields fields(state, 1, "nbody", keys);
  scene_to_build(state, fields).gravitational_constant = fields.required("G", fields.number("G"));
  return 0;
}

/// Its level is a height, so there must be no doubt what is up.
void check_gravity_for_water(const Model& model) {
  if (!model.described) throw Problem("buoyancy needs the scene's gravity: call scenario{...} first");
  const Vec2d gravity = model.scenario.scene.gravity;
  if (gravity.x == 0 && gravity.y <= 0) return;
  throw Problem(
      "buoyancy has a level, which is a height, so gravity must point straight down: write gravity={0, -g}, or leave "
      "the water out");
}

int buoyancy(lua_State* state) {
  static constexpr Name keys[] = {{"level"}, {"density"}, {"drag"}};
  const Fields fields(state, 1, "buoyancy", keys);
  WaterDef water;
  water.level = fields.required("level", fields.number("level"));
  water.density = fields.required("density", fields.number("density", Range::positive));
  water.drag = fields.number("drag", Range::not_negative).value_or(0);
  for (const auto& [key, value] : {std::pair{"level", water.level}, {"density", water.density}, {"drag", water.drag}}) {
    if (std::abs(value) > max_coordinate) fields.refuse(key, "must not exceed 1e9");
  }
  Scene& scene = scene_to_build(state, fields);
  check_gravity_for_water(model_of(state));
  if (scene.water) throw Problem("buoyancy was given already: a scene has one water, with one level");
  scene.water = water;
  return 0;
}

int field(lua_State* state) {
  Model& model = model_of(state);
  model.must_load("field");
  charge_for_making(state);
  if (model.fields.size() >= most_forces) throw Problem("a scene holds at most 1000 fields");
  model.fields.push_back(keep_function(state, 1, "field(fn): fn"));
  return 0;
}

std::string kilograms(lua_State* state, double mass) {
  lua_pushnumber(state, mass);
  const std::string text = shown(state, -1) + " kg";
  lua_pop(state, 1);
  return text;
}

void check_rocket(lua_State* state, const RocketDef& rocket, const BodyDef& body,
                  const std::vector<RocketDef>& others) {
  const std::string name = "rocket: body " + quote(body.name);
  if (body.type != BodyType::dynamic) throw Problem(name + " is not dynamic, so no thrust can move it");
  double fuel = rocket.fuel;
  for (const RocketDef& other : others) fuel += other.body == rocket.body ? other.fuel : 0;
  const double mass = mass_of(body).mass;
  if (fuel < mass) return;
  throw Problem(name + " carries " + kilograms(state, fuel) + " of fuel but has a mass of " + kilograms(state, mass) +
                ", which includes it: give it more mass, or less fuel");
}

int rocket(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"thrust"}, {"burn_rate"}, {"fuel"}, {"at"}};
  const Fields fields(state, 1, "rocket", keys);
  Scene& scene = scene_to_build(state, fields);
  RocketDef def;
  def.body = fields.required("body", body_field(fields));
  def.thrust = fields.required("thrust", fields.number("thrust"));
  def.burn_rate = fields.required("burn_rate", fields.number("burn_rate", Range::positive));
  def.fuel = fields.required("fuel", fields.number("fuel", Range::positive));
  const BodyDef& body = model_of(state).record(def.body).def;
  def.at = fields.vector("at").value_or(mass_of(body).center);
  check_rocket(state, def, body, scene.rockets);
  if (scene.rockets.size() >= most_forces) throw Problem("a scene holds at most 1000 rockets");
  scene.rockets.push_back(def);
  return 0;
}

}  // namespace

std::optional<DragDef> read_drag(const Fields& fields) {
  if (!fields.push("drag")) return std::nullopt;
  lua_State* state = fields.state();
  if (lua_type(state, -1) == LUA_TTABLE) {
    const DragDef drag = drag_of(Fields(state, -1, fields.word() + ": drag", drag_keys));
    lua_pop(state, 1);
    return drag;
  }
  const bool is_number = lua_type(state, -1) == LUA_TNUMBER;
  lua_pop(state, 1);
  if (!is_number) fields.refuse("drag", "must be a number or {linear=, quadratic=, angular=}");
  return DragDef{*fields.number("drag", Range::not_negative), 0, 0};
}

void open_forces(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<drag>(state, "drag");
  set_word<wind>(state, "wind");
  set_word<attractor>(state, "attractor");
  set_word<nbody>(state, "nbody");
  set_word<buoyancy>(state, "buoyancy");
  set_word<field>(state, "field");
  set_word<rocket>(state, "rocket");
  lua_pop(state, 1);
}

}  // namespace proofreel
