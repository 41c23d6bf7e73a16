#include "engine/decompose.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <optional>

#include "engine/elementary.h"
#include "engine/outline.h"
#include "engine/polygon.h"
#include "engine/scene.h"
#include "tests/engine/random.h"

namespace proofreel {
namespace {

using Points = std::vector<Vec2d>;
using Catch::Matchers::Contains;

constexpr double pi = 3.141592653589793;

Points cleaned(const Points& corners) {
  const auto result = clean_polygon(corners);
  if (const auto* sentence = std::get_if<std::string>(&result)) FAIL(*sentence);
  return std::get<Points>(result);
}

std::optional<Points> cleaned_or_nothing(const Points& corners) {
  const auto result = clean_polygon(corners);
  if (const auto* outline = std::get_if<Points>(&result)) return *outline;
  return std::nullopt;
}

ConvexParts parts_of(const Points& outline) {
  const auto result = convex_parts(outline);
  if (const auto* sentence = std::get_if<std::string>(&result)) FAIL(*sentence);
  return std::get<ConvexParts>(result);
}

Vec2d at_angle(double angle, double radius) { return radius * Vec2d{elementary::cos(angle), elementary::sin(angle)}; }

Points regular(int sides, double radius) {
  Points corners;
  for (int i = 0; i < sides; ++i) corners.push_back(at_angle(2 * pi * i / sides, radius));
  return corners;
}

Points star(int points) {
  Points corners;
  for (int i = 0; i < 2 * points; ++i) corners.push_back(at_angle(pi * i / points, i % 2 == 0 ? 2 : 1));
  return corners;
}

/// Star-shaped round the origin.
Points random_star(Random& random, int n) {
  Points corners;
  for (int i = 0; i < n; ++i) {
    corners.push_back(at_angle(2 * pi * (i + random.between(0.1, 0.9)) / n, random.between(0.2, 1)));
  }
  return corners;
}

/// Teeth upwards from a bar: four corners a tooth.
Points comb(int teeth) {
  Points corners{{0, -1}, {2.0 * teeth - 1, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    for (const Vec2d p : {Vec2d{1, 0}, Vec2d{1, 1}, Vec2d{0, 1}, Vec2d{0, 0}}) corners.push_back(p + Vec2d{2.0 * i, 0});
  }
  return corners;
}

/// A band that winds inwards.
Points spiral(int corners_a_side) {
  Points outer, inner;
  for (int i = 0; i < corners_a_side; ++i) {
    const double radius = 20 - 0.3 * i;
    outer.push_back(at_angle(0.5 * i, radius));
    inner.push_back(at_angle(0.5 * i, radius - 0.8));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

/// Random corners joined into a simple outline: as long as two edges cross, the way between them is turned round.
Points untangled(Points corners) {
  const std::size_t n = corners.size();
  for (bool crossing = true; crossing;) {
    crossing = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if (!segments_cross(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n])) continue;
        std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     corners.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        crossing = true;
      }
    }
  }
  return corners;
}

Points random_simple(Random& random, int n) {
  Points corners;
  for (int i = 0; i < n; ++i) corners.push_back({random.between(-5, 5), random.between(-5, 5)});
  return untangled(corners);
}

int concave_corners(const Points& outline) {
  const std::size_t n = outline.size();
  int count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    count += orientation(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]) < 0 ? 1 : 0;
  }
  return count;
}

/// Whether an edge of `a` has all of `b` on its outer side.
bool edge_separates(const Points& a, const Points& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool outside =
        std::all_of(b.begin(), b.end(), [&](Vec2d p) { return orientation(a[i], a[(i + 1) % a.size()], p) <= 0; });
    if (outside) return true;
  }
  return false;
}

void check_shape_of_parts(const Points& outline, const ConvexParts& parts) {
  for (const Points& part : parts) {
    REQUIRE(part.size() <= max_polygon_vertices);
    REQUIRE(is_convex(part));
    REQUIRE(std::holds_alternative<Points>(clean_polygon(part)));
    for (std::size_t i = 0; i < part.size(); ++i) {
      REQUIRE(orientation(part[i], part[(i + 1) % part.size()], part[(i + 2) % part.size()]) > 0);
      REQUIRE(std::find(outline.begin(), outline.end(), part[i]) != outline.end());
    }
  }
}

