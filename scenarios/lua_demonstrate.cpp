// The word `demonstrate`: an algorithm of the engine as a lecture film.

#include <cmath>

#include "scenarios/demonstrations/reading.h"
#include "scenarios/lua_fields.h"
#include "scenarios/lua_model.h"
#include "scenarios/lua_shapes.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr double slowest_pace = 60;        // s per step
constexpr lua_Unsigned most_items = 1000;  // far more than any algorithm takes
constexpr double farthest = 1e9;           // m, as everywhere

/// How many values the table on top of the stack holds, whatever their keys.
lua_Unsigned count_all(lua_State* state) {
  lua_Unsigned count = 0;
  for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) ++count;
  return count;
}

/// Calls read(place) for every item of the list at `key`, the item being on top of the stack.
template <typename Read>
void read_list(const Fields& fields, const char* key, const char* items, Read read) {
  lua_State* state = fields.state();
  if (!fields.push(key)) return;
  if (lua_type(state, -1) != LUA_TTABLE)
    fields.refuse(key, std::string("must be a list of ") + items + ", got " + described(state, -1));
  const lua_Unsigned count = lua_rawlen(state, -1);
  if (count_all(state) != count) fields.refuse(key, std::string("must be a list of ") + items + " and nothing else");
  if (count > most_items) fields.refuse(key, "holds " + std::to_string(count) + " " + items + ": leave some out");
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(state, -1, static_cast<lua_Integer>(i));
    charge_for_making(state);
    read(i);
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
}

std::vector<Vec2d> read_points(const Fields& fields) {
  std::vector<Vec2d> points;
  read_list(fields, "points", "points {x, y}", [&](lua_Unsigned place) {
    const auto point = to_vector(fields.state(), -1);
    const std::string what = "holds " + described(fields.state(), -1) + " in place " + std::to_string(place);
    if (!point) fields.refuse("points", "must be a list of points {x, y}, but " + what);
    if (!is_finite(*point) || std::max(std::abs(point->x), std::abs(point->y)) > farthest)
      fields.refuse("points", "must lie within 1e9 m of the origin, but point " + std::to_string(place) + " does not");
    points.push_back(*point);
  });
  return points;
}

std::vector<DemonstrationShape> read_shapes(const Fields& fields) {
  std::vector<DemonstrationShape> shapes;
  read_list(fields, "shapes", "shapes", [&](lua_Unsigned place) {
    const ShapeValue* shape = to_shape(fields.state(), -1);
    if (shape == nullptr) {
      fields.refuse("shapes", "must be a list of shapes such as box{...}, but holds " + described(fields.state(), -1) +
                                  " in place " + std::to_string(place));
    }
    if (!shape->problem.empty())
      fields.refuse("shapes",
                    "holds a shape in place " + std::to_string(place) + " that cannot be used: " + shape->problem);
    shapes.push_back(
        {shape->parts, shape->radius, shape->density.value_or(1), shape->friction.value_or(FrictionDef{})});
  });
  return shapes;
}

Algorithm read_algorithm(const Fields& fields) {
  const std::string name = fields.required("algorithm", fields.text("algorithm"));
  const auto algorithm = algorithm_named(name);
  if (!algorithm) fields.refuse("algorithm", "cannot be " + quote(name) + ", " + did_you_mean(name, algorithm_names()));
  return *algorithm;
}

/// Asked for by any of its keys.
std::optional<Placing> read_placing(const Fields& fields) {
  if (!fields.has("scale") && !fields.has("angle") && !fields.has("at")) return std::nullopt;
  const Placing untouched;
  return Placing{fields.vector("scale").value_or(untouched.scale), fields.number("angle").value_or(untouched.angle),
                 fields.vector("at", Range::place).value_or(untouched.at)};
}

/// What a story takes of the memory.
void charge_for(lua_State* state, const Story& story) {
  constexpr std::uint64_t cost = 400;
  std::uint64_t marks = 0;
  for (const Step& step : story.steps) marks += step.marks.size();
  sandbox_of(state).charge(cost * marks);
}

int demonstrate(lua_State* state) {
  static constexpr Name keys[] = {{"algorithm"}, {"points"}, {"shapes"}, {"pace"}, {"scale"}, {"angle"}, {"at"}};
  const Fields fields(state, 1, "demonstrate", keys);
  Model& model = model_of(state);
  model.must_load("demonstrate");
  Demonstration asked;
  asked.algorithm = read_algorithm(fields);
  asked.points = read_points(fields);
  asked.shapes = read_shapes(fields);
  asked.pace = fields.number("pace", Range::positive).value_or(usual_pace(asked.algorithm));
  asked.placing = read_placing(fields);
  if (asked.pace > slowest_pace) fields.refuse("pace", "must not be larger than 60: it is the seconds a step is shown");
  if (const auto problem = problem_with(asked)) throw Problem("demonstrate: " + *problem);
  if (!model.bodies.empty())
    throw Problem("demonstrate{...} films an algorithm: a scenario that has one has no bodies");
  Story story = story_of(asked);
  give_time_to_read(story, model.scenario.stories, asked.pace / usual_pace(asked.algorithm));
  model.scenario.stories.push_back(std::move(story));
  charge_for(state, model.scenario.stories.back());
  return 0;
}

}  // namespace

void open_demonstrate(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<demonstrate>(state, "demonstrate");
  lua_pop(state, 1);
}

}  // namespace proofreel
