#include "scenarios/demonstration.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/collide.h"
#include "engine/collide_gjk.h"
#include "engine/dynamic_tree.h"
#include "engine/polygon.h"
#include "film_marks.h"

using namespace proofreel;
using namespace proofreel::films;
using Catch::Contains;

namespace {

/// The same everywhere: a linear congruential generator (Knuth's MMIX).
class Dice {
 public:
  double roll(double low, double high) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * static_cast<double>(state_ >> 11U) * 0x1p-53;
  }
  Points points(std::size_t count) {
    Points all;
    while (all.size() < count) {
      const double x = roll(-3, 3);
      all.push_back({x, roll(-2, 2)});
    }
    return all;
  }

 private:
  std::uint64_t state_ = 7;
};

double length_of(const StoryMark& mark) { return distance(mark.points.front(), mark.points.back()); }

Hull hull_about(const Points& points, Vec2d center) {
  ShapeDef def;
  def.points = points;
  return make_hull(def, center);
}

Manifold collided(const Points& a, const Points& b) {
  return collide(hull_about(a, {}), Pose{}, hull_about(b, {}), Pose{}, 0);
}

double depth_of(const Points& a, const Points& b) { return -static_cast<double>(deepest(collided(a, b))); }

const Points square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
const Points triangle{{0.4, -0.3}, {2.8, -0.8}, {2.1, 1.4}};
const Points far_triangle{{2.4, -0.3}, {4.8, -0.8}, {4.1, 1.4}};

std::vector<DemonstrationShape> some_boxes(std::size_t count) {
  Dice dice;
  std::vector<DemonstrationShape> shapes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d at{dice.roll(-3, 3), dice.roll(-2, 2)};
    shapes.push_back(disc_at(at, dice.roll(0.2, 0.7)));
  }
  return shapes;
}

template <typename Watching = NoObserver>
DynamicTree tree_of(const std::vector<DemonstrationShape>& shapes, Watching observer = {}) {
  DynamicTree tree;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Vec2 center(shapes[i].parts[0][0]);
    tree.insert(expanded(Aabb{center, center}, static_cast<real>(shapes[i].radius)), static_cast<std::uint32_t>(i),
                observer);
  }
  return tree;
}

/// One of every algorithm.
std::vector<Story> all_stories() {
  Dice dice;
  DemonstrationShape block = polygon_of({{-1, 0}, {1, 0}, {1, 0.5}, {-1, 0.5}});
  block.friction = {0.6, 0.4};
  return {told(Algorithm::gift_wrapping, dice.points(9)),
          told(Algorithm::separating_axes, {polygon_of(square), polygon_of(triangle)}),
          told(Algorithm::gjk_epa, {polygon_of(square), polygon_of(triangle)}),
          told(Algorithm::gjk_epa, {polygon_of(square), polygon_of(far_triangle)}),
          told(Algorithm::tree_insertion, some_boxes(9)),
          told(Algorithm::tree_pairs, some_boxes(9)),
          told(Algorithm::diagonal_test, square),
          told(Algorithm::edge_walk, triangle),
          told(Algorithm::centroid, square),
          told(Algorithm::circle_contact, {disc_at({0, 0}, 1), disc_at({1, 1}, 1)}),
          told(Algorithm::circle_contact, {disc_at({0, 0}, 1), polygon_of(triangle)}),
          told(Algorithm::bounding_volumes, {polygon_of(triangle)}),
          told(Algorithm::dot_product, triangle),
          told(Algorithm::cross_product, triangle),
          story_of({Algorithm::transforms, {}, {polygon_of(square)}, 1, Placing{{2, 0.5}, 1, {3, 1}}}),
          story_of({Algorithm::transform_order, {}, {polygon_of(square)}, 1, Placing{{2, 0.5}, 1, {3, 1}}}),
          told(Algorithm::gjk_line, {polygon_of({{0, 0}, {1, 0}}), polygon_of({{2, 0}, {4, 0}})}),
          told(Algorithm::center_of_mass, {polygon_of(square), disc_at({3, 0}, 1)}),
          told(Algorithm::moment_of_inertia, {polygon_of(square), disc_at({3, 0}, 1)}),
          told(Algorithm::friction_cone, {block}),
          told(Algorithm::sequential_impulses, {polygon_of(square), polygon_of({{-1, 1}, {1, 1}, {0, 2}})})};
}

}  // namespace

