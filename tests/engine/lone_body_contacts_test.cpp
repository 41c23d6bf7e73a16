#include "engine/lone_body_contacts.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr BodyIndex ground = 0;
constexpr BodyIndex body = 1;
constexpr double negligible = 1e-12;
using Outcome = LoneBodyContacts::Outcome;

struct Problem {
  std::vector<ContactRow> rows;
  std::vector<Motion> motions = std::vector<Motion>(2);

  /// A point at `arm` from the body's centre, pressed along `normal`; its rows.
  void add_point(Vec2 arm, Vec2 normal, real friction) {
    const std::size_t gap = rows.size();
    rows.push_back({RowKind::gap, 0, 0, term_along(arm, normal)});
    ContactRow& slip = rows.emplace_back(ContactRow{RowKind::slip, 0, 0, term_along(arm, perp(normal))});
    slip.first_gap = gap;
    slip.gap_count = 1;
    slip.coefficient = friction;
  }

  void resist_rolling(real lever, std::size_t gap) {
    ContactRow& roll = rows.emplace_back(ContactRow{RowKind::roll, 0, 0, {ground, body, {}, 1, 1}});
    roll.first_gap = gap;
    roll.gap_count = 1;
    roll.coefficient = lever;
  }

  Outcome solve() { return LoneBodyContacts().solve(rows, body, motions, negligible); }
  real speed(std::size_t i) const { return speed_of(rows[i].term, motions) + rows[i].bias; }

 private:
  static Term term_along(Vec2 arm, Vec2 direction) { return {ground, body, direction, 0, cross(arm, direction)}; }
};

/// A kilogram that reaches half a metre to each side, falling at 1 m/s.
Problem box_on(std::vector<Vec2> arms, real friction) {
  Problem box;
  box.motions[body].inv_mass = 1;
  box.motions[body].inv_inertia = 6;
  box.motions[body].velocity = {0, -1};
  for (const Vec2 arm : arms) box.add_point(arm, {0, 1}, friction);
  return box;
}

Vec2 direction_at(Random& random) {
  const double x = random.between(-1, 1);
  return Vec2(Vec2d{x, std::sqrt(1 - x * x)});
}

/// Up to four points below a body that may be light or heavy, slow or fast, pressed last time or not, near or off.
Problem random_problem(Random& random) {
  Problem p;
  Motion& m = p.motions[body];
  m.inv_mass = static_cast<real>(std::exp2(random.between(-5, 5)));
  m.inv_inertia = random.below(8) == 0 ? real(0) : m.inv_mass * static_cast<real>(random.between(2, 20));
  m.velocity = Vec2(Vec2d{random.between(-2, 2), random.between(-2, 1)});
  m.spin = static_cast<real>(random.between(-3, 3));
  const std::uint32_t points = 1 + random.below(4);
  const bool flat = random.below(2) == 0;
  const double friction = random.below(4) == 0 ? 0 : random.between(0.05, 0.8);
  for (std::uint32_t i = 0; i < points; ++i) {
    const Vec2 arm = Vec2(Vec2d{random.between(-0.6, 0.6), flat ? -0.5 : random.between(-0.6, -0.2)});
    p.add_point(arm, flat ? Vec2{0, 1} : direction_at(random), static_cast<real>(friction));
  }
  if (random.below(4) == 0) p.resist_rolling(static_cast<real>(random.between(0.01, 0.2)), 0);
  for (ContactRow& row : p.rows) {
    row.bias = random.below(2) == 0 ? real(0) : static_cast<real>(random.between(-0.2, 0.2));
    row.off = row.kind == RowKind::gap && random.below(10) == 0;
    if (row.kind != RowKind::gap || random.below(2) == 0) continue;
    row.given = static_cast<real>(random.between(0, 1)) / m.inv_mass;
    push(row.term, row.given, p.motions);
  }
  return p;
}

