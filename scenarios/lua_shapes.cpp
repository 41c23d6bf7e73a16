#include "scenarios/lua_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>
#include <numbers>

#include "engine/decompose.h"
#include "engine/elementary.h"
#include "engine/outline.h"
#include "engine/polygon.h"
#include "engine/pose.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

constexpr const char* shape_type = "proofreel.shape";
constexpr int most_corners = 1000;  // far more than an outline may have once it is cleaned

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
  value.rolling_resistance = fields.number("rolling_resistance", Range::not_negative);
  value.surface_speed = fields.number("surface_speed");
  return value;
}

/// What sentences call the shape.
std::string noun_of(const Fields& fields) {
  return "its " + (fields.word() == "regular" ? "regular polygon" : fields.word());
}

/// Of several problems the first is told.
void note(ShapeValue& value, const std::string& problem) {
  if (value.problem.empty()) value.problem = problem;
}

/// A length that must be positive; otherwise a note in the shape.
double length_of(const Fields& fields, const char* key, ShapeValue& value) {
  const double length = fields.required(key, fields.number(key, Range::any));
  const std::string what = std::string("the ") + key + " of " + noun_of(fields);
  if (!(length > 0)) note(value, what + " must be a positive number");
  if (length > max_coordinate) note(value, what + " must not exceed 1e9 m: make it smaller");
  return length;
}

/// Notes in the shape when a point cannot be used; `what` is what the sentence calls it.
void check_point(ShapeValue& value, Vec2d p, const std::string& what) {
  if (!is_finite(p)) {
    note(value, what + " is not finite: give two ordinary numbers");
  } else if (std::fabs(p.x) > max_coordinate || std::fabs(p.y) > max_coordinate) {
    note(value, what + " has a coordinate above 1e9 m: make it smaller or move it nearer");
  }
}

/// The radius of the largest circle inside a convex outline. Twice the area over the circumference is no less.
double inradius_of(const std::vector<Vec2d>& corners) {
  double around = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) around += distance(corners[i], corners[(i + 1) % corners.size()]);
  double fits = 0;
  double too_large = 2 * area_of(corners) / around;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = (fits + too_large) / 2;
    (inset(corners, middle).size() < 3 ? too_large : fits) = middle;
  }
  return too_large;
}

/// A rounding that leaves nothing of the shape.
std::string problem_with_rounding(double rounding, const std::string& noun, const std::vector<Vec2d>& corners) {
  char text[128];
  std::snprintf(text, sizeof text, " is %.6g m and leaves nothing of it: make it smaller than %.6g m,", rounding,
                inradius_of(corners));
  return "the rounding of " + noun + text + " the radius of the largest circle inside";
}

/// The key `rounding`: corners become arcs of that radius, and the shape grows nowhere.
void round_corners(const Fields& fields, ShapeValue& value) {
  const std::optional<double> rounding = fields.number("rounding", Range::not_negative);
  if (!rounding || *rounding == 0 || !value.problem.empty()) return;
  if (value.parts.size() != 1) {
    return note(value,
                "the rounding of " + noun_of(fields) + " cannot be had, because its outline is concave: leave it out");
  }
  std::vector<Vec2d> core = inset(value.parts[0], *rounding);
  if (std::holds_alternative<std::string>(clean_polygon(core))) {
    return note(value, problem_with_rounding(*rounding, noun_of(fields), value.parts[0]));
  }
  value.parts = {std::move(core)};
  value.radius = *rounding;
}

int circle(lua_State* state) {
  static constexpr Name keys[] = {
      {"radius"}, {"at"}, {"density"}, {"friction"}, {"restitution"}, {"rolling_resistance"}, {"surface_speed"}};
  const Fields fields(state, 1, "circle", keys);
  ShapeValue value = with_coefficients(fields);
  const Vec2d center = fields.vector("at", Range::any).value_or(Vec2d{});
  value.parts = {{center}};
  value.radius = length_of(fields, "radius", value);
  check_point(value, center, "the centre of " + noun_of(fields));
  return push_shape(state, std::move(value));
}

