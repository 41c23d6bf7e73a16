// The word `scenario`, and what the command line sets in its stead.

#include <algorithm>
#include <cmath>

#include "scenarios/effects.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_picture.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

constexpr int largest_side = 16384;            // px
constexpr std::int64_t most_pixels = 1 << 26;  // 256 MB of RGBA

constexpr Name scenario_keys[] = {{"title"},   {"description"}, {"duration"}, {"rate"},   {"fps"},
                                  {"seed"},    {"gravity"},     {"view"},     {"size"},   {"theme"},
                                  {"effects"}, {"layers"},      {"method"},   {"golden"}, {"force_scale"}};
constexpr Name view_keys[] = {{"center"}, {"height"}};
constexpr Name method_keys[] = {{"integrator"}, {"contact_solver"}, {"joint_solver"}, {"substeps"},
                                {"iterations"}, {"contact_hz"},     {"precision"}};
constexpr Name golden_keys[] = {{"frames"}, {"size"}};
constexpr Name theme_names[] = {{"light"}, {"dark"}, {"print"}};
constexpr Name integrator_names[] = {{"symplectic_euler"},  {"verlet"},         {"suzuki4"}, {"rk4"},
                                     {"implicit_midpoint"}, {"gauss_legendre6"}};
constexpr Name contact_solver_names[] = {{"auto"}, {"soft_step"}, {"sequential_impulses"},
                                         {"ngs"},  {"exact"},     {"event"}};
constexpr Name joint_solver_names[] = {{"direct"}, {"iterative"}};
constexpr Name precision_names[] = {{"single"}, {"double"}};
constexpr Name effect_names[] = {{"gravity"},       {"springs"}, {"contacts"},  {"friction"},
                                 {"restitution"},   {"ccd"},     {"joints"},    {"sensors"},
                                 {"drag"},          {"wind"},    {"attractor"}, {"nbody"},
                                 {"buoyancy"},      {"field"},   {"rocket"},    {"rolling_resistance"},
                                 {"surface_speed"}, {"limits"},  {"motors"},    {"breakage"},
                                 {"sleeping"}};

void push_item(lua_State* state, const OverrideItem& item) {
  if (const auto* flag = std::get_if<bool>(&item)) {
    lua_pushboolean(state, *flag ? 1 : 0);
  } else if (const auto* integer = std::get_if<std::int64_t>(&item)) {
    lua_pushinteger(state, *integer);
  } else if (const auto* number = std::get_if<double>(&item)) {
    lua_pushnumber(state, *number);
  } else {
    lua_pushstring(state, std::get<std::string>(item).c_str());
  }
}

void push_value(lua_State* state, const ParsedOverride& value) {
  if (!value.is_list) return push_item(state, value.items.front());
  lua_newtable(state);
  lua_Integer place = 0;
  for (const OverrideItem& item : value.items) {
    push_item(state, item);
    lua_rawseti(state, -2, ++place);
  }
}

/// Pushes a copy of the table at `index`; an empty table for anything else.
void push_copy(lua_State* state, int index) {
  index = lua_absindex(state, index);
  lua_newtable(state);
  if (lua_type(state, index) != LUA_TTABLE) return;
  for (lua_pushnil(state); lua_next(state, index) != 0;) {
    lua_pushvalue(state, -2);
    lua_insert(state, -2);
    lua_rawset(state, -4);
  }
}

/// Sets the key in the table on top of the stack; one with a dot in a copy of the table it names.
void set_override(lua_State* state, const ParsedOverride& value) {
  const std::size_t dot = value.path.find('.');
  if (dot == std::string::npos) {
    push_value(state, value);
    lua_setfield(state, -2, value.path.c_str());
    return;
  }
  const std::string outer = value.path.substr(0, dot);
  lua_getfield(state, -1, outer.c_str());
  push_copy(state, -1);
  lua_remove(state, -2);
  push_value(state, value);
  lua_setfield(state, -2, value.path.c_str() + dot + 1);
  lua_setfield(state, -2, outer.c_str());
}

