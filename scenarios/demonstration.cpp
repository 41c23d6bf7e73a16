#include "scenarios/demonstration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/polygon.h"
#include "engine/state_hash.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {
namespace {

/// More would not be told apart in a picture, and make a film of hours.
constexpr std::size_t most_points = 32;
constexpr std::size_t most_boxes = 12;
constexpr std::size_t most_corners = 8;

using Check = std::optional<std::string> (*)(const Demonstration&);

/// How an algorithm is told, and what it takes.
struct Recipe {
  const char* name;
  bool takes_points;
  std::size_t fewest;
  std::size_t most;
  double pace;
  Check check;
  Story (*tell)(const Demonstration&);
};

bool is_polygon(const DemonstrationShape& shape) {
  return shape.parts.size() == 1 && shape.parts[0].size() >= 3 && shape.radius == 0;
}

bool is_circle(const DemonstrationShape& shape) { return shape.parts.size() == 1 && shape.parts[0].size() == 1; }

std::optional<std::string> check_points(const Demonstration& d) {
  if (convex_hull(d.points).size() >= 3) return std::nullopt;
  return "takes points that are not all on one line: move one off the line";
}

std::optional<std::string> check_outline(const Demonstration& d) {
  const auto cleaned = clean_polygon(d.points);
  if (const auto* problem = std::get_if<std::string>(&cleaned)) return "takes an outline, but " + *problem;
  if (std::get<0>(cleaned).size() == d.points.size()) return std::nullopt;
  return std::string(
      "takes the corners of an outline, none of them twice and none within a straight edge: leave it out");
}

std::optional<std::string> check_polygons(const Demonstration& d) {
  const auto fits = [](const auto& shape) { return is_polygon(shape) && shape.parts[0].size() <= most_corners; };
  if (std::all_of(d.shapes.begin(), d.shapes.end(), fits)) return std::nullopt;
  return "takes two convex polygons without rounding, of at most " + std::to_string(most_corners) + " corners each";
}

/// Every axis has a bar of its own.
std::optional<std::string> check_axes(const Demonstration& d) {
  constexpr std::size_t most_axes = 10;
  if (const auto problem = check_polygons(d)) return problem;
  if (d.shapes[0].parts[0].size() + d.shapes[1].parts[0].size() <= most_axes) return std::nullopt;
  return "takes two convex polygons of at most " + std::to_string(most_axes) + " corners together";
}

std::optional<std::string> check_boxes(const Demonstration& d) {
  const auto box_of = [](const DemonstrationShape& shape) {
    Aabbd box;
    for (const auto& part : shape.parts) box = merged(box, expanded(bounds_of(part), shape.radius));
    return box;
  };
  for (std::size_t i = 0; i < d.shapes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Aabbd a = box_of(d.shapes[i]), b = box_of(d.shapes[j]);
      if (a.lower == b.lower && a.upper == b.upper)
        return "takes shapes whose boxes differ, but shape " + std::to_string(j + 1) + " and shape " +
               std::to_string(i + 1) + " have the same one: move one of them";
    }
  }
  return std::nullopt;
}

std::optional<std::string> check_circle(const Demonstration& d) {
  const bool other = is_circle(d.shapes[1]) || (is_polygon(d.shapes[1]) && d.shapes[1].parts[0].size() <= most_corners);
  if (is_circle(d.shapes[0]) && other) return std::nullopt;
  return "takes a circle, and then a circle or a convex polygon without rounding of at most " +
         std::to_string(most_corners) + " corners";
}

std::optional<std::string> check_body(const Demonstration& d) {
  const DemonstrationShape& shape = d.shapes[0];
  const auto thin = [](const auto& part) { return part.size() < 3; };
  if (shape.radius == 0 && std::none_of(shape.parts.begin(), shape.parts.end(), thin)) return std::nullopt;
  return std::string("takes a polygon, convex or concave, without rounding");
}

constexpr std::array<Recipe, algorithm_count> recipes{{
    {"gift_wrapping", true, 3, most_points, 0.5, check_points, tell_gift_wrapping},
    {"separating_axes", false, 2, 2, 1.6, check_axes, tell_separating_axes},
    {"gjk_epa", false, 2, 2, 1, check_polygons, tell_gjk_epa},
    {"tree_insertion", false, 2, most_boxes, 1, check_boxes, tell_tree_insertion},
    {"tree_pairs", false, 2, most_boxes, 1.6, check_boxes, tell_tree_pairs},
    {"diagonal_test", true, 4, 4, 1, check_outline, tell_diagonal_test},
    {"edge_walk", true, 3, most_points, 1.3, check_outline, tell_edge_walk},
    {"centroid", true, 3, most_points, 1, check_outline, tell_centroid},
    {"circle_contact", false, 2, 2, 0.9, check_circle, tell_circle_contact},
    {"bounding_volumes", false, 1, 1, 1, check_body, tell_bounding_volumes},
}};

const Recipe& recipe_of(Algorithm algorithm) { return recipes[static_cast<std::size_t>(algorithm)]; }

