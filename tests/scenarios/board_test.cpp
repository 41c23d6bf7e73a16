// Lecture films on vectors, transforms and intervals, held against answers found another way; and what these films and
// those on weights do not take.

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/polygon.h"
#include "film_marks.h"

using namespace proofreel;
using namespace proofreel::films;
using Catch::Contains;

namespace {

constexpr double pi = std::numbers::pi;

DemonstrationShape interval(double a, double b) { return polygon_of({{a, 0}, {b, 0}}); }

std::string problem_of(const Demonstration& asked) { return problem_with(asked).value_or(""); }

const Points vectors{{2.4, 0.6}, {1.4, 1.6}, {1.3, 1.1}, {2.2, -1.6}, {-0.9, 1.5}, {-0.6, 2.4}};

}  // namespace

TEST_CASE("The shadow drawn ends where b's projection on a does, and has its sign by its colour") {
  const Story story = told(Algorithm::dot_product, vectors);
  int seen = 0;
  for (const Step& step : story.steps) {
    const StoryMark* shadow = mark_called(step, MarkKind::bar, "shadow");
    const StoryMark* b = mark_called(step, MarkKind::arrow, "b");
    if (shadow == nullptr || b == nullptr) continue;
    ++seen;
    const Vec2d a = vectors[0];
    const double along = a.x * tip(*b).x + a.y * tip(*b).y;
    CHECK(dot(tip(*shadow), a) == Approx(along).margin(1e-12));
    CHECK(cross(tip(*shadow), a) == Approx(0).margin(1e-12));
    CHECK((shadow->role == Role::result) == (along > 0));
    CHECK(length(tip(*b)) == Approx(length(vectors[1])));
  }
  CHECK(seen > 60);
}

TEST_CASE("b turns by 90 degrees from halt to halt, and its product is 0 exactly where they are square") {
  const Story story = told(Algorithm::dot_product, vectors);
  const StoryMark* square = mark_called(step_saying(story, "= 90\u00b0$: no shadow"), MarkKind::arrow, "b");
  REQUIRE(square != nullptr);
  CHECK(dot(vectors[0], tip(*square)) == 0);
  const StoryMark* same = mark_called(step_saying(story, "The same direction"), MarkKind::arrow, "b");
  REQUIRE(same != nullptr);
  CHECK(cross(vectors[0], tip(*same)) == Approx(0).margin(1e-12));
  CHECK(dot(vectors[0], tip(*same)) > 0);
}

TEST_CASE("Points are in front, in the field of view and nearest as their angles and distances say") {
  const Story story = told(Algorithm::dot_product, vectors);
  const Vec2d a = vectors[0];
  const auto angle_to = [&](Vec2d p) { return std::abs(std::atan2(a.x * p.y - a.y * p.x, a.x * p.x + a.y * p.y)); };
  const auto is_marked = [](const Step& step, Vec2d p, Role role) {
    const auto dots = marks_of(step, MarkKind::dot, role);
    return std::any_of(dots.begin(), dots.end(), [&](const StoryMark& mark) { return mark.points[0] == p; });
  };
  const Step& view = step_saying(story, "45\u00b0 to each side");
  double nearest = 1e9;
  for (std::size_t i = 2; i < vectors.size(); ++i) {
    const Vec2d p = vectors[i];
    const Step& looked = step_saying(story, "\\vec{QP_{" + std::to_string(i - 1) + "}}");
    CHECK_THAT(looked.caption, Contains(angle_to(p) < pi / 2 ? "in front" : "behind"));
    CHECK(is_marked(view, p, Role::result) == (angle_to(p) < pi / 4));
    if (angle_to(p) < pi / 2) nearest = std::min(nearest, length(p) * std::cos(angle_to(p)));
  }
  const auto found = marks_of(story.steps.back(), MarkKind::dot, Role::result);
  REQUIRE(found.size() == 1);
  CHECK(length(found[0].points[0]) * std::cos(angle_to(found[0].points[0])) == Approx(nearest));
}

TEST_CASE("Where nothing lies in front, nothing is nearest") {
  const Story story = told(Algorithm::dot_product, Points{{1, 0}, {0, 1}, {-1, 1}, {-2, 0}});
  CHECK(story.steps.back().caption == "No product is positive: nothing lies in front.");
}

TEST_CASE("The parallelogram drawn has the area the cross product says, negative where b is on the right") {
  const Story story = told(Algorithm::cross_product, vectors);
  int seen = 0;
  for (const Step& step : story.steps) {
    const StoryMark* area = mark_called(step, MarkKind::region, "area");
    const StoryMark* now = mark_called(step, MarkKind::dot, "now");
    if (area == nullptr || now == nullptr) continue;
    ++seen;
    const double shown = area_of(area->points);  // by triangles
    const double all = length(vectors[0]) * length(vectors[1]);
    CHECK(now->points[0].y == Approx(shown / all).margin(1e-12));
    CHECK(now->points[0].y == Approx(std::sin(now->points[0].x * pi / 2)).margin(1e-9));
    CHECK((area->role == Role::result) == (shown > 0));
  }
  CHECK(seen > 60);
}