Size checked_size(const Fields& fields, double width, double height) {
  const bool whole = width == std::floor(width) && height == std::floor(height);
  const bool sane = width >= 1 && height >= 1 && width <= largest_side && height <= largest_side;
  if (!whole || !sane) {
    fields.refuse("size", "must be two whole numbers between 1 and " + std::to_string(largest_side) + " (pixels)");
  }
  const Size size{static_cast<int>(width), static_cast<int>(height)};
  if (std::int64_t{size.width_px} * size.height_px > most_pixels) {
    fields.refuse("size", "is too large: at most " + std::to_string(most_pixels) + " pixels in all");
  }
  return size;
}

/// {width, height}, or "1280x720" as the command line has it.
std::optional<Size> read_size(const Fields& fields) {
  lua_State* state = fields.state();
  if (!fields.push("size")) return std::nullopt;
  if (lua_type(state, -1) == LUA_TSTRING) {
    const std::string text = lua_tostring(state, -1);
    const std::size_t x = std::min(text.find('x'), text.size());
    lua_pushstring(state, text.substr(0, x).c_str());
    lua_pushstring(state, text.substr(std::min(x + 1, text.size())).c_str());
    const Size size = checked_size(fields, lua_tonumber(state, -2), lua_tonumber(state, -1));
    lua_pop(state, 3);
    return size;
  }
  lua_pop(state, 1);
  const Vec2d size = *fields.vector("size");
  return checked_size(fields, size.x, size.y);
}

/// "auto" or a list.
std::optional<EffectSet> read_effects(const Fields& fields) {
  if (!fields.push("effects")) return std::nullopt;
  const bool is_text = lua_type(fields.state(), -1) == LUA_TSTRING;
  const auto refuse = [&](const std::string& what) { fields.refuse("effects", what); };
  const auto listed = is_text ? std::vector<std::string>{} : read_names(fields.state(), refuse);
  lua_pop(fields.state(), 1);
  if (is_text) {
    if (*fields.text("effects") != "auto") fields.refuse("effects", "must be \"auto\" or a list of names");
    return std::nullopt;
  }
  EffectSet set;
  for (const std::string& name : listed) {
    const auto* known =
        std::find_if(std::begin(effect_names), std::end(effect_names), [&](const Name& n) { return n.text == name; });
    if (known == std::end(effect_names)) {
      std::vector<std::string> names;
      for (const Name& n : effect_names) names.emplace_back(n.text);
      fields.refuse("effects", "cannot hold " + quote(name) + ", " + did_you_mean(name, names));
    }
    set.add(effect_named(name).value());
  }
  return set;
}

template <typename Value>
void put(Value& target, const std::optional<Value>& value) {
  if (value) target = *value;
}

/// Reads a table inside the table of `scenario{}`.
template <typename Read>
void read_part(const Fields& fields, const char* key, std::span<const Name> keys, const Model& model, Read read) {
  if (!fields.push(key)) return;
  if (lua_type(fields.state(), -1) != LUA_TTABLE) {
    fields.refuse(key, "must be a table, got " + described(fields.state(), -1));
  }
  read(Fields(fields.state(), -1, std::string("scenario: ") + key, keys, std::string(key) + ".", &model.overrides));
  lua_pop(fields.state(), 1);
}

void read_method(const Fields& fields, Method& method) {
  constexpr int most = 10000;
  if (const auto index = fields.choice("integrator", integrator_names))
    method.integrator = static_cast<Integrator>(*index);
  if (const auto index = fields.choice("contact_solver", contact_solver_names))
    method.contact_solver = static_cast<ContactMethod>(*index);
  if (const auto index = fields.choice("joint_solver", joint_solver_names))
    method.joint_solver = static_cast<JointMethod>(*index);
  if (const auto index = fields.choice("precision", precision_names)) method.precision = static_cast<Precision>(*index);
  method.substeps = static_cast<int>(fields.integer("substeps", 1, most).value_or(method.substeps));
  if (const auto count = fields.integer("iterations", 1, most)) method.iterations = static_cast<int>(*count);
  method.contact_hz = fields.number("contact_hz", Range::positive);
}

