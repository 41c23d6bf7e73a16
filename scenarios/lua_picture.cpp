#include <algorithm>
#include <limits>

#include "scenarios/formula.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_picture.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double longest_memory = 1e6;  // s of a trail or plot

constexpr Name corner_names[] = {{"top_left"}, {"top"}, {"top_right"}, {"bottom_left"}, {"bottom"}, {"bottom_right"}};
constexpr Name ease_names[] = {{"smooth"}, {"linear"}};
constexpr Name vector_names[] = {{"velocity"}, {"force"}, {"momentum"}, {"acceleration"}, {"contact_impulse"}};

Corner read_corner(const Fields& fields, Corner usual) {
  const auto index = fields.choice("at", corner_names);
  return index ? static_cast<Corner>(*index) : usual;
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
  static constexpr Name keys[] = {{"at"}, {"over"}, {"center"}, {"height"}, {"follow"}, {"ease"}};
  const Fields fields(state, 1, "camera", keys);
  Model& model = drawing_model(state, "camera");
  CameraMove move;
  move.at = fields.number("at", Range::not_negative).value_or(model.time());
  move.over = fields.number("over", Range::not_negative).value_or(0);
  move.center = fields.vector("center");
  move.height = fields.number("height", Range::positive);
  if (fields.has("follow")) move.follow = read_body(fields, "follow");
  if (const auto ease = fields.choice("ease", ease_names)) move.ease = static_cast<Ease>(*ease);
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
  caption.place = sandbox_of(state).place("text");
  model.scenario.picture.captions.push_back(std::move(caption));
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

/// Of what the arrow is: a quantity of the body by its name, or a vector that is given.
void read_quantity(const Fields& fields, VectorMark& mark) {
  if (!fields.push("of")) fields.missing("of");
  const int type = lua_type(fields.state(), -1);
  lua_pop(fields.state(), 1);
  if (type == LUA_TTABLE) {
    mark.of = VectorOf::given;
    mark.value = fields.required("of", fields.vector("of", Range::place));
  } else if (type == LUA_TSTRING) {
    mark.of = static_cast<VectorOf>(fields.required("of", fields.choice("of", vector_names)));
  } else {
    fields.refuse("of", "must be the name of a quantity, such as \"velocity\", or a vector {x, y}");
  }
}

int vector(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"of"}, {"scale"}, {"point"}, {"from"}, {"to"}};
  const Fields fields(state, 1, "vector", keys);
  Model& model = drawing_model(state, "vector");
  VectorMark mark;
  mark.body = read_body(fields, "body");
  read_quantity(fields, mark);
  mark.scale = fields.number("scale", Range::positive).value_or(1);
  mark.point = fields.vector("point", Range::place);
  mark.from = fields.number("from", Range::not_negative).value_or(0);
  mark.to = fields.number("to", Range::not_negative).value_or(forever);
  if (mark.to <= mark.from) fields.refuse("to", "must come after from");
  model.scenario.picture.vectors.push_back(mark);
  return 0;
}

int trail(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"seconds"}, {"point"}};
  const Fields fields(state, 1, "trail", keys);
  Model& model = drawing_model(state, "trail");
  const BodyId body = read_body(fields, "body");
  model.scenario.picture.trails.push_back({body, read_seconds(fields, 1), fields.vector("point", Range::place)});
  return 0;
}

/// The names in the table `key`, sorted, their functions kept in the same order; all its values must be functions.
std::vector<std::string> read_curves(const Fields& fields, const char* key, std::vector<int>& functions) {
  lua_State* state = fields.state();
  const auto refuse = [&] { fields.refuse(key, "must be a table {name = function() ... end, ...}"); };
  if (!fields.push(key)) fields.missing(key);
  if (lua_type(state, -1) != LUA_TTABLE) refuse();
  std::vector<std::string> names;
  for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) != LUA_TSTRING || lua_type(state, -1) != LUA_TFUNCTION) refuse();
    charge_for_making(state);
    names.push_back(text_to_show(state, -2, "plot: the name of a curve"));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    lua_getfield(state, -1, name.c_str());
    functions.push_back(keep_function(state, -1, std::string("plot: ") + key + "." + name));
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  return names;
}

