#include "scenarios/lua_shapes.h"

#include <cmath>
#include <new>
#include <numbers>

#include "engine/elementary.h"
#include "engine/polygon.h"
#include "engine/pose.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

constexpr const char* shape_type = "proofreel.shape";
constexpr int most_corners = 1000;  // far more than a body may have; the check for crossings takes their square

int destroy_shape(lua_State* state) {
  static_cast<ShapeValue*>(luaL_checkudata(state, 1, shape_type))->~ShapeValue();
  return 0;
}

int no_field(lua_State* state) {
  throw Problem("a shape has no " + described(state, 2) + ": it is a value to give to body{shape=...}");
}

int shape_text(lua_State* state) {
  lua_pushliteral(state, "shape");
  return 1;
}

int push_shape(lua_State* state, ShapeValue value) {
  charge_for_making(state);
  // The metatable, and with it the destructor, comes last: Lua may fail before.
  void* memory = lua_newuserdatauv(state, sizeof(ShapeValue), 0);
  new (memory) ShapeValue(std::move(value));
  luaL_setmetatable(state, shape_type);
  return 1;
}

ShapeValue with_coefficients(const Fields& fields) {
  ShapeValue value;
  value.density = fields.number("density", Range::positive);
  value.friction = read_friction(fields);
  value.restitution = read_restitution(fields);
  return value;
}

/// A length that must be positive; otherwise a note in the shape.
double length_of(const Fields& fields, const char* key, ShapeValue& value) {
  const double length = fields.required(key, fields.number(key, Range::any));
  if (!(length > 0) || !std::isfinite(length)) {
    value.problem = std::string("the ") + key + " of its " + fields.word() + " must be a positive number";
  }
  return length;
}

int circle(lua_State* state) {
  static constexpr Name keys[] = {{"radius"}, {"at"}, {"density"}, {"friction"}, {"restitution"}};
  const Fields fields(state, 1, "circle", keys);
  ShapeValue value = with_coefficients(fields);
  value.def.points = {fields.vector("at", Range::any).value_or(Vec2d{})};
  value.def.radius = length_of(fields, "radius", value);
  return push_shape(state, std::move(value));
}

int box(lua_State* state) {
  static constexpr Name keys[] = {{"width"}, {"height"}, {"at"}, {"angle"}, {"density"}, {"friction"}, {"restitution"}};
  const Fields fields(state, 1, "box", keys);
  ShapeValue value = with_coefficients(fields);
  const double x = length_of(fields, "width", value) / 2;
  const double y = length_of(fields, "height", value) / 2;
  const Posed pose{fields.vector("at", Range::any).value_or(Vec2d{}), Rotd{fields.number("angle").value_or(0)}};
  for (const Vec2d corner : {Vec2d{-x, -y}, Vec2d{x, -y}, Vec2d{x, y}, Vec2d{-x, y}}) {
    value.def.points.push_back(to_world(pose, corner));
  }
  return push_shape(state, std::move(value));
}

/// The corners listed in the table at index 1.
std::vector<Vec2d> read_corners(lua_State* state, const char* word) {
  const auto count = lua_rawlen(state, 1);
  if (count > most_corners) {
    throw Problem(std::string(word) + " has " + std::to_string(count) + " corners; use at most " +
                  std::to_string(most_corners));
  }
  std::vector<Vec2d> corners;
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(state, 1, static_cast<lua_Integer>(i));
    const auto corner = to_vector(state, -1);
    if (!corner) {
      throw Problem(std::string(word) + ": corner " + std::to_string(i) + " must be a vector {x, y}, got " +
                    described(state, -1));
    }
    corners.push_back(*corner);
    lua_pop(state, 1);
  }
  return corners;
}

constexpr Name corner_keys[] = {{"density"}, {"friction"}, {"restitution"}};

int push_polygon(lua_State* state, ShapeValue value, const std::vector<Vec2d>& corners) {
  sandbox_of(state).charge(corners.size() * corners.size());  // every edge is held against every other
  auto cleaned = clean_polygon(corners);
  if (auto* points = std::get_if<std::vector<Vec2d>>(&cleaned)) {
    value.def.points = std::move(*points);
  } else {
    value.problem = std::get<std::string>(cleaned);
  }
  return push_shape(state, std::move(value));
}

int polygon(lua_State* state) {
  const Fields fields(state, 1, "polygon", corner_keys, most_corners + 1);
  return push_polygon(state, with_coefficients(fields), read_corners(state, "polygon"));
}