TEST_CASE("The side of the line that is told is that of the exact predicate, on the line included") {
  const Points points{{2, 1}, {0, 1}, {1, 3}, {3, -1}, {-4, -2}};
  const Story story = told(Algorithm::cross_product, points);
  CHECK_THAT(step_saying(story, "\\vec{OP_{1}}").caption, Contains("= 5.00 > 0$: $P_{1}$ is on the left"));
  CHECK_THAT(step_saying(story, "\\vec{OP_{2}}").caption, Contains("= \u22125.00 < 0$: $P_{2}$ is on the right"));
  CHECK_THAT(step_saying(story, "\\vec{OP_{3}}").caption, Contains("= 0.00$: $P_{3}$ is on the line"));
}

TEST_CASE("Scaled, turned and moved, a shape ends where each corner does by hand") {
  const Points corners{{-1, -0.7}, {1.1, -0.7}, {1.1, 0.2}, {-1, 0.5}};
  const Placing placing{{1.5, 0.8}, 0.9, {3.2, 1.4}};
  const Demonstration asked{Algorithm::transforms, {}, {polygon_of(corners)}, 1, placing};
  const Story story = told(asked);
  const StoryMark* shape = mark_called(story.steps.back(), MarkKind::shape, "shape 0");
  REQUIRE(shape != nullptr);
  const double c = std::cos(0.9), s = std::sin(0.9);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double x = 1.5 * corners[i].x, y = 0.8 * corners[i].y;
    CHECK(distance(shape->points[i], Vec2d{c * x - s * y + 3.2, s * x + c * y + 1.4}) < 1e-12);
  }
  const StoryMark* axis = mark_called(story.steps.back(), MarkKind::arrow, "axis x 0");
  REQUIRE(axis != nullptr);
  CHECK(distance(tip(*axis), Vec2d{1.5 * c, 1.5 * s}) < 1e-12);
}

TEST_CASE("The figures in the matrix are the images of the unit vectors in the picture") {
  const Placing placing{{2, -0.5}, -0.4, {1, -2}};
  const Story story = told({Algorithm::transforms, {}, {box_at({0, 0}, 1, 1)}, 1, placing});
  for (const Step& step : story.steps) {
    const StoryMark* x = mark_called(step, MarkKind::arrow, "axis x 0");
    REQUIRE(x != nullptr);
    const auto entry = [&](double column, double row) {
      for (const StoryMark& mark : marks_of(step, MarkKind::text, Role::first, 1)) {
        if (mark.points[0] == Vec2d{column, row}) return mark.text;
      }
      return std::string("missing");
    };
    const auto shown = [](double value) {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "%.2f", std::abs(value));
      return std::string(text.data());
    };
    CHECK_THAT(entry(0, 0.5), Contains(shown(tip(*x).x)));
    CHECK_THAT(entry(0, -0.5), Contains(shown(tip(*x).y)));
    CHECK_THAT(entry(2, 0.5), Contains(shown(x->points[0].x)));
  }
}

TEST_CASE("In the other order the way is turned and scaled as well") {
  const Placing placing{{1.5, 0.8}, 0.9, {3.2, 1.4}};
  const Story story = told({Algorithm::transform_order, {}, {box_at({0, 0}, 1, 1)}, 1, placing});
  const Step& last = story.steps.back();
  const auto left = marks_of(last, MarkKind::dot, Role::alert, 0),
             right = marks_of(last, MarkKind::dot, Role::alert, 1);
  REQUIRE(left.size() == 1);
  REQUIRE(right.size() == 1);
  CHECK(left[0].points[0] == placing.at);
  const double c = std::cos(0.9), s = std::sin(0.9);
  CHECK(distance(right[0].points[0], Vec2d{1.5 * (c * 3.2 - s * 1.4), 0.8 * (s * 3.2 + c * 1.4)}) < 1e-12);
  CHECK_THAT(last.caption, Contains("do not commute"));
  const Story alike = told({Algorithm::transform_order, {}, {box_at({0, 0}, 1, 1)}, 1, Placing{{1, 1}, 0, {3, 1}}});
  CHECK_THAT(alike.steps.back().caption, Contains("the order of the parts does not show"));
}

TEST_CASE("Intervals overlap, touch or are apart as their ends say, and the gap drawn is the distance") {
  const auto ends = [](double a1, double a2, double b1, double b2) {
    return told(Algorithm::gjk_line, std::vector{interval(a1, a2), interval(b1, b2)}).steps.back();
  };
  CHECK_THAT(ends(1, 3, 2, 4).caption, Contains("from $2.00$ to $3.00$"));
  CHECK_THAT(ends(4, 2, 3, 1).caption, Contains("from $2.00$ to $3.00$"));
  CHECK_THAT(ends(1, 2, 2, 4).caption, Contains("They touch"));
  CHECK_THAT(ends(-3, 3, -1, 2).caption, Contains("from $\u22121.00$ to $2.00$"));
  for (const double gap : {0.5, 1.0, 40.0}) {
    const Step right = ends(-4, -2, -2 + gap, 2 + gap), left = ends(-2 + gap, 2 + gap, -4, -2);
    for (const Step& step : {right, left}) {
      const auto drawn = marks_of(step, MarkKind::path, Role::result);
      REQUIRE(drawn.size() == 2);
      for (const StoryMark& mark : drawn) CHECK(std::abs(tip(mark).x) == Approx(gap));
    }
  }
}

