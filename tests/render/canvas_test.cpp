#include "render/canvas.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "engine/elementary.h"
#include "tests/render/painted.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

constexpr double pi = 3.14159265358979323846;

std::vector<Vec2d> regular(Vec2d center, double radius, int sides, double turn) {
  std::vector<Vec2d> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = turn + 2 * pi * i / sides;
    corners.push_back(center + radius * Vec2d{elementary::cos(angle), elementary::sin(angle)});
  }
  return corners;
}

double area_of_regular(double radius, int sides) {
  return 0.5 * sides * radius * radius * elementary::sin(2 * pi / sides);
}

}  // namespace

TEST_CASE("A disc covers pi r squared pixels wherever its centre lies") {
  for (const double radius : {6.0, 20.3, 45.0}) {
    const Vec2d center{50.0 + 0.37 * radius / 45, 50.21};
    const Image image = picture(100, 100, [&](Canvas& canvas) { canvas.disc(center, radius, solid); });
    CHECK(ink(image) == Approx(pi * radius * radius).epsilon(0.005));
  }
}

TEST_CASE("A disc centred between pixels is its own mirror image") {
  const Image image = picture(64, 64, [](Canvas& canvas) { canvas.disc({32, 32}, 20.7, {white, black, 3}); });
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      REQUIRE(red(image, x, y) == red(image, 63 - x, y));
      REQUIRE(red(image, x, y) == red(image, x, 63 - y));
      REQUIRE(red(image, x, y) == red(image, y, x));
    }
  }
}

TEST_CASE("Convex polygons of 3 to 16 corners cover their area, in either orientation") {
  for (const int sides : {3, 4, 5, 8, 9, 12, 16}) {
    std::vector<Vec2d> corners = regular({64.3, 63.8}, 50, sides, 0.3);
    const Image image = picture(128, 128, [&](Canvas& canvas) { canvas.polygon(corners, 0, solid); });
    INFO(sides << " sides");
    CHECK(ink(image) == Approx(area_of_regular(50, sides)).epsilon(0.005));
    std::reverse(corners.begin(), corners.end());
    const Image mirrored = picture(128, 128, [&](Canvas& canvas) { canvas.polygon(corners, 0, solid); });
    CHECK(largest_difference(image, mirrored) <= 1);
  }
}

TEST_CASE("Rounding grows a polygon by a band and the corners of a disc") {
  for (const int sides : {3, 4, 6, 11, 16}) {
    const double radius = 9;
    const std::vector<Vec2d> corners = regular({64, 64}, 40, sides, 0.2);
    const Image image = picture(128, 128, [&](Canvas& canvas) { canvas.polygon(corners, radius, solid); });
    const double edge = distance(corners[0], corners[1]);
    INFO(sides << " sides");
    CHECK(ink(image) ==
          Approx(area_of_regular(40, sides) + sides * edge * radius + pi * radius * radius).epsilon(0.005));
  }
}

TEST_CASE("A line covers its length times its width, and half a disc at each end") {
  for (const double width : {0.5, 1.0, 2.5, 6.0}) {
    const Vec2d a{20.2, 30.1};
    const Vec2d b{100.7, 88.9};
    const Image image = picture(128, 128, [&](Canvas& canvas) { canvas.line(a, b, width, black); });
    INFO("width " << width);
    CHECK(ink(image) == Approx(distance(a, b) * width + 0.25 * pi * width * width).epsilon(0.02));
  }
}

TEST_CASE("A capsule is as long as its segment and round at both ends") {
  const Image image = picture(128, 64, [](Canvas& canvas) { canvas.capsule({30, 32}, {98, 32}, 20, solid); });
  CHECK(ink(image) == Approx(68 * 40 + pi * 400).epsilon(0.005));
}

TEST_CASE("The outline lies inside the edge") {
  const Image image = picture(64, 64, [](Canvas& canvas) {
    canvas.rectangle({10, 10}, {50, 50}, 0, {white, black, 4});
  });
  CHECK(red(image, 9, 30) == 255);
  CHECK(red(image, 10, 30) == 0);
  CHECK(red(image, 13, 30) == 0);
  CHECK(red(image, 14, 30) == 255);
  CHECK(ink(image) == Approx(40 * 40 - 32 * 32).epsilon(0.001));
}

TEST_CASE("An empty frame shows what lies under it and equals an outline over the same ground") {
  const auto frame = [](Color fill) {
    return picture(90, 70, [fill](Canvas& canvas) {
      canvas.rectangle({10.3, 12.6}, {70.2, 58.9}, 0, {fill, black, 2.4});
    });
  };
  CHECK(largest_difference(frame({255, 255, 255, 0}), frame(white)) <= 1);
}

