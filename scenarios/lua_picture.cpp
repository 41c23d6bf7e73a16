#include <algorithm>
#include <limits>

#include "scenarios/formula.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double longest_memory = 1e6;   // s of a trail or plot
constexpr double longest_freeze = 3600;  // s

constexpr Name corner_names[] = {{"top_left"}, {"top"}, {"top_right"}, {"bottom_left"}, {"bottom"}, {"bottom_right"}};
constexpr Name vector_names[] = {{"velocity"}, {"force"}, {"momentum"}, {"acceleration"}, {"contact_impulse"}};

Corner read_corner(const Fields& fields, Corner usual) {
  const auto index = fields.choice("at", corner_names);
  return index ? static_cast<Corner>(*index) : usual;
}

Model& drawing_model(lua_State* state, const char* word) {
  Model& model = model_of(state);
  model.must_act(word);
  charge_for_making(state);
  return model;
}

BodyId read_body(const Fields& fields, const char* key) {
  if (!fields.push(key)) fields.missing(key);
  const BodyId body = own_body(fields.state(), -1, fields.word() + ": " + key);
  lua_pop(fields.state(), 1);
  return body;
}

double read_seconds(const Fields& fields, double usual) {
  const double seconds = fields.number("seconds", Range::positive).value_or(usual);
  if (seconds > longest_memory) fields.refuse("seconds", "must not be larger than 1e6");
  return seconds;
}

int camera(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"over"}, {"center"}, {"height"}, {"follow"}};
  const Fields fields(state, 1, "camera", keys);
  Model& model = drawing_model(state, "camera");
  CameraMove move;
  move.at = fields.number("at", Range::not_negative).value_or(model.time());
  move.over = fields.number("over", Range::not_negative).value_or(0);
  move.center = fields.vector("center");
  move.height = fields.number("height", Range::positive);
  if (fields.has("follow")) move.follow = read_body(fields, "follow");
  if (move.center && move.follow) fields.refuse("follow", "and center cannot both be set");
  if (!move.center && !move.follow && !move.height) throw Problem("camera needs follow=, center= or height=");
  model.scenario.picture.camera.push_back(move);
  return 0;
}

int caption(lua_State* state) {
  static constexpr Name keys[] = {{"text"}, {"from"}, {"to"}, {"at"}};
  const Fields fields(state, 1, "caption", keys);
  Model& model = drawing_model(state, "caption");
  Caption caption;
  caption.text = fields.required("text", fields.text("text"));
  const auto parsed = parse_formulas(caption.text);
  if (const auto* problem = std::get_if<std::string>(&parsed)) fields.refuse("text", *problem);
  caption.from = fields.number("from", Range::not_negative).value_or(model.time());
  caption.to = fields.number("to", Range::not_negative).value_or(forever);
  if (caption.to <= caption.from) fields.refuse("to", "must come after from");
  caption.at = read_corner(fields, Corner::bottom);
  model.scenario.picture.captions.push_back(caption);
  return 0;
}

int label(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"text"}};
  const Fields fields(state, 1, "label", keys);
  Model& model = drawing_model(state, "label");
  const BodyId body = read_body(fields, "body");
  model.scenario.picture.labels.push_back({body, fields.required("text", fields.text("text"))});
  return 0;
}

int vector(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"of"}, {"scale"}};
  const Fields fields(state, 1, "vector", keys);
  Model& model = drawing_model(state, "vector");
  const BodyId body = read_body(fields, "body");
  const auto of = static_cast<VectorOf>(fields.required("of", fields.choice("of", vector_names)));
  model.scenario.picture.vectors.push_back({body, of, fields.number("scale", Range::positive).value_or(1)});
  return 0;
}

int trail(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"seconds"}};
  const Fields fields(state, 1, "trail", keys);
  Model& model = drawing_model(state, "trail");
  const BodyId body = read_body(fields, "body");
  model.scenario.picture.trails.push_back({body, read_seconds(fields, 1)});
  return 0;
}