TEST_CASE("On a line GJK keeps a simplex of ends of the difference, whatever the intervals") {
  std::uint64_t state = 5;
  const auto roll = [&state] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>((state >> 40U) % 13U) - 6;
  };
  int overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const double a1 = roll(), a2 = a1 + 1 + std::abs(roll()), b1 = roll(), b2 = b1 + 1 + std::abs(roll());
    const Story story = told(Algorithm::gjk_line, std::vector{interval(a1, a2), interval(b1, b2)});
    const bool overlap = a1 <= b2 && b1 <= a2;
    overlapping += overlap ? 1 : 0;
    INFO(a1 << " " << a2 << " " << b1 << " " << b2);
    CHECK((story.steps.back().caption.find("apart") == std::string::npos) == overlap);
  }
  CHECK(overlapping > 50);
}

TEST_CASE("What these films do not take is refused in a sentence") {
  const DemonstrationShape box = box_at({0, 0}, 1, 1);
  const auto of_shapes = [](Algorithm algorithm, const std::vector<DemonstrationShape>& shapes) {
    return problem_of({algorithm, {}, shapes, 1, {}});
  };
  const auto of_points = [](Algorithm algorithm, const Points& points) {
    return problem_of({algorithm, points, {}, 1, {}});
  };
  const auto of_placing = [&](const DemonstrationShape& shape, const Placing& placing) {
    return problem_of({Algorithm::transforms, {}, {shape}, 1, placing});
  };
  CHECK(of_points(Algorithm::dot_product, {{1, 0}, {0, 1}}) == "dot_product takes 3 to 8 points, got 2");
  CHECK_THAT(of_points(Algorithm::dot_product, {{0, 0}, {0, 1}, {1, 1}}),
             Contains("none of them {0, 0}: change point 1"));
  CHECK_THAT(of_points(Algorithm::cross_product, {{1, 0}, {0, 1}, {0, 0}}), Contains("change point 3"));
  CHECK_THAT(of_shapes(Algorithm::cross_product, {box}), Contains("takes points={{x, y}, ...}"));
  CHECK(of_shapes(Algorithm::transforms, {box}) == "transforms takes scale={x, y}, angle= and at={x, y}");
  CHECK(problem_of({Algorithm::center_of_mass, {}, parts, 1, Placing{}}) ==
        "center_of_mass takes no scale={x, y}, angle= and at={x, y}");
  CHECK_THAT(of_placing(disc_at({0, 0}, 1), {}), Contains("takes a convex polygon"));
  CHECK_THAT(of_placing(box, {{0, 1}, 0, {}}), Contains("scales between 0.01 and 100"));
  CHECK_THAT(of_placing(box, {{1, 1e9}, 0, {}}), Contains("scales between 0.01 and 100"));
  CHECK(of_placing(box, {{-1, 1}, 7, {}}).empty());
  CHECK_THAT(of_shapes(Algorithm::gjk_line, {box, box}), Contains("takes two intervals of the x axis"));
  CHECK_THAT(of_shapes(Algorithm::gjk_line, {interval(0, 1), polygon_of({{0, 0}, {1, 1}})}), Contains("two intervals"));
  CHECK_THAT(of_shapes(Algorithm::center_of_mass, {box, interval(0, 1)}), Contains("convex shapes with an area"));
  CHECK_THAT(of_shapes(Algorithm::moment_of_inertia, {box}), Contains("takes 2 to 6 shapes, got 1"));
  CHECK_THAT(of_shapes(Algorithm::friction_cone, {block_of(0.4, 0.6)}), Contains("the static one larger"));
  CHECK_THAT(of_shapes(Algorithm::friction_cone, {block_of(0.4, 0)}), Contains("between 0.2 and 1"));
  DemonstrationShape high = box_at({0, 0}, 0.4, 2);
  high.friction = {0.6, 0.4};
  CHECK_THAT(of_shapes(Algorithm::friction_cone, {high}), Contains("slides before it tips"));
  DemonstrationShape pointed = polygon_of({{0, 0}, {1, 1}, {-1, 1}});
  pointed.friction = {0.6, 0.4};
  CHECK_THAT(of_shapes(Algorithm::friction_cone, {pointed}), Contains("stands on a level edge"));
  CHECK_THAT(of_shapes(Algorithm::sequential_impulses, {box, disc_at({0, 1}, 0.5)}), Contains("without rounding"));
  CHECK_THAT(of_shapes(Algorithm::sequential_impulses, {box, box_at({0, 0.8}, 1, 1)}),
             Contains("the contact 1\u20132 is an overlap"));
  CHECK_THAT(of_shapes(Algorithm::sequential_impulses, {box, box_at({0, 1.5}, 1, 1)}),
             Contains("shape 2 touches nothing"));
}