TEST_CASE("The hull drawn is the hull returned, and every comparison is counted") {
  Dice dice;
  for (std::size_t count = 3; count <= 20; ++count) {
    const Points points = dice.points(count);
    const Story story = told(Algorithm::gift_wrapping, points);
    Points hull = convex_hull(points);
    const std::string comparisons = std::to_string((count - 2) * hull.size());
    CHECK_THAT(story.steps.back().caption, Contains("= " + comparisons + "$ comparisons"));
    hull.push_back(hull.front());
    const auto drawn = marks_of(story.steps.back(), MarkKind::path, Role::result);
    REQUIRE(drawn.size() == 1);
    CHECK(drawn.front().points == hull);
  }
}

TEST_CASE("Gift wrapping shows points in line as such") {
  const Story story = told(Algorithm::gift_wrapping, {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}});
  CHECK_THAT(step_saying(story, "in line and farther").caption, Contains("= 0.00$"));
  CHECK(marks_of(story.steps.back(), MarkKind::path, Role::result).front().points.size() == 5);
}

TEST_CASE("The depth that separating axes end with is the manifold's") {
  const Story story = told(Algorithm::separating_axes, {polygon_of(square), polygon_of(triangle)});
  const auto arrows = marks_of(story.steps.back(), MarkKind::arrow, Role::alert);
  const Manifold manifold = collided(square, triangle);
  REQUIRE(arrows.size() == static_cast<std::size_t>(manifold.count));
  double deepest_drawn = 0;
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    CHECK(length_of(arrows[i]) == Approx(-static_cast<double>(manifold.points[i].separation)));
    deepest_drawn = std::max(deepest_drawn, length_of(arrows[i]));
    CHECK(arrows[i].points[0] == Vec2d(manifold.points[i].point));
    const Vec2d way = normalized(arrows[i].points[1] - arrows[i].points[0]);
    CHECK(dot(way, Vec2d(manifold.normal)) == Approx(1));
  }
  CHECK(deepest_drawn == Approx(depth_of(square, triangle)));
  CHECK(story.steps.size() == 1 + square.size() + triangle.size() + 1);
}

TEST_CASE("Separating axes end where one shape's axes have a gap") {
  const Story story = told(Algorithm::separating_axes, {polygon_of(square), polygon_of(far_triangle)});
  CHECK(collided(square, far_triangle).count == 0);
  CHECK_THAT(story.steps.back().caption, Contains("a_{2}$ separates them: a gap of $1.40$ m"));
  CHECK(story.steps.size() == 1 + square.size() + 1);
}

TEST_CASE("The depth that EPA draws is the manifold's, and so are the contact points") {
  Dice dice;
  for (int i = 0; i < 30; ++i) {
    const Points other = convex_hull(dice.points(6));
    if (collided(square, other).count == 0) continue;
    const Story story = told(Algorithm::gjk_epa, {polygon_of(square), polygon_of(other)});
    const Vec2d a = centroid_of(square), b = centroid_of(other);
    const Manifold manifold = collide_gjk(hull_about(square, a), {a, Rot{}}, hull_about(other, b), {b, Rot{}}, 0);
    const Step& found = step_saying(story, "Nothing lies beyond");
    const auto depth = marks_of(found, MarkKind::arrow, Role::alert, 1);
    REQUIRE(depth.size() == 1);
    CHECK(length_of(depth.front()) == Approx(-static_cast<double>(deepest(manifold))));
    const auto dots = marks_of(story.steps.back(), MarkKind::dot, Role::alert);
    REQUIRE(dots.size() == static_cast<std::size_t>(manifold.count));
    for (std::size_t k = 0; k < dots.size(); ++k) CHECK(dots[k].points[0] == Vec2d(manifold.points[k].point) + a);
  }
}

TEST_CASE("The gap that GJK draws is the distance") {
  const Story story = told(Algorithm::gjk_epa, {polygon_of(square), polygon_of(far_triangle)});
  const auto world = marks_of(story.steps.back(), MarkKind::path, Role::result);
  const auto difference = marks_of(story.steps.back(), MarkKind::path, Role::result, 1);
  REQUIRE(world.size() == 1);
  REQUIRE(difference.size() == 1);
  const auto apart =
      static_cast<double>(distance(hull_about(square, {}), Pose{}, hull_about(far_triangle, {}), Pose{}).separation);
  CHECK(length_of(world.front()) == Approx(apart));
  CHECK(length_of(difference.front()) == Approx(apart));
}