/// The names in the table on top of the stack, sorted; all its values must be functions.
std::vector<std::string> curve_names(const Fields& fields) {
  lua_State* state = fields.state();
  if (lua_type(state, -1) != LUA_TTABLE) fields.refuse("y", "must be a table {name = function() ... end, ...}");
  std::vector<std::string> names;
  for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) != LUA_TSTRING || lua_type(state, -1) != LUA_TFUNCTION) {
      fields.refuse("y", "must be a table {name = function() ... end, ...}");
    }
    charge_for_making(state);
    names.push_back(text_to_show(state, -2, "plot: the name of a curve"));
  }
  if (names.empty()) fields.refuse("y", "must hold at least one curve");
  std::sort(names.begin(), names.end());
  return names;
}

int plot(lua_State* state) {
  static constexpr Name keys[] = {{"title"}, {"y"}, {"seconds"}, {"at"}};
  const Fields fields(state, 1, "plot", keys);
  Model& model = drawing_model(state, "plot");
  PlotMark plot;
  plot.title = fields.text("title").value_or("");
  plot.seconds = read_seconds(fields, 10);
  plot.at = read_corner(fields, Corner::top_right);
  if (!fields.push("y")) fields.missing("y");
  plot.curves = curve_names(fields);
  std::vector<int> functions;
  for (const std::string& name : plot.curves) {
    lua_getfield(state, -1, name.c_str());
    functions.push_back(keep_function(state, -1, "plot: y." + name));
    lua_pop(state, 1);
  }
  model.plots.push_back(std::move(functions));
  model.scenario.picture.plots.push_back(std::move(plot));
  return 0;
}

int slow(lua_State* state) {
  static constexpr Name keys[] = {{"from"}, {"to"}, {"factor"}};
  const Fields fields(state, 1, "slow", keys);
  Model& model = drawing_model(state, "slow");
  model.must_load("slow");
  SlowMotion motion;
  motion.from = fields.required("from", fields.number("from", Range::not_negative));
  motion.to = fields.required("to", fields.number("to", Range::not_negative));
  motion.factor = fields.required("factor", fields.number("factor", Range::positive));
  if (motion.to <= motion.from) fields.refuse("to", "must come after from");
  if (motion.factor > 1)
    fields.refuse("factor", "must not be larger than 1: 0.25 makes everything last four times as long");
  for (const SlowMotion& other : model.scenario.picture.slow) {
    if (motion.from < other.to && other.from < motion.to) throw Problem("slow: two stretches of slow motion overlap");
  }
  model.scenario.picture.slow.push_back(motion);
  return 0;
}

int ghost(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"every"}};
  const Fields fields(state, 1, "ghost", keys);
  Model& model = drawing_model(state, "ghost");
  const BodyId body = read_body(fields, "body");
  model.scenario.picture.ghosts.push_back({body, fields.required("every", fields.number("every", Range::positive))});
  return 0;
}

int freeze(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"seconds"}};
  const Fields fields(state, 1, "freeze", keys);
  Model& model = drawing_model(state, "freeze");
  model.must_load("freeze");
  Freeze freeze;
  freeze.at = fields.required("at", fields.number("at", Range::not_negative));
  freeze.seconds = fields.required("seconds", fields.number("seconds", Range::positive));
  if (freeze.seconds > longest_freeze) fields.refuse("seconds", "must not be larger than 3600");
  model.scenario.picture.freezes.push_back(freeze);
  return 0;
}

int section(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"name"}};
  const Fields fields(state, 1, "section", keys);
  Model& model = drawing_model(state, "section");
  model.must_load("section");
  const Section section{fields.required("at", fields.number("at", Range::not_negative)),
                        fields.required("name", fields.text("name"))};
  std::vector<Section>& sections = model.scenario.picture.sections;
  if (section.name.empty()) fields.refuse("name", "must not be empty");
  if (!sections.empty() && section.at <= sections.back().at)
    fields.refuse("at", "must come after that of the section before, " + quote(sections.back().name));
  sections.push_back(section);
  return 0;
}

}  // namespace

void open_picture(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<camera>(state, "camera");
  set_word<caption>(state, "caption");
  set_word<label>(state, "label");
  set_word<vector>(state, "vector");
  set_word<trail>(state, "trail");
  set_word<plot>(state, "plot");
  set_word<slow>(state, "slow");
  set_word<ghost>(state, "ghost");
  set_word<freeze>(state, "freeze");
  set_word<section>(state, "section");
  lua_pop(state, 1);
}

}  // namespace proofreel