/// Measured from `origin`: far away, a centroid could not be told to the digits that are to be compared.
Points seen_from(Vec2d origin, Points points) {
  for (Vec2d& p : points) p -= origin;
  return points;
}

void check_parts_fill(const Points& far_outline, const ConvexParts& parts) {
  const Points outline = seen_from(far_outline[0], far_outline);
  double area = 0;
  double extent = 0;
  Vec2d weighted;
  for (const Points& far_part : parts) {
    const Points part = seen_from(far_outline[0], far_part);
    area += area_of(part);
    weighted += area_of(part) * centroid_of(part);
  }
  for (const Vec2d p : outline) extent = std::max(extent, length(p));
  REQUIRE(std::fabs(area - area_of(outline)) <= 1e-12 * area);
  REQUIRE(distance((1 / area) * weighted, centroid_of(outline)) <= 1e-12 * extent);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      REQUIRE((edge_separates(parts[i], parts[j]) || edge_separates(parts[j], parts[i])));
    }
  }
}

/// The parts, after everything that must hold of them was checked.
ConvexParts checked_parts(const Points& corners) {
  const Points outline = cleaned(corners);
  const ConvexParts parts = parts_of(outline);
  check_shape_of_parts(outline, parts);
  check_parts_fill(outline, parts);
  const int concave = concave_corners(outline);
  if (outline.size() <= max_polygon_vertices) {
    REQUIRE(static_cast<int>(parts.size()) <= 2 * concave + 1);
    REQUIRE(static_cast<int>(parts.size()) >= (concave + 1) / 2 + 1);
  }
  REQUIRE(parts_of(outline) == parts);
  return parts;
}

TEST_CASE("A convex outline is one part, as it is") {
  const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(parts_of(square) == ConvexParts{square});
  CHECK(parts_of(regular(16, 1)) == ConvexParts{regular(16, 1)});
}

TEST_CASE("Letters and signs are cut into as few parts as they need") {
  CHECK(checked_parts({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}).size() == 2);                  // L
  CHECK(checked_parts({{1, 0}, {2, 0}, {2, 2}, {3, 2}, {3, 3}, {0, 3}, {0, 2}, {1, 2}}).size() == 2);  // T
  CHECK(checked_parts({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}).size() == 3);  // U
  CHECK(checked_parts({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}).size() == 2);                              // dart
  CHECK(checked_parts({{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}})
            .size() == 3);  // plus
  CHECK(checked_parts({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 3}, {0, 3}, {0, 2}, {1, 2}, {1, 1}, {0, 1}})
            .size() == 3);  // H on its side
}

TEST_CASE("Stars, combs and spirals are cut soundly") {
  CHECK(checked_parts(star(5)).size() == 4);
  CHECK(checked_parts(star(20)).size() >= 11);
  for (const int teeth : {2, 5, 20, 60}) {
    CAPTURE(teeth);
    CHECK(checked_parts(comb(teeth)).size() == static_cast<std::size_t>(teeth) + 1);
  }
  checked_parts(spiral(12));
  checked_parts(spiral(60));
}

TEST_CASE("A side on which many parts stand takes no corners: a comb's bar is one rectangle") {
  const ConvexParts parts = parts_of(cleaned(comb(30)));
  const auto bar = std::find_if(parts.begin(), parts.end(), [](const Points& p) { return area_of(p) > 2; });
  REQUIRE(bar != parts.end());
  CHECK(bar->size() == 4);
}

TEST_CASE("A convex outline of more corners than a part may have is cut into as few as hold them") {
  for (const int sides : {17, 30, 31, 44, 45, 256}) {
    CAPTURE(sides);
    CHECK(checked_parts(regular(sides, 3)).size() == static_cast<std::size_t>((sides - 2 + 13) / 14));
  }
}

TEST_CASE("Parts fill a random outline, convex and apart") {
  Random random(31);
  for (int round = 0; round < 150; ++round) {
    const int n = 4 + static_cast<int>(random.below(40));
    CAPTURE(round, n);
    checked_parts(random_star(random, n));
    checked_parts(random_simple(random, n));
  }
}

TEST_CASE("Parts fill an outline of as many corners as there may be") {
  Random random(32);
  checked_parts(random_star(random, max_outline_corners));
  checked_parts(random_simple(random, 150));
}