GoldenFrames read_golden(const Fields& fields) {
  lua_State* state = fields.state();
  GoldenFrames golden;
  put(golden.size, read_size(fields));
  if (!fields.push("frames")) fields.missing("frames");
  if (lua_type(state, -1) != LUA_TTABLE) fields.refuse("frames", "must be a list of frame numbers");
  const lua_Unsigned count = lua_rawlen(state, -1);
  for (lua_Unsigned i = 1; i <= count; ++i) {
    int is_integer = 0;
    lua_rawgeti(state, -1, static_cast<lua_Integer>(i));
    const lua_Integer frame = lua_tointegerx(state, -1, &is_integer);
    if (is_integer == 0 || frame < 0)
      fields.refuse("frames", "must be a list of frame numbers, got " + described(state, -1));
    charge_for_making(state);
    golden.frames.push_back(frame);
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  std::sort(golden.frames.begin(), golden.frames.end());
  golden.frames.erase(std::unique(golden.frames.begin(), golden.frames.end()), golden.frames.end());
  return golden;
}

void read_time(const Fields& fields, Scenario& scenario) {
  constexpr int fastest_rate = 1'000'000;
  constexpr int most_fps = 1000;
  scenario.duration = fields.number("duration", Range::positive).value_or(scenario.duration);
  scenario.scene.rate = static_cast<int>(fields.integer("rate", 1, fastest_rate).value_or(scenario.scene.rate));
  scenario.picture.fps = static_cast<int>(fields.integer("fps", 1, most_fps).value_or(scenario.picture.fps));
  const double ticks = scenario.duration * scenario.scene.rate;
  if (ticks > most_ticks) fields.refuse("duration", "times rate must not exceed 100 million ticks");
  if (ticks < 0.5) fields.refuse("duration", "is shorter than a tick");
}

/// m/s^2. Far beyond it a body leaves the coordinates that can be computed with within a second.
constexpr double strongest_gravity = 1e6;

void read_scenario(const Fields& fields, Model& model) {
  Scenario& scenario = model.scenario;
  Picture& picture = scenario.picture;
  put(scenario.title, fields.text("title"));
  put(scenario.description, fields.text("description"));
  read_time(fields, scenario);
  model.timed = fields.has("duration");
  if (const auto seed = fields.integer("seed", INT64_MIN, INT64_MAX)) scenario.seed = static_cast<std::uint64_t>(*seed);
  put(scenario.scene.gravity, fields.vector("gravity"));
  if (length(scenario.scene.gravity) > strongest_gravity) fields.refuse("gravity", "must stay below 1e6 m/s^2");
  put(picture.size, read_size(fields));
  picture.view.made_for = picture.size;
  if (const auto index = fields.choice("theme", theme_names)) picture.theme = static_cast<Theme>(*index);
  if (fields.push("layers")) {
    picture.layers = read_layers(fields.state(), [&](const std::string& what) { fields.refuse("layers", what); });
    lua_pop(fields.state(), 1);
  }
  put(picture.force_scale, fields.number("force_scale", Range::positive));
  scenario.scene.effects = read_effects(fields);
  read_part(fields, "view", view_keys, model, [&](const Fields& view) {
    put(picture.view.center, view.vector("center"));
    put(picture.view.height, view.number("height", Range::positive));
  });
  read_part(fields, "method", method_keys, model,
            [&](const Fields& method) { read_method(method, scenario.scene.method); });
  read_part(fields, "golden", golden_keys, model, [&](const Fields& golden) { scenario.golden = read_golden(golden); });
}

int scenario(lua_State* state) {
  Model& model = model_of(state);
  model.must_load("scenario");
  if (model.described) throw Problem("scenario{...} was called already");
  if (lua_type(state, 1) != LUA_TTABLE)
    throw Problem("scenario needs a table, scenario{...}, got " + described(state, 1));
  push_copy(state, 1);
  for (const ParsedOverride& value : model.overrides) set_override(state, value);
  read_scenario(Fields(state, -1, "scenario", scenario_keys, "", &model.overrides), model);
  model.random = Random(model.scenario.seed);
  model.described = true;
  return 0;
}

}  // namespace

void open_scenario(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<scenario>(state, "scenario");
  lua_pop(state, 1);
}

}  // namespace proofreel