TEST_CASE("What is drawn later lies on top, whatever programs draw it") {
  const std::vector<Vec2d> hexagon = regular({32, 32}, 20, 6, 0);
  const Paint gray{{90, 90, 90, 255}, {90, 90, 90, 255}, 0};
  const Image disc_last = picture(64, 64, [&](Canvas& canvas) {
    canvas.polygon(hexagon, 0, solid);
    canvas.disc({32, 32}, 10, gray);
  });
  CHECK(red(disc_last, 32, 32) == 90);
  const Image hexagon_last = picture(64, 64, [&](Canvas& canvas) {
    canvas.disc({32, 32}, 10, gray);
    canvas.polygon(hexagon, 0, solid);
  });
  CHECK(red(hexagon_last, 32, 32) == 0);
  const Image again = picture(64, 64, [&](Canvas& canvas) {
    canvas.polygon(hexagon, 0, gray);
    canvas.disc({32, 32}, 10, solid);
    canvas.polygon(regular({32, 32}, 5, 5, 0), 0, gray);
    canvas.text("I", {32, 200}, 12, Align::center, black);
  });
  CHECK(red(again, 32, 32) == 90);
  CHECK(red(again, 32, 40) == 0);
  CHECK(red(again, 32, 45) == 90);
}

TEST_CASE("Sorting shapes into few draw calls does not change the picture") {
  const auto draw = [](Canvas& canvas, int i) {
    const Vec2d at{10.0 + (i * 37) % 180, 10.0 + (i * 53) % 100};
    const Color color{static_cast<std::uint8_t>(i * 40), 80, static_cast<std::uint8_t>(255 - i * 30), 160};
    if (i % 3 == 0) canvas.disc(at, 22, {color, black, 2});
    if (i % 3 == 1) canvas.polygon(regular(at, 22, 7, i), 0, {color, black, 2});
    if (i % 3 == 2) canvas.polygon(regular(at, 18, 5, i), 4, {color, black, 2});
  };
  const Image together = picture(200, 120, [&](Canvas& canvas) {
    for (int i = 0; i < 40; ++i) draw(canvas, i);
  });
  // A stroke without colour across all of the picture keeps what comes after it out of the batches before it.
  const Image apart = picture(200, 120, [&](Canvas& canvas) {
    for (int i = 0; i < 40; ++i) {
      draw(canvas, i);
      canvas.stroke(std::array<Vec2d, 2>{Vec2d{-50, -50}, Vec2d{250, 170}}, 1, {0, 0, 0, 0}, {0, 0, 0, 0});
    }
  });
  CHECK(fingerprint(together) == fingerprint(apart));
}

TEST_CASE("A translucent stroke has no beads at its joints") {
  std::vector<Vec2d> points;
  for (int i = 0; i <= 40; ++i) points.push_back({10.0 + 4 * i, 50 + 20 * elementary::sin(0.25 * i)});
  const Color half{0, 0, 0, 128};
  const Image image = picture(180, 100, [&](Canvas& canvas) { canvas.stroke(points, 6, half, half); });
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 180; ++x) REQUIRE(red(image, x, y) >= 127);
  }
  CHECK(ink(image) > 100);
}

TEST_CASE("A stroke covers all that is within half its width of it, however it turns") {
  constexpr double width = 14;
  for (int degrees = -175; degrees <= 175; degrees += 10) {
    const double turn = degrees * pi / 180;
    const Vec2d middle{60, 60};
    const std::array<Vec2d, 4> points{middle - Vec2d{40, 3}, middle - Vec2d{2, 0}, middle,
                                      middle + 38.0 * Vec2d{elementary::cos(turn), elementary::sin(turn)}};
    const Image image = picture(120, 120, [&](Canvas& canvas) { canvas.stroke(points, width, black, black); });
    const auto distance_to_segment = [](Vec2d p, Vec2d a, Vec2d b) {
      const double along = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      return distance(p, lerp(a, b, along));
    };
    int gaps = 0, beyond = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        double nearest = 1e9;
        for (std::size_t i = 1; i < points.size(); ++i)
          nearest = std::min(nearest, distance_to_segment({x + 0.5, y + 0.5}, points[i - 1], points[i]));
        gaps += nearest < 0.5 * width - 0.51 && red(image, x, y) > 0 ? 1 : 0;
        beyond += nearest > 0.5 * width + 0.51 && red(image, x, y) < 255 ? 1 : 0;
      }
    }
    CAPTURE(degrees);
    CHECK(gaps == 0);
    CHECK(beyond == 0);
  }
}

