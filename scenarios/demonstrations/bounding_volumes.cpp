// Bounding volumes compared (thesis figure 4.1): how tight they are against how dear a test is.

#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/elementary.h"
#include "engine/polygon.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"
#include "scenarios/demonstrations/shape_pair.h"

namespace proofreel {
namespace {

constexpr double pi = std::numbers::pi;

/// The smallest rectangle around a convex polygon has a side on one of its edges (Freeman and Shapira 1975).
std::vector<Vec2d> smallest_rectangle(const std::vector<Vec2d>& hull) {
  std::vector<Vec2d> best;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2d along = normalized(hull[(i + 1) % hull.size()] - hull[i]);
    Aabbd box;
    for (const Vec2d p : hull) box = merged(box, Vec2d{dot(p, along), dot(p, perp(along))});
    const Vec2d size = box.upper - box.lower;
    if (size.x * size.y >= least) continue;
    least = size.x * size.y;
    const auto back = [&](double u, double v) { return u * along + v * perp(along); };
    best = {back(box.lower.x, box.lower.y), back(box.upper.x, box.lower.y), back(box.upper.x, box.upper.y),
            back(box.lower.x, box.upper.y)};
  }
  return best;
}

struct Volume {
  std::string name;
  StoryMark mark;
  double area = 0;
  std::string test;
};

/// A shape at some angle, and the volumes around it.
struct Bounded {
  DemonstrationShape shape;
  std::vector<Volume> volumes;
  double area = 0;
};

Bounded bounded(const DemonstrationShape& shape, Vec2d center) {
  Bounded result{shape, {}, 0};
  std::vector<Vec2d> points;
  for (const std::vector<Vec2d>& part : shape.parts) {
    points.insert(points.end(), part.begin(), part.end());
    result.area += area_of(part);
  }
  double radius = 0;
  for (const Vec2d p : points) radius = std::max(radius, distance(center, p));
  const std::vector<Vec2d> hull = convex_hull(points);
  const std::vector<Vec2d> rectangle = smallest_rectangle(hull);
  const Aabbd box = bounds_of(points);
  const Vec2d size = box.upper - box.lower;
  std::vector<Vec2d> ring;
  for (int i = 0; i < 72; ++i)
    ring.push_back(center + radius * Vec2d{elementary::cos(pi * i / 36), elementary::sin(pi * i / 36)});
  result.volumes = {
      {"circle", closed_path(Role::candidate, ring), pi * radius * radius, "one distance against two radii"},
      {"AABB", box_mark(Role::candidate, box), size.x * size.y, "four comparisons"},
      {"OBB", closed_path(Role::candidate, rectangle), area_of(rectangle), "up to four separating axes"},
      {"convex hull", closed_path(Role::candidate, hull), area_of(hull),
       filled("up to one separating axis for every edge, here % of each shape", {figure(hull.size())})}};
  return result;
}

class Comparison {
 public:
  explicit Comparison(const Demonstration& asked) : shape_(asked.shapes[0]), board_(asked.pace) {
    board_.pane("");
    bars_ = board_.pane("area, the shape's own = 1", 0.5, true);
    board_.heading("Bounding volumes");
    std::vector<Vec2d> points;
    for (const std::vector<Vec2d>& part : shape_.parts) points.insert(points.end(), part.begin(), part.end());
    center_ = center(bounds_of(points));
  }

  Story tell() {
    const Bounded at_rest = bounded(shape_, center_);
    show(at_rest, -1);
    board_.step(
        "A volume that is simple to test goes around the shape. How much of it is empty, and what does a test cost?",
        4);
    for (int i = 0; i < 4; ++i) {
      show(at_rest, i);
      const Volume& volume = at_rest.volumes[static_cast<std::size_t>(i)];
      board_.step(filled("The % covers $%$ times the shape. Its test: %.",
                         {volume.name, figure(volume.area / at_rest.area), volume.test}),
                  4);
    }
    constexpr int turns = 24;
    for (int i = 0; i <= turns; ++i) {
      show(bounded(turned(shape_, center_, 0.5 * pi * i / turns), center_), 1);
      board_.step("When the shape turns, only the AABB grows and shrinks: the others turn with it.",
                  i < turns ? 0.25 : 3);
    }
    return board_.finish();
  }

 private:
  void show(const Bounded& now, int volume) {
    std::size_t part = 0;
    for (StoryMark& mark : shape_marks(Role::first, now.shape, 1))
      board_.show(keyed(std::move(mark), filled("part %", {figure(part++)})));
    std::vector<Bar> bars;
    for (int i = 0; i < 4; ++i) {
      const Volume& v = now.volumes[static_cast<std::size_t>(i)];
      const double ratio = v.area / now.area;
      bars.push_back(
          {i == volume ? Role::candidate : Role::rejected, ratio, filled("%: %", {v.name, figure(ratio)}), v.name});
      StoryMark mark = v.mark;
      mark.role = i == volume ? Role::candidate : Role::quiet;
      board_.show(keyed(std::move(mark), filled("% outline", {v.name})));
    }
    const double square = 4 / pi * now.volumes[0].area / now.area;  // around the circle: no AABB is larger
    show_bars(board_, bars_, bars, square);
  }

  DemonstrationShape shape_;
  Storyboard board_;
  Vec2d center_;
  int bars_ = 0;
};

}  // namespace

Story tell_bounding_volumes(const Demonstration& demonstration) { return Comparison(demonstration).tell(); }

}  // namespace proofreel