/// For polygons whose corners are computed, not listed. Far from the origin, rounding may spoil what is sound where it
/// is made.
int push_made_polygon(const Fields& fields, ShapeValue value, std::vector<Vec2d> corners, const Posed& pose) {
  const std::string noun = noun_of(fields);
  const auto made = clean_polygon(corners, noun);
  if (const auto* problem = std::get_if<std::string>(&made)) note(value, *problem);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = to_world(pose, corners[i]);
    check_point(value, corners[i], "corner " + std::to_string(i + 1) + " of " + noun);
  }
  const auto placed = clean_polygon(corners, noun);
  const auto* outline = std::get_if<std::vector<Vec2d>>(&placed);
  if (outline == nullptr || *outline != corners || !is_convex(corners)) {
    note(value, noun + " is too small for its corners to be told apart so far away: make it larger or move it nearer");
  }
  value.parts = {std::move(corners)};
  round_corners(fields, value);
  return push_shape(fields.state(), std::move(value));
}

int box(lua_State* state) {
  static constexpr Name keys[] = {{"width"},        {"height"},      {"at"},
                                  {"angle"},        {"rounding"},    {"density"},
                                  {"friction"},     {"restitution"}, {"rolling_resistance"},
                                  {"surface_speed"}};
  const Fields fields(state, 1, "box", keys);
  ShapeValue value = with_coefficients(fields);
  const double x = length_of(fields, "width", value) / 2;
  const double y = length_of(fields, "height", value) / 2;
  const Posed pose{fields.vector("at", Range::any).value_or(Vec2d{}), Rotd{fields.number("angle").value_or(0)}};
  return push_made_polygon(fields, std::move(value), {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, pose);
}

/// Refuses what is listed at a number beyond the last of the sequence: nobody would read it.
void refuse_stray_corners(lua_State* state, const char* word, lua_Integer count) {
  lua_Integer stray = 0;
  for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
    if (!lua_isinteger(state, -2)) continue;
    const lua_Integer key = lua_tointeger(state, -2);
    if (key > count && (stray == 0 || key < stray)) stray = key;
  }
  if (stray == 0) return;
  const std::string number = "[" + std::to_string(stray) + "]";
  throw Problem(std::string(word) + ": " + number + " comes after a gap, the list ends at " + std::to_string(count) +
                ": number the points without gaps, or leave " + number + " out");
}

