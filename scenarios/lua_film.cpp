// What happens in the film and not in the scene: slow motion, freezes, sections, other layers.

#include <algorithm>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_picture.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr double longest_freeze = 3600;  // s

/// The film's course is fixed before it begins.
Model& film_model(lua_State* state, const char* word) {
  Model& model = drawing_model(state, word);
  model.must_load(word);
  return model;
}

double required_time(const Fields& fields, const char* key) {
  return fields.required(key, fields.number(key, Range::not_negative));
}

int slow(lua_State* state) {
  static constexpr Name keys[] = {{"from"}, {"to"}, {"factor"}};
  const Fields fields(state, 1, "slow", keys);
  Model& model = film_model(state, "slow");
  SlowMotion motion{required_time(fields, "from"), required_time(fields, "to"),
                    fields.required("factor", fields.number("factor", Range::positive))};
  if (motion.to <= motion.from) fields.refuse("to", "must come after from");
  if (motion.factor > 1)
    fields.refuse("factor", "must not be larger than 1: 0.25 makes everything last four times as long");
  for (const SlowMotion& other : model.scenario.picture.slow) {
    if (motion.from < other.to && other.from < motion.to) throw Problem("slow: two stretches of slow motion overlap");
  }
  model.scenario.picture.slow.push_back(motion);
  return 0;
}

int freeze(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"seconds"}};
  const Fields fields(state, 1, "freeze", keys);
  Model& model = film_model(state, "freeze");
  const Freeze freeze{required_time(fields, "at"),
                      fields.required("seconds", fields.number("seconds", Range::positive))};
  if (freeze.seconds > longest_freeze) fields.refuse("seconds", "must not be larger than 3600");
  model.scenario.picture.freezes.push_back(freeze);
  return 0;
}

int section(lua_State* state) {
  static constexpr Name keys[] = {{"at"}, {"name"}};
  const Fields fields(state, 1, "section", keys);
  Model& model = film_model(state, "section");
  const Section section{required_time(fields, "at"), fields.required("name", fields.text("name"))};
  std::vector<Section>& sections = model.scenario.picture.sections;
  if (section.name.empty()) fields.refuse("name", "must not be empty");
  if (!sections.empty() && section.at <= sections.back().at)
    fields.refuse("at", "must come after that of the section before, " + quote(sections.back().name));
  sections.push_back(section);
  return 0;
}

int layers(lua_State* state) {
  static constexpr Name keys[] = {{"at"}};
  const Fields fields(state, 1, "layers", keys, layer_count);
  Model& model = film_model(state, "layers");
  std::vector<LayerChange>& changes = model.scenario.picture.layer_changes;
  const double at = required_time(fields, "at");
  if (!changes.empty() && at <= changes.back().at)
    fields.refuse("at", "must come after that of the layers{...} before");
  lua_settop(state, 1);
  changes.push_back({at, read_layers(state, [](const std::string& what) { throw Problem("layers " + what); })});
  return 0;
}

std::vector<std::string> all_layer_names() {
  std::vector<std::string> names;
  for (int i = 0; i < layer_count; ++i) names.emplace_back(name_of(static_cast<Layer>(i)));
  return names;
}

}  // namespace

std::vector<std::string> read_names(lua_State* state, const RefuseList& refuse) {
  if (lua_type(state, -1) != LUA_TTABLE) refuse("must be a list of names, got " + described(state, -1));
  std::vector<std::string> names;
  const lua_Unsigned count = lua_rawlen(state, -1);
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(state, -1, static_cast<lua_Integer>(i));
    if (lua_type(state, -1) != LUA_TSTRING) refuse("must be a list of names, got " + described(state, -1) + " in it");
    charge_for_making(state);
    names.emplace_back(lua_tostring(state, -1));
    lua_pop(state, 1);
  }
  return names;
}

std::vector<Layer> read_layers(lua_State* state, const RefuseList& refuse) {
  // Whoever marks a body with a trail, a vector or a label wants to see it, without naming it here again.
  std::vector<Layer> layers{Layer::trails, Layer::vectors, Layer::labels};
  for (const std::string& name : read_names(state, refuse)) {
    const auto layer = layer_named(name);
    if (!layer) refuse("cannot hold " + quote(name) + "; there are " + quoted_list(all_layer_names()));
    if (std::find(layers.begin(), layers.end(), *layer) == layers.end()) layers.push_back(*layer);
  }
  return layers;
}

void open_film(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<slow>(state, "slow");
  set_word<freeze>(state, "freeze");
  set_word<section>(state, "section");
  set_word<layers>(state, "layers");
  lua_pop(state, 1);
}

}  // namespace proofreel