TEST_CASE("An arrow ends exactly in its point, and a short one keeps its length") {
  for (const double reach : {80.0, 12.0, 5.0}) {
    const Image image = picture(128, 32, [reach](Canvas& canvas) {
      canvas.arrow({20, 16}, {20 + reach, 16}, 4, black);
    });
    const int tip = 20 + static_cast<int>(reach);
    INFO("length " << reach);
    CHECK(red(image, tip + 1, 16) == 255);
    CHECK(red(image, tip - 2, 16) < 200);
    CHECK(red(image, 20, 16) < 200);
    CHECK(red(image, 18, 16) == 255);
  }
}

TEST_CASE("A huge ground looks as a small one that fills the picture") {
  const auto ground = [](double half_width, double depth, double turn) {
    return picture(160, 90, [=](Canvas& canvas) {
      const Vec2d x{elementary::cos(turn), elementary::sin(turn)};
      const Vec2d y = perp(x);
      const Vec2d top{80.25, 40.6};
      canvas.polygon(std::array<Vec2d, 4>{top - half_width * x, top + half_width * x, top + half_width * x + depth * y,
                                          top - half_width * x + depth * y},
                     0, {white, black, 3});
    });
  };
  for (const double turn : {0.0, 0.21}) {
    const Image small = ground(400, 300, turn);
    CHECK(largest_difference(small, ground(1e5, 1e5, turn)) <= 1);
    CHECK(largest_difference(small, ground(1e9, 1e9, turn)) <= 1);
    CHECK(ink(small) > 100);
  }
}

TEST_CASE("A planet's horizon is as flat as its radius says") {
  const auto planet = [](double radius) {
    return picture(160, 90, [radius](Canvas& canvas) { canvas.disc({80, 40.5 + radius}, radius, solid); });
  };
  CHECK(ink(planet(1e9)) == Approx(160 * 49.5).epsilon(0.001));
  CHECK(largest_difference(planet(0.99e6), planet(1.01e6)) <= 20);
  for (const Vec2d center : {Vec2d{80, 45}, {80, 60}, {-3e6, 45}}) {
    const Image inside = picture(160, 90, [center](Canvas& canvas) { canvas.disc(center, 1e7, solid); });
    CHECK(ink(inside) == 160 * 90);
  }
}

TEST_CASE("What is off the picture or not finite draws nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const Image image = picture(40, 30, [&](Canvas& canvas) {
    canvas.disc({-50, 10}, 20, solid);
    canvas.disc({20, 10}, 0, solid);
    canvas.disc({20, 10}, -4, solid);
    canvas.disc({nan, 10}, 4, solid);
    canvas.disc({20, 10}, nan, solid);
    canvas.line({-10, -10}, {80, -10}, 4, black);
    canvas.line({20, infinite}, {20, 10}, 4, black);
    canvas.polygon(regular({100, 10}, 20, 6, 0), 0, solid);
    canvas.polygon(std::array<Vec2d, 3>{Vec2d{5, 5}, {10, 10}, {15, 15}}, 0, solid);
    canvas.polygon(std::array<Vec2d, 2>{Vec2d{5, 5}, {10, 10}}, 0, solid);
    canvas.rectangle({10, 10}, {10, 20}, 0, solid);
    canvas.arrow({5, 5}, {5, 5}, 3, black);
    canvas.stroke(std::array<Vec2d, 1>{Vec2d{5, 5}}, 3, black, black);
    canvas.text("off", {-100, 10}, 12, Align::left, black);
    canvas.disc({20, 15}, 8, {nothing, nothing, 2});
  });
  CHECK(ink(image) == 0);
}

TEST_CASE("Spaces draw nothing, also before the first letter") {
  Canvas canvas(context(), 60, 40);
  Image spaces, letters;
  canvas.clear(white);
  canvas.text("  ", {10, 20}, 12, Align::left, black);
  canvas.finish(spaces);
  CHECK(ink(spaces) == 0);
  canvas.text("ab", {10, 20}, 12, Align::left, black);
  canvas.finish(letters);
  CHECK(ink(letters) > 20);
}

TEST_CASE("A canvas draws the same picture again after another one") {
  Canvas canvas(context(), 60, 40);
  Image first;
  Image other;
  Image second;
  const auto draw = [&](Image& image) {
    canvas.clear(white);
    canvas.disc({30, 20}, 15, solid);
    canvas.text("ab", {5, 20}, 12, Align::left, black);
    canvas.finish(image);
  };
  draw(first);
  canvas.clear(black);
  canvas.polygon(regular({30, 20}, 15, 7, 0), 0, {white, white, 0});
  canvas.text("a longer text in another size", {5, 20}, 17, Align::left, white);
  canvas.finish(other);
  draw(second);
  CHECK(first.rgba == second.rgba);
  CHECK(first.rgba != other.rgba);
}