TEST_CASE("The tree drawn at the end is the tree that was built") {
  for (std::size_t count = 2; count <= 12; count += 2) {
    const std::vector<DemonstrationShape> shapes = some_boxes(count);
    const Story story = told(Algorithm::tree_insertion, shapes);
    const DynamicTree tree = tree_of(shapes);
    std::size_t node = 0;
    tree.visit([&](const Aabb& box, int depth, bool leaf) {
      const auto boxes = marks_of(story.steps.back(), MarkKind::path, leaf ? Role::first : Role::quiet);
      const auto is_drawn = [&](const StoryMark& mark) { return mark.points[0] == Vec2d(box.lower); };
      CHECK(std::any_of(boxes.begin(), boxes.end(), is_drawn));
      const auto dots = marks_of(story.steps.back(), MarkKind::dot, leaf ? Role::first : Role::rejected, 1);
      const auto is_deep = [&](const StoryMark& mark) { return mark.points[0].y == -depth; };
      CHECK(std::any_of(dots.begin(), dots.end(), is_deep));
      ++node;
    });
    CHECK(node == 2 * count - 1);
    CHECK(marks_of(story.steps.back(), MarkKind::path, Role::quiet, 1).size() == 2 * count - 2);
  }
}

TEST_CASE("The chosen sibling is the least of those whose cost was shown") {
  const Story story = told(Algorithm::tree_insertion, some_boxes(12));
  int chosen = 0;
  for (std::size_t i = 1; i < story.steps.size(); ++i) {
    if (story.steps[i].caption.find("No node further down") == std::string::npos) continue;
    ++chosen;
    const auto winner = marks_of(story.steps[i], MarkKind::dot, Role::chosen, 1);
    REQUIRE(winner.size() == 1);
    double least = 1e9;
    for (std::size_t k = i - 1; story.steps[k].caption.starts_with("Beside "); --k) {
      const auto tested = marks_of(story.steps[k], MarkKind::dot, Role::candidate, 1);
      REQUIRE(tested.size() == 1);
      least = std::min(least, std::stod(tested.front().text.substr(1)));
    }
    CHECK(std::stod(winner.front().text.substr(1)) == least);
  }
  CHECK(chosen == 11);
}

TEST_CASE("The pairs found are those whose boxes overlap, and the queue ends empty") {
  for (std::size_t count = 2; count <= 12; count += 2) {
    const std::vector<DemonstrationShape> shapes = some_boxes(count);
    const Story story = told(Algorithm::tree_pairs, shapes);
    std::size_t overlapping = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Vec2d a = shapes[i].parts[0][0], b = shapes[j].parts[0][0];
        const double reach = shapes[i].radius + shapes[j].radius;
        overlapping += std::abs(a.x - b.x) <= reach && std::abs(a.y - b.y) <= reach ? 1 : 0;
      }
    }
    CHECK(marks_of(story.steps.back(), MarkKind::region, Role::result).size() == overlapping);
    const auto queue = marks_of(story.steps.back(), MarkKind::text, Role::first, 1);
    REQUIRE(queue.size() == 1);
    CHECK(queue.front().text == "queue: empty");
  }
}

TEST_CASE("Every pair highlighted is the one the traversal looked at, and stood first in the queue") {
  const std::vector<DemonstrationShape> shapes = some_boxes(12);
  const Story story = told(Algorithm::tree_pairs, shapes);
  std::vector<PairVisited> visited;
  tree_of(shapes).for_each_pair([](ProxyId, ProxyId) {},
                                Observer([&](const Event& event) { visited.push_back(std::get<PairVisited>(event)); }));
  REQUIRE(story.steps.size() == visited.size() + 2);
  for (std::size_t i = 0; i < visited.size(); ++i) {
    const std::string queue = marks_of(story.steps[i], MarkKind::text, Role::first, 1).front().text;
    CHECK_THAT(story.steps[i + 1].caption, Catch::StartsWith(queue.substr(7, queue.find(')') - 6) + " "));
    const bool pruned = visited[i].pruned;
    const Role role = pruned ? Role::alert : visited[i].leaves ? Role::result : Role::candidate;
    const auto boxes = marks_of(story.steps[i + 1], MarkKind::path, role);
    REQUIRE(boxes.size() >= 2);
    CHECK(boxes[boxes.size() - 2].points[0] == visited[i].a.lower);
    CHECK(boxes[boxes.size() - 2].points[2] == visited[i].a.upper);
    CHECK(boxes.back().points[0] == visited[i].b.lower);
    CHECK(boxes.back().points[2] == visited[i].b.upper);
  }
}