/// By how much the laws are broken, in m/s: a gap that presses keeps its speed 0, others part; what is bounded keeps
/// its speed 0, or gives all it may against it.
double broken_laws(const Problem& p) {
  const double tiny = pick(1e-9, 1e-4) / static_cast<double>(p.motions[body].inv_mass);
  double worst = 0;
  for (std::size_t i = 0; i < p.rows.size(); ++i) {
    const ContactRow& row = p.rows[i];
    const double speed = static_cast<double>(p.speed(i));
    const double given = static_cast<double>(row.given);
    if (row.kind == RowKind::gap) {
      if (given < 0 || (row.off && given > 0)) return 1e9;
      if (!row.off) worst = std::max(worst, given > tiny ? std::abs(speed) : -speed);
      continue;
    }
    double most = 0;
    for (std::size_t k = row.first_gap; k < row.first_gap + row.gap_count; ++k)
      most += static_cast<double>(row.coefficient * p.rows[k].given);
    if (std::abs(given) > most + tiny) return 1e9;
    if (row.kind == RowKind::roll && p.motions[body].inv_inertia == 0) continue;  // nothing turns it
    if (std::abs(given) < most - tiny) worst = std::max(worst, std::abs(speed));
    if (std::abs(given) > tiny) worst = std::max(worst, given > 0 ? speed : -speed);
  }
  return worst;
}

std::vector<double> responses_of(const Problem& p) {
  const std::size_t n = p.rows.size();
  const Motion& m = p.motions[body];
  std::vector<double> response(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Term& one = p.rows[i].term;
      const Term& other = p.rows[j].term;
      response[i * n + j] =
          static_cast<double>(m.inv_mass) * dot(Vec2d(one.direction), Vec2d(other.direction)) +
          static_cast<double>(m.inv_inertia) * static_cast<double>(one.arm_b) * static_cast<double>(other.arm_b);
    }
  }
  return response;
}

double difference(const Motion& a, const Motion& b) {
  return static_cast<double>(length(a.velocity - b.velocity) + std::abs(a.spin - b.spin));
}

}  // namespace

TEST_CASE("A lone body gets the speeds that pivoting finds, or others that keep all laws", "[lone body]") {
  Random random(1);
  int solved = 0;
  int alike = 0;
  constexpr int count = 5000;
  for (int i = 0; i < count; ++i) {
    Problem quick = random_problem(random);
    Problem pivoted = quick;
    if (quick.solve() == Outcome::unsolved) continue;
    ++solved;
    INFO("problem " << i);
    CHECK(broken_laws(quick) < pick(1e-7, 2e-3));
    if (!solve_by_pivots(pivoted.rows, responses_of(pivoted), 1e-10, pivoted.motions)) continue;
    alike += difference(quick.motions[body], pivoted.motions[body]) < pick(1e-6, 1e-3) ? 1 : 0;
  }
  CHECK(solved > 0.985 * count);
  CHECK(alike > 0.995 * solved);
}

TEST_CASE("Impulses that are off by no more than what is negligible are left bit for bit", "[lone body]") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    Problem p = random_problem(random);
    if (p.solve() == Outcome::unsolved) continue;
    const Problem before = p;
    LoneBodyContacts().solve(p.rows, body, p.motions, 1e-4);
    INFO("problem " << i);
    CHECK(p.motions[body].velocity == before.motions[body].velocity);
    CHECK(p.motions[body].spin == before.motions[body].spin);
    for (std::size_t k = 0; k < p.rows.size(); ++k) CHECK(p.rows[k].given == before.rows[k].given);
  }
}

TEST_CASE("What cannot be solved leaves everything as it was", "[lone body]") {
  Problem p = box_on({{0, real(-0.5)}, {0, real(0.5)}}, 0);
  for (Term* t : {&p.rows[2].term, &p.rows[3].term}) t->direction = -t->direction;  // one from below, one from above
  for (const std::size_t gap : {std::size_t{0}, std::size_t{2}}) p.rows[gap].bias = -1;  // and both press
  CHECK(p.solve() == Outcome::unsolved);
  CHECK(p.motions[body].velocity == Vec2{0, -1});
  CHECK(p.rows[0].given == 0);
}

TEST_CASE("The four points of a box on two grounds carry its weight together, as they did before", "[lone body]") {
  const real half = real(0.5);
  Problem p = box_on({{-half, -half}, {-real(0.25), -half}, {real(0.25), -half}, {half, -half}}, half);
  SECTION("the first time, alike to both sides") {
    REQUIRE(p.solve() == Outcome::solved);
    CHECK(p.rows[0].given == Approx(p.rows[6].given).epsilon(pick(1e-9, 1e-5)));
    CHECK(p.rows[2].given == Approx(p.rows[4].given).epsilon(pick(1e-9, 1e-5)));
  }
  SECTION("and then with the shares they have") {
    for (const auto& [row, share] : {std::pair{0, 0.1}, std::pair{2, 0.4}, std::pair{4, 0.4}, std::pair{6, 0.1}}) {
      ContactRow& gap = p.rows[static_cast<std::size_t>(row)];
      gap.given = static_cast<real>(share);
      push(gap.term, gap.given, p.motions);
    }
    p.motions[body].velocity = {};
    p.motions[body].spin = 0;
    CHECK(p.solve() == Outcome::unchanged);
    CHECK(p.rows[2].given == real(0.4));
  }
  double sum = 0;
  for (std::size_t gap = 0; gap < 8; gap += 2) sum += static_cast<double>(p.rows[gap].given);
  CHECK(sum == Approx(1).epsilon(pick(1e-9, 1e-5)));
  CHECK(std::abs(p.motions[body].spin) < pick(1e-9, 1e-5));
  CHECK(length(p.motions[body].velocity) < pick(1e-9, 1e-5));
}