int plot(lua_State* state) {
  static constexpr Name keys[] = {{"title"}, {"y"}, {"unit"}, {"x"}, {"x_unit"}, {"seconds"}, {"at"}};
  const Fields fields(state, 1, "plot", keys);
  Model& model = drawing_model(state, "plot");
  PlotMark plot;
  std::vector<int> functions;
  plot.title = fields.text("title").value_or("");
  plot.seconds = read_seconds(fields, 10);
  plot.at = read_corner(fields, Corner::top_right);
  plot.unit = fields.text("unit").value_or("");
  plot.x_unit = fields.text("x_unit").value_or("");
  plot.curves = read_curves(fields, "y", functions);
  if (plot.curves.empty()) fields.refuse("y", "must hold at least one curve");
  if (fields.has("x")) {
    const std::vector<std::string> names = read_curves(fields, "x", functions);
    if (names.size() != 1 || names[0].empty())
      fields.refuse("x", "must hold one quantity: x = {angle = function() ... end}");
    plot.x_name = names[0];
  } else if (fields.has("x_unit")) {
    fields.refuse("x_unit", "is the unit of x, which is not given; against time it is s");
  }
  model.plots.push_back(std::move(functions));
  model.scenario.picture.plots.push_back(std::move(plot));
  return 0;
}

int ghost(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"every"}};
  const Fields fields(state, 1, "ghost", keys);
  Model& model = drawing_model(state, "ghost");
  const BodyId body = read_body(fields, "body");
  const double every = fields.required("every", fields.number("every", Range::positive));
  const int rate = model.scenario.scene.rate;
  if (model.described && every * rate < 1 - 1e-9)
    fields.refuse("every", "must not be shorter than a tick, which takes 1/" + std::to_string(rate) + " s");
  model.scenario.picture.ghosts.push_back({body, every});
  return 0;
}

/// One thing: a body or one of its points, a joint, or a point of the world.
void read_target(const Fields& fields, Highlight& highlight) {
  const int targets = (fields.has("body") ? 1 : 0) + (fields.has("joint") ? 1 : 0) + (fields.has("at") ? 1 : 0);
  if (targets != 1) throw Problem("highlight needs one of body=, joint= and at=");
  if (fields.has("body")) highlight.body = read_body(fields, "body");
  if (fields.push("joint")) {
    highlight.joint = to_joint(fields.state(), -1);
    if (!highlight.joint || !model_of(fields.state()).exists(*highlight.joint))
      fields.refuse("joint", "must be a joint that exists, got " + described(fields.state(), -1));
    lua_pop(fields.state(), 1);
  }
  highlight.at = fields.vector("at", Range::place);
  highlight.point = fields.vector("point", Range::place);
  highlight.radius = fields.number("radius", Range::positive).value_or(0);
  if (highlight.point && !highlight.body) fields.refuse("point", "is a point of a body: give body=, or a point at=");
  if (highlight.radius > 0 && highlight.body && !highlight.point)
    fields.refuse("radius", "is that of a circle round a point: give point=, or leave it out");
}

int highlight(lua_State* state) {
  static constexpr Name keys[] = {{"body"}, {"joint"}, {"at"}, {"point"}, {"radius"}, {"from"}, {"to"}, {"text"}};
  const Fields fields(state, 1, "highlight", keys);
  Model& model = drawing_model(state, "highlight");
  Highlight highlight;
  read_target(fields, highlight);
  highlight.from = fields.number("from", Range::not_negative).value_or(model.time());
  highlight.to = fields.number("to", Range::not_negative).value_or(forever);
  if (highlight.to <= highlight.from) fields.refuse("to", "must come after from");
  highlight.text = fields.text("text").value_or("");
  model.scenario.picture.highlights.push_back(highlight);
  return 0;
}

}  // namespace

Model& drawing_model(lua_State* state, const char* word) {
  Model& model = model_of(state);
  model.must_act(word);
  charge_for_making(state);
  return model;
}

void open_picture(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<camera>(state, "camera");
  set_word<caption>(state, "caption");
  set_word<label>(state, "label");
  set_word<vector>(state, "vector");
  set_word<trail>(state, "trail");
  set_word<plot>(state, "plot");
  set_word<ghost>(state, "ghost");
  set_word<highlight>(state, "highlight");
  lua_pop(state, 1);
}

}  // namespace proofreel
