#include "scenarios/demonstration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/state_hash.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/checks.h"

namespace proofreel {
namespace {

/// More would not be told apart in a picture, and make a film of hours.
constexpr std::size_t most_points = 32;
constexpr std::size_t most_boxes = 12;
constexpr std::size_t most_vectors = 8;
constexpr std::size_t most_bodies = 6;

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
  bool takes_placing = false;
};

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
    {"dot_product", true, 3, most_vectors, 1, check_vectors, tell_dot_product},
    {"cross_product", true, 3, most_vectors, 1, check_vectors, tell_cross_product},
    {"transforms", false, 1, 1, 1, check_transform, tell_transforms, true},
    {"transform_order", false, 1, 1, 1, check_transform, tell_transform_order, true},
    {"gjk_line", false, 2, 2, 1, check_intervals, tell_gjk_line},
    {"center_of_mass", false, 2, most_bodies, 1, check_masses, tell_center_of_mass},
    {"moment_of_inertia", false, 2, most_bodies, 1, check_masses, tell_moment_of_inertia},
    {"friction_cone", false, 1, 1, 1, check_block, tell_friction_cone},
    {"sequential_impulses", false, 2, most_bodies, 1, check_stack, tell_sequential_impulses},
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
    return mark.key == other.key && mark.kind == other.kind && mark.pane == other.pane &&
           mark.points.size() == other.points.size();
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

/// A step of a story, and for how many seconds it has been shown.
struct Moment {
  const Story* story = nullptr;
  std::size_t step = 0;
  double since = 0;
};

/// What ends within a rounding error has ended: steps begin on the very tick at which their section does.
Moment moment_at(const std::vector<Story>& stories, double seconds) {
  constexpr double rounding = 1e-9;
  const Story* last = nullptr;
  for (const Story& story : stories) {
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
      if (seconds < story.steps[i].seconds - rounding) return {&story, i, std::max(0.0, seconds)};
      seconds -= story.steps[i].seconds;
    }
    last = &story;
  }
  return {last, last->steps.size() - 1, last->steps.back().seconds};
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
  } else if (recipe.takes_placing != d.placing.has_value()) {
    problem = std::string(recipe.takes_placing ? "takes" : "takes no") + " scale={x, y}, angle= and at={x, y}";
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

const Step& step_at(const std::vector<Story>& stories, double seconds) {
  const Moment moment = moment_at(stories, seconds);
  return moment.story->steps[moment.step];
}

DemonstrationView view_of(const std::vector<Story>& stories, double seconds) {
  const Moment moment = moment_at(stories, seconds);
  return view_of_step(*moment.story, moment.step, moment.since);
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