TEST_CASE("Every node highlighted is one whose cost the insertion looked at") {
  const std::vector<DemonstrationShape> shapes = some_boxes(12);
  std::vector<SiblingTested> tested;
  tree_of(shapes, Observer([&](const Event& event) {
            if (const auto* sibling = std::get_if<SiblingTested>(&event)) tested.push_back(*sibling);
          }));
  std::size_t next = 0;
  for (const Step& step : told(Algorithm::tree_insertion, shapes).steps) {
    if (!step.caption.starts_with("Beside ")) continue;
    REQUIRE(next < tested.size());
    const auto boxes = marks_of(step, MarkKind::path, Role::candidate);
    REQUIRE(boxes.size() == 2);
    CHECK(boxes[0].points[0] == tested[next].box.lower);
    CHECK(boxes[0].points[2] == tested[next].box.upper);
    ++next;
  }
  CHECK(next == tested.size());
}

TEST_CASE("The centroid drawn is the centroid, also of concave outlines and of clockwise ones") {
  const Points concave{{2.6, 0.2}, {0.3, 0.1}, {1.5, 1.9}, {-1.9, 1.3}, {-2.6, -1.2}, {0.4, -1.7}};
  const Points turned(concave.rbegin(), concave.rend());
  for (const Points& outline : {square, triangle, concave, turned}) {
    const Story story = told(Algorithm::centroid, outline);
    const auto dots = marks_of(story.steps.back(), MarkKind::dot, Role::result);
    REQUIRE(dots.size() == 1);
    CHECK(distance(dots.front().points[0], centroid_of(outline)) < 1e-12);
  }
  const Story story = told(Algorithm::centroid, concave);
  CHECK_FALSE(marks_of(story.steps.back(), MarkKind::region, Role::alert).empty());
}

TEST_CASE("Films on convexity come to the answer of the engine") {
  const Points dart{{-2, -1.2}, {2.2, -0.2}, {-0.5, -0.1}, {-0.8, 1.7}};
  for (const Points& outline : {square, dart}) {
    const bool convex = is_convex(outline);
    const std::string answer = convex ? "convex." : "concave.";
    CHECK_THAT(told(Algorithm::diagonal_test, outline).steps.back().caption, Catch::EndsWith(answer));
    const Story walk = told(Algorithm::edge_walk, outline);
    CHECK_THAT(walk.steps.back().caption, Catch::EndsWith(answer));
    CHECK((walk.steps.size() == outline.size() + 2) == convex);
  }
}

TEST_CASE("The depth of a circle's contact is drawn to scale, coincident circles by both radii") {
  const auto drawn_depth = [](const DemonstrationShape& a, const DemonstrationShape& b) {
    const Story story = told(Algorithm::circle_contact, {a, b});
    const auto paths = marks_of(story.steps.back(), MarkKind::path, Role::alert);
    return paths.size() == 1 ? length_of(paths.front()) : 0;
  };
  CHECK(drawn_depth(disc_at({0, 0}, 1), disc_at({1.5, 0}, 0.75)) == Approx(0.25));
  CHECK(drawn_depth(disc_at({0, 0}, 1), disc_at({0, 0}, 0.75)) == Approx(1.75));
  CHECK(drawn_depth(disc_at({0, 0}, 1), disc_at({3, 0}, 0.75)) == 0);
  CHECK(drawn_depth(disc_at({-1.5, 0}, 1), polygon_of(square)) == Approx(0.5));
  CHECK(drawn_depth(disc_at({-1.6, -1.8}, 1.25), polygon_of(square)) == Approx(0.25));
  CHECK(drawn_depth(disc_at({-0.5, 0}, 1), polygon_of(square)) == Approx(1.5));
  CHECK(drawn_depth(disc_at({-2.5, 0}, 1), polygon_of(square)) == 0);
}

TEST_CASE("Every bounding volume holds the shape, and none is tighter than the hull") {
  const Story story = told(Algorithm::bounding_volumes, {polygon_of(triangle)});
  for (const Step& step : story.steps) {
    const auto shape = marks_of(step, MarkKind::shape, Role::first);
    REQUIRE(shape.size() == 1);
    for (const Role role : {Role::candidate, Role::quiet}) {
      for (const StoryMark& volume : marks_of(step, MarkKind::path, role)) {
        Points corners(volume.points.begin(), volume.points.end() - 1);
        CHECK(area_of(corners) >= area_of(triangle) * (1 - 1e-12));
        // A ring of corners stands for the circle: its sides cut a little off.
        const double slack = corners.size() > 4 ? 0.01 : 1e-9;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const Vec2d along = normalized(corners[(i + 1) % corners.size()] - corners[i]);
          for (const Vec2d p : shape.front().points) CHECK(cross(along, p - corners[i]) > -slack);
        }
      }
    }
  }
}