TEST_CASE("An outline far from the origin is cut as it is there") {
  Random random(33);
  for (int round = 0; round < 20; ++round) {
    Points outline = random_simple(random, 20);
    for (Vec2d& p : outline) p += Vec2d{3e7, -1e8};
    if (cleaned_or_nothing(outline)) checked_parts(outline);
  }
}

// Independent of the engine: all sets of diagonals of small outlines on a grid of whole numbers, tried one by one.

struct Brute {
  Points outline;
  bool only_sound = false;
  std::map<std::vector<std::size_t>, int> known{};

  static constexpr int never = 1000;

  Points points(const std::vector<std::size_t>& corners) const {
    Points result;
    for (const std::size_t i : corners) result.push_back(outline[i]);
    return result;
  }
  static std::int64_t side(Vec2d a, Vec2d b, Vec2d c) {
    const auto whole = [](double x) { return static_cast<std::int64_t>(x); };
    return (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) -
           (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
  }
  static int sign(std::int64_t x) { return (x > 0) - (x < 0); }

  /// Straight corners left out.
  Points turning(const std::vector<std::size_t>& corners) const {
    const Points all = points(corners);
    const std::size_t n = all.size();
    Points result;
    for (std::size_t i = 0; i < n; ++i) {
      if (side(all[(i + n - 1) % n], all[i], all[(i + 1) % n]) != 0) result.push_back(all[i]);
    }
    return result;
  }
  bool is_part(const std::vector<std::size_t>& corners) const {
    const Points all = points(corners);
    const std::size_t n = all.size();
    bool has_area = false;
    for (std::size_t i = 0; i < n; ++i) {
      const auto turn = side(all[i], all[(i + 1) % n], all[(i + 2) % n]);
      if (turn < 0) return false;
      has_area = has_area || turn > 0;
    }
    return has_area && (!only_sound || cleaned_or_nothing(turning(corners)));
  }

  bool on_segment(Vec2d p, Vec2d a, Vec2d b) const {
    return side(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
  }
  /// By counting edges to the right; the point is not on the outline. Doubled, so that a middle is a whole number.
  bool inside(Vec2d middle) const {
    bool odd = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2d a = 2.0 * outline[i], b = 2.0 * outline[(i + 1) % outline.size()];
      if ((a.y > middle.y) == (b.y > middle.y)) continue;
      const auto s = side(a, b, middle);
      if ((b.y > a.y) == (s > 0)) odd = !odd;
    }
    return odd;
  }
  bool is_diagonal(std::size_t i, std::size_t j) const {
    const Vec2d a = outline[i], b = outline[j];
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec2d c = outline[k], d = outline[(k + 1) % outline.size()];
      if (k != i && k != j && on_segment(c, a, b)) return false;
      const bool crosses =
          sign(side(a, b, c)) * sign(side(a, b, d)) < 0 && sign(side(c, d, a)) * sign(side(c, d, b)) < 0;
      if (crosses) return false;
    }
    return inside(a + b);
  }

  /// The fewest parts of the polygon of these corners.
  int fewest(const std::vector<std::size_t>& corners) {
    if (const auto found = known.find(corners); found != known.end()) return found->second;
    int best = is_part(corners) ? 1 : never;
    const std::size_t n = corners.size();
    for (std::size_t a = 0; a < n && best > 1; ++a) {
      for (std::size_t b = a + 2; b < n; ++b) {
        if ((a == 0 && b + 1 == n) || !is_diagonal(corners[a], corners[b])) continue;
        const auto at = [&](std::size_t k) { return corners.begin() + static_cast<std::ptrdiff_t>(k); };
        const std::vector<std::size_t> one(at(a), at(b + 1));
        std::vector<std::size_t> other(at(b), corners.end());
        other.insert(other.end(), corners.begin(), at(a + 1));
        best = std::min(best, fewest(one) + fewest(other));
      }
    }
    return known[corners] = best;
  }
  int fewest() {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < outline.size(); ++i) all.push_back(i);
    return fewest(all);
  }
};