TEST_CASE("What slides is braked by mu times what presses, and what holds still is not", "[lone body]") {
  Problem p = box_on({{0, real(-0.5)}}, real(0.5));
  p.motions[body].inv_inertia = 0;
  const auto [before, after] = GENERATE(std::pair{3.0, 2.5}, std::pair{-3.0, -2.5}, std::pair{0.3, 0.0});
  p.motions[body].velocity.x = static_cast<real>(before);
  REQUIRE(p.solve() == Outcome::solved);
  CHECK(p.motions[body].velocity.x == Approx(after).margin(pick(1e-9, 1e-6)));
  CHECK(p.motions[body].velocity.y == Approx(0).margin(pick(1e-9, 1e-6)));
}

TEST_CASE("Without friction nothing brakes, and without pressing nothing does either", "[lone body]") {
  SECTION("no friction") {
    Problem p = box_on({{0, real(-0.5)}}, 0);
    p.motions[body].velocity.x = 3;
    REQUIRE(p.solve() == Outcome::solved);
    CHECK(p.motions[body].velocity.x == 3);
    CHECK(p.rows[1].given == 0);
  }
  SECTION("it parts") {
    Problem p = box_on({{0, real(-0.5)}}, 1);
    p.motions[body].velocity = {3, 1};
    CHECK(p.solve() == Outcome::unchanged);
  }
  SECTION("its gap is open") {
    Problem p = box_on({{0, real(-0.5)}}, 1);
    p.motions[body].velocity.x = 3;
    p.rows[0].off = true;
    CHECK(p.solve() == Outcome::unchanged);
  }
}

TEST_CASE("Rolling resistance takes the lever times what presses, and no more than the roll has", "[lone body]") {
  Problem p = box_on({{0, real(-0.5)}}, 0);
  const auto [lever, after] = GENERATE(std::pair{0.1, 1.4}, std::pair{0.5, 0.0});
  p.resist_rolling(static_cast<real>(lever), 0);
  p.motions[body].spin = 2;
  REQUIRE(p.solve() == Outcome::solved);
  CHECK(p.motions[body].spin == Approx(after).margin(pick(1e-9, 1e-6)));
}

TEST_CASE("A box that lies on two grounds lies there for good", "[lone body]") {
  Scene scene = with_floor(body_with(box_shape(1, 1), {0, 0.5}));
  scene.bodies[0] = body_with(box_shape(10, 1), {-5, -0.5}, BodyType::fixed);
  scene.bodies.push_back(body_with(box_shape(10, 1), {5, -0.5}, BodyType::fixed));
  const auto simulation = simulate(scene);
  run(*simulation, 10);
  const BodyState state = simulation->body(BodyId{2});
  CHECK(length(state.velocity) < pick(1e-12, 1e-5));
  CHECK(state.position.x == Approx(0).margin(pick(1e-9, 1e-5)));
  CHECK(state.position.y == Approx(0.5).margin(pick(1e-9, 1e-4)));
}

TEST_CASE("How a body slides does not depend on others far away", "[lone body]") {
  BodyDef box = body_with(box_shape(1, 1), {0, 0.5});
  box.velocity = {3, 0};
  Scene alone = with_floor(box);
  Scene among_others = alone;
  for (int i = 0; i < 6; ++i) among_others.bodies.push_back(body_with(disc_shape(0.3), {20 + 0.1 * i, 0.5 + 0.6 * i}));
  const auto one = simulate(alone);
  const auto other = simulate(among_others);
  run(*one, 2);
  run(*other, 2);
  CHECK(one->body(BodyId{2}).position == other->body(BodyId{2}).position);
  CHECK(one->body(BodyId{2}).angle == other->body(BodyId{2}).angle);
}