TEST_CASE("All that a film shows lies within its panes") {
  for (const Story& story : all_stories()) {
    for (const Step& step : story.steps) {
      CHECK_FALSE(step.caption.empty());
      CHECK_FALSE(step.heading.empty());
      for (const StoryMark& mark : step.marks) {
        for (const Vec2d p : mark.points)
          CHECK(contains(story.panes[static_cast<std::size_t>(mark.pane)].bounds, Aabbd{p, p}));
      }
    }
  }
}

TEST_CASE("Shapes on a lattice, which touch, coincide and lie in line, can be demonstrated") {
  Dice dice;
  const auto lattice_points = [&dice](std::size_t count) {
    Points points = dice.points(count);
    for (Vec2d& p : points) p = {std::floor(p.x), std::floor(p.y)};
    return points;
  };
  int told_of = 0;
  for (int round = 0; round < 400; ++round) {
    const Points a = convex_hull(lattice_points(6)), b = convex_hull(lattice_points(6));
    for (int i = 0; i < algorithm_count; ++i) {
      Demonstration asked{static_cast<Algorithm>(i), a, {}, 1, {}};
      if (problem_with(asked)) asked = {asked.algorithm, {}, {polygon_of(a), polygon_of(b)}, 1, {}};
      if (problem_with(asked)) asked.shapes = {disc_at(b.front(), 1), polygon_of(a)};
      if (problem_with(asked)) continue;
      ++told_of;
      for (const Step& step : story_of(asked).steps) {
        for (const StoryMark& mark : step.marks)
          REQUIRE(std::all_of(mark.points.begin(), mark.points.end(), [](Vec2d p) { return is_finite(p); }));
      }
    }
  }
  CHECK(told_of > 2000);
}

TEST_CASE("In its second half a step stands still, and the last one stays") {
  const std::vector<Story> stories = all_stories();
  double start = 0;
  for (const Story& story : stories) {
    for (const Step& step : story.steps) {
      const DemonstrationView view = view_of(stories, start + 0.99 * step.seconds);
      CHECK(view.caption == step.caption);
      if (step.seconds >= 0.35) {
        REQUIRE(view.marks.size() == step.marks.size());
        for (std::size_t i = 0; i < step.marks.size(); ++i) {
          CHECK(view.marks[i].points == step.marks[i].points);
          CHECK(view.marks[i].presence == 1);
        }
      }
      start += step.seconds;
    }
  }
  CHECK(duration_of(stories) == Approx(start));
  CHECK(view_of(stories, 10 * start).caption == stories.back().steps.back().caption);
}

TEST_CASE("What moves is half way when a step has settled half, and so do the words change") {
  Dice dice;
  const std::vector<Story> stories{told(Algorithm::gift_wrapping, dice.points(6))};
  const Step& first = stories[0].steps[0];
  const Step& second = stories[0].steps[1];
  CHECK(view_of(stories, first.seconds + 0.1).caption == first.caption);
  CHECK(view_of(stories, first.seconds + 0.2).caption == second.caption);
  const auto dots = [](const DemonstrationView& view) {
    return std::count_if(view.marks.begin(), view.marks.end(), [](const auto& mark) { return mark.presence < 1; });
  };
  CHECK(dots(view_of(stories, first.seconds + 0.1)) > 0);
  CHECK(dots(view_of(stories, first.seconds + 0.4)) == 0);
}

TEST_CASE("Marks of one key in two panes move each within its own") {
  Story story;
  story.panes.resize(2);
  story.steps.resize(2);
  for (int step = 0; step < 2; ++step) {
    for (int pane = 0; pane < 2; ++pane) {
      StoryMark mark;
      mark.key = "same";
      mark.pane = pane;
      mark.points = {{10.0 * pane + step, 0}};
      story.steps[static_cast<std::size_t>(step)].marks.push_back(mark);
    }
  }
  const DemonstrationView view = view_of({story}, 1.175);  // half of the 0.35 s in which marks settle
  REQUIRE(view.marks.size() == 2);
  CHECK(view.marks[0].points[0].x == Approx(0.5));
  CHECK(view.marks[1].points[0].x == Approx(10.5));
}

TEST_CASE("The same demonstration has the same hash, another one another") {
  CHECK(hash_of(all_stories()) == hash_of(all_stories()));
  Points moved = square;
  moved[0].x -= 1e-9;
  CHECK(hash_of({told(Algorithm::edge_walk, square)}) != hash_of({told(Algorithm::edge_walk, moved)}));
}

TEST_CASE("Every algorithm is found by its name") {
  const std::vector<std::string> names = algorithm_names();
  REQUIRE(names.size() == algorithm_count);
  for (const std::string& name : names) CHECK(name_of(algorithm_named(name).value()) == name);
  CHECK_FALSE(algorithm_named("bubble_sort"));
}