/// "3 to 40 points", "2 shapes"
std::string amount(const Recipe& recipe) {
  const std::string range = recipe.fewest == recipe.most
                                ? std::to_string(recipe.most)
                                : std::to_string(recipe.fewest) + " to " + std::to_string(recipe.most);
  return range + (recipe.takes_points ? " points" : recipe.most == 1 ? " shape" : " shapes");
}

/// How far marks have come to their places, 0 to 1: they start and end at rest.
double eased(double part) {
  const double s = std::clamp(part, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

bool looks_like(const StoryMark& a, const StoryMark& b) {
  return a.kind == b.kind && a.role == b.role && a.pane == b.pane && a.points == b.points && a.radius == b.radius;
}

/// `mark` on its way from where it was in the step before, or while it appears.
StoryMark underway(const StoryMark& mark, const std::vector<StoryMark>& before, double part) {
  StoryMark moving = mark;
  const auto was = std::find_if(before.begin(), before.end(), [&](const StoryMark& other) {
    if (mark.key.empty()) return looks_like(mark, other);
    return mark.key == other.key && mark.kind == other.kind && mark.points.size() == other.points.size();
  });
  if (was == before.end()) {
    moving.presence = part;
    return moving;
  }
  for (std::size_t i = 0; i < mark.points.size(); ++i) moving.points[i] = lerp(was->points[i], mark.points[i], part);
  if (part < 0.5) moving.role = was->role;
  return moving;
}

/// How far the marks of a step have come `since` it began. They settle within a part of a second and then stand still;
/// steps shorter than that follow each other as one motion.
double progress(double since, double seconds) {
  constexpr double settling = 0.35;
  if (seconds < settling) return since / seconds;
  return eased(since / std::min(settling, 0.5 * seconds));
}

DemonstrationView view_of_step(const Story& story, std::size_t index, double since) {
  const Step& step = story.steps[index];
  DemonstrationView view{step.heading, step.caption, step.counters, story.panes, step.marks};
  const double part = progress(since, step.seconds);
  if (index == 0 || part >= 1) return view;
  const Step& before = story.steps[index - 1];
  for (StoryMark& mark : view.marks) mark = underway(mark, before.marks, part);
  if (part < 0.5) {  // the words change where the picture is half way
    view.heading = before.heading;
    view.caption = before.caption;
    view.counters = before.counters;
  }
  return view;
}

}  // namespace

const char* name_of(Algorithm algorithm) { return recipe_of(algorithm).name; }

double usual_pace(Algorithm algorithm) { return recipe_of(algorithm).pace; }

std::optional<Algorithm> algorithm_named(std::string_view name) {
  const auto found = std::find_if(recipes.begin(), recipes.end(), [&](const Recipe& r) { return name == r.name; });
  if (found == recipes.end()) return std::nullopt;
  return static_cast<Algorithm>(found - recipes.begin());
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) names.emplace_back(recipe.name);
  return names;
}

std::optional<std::string> problem_with(const Demonstration& d) {
  const Recipe& recipe = recipe_of(d.algorithm);
  const std::size_t given = recipe.takes_points ? d.points.size() : d.shapes.size();
  const std::size_t needless = recipe.takes_points ? d.shapes.size() : d.points.size();
  std::optional<std::string> problem;
  if (needless > 0 || given == 0) {
    problem =
        "takes " + std::string(recipe.takes_points ? "points={{x, y}, ...}" : "shapes={...}") + ", " + amount(recipe);
  } else if (given < recipe.fewest || given > recipe.most) {
    problem = "takes " + amount(recipe) + ", got " + std::to_string(given);
  } else {
    problem = recipe.check(d);
  }
  if (problem) return std::string(recipe.name) + " " + *problem;
  return std::nullopt;
}

Story story_of(const Demonstration& demonstration) {
  Story story = recipe_of(demonstration.algorithm).tell(demonstration);
  story.algorithm = demonstration.algorithm;
  return story;
}

double duration_of(const std::vector<Story>& stories) {
  double seconds = 0;
  for (const Story& story : stories) {
    for (const Step& step : story.steps) seconds += step.seconds;
  }
  return seconds;
}

DemonstrationView view_of(const std::vector<Story>& stories, double seconds) {
  const Story* last = nullptr;
  for (const Story& story : stories) {
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
      if (seconds < story.steps[i].seconds) return view_of_step(story, i, seconds);
      seconds -= story.steps[i].seconds;
    }
    last = &story;
  }
  return view_of_step(*last, last->steps.size() - 1, last->steps.back().seconds);
}

std::uint64_t hash_of(const std::vector<Story>& stories) {
  std::uint64_t chain = 0;
  for (const Story& story : stories) {
    for (const Step& step : story.steps) {
      for (const StoryMark& mark : step.marks) {
        const std::array<std::uint8_t, 2> what{static_cast<std::uint8_t>(mark.kind),
                                               static_cast<std::uint8_t>(mark.role)};
        chain = chained_hash(chain, hash_of(what.data(), what.size()));
        chain = chained_hash(chain, hash_of(mark.points.data(), mark.points.size() * sizeof(Vec2d)));
      }
    }
  }
  return chain;
}

}  // namespace proofreel
