#pragma once

/// Lecture films: an algorithm of the engine, run on shapes that a scenario gives, told step by step. The steps are
/// made of the events the algorithm itself tells (engine/observer.h), so a film can show nothing but what the engine
/// did.
///
///     demonstrate{...} -> Demonstration -> the algorithm with an Observer -> Story -> DemonstrationView -> picture
///
/// A Story is plain data: marks in world coordinates, each with a role. Who draws it knows roles, not algorithms.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/aabb.h"
#include "engine/scene.h"

namespace proofreel {

/// What can be demonstrated; the files of demonstrations/ say what of the thesis each shows.
enum class Algorithm : std::uint8_t {
  gift_wrapping,
  separating_axes,
  gjk_epa,
  tree_insertion,
  tree_pairs,
  diagonal_test,
  edge_walk,
  centroid,
  circle_contact,
  bounding_volumes,
  dot_product,
  cross_product,
  transforms,
  transform_order,
  gjk_line,
  center_of_mass,
  moment_of_inertia,
  friction_cone,
  sequential_impulses
};
inline constexpr int algorithm_count = 19;
const char* name_of(Algorithm algorithm);
/// Seconds a usual step is shown unless the scenario says otherwise: comparisons come in dozens and are all alike. What
/// takes longer to read is shown longer (demonstrations/reading.h).
double usual_pace(Algorithm algorithm);

/// The convex hulls of `parts`, rounded by `radius`; one part unless the outline is concave. World coordinates, m.
struct DemonstrationShape {
  std::vector<std::vector<Vec2d>> parts;
  double radius = 0;
  double density = 1;  ///< kg/m^2
  FrictionDef friction{};
};

/// The three parts of a transform from local to world coordinates.
struct Placing {
  Vec2d scale{1, 1};
  double angle = 0;  ///< rad
  Vec2d at;          ///< m
};

/// What a scenario asks for. Algorithms on outlines, point sets and vectors take `points`, the others `shapes`.
struct Demonstration {
  Algorithm algorithm = Algorithm::gift_wrapping;
  std::vector<Vec2d> points;
  std::vector<DemonstrationShape> shapes;
  double pace = 1;                 ///< s a usual step is shown, or longer where it has more to read
  std::optional<Placing> placing;  ///< of transforms, which need it
};

/// What a mark means, which decides how it looks.
enum class Role : std::uint8_t {
  quiet,      ///< construction lines and what is only there for orientation
  first,      ///< the first shape, or all there is
  second,     ///< the second shape
  candidate,  ///< looked at in this step
  chosen,     ///< the best so far
  rejected,   ///< looked at before and put aside
  result,     ///< what the algorithm has found
  alert       ///< overlap, depth, wrong side, negative area
};

enum class MarkKind : std::uint8_t {
  shape,      ///< filled and outlined: the hull of `points`, rounded by `radius`
  region,     ///< a convex area without an outline
  bar,        ///< a convex area without an outline that stands for a length: solid
  path,       ///< a polyline; closed when the last point is the first
  arrow,      ///< from the first point to the second
  dot,        ///< a point
  crosswise,  ///< a point as a cross: an origin
  text        ///< written beside a point, without a mark of its own
};

/// One thing in the picture of a step.
struct StoryMark {
  MarkKind kind = MarkKind::dot;
  Role role = Role::first;
  std::vector<Vec2d> points;  ///< m, in the coordinates of its pane
  double radius = 0;          ///< m, of a shape
  std::string text;           ///< the label of a dot or a text, with formulas ($...$)
  Vec2d side;                 ///< where the label stands as seen from its point; zero: over it, centred
  std::string key;            ///< the mark of that key in the step before and in this pane is this one: it moves
  int pane = 0;
  int group = 0;        ///< shapes of one group, unless it is 0, are the parts of one outline
  double presence = 1;  ///< 0..1 while it appears
};

/// A part of the picture with coordinates of its own.
struct Pane {
  std::string title;
  bool diagram = false;  ///< not metres: has a scale of its own, and may be stretched
  double share = 1;      ///< of the picture, beside the other panes' shares
  Aabbd bounds;          ///< of all that it ever shows
};

/// A figure in the heading, such as "comparisons 12".
struct Counter {
  std::string name;
  std::string value;
};

/// What is shown between two things happening.
struct Step {
  std::string heading;
  std::string caption;  ///< with formulas
  std::vector<Counter> counters;
  std::vector<StoryMark> marks;
  double seconds = 1;
};

/// A demonstration from its beginning to its end.
struct Story {
  Algorithm algorithm{};
  std::vector<Pane> panes;
  std::vector<Step> steps;
};

/// The demonstration at one moment.
struct DemonstrationView {
  std::string heading;
  std::string caption;
  std::vector<Counter> counters;
  std::vector<Pane> panes;
  std::vector<StoryMark> marks;
};

std::optional<Algorithm> algorithm_named(std::string_view name);
std::vector<std::string> algorithm_names();

/// What of the input the algorithm does not take, as a sentence that begins with its name; nothing when it takes all.
std::optional<std::string> problem_with(const Demonstration& demonstration);

/// Runs the algorithm; the demonstration must have no problem. The same on every machine.
Story story_of(const Demonstration& demonstration);

/// Seconds from the first step to the end of the last.
double duration_of(const std::vector<Story>& stories);

/// The step that is shown `seconds` after the first began; the last one stays. There must be one.
const Step& step_at(const std::vector<Story>& stories, double seconds);

/// The stories one after the other, `seconds` after the first began; the last step stays. A mark that is new appears
/// and one that has moved moves within a part of a second, then all stands still.
DemonstrationView view_of(const std::vector<Story>& stories, double seconds);

/// Equal exactly when all marks of all steps are: chained into the trajectory hash, so that a change of an algorithm is
/// told apart from a change of the drawing.
std::uint64_t hash_of(const std::vector<Story>& stories);

}  // namespace proofreel