/// The corners listed in the table at index 1.
std::vector<Vec2d> read_corners(lua_State* state, const char* word) {
  const auto count = lua_rawlen(state, 1);
  if (count > most_corners) {
    throw Problem(std::string(word) + ": " + std::to_string(count) + " points are too many, at most " +
                  std::to_string(most_corners) + " can be given: leave some out");
  }
  refuse_stray_corners(state, word, static_cast<lua_Integer>(count));
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

constexpr Name corner_keys[] = {{"rounding"},           {"density"},      {"friction"}, {"restitution"},
                                {"rolling_resistance"}, {"surface_speed"}};

/// Cuts the outline into convex parts where it has to be.
void set_parts(lua_State* state, ShapeValue& value, const std::vector<Vec2d>& outline, const std::string& noun) {
  const std::uint64_t n = outline.size();
  if (n > max_polygon_vertices || !is_convex(outline)) sandbox_of(state).charge(n * n * n);
  auto parts = convex_parts(outline);
  if (auto* found = std::get_if<ConvexParts>(&parts)) {
    value.parts = std::move(*found);
  } else {
    note(value, noun + " cannot be used: " + std::get<std::string>(parts));
  }
}

int push_polygon(const Fields& fields, ShapeValue value, const std::vector<Vec2d>& corners) {
  lua_State* state = fields.state();
  const std::string noun = noun_of(fields);
  sandbox_of(state).charge(corners.size() * corners.size());  // every edge is held against every other
  const auto cleaned = clean_polygon(corners, noun);
  if (const auto* outline = std::get_if<std::vector<Vec2d>>(&cleaned)) {
    set_parts(state, value, *outline, noun);
  } else {
    note(value, std::get<std::string>(cleaned));
  }
  round_corners(fields, value);
  return push_shape(state, std::move(value));
}

int polygon(lua_State* state) {
  const Fields fields(state, 1, "polygon", corner_keys, most_corners + 1);
  return push_polygon(fields, with_coefficients(fields), read_corners(state, "polygon"));
}

/// What makes a hull of fewer than three corners.
std::string problem_with_flat_hull(const std::vector<Vec2d>& points, const std::vector<Vec2d>& hull) {
  const bool on_a_line =
      std::any_of(points.begin(), points.end(), [&](Vec2d p) { return !(p == hull.front()) && !(p == hull.back()); });
  if (on_a_line) return "all points of its hull lie on one line, it has zero area: move one off the line";
  return "its hull has fewer than three distinct points: give at least three";
}

int hull(lua_State* state) {
  const Fields fields(state, 1, "hull", corner_keys, most_corners + 1);
  const std::vector<Vec2d> points = read_corners(state, "hull");
  sandbox_of(state).charge(points.size() * points.size());
  ShapeValue value = with_coefficients(fields);
  for (std::size_t i = 0; i < points.size(); ++i) {
    check_point(value, points[i], "point " + std::to_string(i + 1) + " of its hull");
  }
  if (!value.problem.empty()) return push_shape(state, std::move(value));
  const std::vector<Vec2d> corners = convex_hull(points);
  if (corners.size() < 3) note(value, problem_with_flat_hull(points, corners));
  return push_polygon(fields, std::move(value), corners);
}

/// A side lies at the bottom, so that it stands.
int regular(lua_State* state) {
  static constexpr Name keys[] = {{"sides"},    {"radius"},      {"rounding"},           {"density"},
                                  {"friction"}, {"restitution"}, {"rolling_resistance"}, {"surface_speed"}};
  const Fields fields(state, 1, "regular", keys);
  ShapeValue value = with_coefficients(fields);
  const double radius = length_of(fields, "radius", value);
  const auto sides = fields.required("sides", fields.integer("sides", 3, max_polygon_vertices));
  std::vector<Vec2d> corners;
  for (std::int64_t i = 0; i < sides; ++i) {
    const double turn = (static_cast<double>(2 * i + 1) / static_cast<double>(sides) - 0.5) * std::numbers::pi;
    corners.push_back({radius * elementary::cos(turn), radius * elementary::sin(turn)});
  }
  return push_made_polygon(fields, std::move(value), std::move(corners), Posed{});
}

/// The keys a and b: the ends of a capsule or segment.
void read_ends(const Fields& fields, ShapeValue& value) {
  const Vec2d a = fields.required("a", fields.vector("a", Range::any));
  const Vec2d b = fields.required("b", fields.vector("b", Range::any));
  check_point(value, a, "the end a of " + noun_of(fields));
  check_point(value, b, "the end b of " + noun_of(fields));
  if (a == b) note(value, "the two ends of " + noun_of(fields) + " are the same point: move one, or use a circle");
  value.parts = {{a, b}};
}

int capsule(lua_State* state) {
  static constexpr Name keys[] = {
      {"a"}, {"b"}, {"radius"}, {"density"}, {"friction"}, {"restitution"}, {"rolling_resistance"}, {"surface_speed"}};
  const Fields fields(state, 1, "capsule", keys);
  ShapeValue value = with_coefficients(fields);
  read_ends(fields, value);
  value.radius = length_of(fields, "radius", value);
  return push_shape(state, std::move(value));
}

int segment(lua_State* state) {
  static constexpr Name keys[] = {
      {"a"}, {"b"}, {"density"}, {"friction"}, {"restitution"}, {"rolling_resistance"}, {"surface_speed"}};
  const Fields fields(state, 1, "segment", keys);
  ShapeValue value = with_coefficients(fields);
  read_ends(fields, value);
  return push_shape(state, std::move(value));
}

}  // namespace

std::vector<ShapeDef> ShapeValue::on_body(const Material& material) const {
  std::vector<ShapeDef> shapes;
  for (const std::vector<Vec2d>& points : parts) {
    ShapeDef& shape = shapes.emplace_back();
    shape.points = points;
    shape.radius = radius;
    shape.density = density.value_or(material.density);
    shape.friction = friction.value_or(material.friction);
    shape.restitution = restitution.value_or(material.restitution);
    shape.rolling_resistance = rolling_resistance.value_or(material.rolling_resistance);
    shape.surface_speed = surface_speed.value_or(material.surface_speed);
  }
  return shapes;
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
