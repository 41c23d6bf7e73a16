#include "scenarios/lua_bodies.h"

#include <limits>

#include "scenarios/effects.h"
#include "scenarios/lua_forces.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

constexpr std::size_t most_bodies = 200'000;

constexpr Name body_keys[] = {{"name"},        {"type"},          {"at"},
                              {"angle"},       {"velocity"},      {"spin"},
                              {"shape"},       {"shapes"},        {"density"},
                              {"mass"},        {"inertia"},       {"friction"},
                              {"restitution"}, {"gravity_scale"}, {"fixed_rotation"},
                              {"bullet"},      {"sensor"},        {"group"},
                              {"category"},    {"mask"},          {"color"},
                              {"drag"},        {"surface_speed"}, {"rolling_resistance"}};

constexpr Name type_names[] = {{"static"}, {"kinematic"}, {"dynamic"}};
constexpr BodyType types[] = {BodyType::fixed, BodyType::kinematic, BodyType::dynamic};

std::optional<BodyType> read_type(const Fields& fields) {
  const auto index = fields.choice("type", type_names);
  if (!index) return std::nullopt;
  return types[*index];
}

/// 0xRRGGBB or "#rrggbb".
std::optional<std::uint32_t> read_color(const Fields& fields) {
  if (!fields.push("color")) return std::nullopt;
  const bool is_text = lua_type(fields.state(), -1) == LUA_TSTRING;
  lua_pop(fields.state(), 1);
  if (!is_text) return static_cast<std::uint32_t>(*fields.integer("color", 0, 0xFFFFFF));
  const std::string text = *fields.text("color");
  const bool six_digits =
      text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!six_digits) fields.refuse("color", "must be written 0xRRGGBB or \"#rrggbb\", got " + quote(text));
  return static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16));
}

std::optional<std::uint64_t> read_bits(const Fields& fields, const char* key) {
  constexpr auto low = std::numeric_limits<std::int64_t>::min();
  constexpr auto high = std::numeric_limits<std::int64_t>::max();
  const auto bits = fields.integer(key, low, high);
  if (!bits) return std::nullopt;
  return static_cast<std::uint64_t>(*bits);
}

/// A copy, which counts as work according to its size.
ShapeValue taken(lua_State* state, const ShapeValue& shape) {
  for (std::size_t i = 0; i < shape.parts.size(); ++i) charge_for_making(state);
  return shape;
}

std::vector<ShapeValue> read_shape_list(const Fields& fields) {
  lua_State* state = fields.state();
  fields.push("shapes");
  if (lua_type(state, -1) != LUA_TTABLE)
    fields.refuse("shapes", "must be a list of shapes, got " + described(state, -1));
  std::vector<ShapeValue> shapes;
  const lua_Unsigned count = lua_rawlen(state, -1);
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(state, -1, static_cast<lua_Integer>(i));
    const ShapeValue* shape = to_shape(state, -1);
    if (shape == nullptr) fields.refuse("shapes", "must be a list of shapes, got " + described(state, -1) + " in it");
    charge_for_making(state);
    shapes.push_back(taken(state, *shape));
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  if (shapes.empty()) fields.refuse("shapes", "must hold at least one shape");
  return shapes;
}

std::optional<std::vector<ShapeValue>> read_shapes(const Fields& fields) {
  lua_State* state = fields.state();
  if (fields.has("shape") && fields.has("shapes")) fields.refuse("shape", "and shapes cannot both be set");
  if (fields.has("shapes")) return read_shape_list(fields);
  if (!fields.push("shape")) return std::nullopt;
  const ShapeValue* shape = to_shape(state, -1);
  if (shape == nullptr) {
    fields.refuse("shape", "must be a shape such as circle{radius=1}, got " + described(state, -1));
  }
  lua_pop(state, 1);
  return std::vector<ShapeValue>{taken(state, *shape)};
}

void read_motion(const Fields& fields, ChangeBody& change) {
  change.type = read_type(fields);
  change.position = fields.vector("at");
  change.angle = fields.number("angle");
  change.velocity = fields.vector("velocity");
  change.spin = fields.number("spin");
  change.gravity_scale = fields.number("gravity_scale");
  change.fixed_rotation = fields.boolean("fixed_rotation");
}

void read_matter(const Fields& fields, ChangeBody& change) {
  change.mass = fields.number("mass", Range::positive);
  change.inertia = fields.number("inertia", Range::positive);
  change.density = fields.number("density", Range::positive);
  change.friction = read_friction(fields);
  change.restitution = read_restitution(fields);
  change.rolling_resistance = fields.number("rolling_resistance", Range::not_negative);
  change.surface_speed = fields.number("surface_speed");
  change.bullet = fields.boolean("bullet");
  change.sensor = fields.boolean("sensor");
  change.drag = read_drag(fields);
  change.color = read_color(fields);
}

template <typename Value>
void put(Value& target, const std::optional<Value>& value) {
  if (value) target = *value;
}

void check_shapes(const BodyRecord& record, const std::vector<ShapeValue>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].problem.empty()) continue;
    const std::string which = shapes.size() > 1 ? "shape " + std::to_string(i + 1) + ": " : "";
    throw Problem("body " + quote(record.def.name) + ": " + which + shapes[i].problem);
  }
}

BodyId create_body(Model& model, BodyRecord record) {
  const auto id = static_cast<BodyId>(model.bodies.size() + 1);
  model.warn_of_omissions(called_for_by(record.def));
  if (model.simulation != nullptr) model.apply(CreateBody{record.def});
  model.scenario.body_names.push_back(record.def.name);
  model.bodies.push_back(std::move(record));
  if (model.simulation != nullptr) model.check_method();
  model.touch();
  return id;
}