Points on_grid(Random& random, int n, std::uint32_t size, double scale, std::uint32_t bump) {
  Points corners;
  const auto coordinate = [&] { return scale * random.below(size) + (bump > 0 ? random.below(bump) : 0); };
  for (int i = 0; i < n; ++i) {
    const double x = coordinate();
    corners.push_back({x, coordinate()});
  }
  return corners;
}

TEST_CASE("There are as few parts as trying all sets of diagonals finds") {
  Random random(34);
  int concave = 0;
  for (int round = 0; round < 6000; ++round) {
    const int n = 4 + static_cast<int>(random.below(5));
    const auto outline = cleaned_or_nothing(untangled(on_grid(random, n, round % 2 == 0 ? 5 : 12, 1, 0)));
    if (!outline || is_convex(*outline)) continue;
    ++concave;
    CAPTURE(round);
    REQUIRE(static_cast<int>(checked_parts(*outline).size()) == Brute{*outline}.fewest());
  }
  CHECK(concave > 1500);
}

TEST_CASE("Thin parts are avoided where any set of diagonals avoids them, and refused where none does") {
  Random random(35);
  int refused = 0, more = 0;
  for (int round = 0; round < 6000; ++round) {
    const int n = 4 + static_cast<int>(random.below(5));
    const auto outline = cleaned_or_nothing(untangled(on_grid(random, n, 4, 0x1p24, 12)));
    if (!outline) continue;
    Brute sound{*outline, true};
    const int fewest = sound.fewest();
    CAPTURE(round, fewest);
    const auto parts = convex_parts(*outline);
    REQUIRE(std::holds_alternative<ConvexParts>(parts) == (fewest < Brute::never));
    if (fewest < Brute::never) REQUIRE(static_cast<int>(checked_parts(*outline).size()) == fewest);
    refused += fewest == Brute::never ? 1 : 0;
    more += fewest < Brute::never && fewest > Brute{*outline}.fewest() ? 1 : 0;
  }
  CHECK(refused > 10);
  CHECK(more > 10);
}

TEST_CASE("An outline that cannot be cut without a thin part is refused by the corner") {
  const Points spiked{{0, 0}, {4, 0}, {4, 4}, {2 + 1e-7, 4}, {2, 9}, {2 - 1e-7, 4}, {0, 4}};
  const auto result = convex_parts(cleaned(spiked));
  REQUIRE(std::holds_alternative<std::string>(result));
  CHECK_THAT(std::get<std::string>(result),
             Contains("corner {") && Contains(", 4}") && Contains("thinner than a millionth") && Contains("move that"));
}

// Observed.

/// Cuts the outline along what the events say, one after the other, and leaves straight corners out.
ConvexParts redrawn(const Points& outline, const std::vector<CutChosen>& cuts) {
  ConvexParts parts{outline};
  for (const CutChosen& cut : cuts) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Points whole = parts[k];
      const auto a = std::find(whole.begin(), whole.end(), cut.a), b = std::find(whole.begin(), whole.end(), cut.b);
      if (a == whole.end() || b == whole.end()) continue;
      const auto first = std::min(a, b), second = std::max(a, b);
      parts[k].assign(first, second + 1);
      Points other(second, whole.end());
      other.insert(other.end(), whole.begin(), first + 1);
      parts.push_back(other);
      break;
    }
  }
  return parts;
}

double squares_of_areas(const ConvexParts& parts) {
  double sum = 0;
  for (const Points& part : parts) sum += area_of(part) * area_of(part);
  return sum;
}

TEST_CASE("The parts can be redrawn from the cuts that were shown") {
  Random random(36);
  for (int round = 0; round < 50; ++round) {
    const Points outline = cleaned(random_simple(random, 25));
    std::vector<CutChosen> cuts;
    const Observer observer([&](const Event& event) { cuts.push_back(std::get<CutChosen>(event)); });
    const auto parts = std::get<ConvexParts>(convex_parts(outline, observer));
    REQUIRE(parts == parts_of(outline));
    REQUIRE(cuts.size() + 1 == parts.size());
    const ConvexParts again = redrawn(outline, cuts);
    REQUIRE(again.size() == parts.size());
    REQUIRE(squares_of_areas(again) == Approx(squares_of_areas(parts)).epsilon(1e-12));
    for (const Points& part : again) REQUIRE(is_convex(part));
  }
}

}  // namespace
}  // namespace proofreel