int hull(lua_State* state) {
  const Fields fields(state, 1, "hull", corner_keys, most_corners + 1);
  const std::vector<Vec2d> corners = read_corners(state, "hull");
  for (const Vec2d corner : corners) {
    if (is_finite(corner)) continue;
    ShapeValue value = with_coefficients(fields);
    value.problem = "a point of its hull is not finite; all coordinates must be numbers";
    return push_shape(state, std::move(value));
  }
  return push_polygon(state, with_coefficients(fields), convex_hull(corners));
}

/// A side lies at the bottom, so that it stands.
int regular(lua_State* state) {
  static constexpr Name keys[] = {{"sides"}, {"radius"}, {"density"}, {"friction"}, {"restitution"}};
  const Fields fields(state, 1, "regular", keys);
  ShapeValue value = with_coefficients(fields);
  const double radius = length_of(fields, "radius", value);
  const auto sides = fields.required("sides", fields.integer("sides", 3, max_polygon_vertices));
  for (std::int64_t i = 0; i < sides; ++i) {
    const double turn = (static_cast<double>(2 * i + 1) / static_cast<double>(sides) - 0.5) * std::numbers::pi;
    value.def.points.push_back({radius * elementary::cos(turn), radius * elementary::sin(turn)});
  }
  return push_shape(state, std::move(value));
}

int capsule(lua_State* state) {
  static constexpr Name keys[] = {{"a"}, {"b"}, {"radius"}, {"density"}, {"friction"}, {"restitution"}};
  const Fields fields(state, 1, "capsule", keys);
  ShapeValue value = with_coefficients(fields);
  value.def.points = {fields.required("a", fields.vector("a", Range::any)),
                      fields.required("b", fields.vector("b", Range::any))};
  value.def.radius = length_of(fields, "radius", value);
  return push_shape(state, std::move(value));
}

int segment(lua_State* state) {
  static constexpr Name keys[] = {{"a"}, {"b"}, {"density"}, {"friction"}, {"restitution"}};
  const Fields fields(state, 1, "segment", keys);
  ShapeValue value = with_coefficients(fields);
  value.def.points = {fields.required("a", fields.vector("a", Range::any)),
                      fields.required("b", fields.vector("b", Range::any))};
  return push_shape(state, std::move(value));
}

}  // namespace

ShapeDef ShapeValue::on_body(const Material& material) const {
  ShapeDef shape = def;
  shape.density = density.value_or(material.density);
  shape.friction = friction.value_or(material.friction);
  shape.restitution = restitution.value_or(material.restitution);
  return shape;
}

void open_shapes(lua_State* state) {
  luaL_newmetatable(state, shape_type);
  set_word<destroy_shape>(state, "__gc");
  set_word<no_field>(state, "__index");
  set_word<no_field>(state, "__newindex");
  set_word<shape_text>(state, "__tostring");
  lua_pop(state, 1);
  lua_pushglobaltable(state);
  set_word<circle>(state, "circle");
  set_word<box>(state, "box");
  set_word<polygon>(state, "polygon");
  set_word<hull>(state, "hull");
  set_word<regular>(state, "regular");
  set_word<capsule>(state, "capsule");
  set_word<segment>(state, "segment");
  lua_pop(state, 1);
}

const ShapeValue* to_shape(lua_State* state, int index) {
  return static_cast<const ShapeValue*>(luaL_testudata(state, index, shape_type));
}

std::optional<FrictionDef> read_friction(const Fields& fields) {
  lua_State* state = fields.state();
  if (!fields.push("friction")) return std::nullopt;
  const int kind = lua_type(state, -1);
  if (kind == LUA_TTABLE) {
    static constexpr Name keys[] = {{"static"}, {"kinetic"}};
    const Fields pair(state, -1, fields.word() + ": friction", keys);
    const double at_rest = pair.required("static", pair.number("static", Range::not_negative));
    const double sliding = pair.required("kinetic", pair.number("kinetic", Range::not_negative));
    lua_pop(state, 1);
    if (sliding > at_rest) fields.refuse("friction", "must not be larger when sliding (kinetic) than at rest (static)");
    return FrictionDef{at_rest, sliding};
  }
  lua_pop(state, 1);
  if (kind != LUA_TNUMBER) fields.refuse("friction", "must be a number or {static=, kinetic=}");
  const double both = *fields.number("friction", Range::not_negative);
  return FrictionDef{both, both};
}

std::optional<double> read_restitution(const Fields& fields) {
  const auto restitution = fields.number("restitution", Range::not_negative);
  if (restitution && *restitution > 1) fields.refuse("restitution", "must lie between 0 and 1");
  return restitution;
}

}  // namespace proofreel