int make_body(lua_State* state, BodyRecord record, const std::string& word) {
  Model& model = model_of(state);
  model.must_act(word);
  charge_for_making(state);
  if (model.bodies.size() >= most_bodies) {
    throw Problem("a scene holds at most " + std::to_string(most_bodies) + " bodies");
  }
  const BodyKeys keys = read_body_keys(state, 1, word);
  apply_keys(record, keys);
  check_body(record.def);
  if (record.def.shapes.empty() && record.def.type != BodyType::dynamic) {
    throw Problem("body " + quote(record.def.name) + ": it needs a shape, such as shape = circle{radius=1}");
  }
  push_body(state, create_body(model, std::move(record)));
  return 1;
}

int body(lua_State* state) {
  BodyRecord record;
  record.def.name = "body " + std::to_string(model_of(state).bodies.size() + 1);
  return make_body(state, std::move(record), "body");
}

/// Keys that make sense for the shorthands besides their own.
BodyRecord shorthand(const Fields& fields, const char* name, ShapeValue shape) {
  BodyRecord record;
  record.def.name = fields.text("name").value_or(name);
  record.def.type = BodyType::fixed;
  record.def.color = read_color(fields);
  put(record.material.friction, read_friction(fields));
  put(record.material.restitution, read_restitution(fields));
  put(record.material.rolling_resistance, fields.number("rolling_resistance", Range::not_negative));
  put(record.material.surface_speed, fields.number("surface_speed"));
  record.def.shapes = shape.on_body(record.material);
  return record;
}

int finish_shorthand(lua_State* state, const BodyRecord& record, const char* word) {
  Model& model = model_of(state);
  model.must_act(word);
  charge_for_making(state);
  check_body(record.def);
  push_body(state, create_body(model, record));
  return 1;
}

/// A slab wide and deep enough to fill every picture; its upper side is at y.
int ground(lua_State* state) {
  static constexpr Name keys[] = {
      {"y"}, {"name"}, {"friction"}, {"restitution"}, {"rolling_resistance"}, {"surface_speed"}, {"color"}};
  constexpr double half_width = 1000;
  constexpr double depth = 100;
  const Fields fields(state, 1, "ground", keys);
  const double y = fields.number("y").value_or(0);
  ShapeValue slab;
  slab.parts = {{{-half_width, -depth}, {half_width, -depth}, {half_width, 0}, {-half_width, 0}}};
  BodyRecord record = shorthand(fields, "ground", slab);
  record.def.position = {0, y};
  return finish_shorthand(state, record, "ground");
}

int wall(lua_State* state) {
  static constexpr Name keys[] = {
      {"a"}, {"b"}, {"name"}, {"friction"}, {"restitution"}, {"rolling_resistance"}, {"surface_speed"}, {"color"}};
  const Fields fields(state, 1, "wall", keys);
  ShapeValue line;
  line.parts = {{fields.required("a", fields.vector("a")), fields.required("b", fields.vector("b"))}};
  return finish_shorthand(state, shorthand(fields, "wall", line), "wall");
}

}  // namespace

BodyKeys read_body_keys(lua_State* state, int index, const std::string& word) {
  const Fields fields(state, index, word, body_keys);
  BodyKeys keys;
  keys.name = fields.text("name");
  read_motion(fields, keys.change);
  read_matter(fields, keys.change);
  keys.shapes = read_shapes(fields);
  if (const auto group = fields.integer("group", INT32_MIN, INT32_MAX)) keys.group = static_cast<std::int32_t>(*group);
  keys.category = read_bits(fields, "category");
  keys.mask = read_bits(fields, "mask");
  return keys;
}

void apply_keys(BodyRecord& record, const BodyKeys& keys) {
  BodyDef& def = record.def;
  const ChangeBody& change = keys.change;
  put(def.name, keys.name);
  put(def.type, change.type);
  put(def.position, change.position);
  put(def.angle, change.angle);
  put(def.velocity, change.velocity);
  put(def.spin, change.spin);
  put(def.gravity_scale, change.gravity_scale);
  put(def.fixed_rotation, change.fixed_rotation);
  put(def.bullet, change.bullet);
  put(def.sensor, change.sensor);
  put(def.filter.group, keys.group);
  put(def.filter.category, keys.category);
  put(def.filter.mask, keys.mask);
  if (change.mass) def.mass = change.mass;
  if (change.inertia) def.inertia = change.inertia;
  if (change.drag) def.drag = change.drag;
  if (change.color) def.color = change.color;
  put(record.material.density, change.density);
  put(record.material.friction, change.friction);
  put(record.material.restitution, change.restitution);
  put(record.material.rolling_resistance, change.rolling_resistance);
  put(record.material.surface_speed, change.surface_speed);
  for (ShapeDef& shape : def.shapes) {
    put(shape.density, change.density);
    put(shape.friction, change.friction);
    put(shape.restitution, change.restitution);
    put(shape.rolling_resistance, change.rolling_resistance);
    put(shape.surface_speed, change.surface_speed);
  }
  if (!keys.shapes) return;
  check_shapes(record, *keys.shapes);
  def.shapes.clear();
  for (const ShapeValue& value : *keys.shapes) {
    for (ShapeDef& shape : value.on_body(record.material)) def.shapes.push_back(std::move(shape));
  }
}

void check_body(const BodyDef& def) {
  if (const auto problem = problem_with(def)) throw Problem("body " + quote(def.name) + ": " + *problem);
}

void open_bodies(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<body>(state, "body");
  set_word<ground>(state, "ground");
  set_word<wall>(state, "wall");
  push_body(state, BodyId::world);
  lua_setfield(state, -2, "world");
  lua_pop(state, 1);
}

}  // namespace proofreel
