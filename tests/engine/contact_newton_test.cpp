// Groups of contacts made up at random, solved by Newton's method and held against the laws themselves and against
// pivoting, which knows nothing of springs.

#include "engine/contact_newton.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double plenty_of_work = 1e7;
constexpr int plenty_of_rounds = 60;

struct Group {
  std::vector<Motion> motions;  ///< the first one does not move
  std::vector<ContactRow> rows;
};

Motion moving(Random& random, double mass) {
  Motion m;
  m.inv_mass = static_cast<real>(1 / mass);
  m.inv_inertia = static_cast<real>(random.between(2, 12) / mass);
  m.velocity = Vec2(Vec2d{random.between(-1, 1), random.between(-1, 1)});
  m.spin = static_cast<real>(random.between(-2, 2));
  return m;
}

/// A point where b touches a, from a random side, and its friction.
void touch(Group& group, BodyIndex a, BodyIndex b, double friction, Random& random) {
  Term normal{a, b, {}, 0, 0};
  const double slope = random.between(-1, 1);
  const double up = 1 / std::sqrt(1 + slope * slope);
  normal.direction = Vec2(Vec2d{slope * up, up});
  Term tangent = normal;
  tangent.direction = perp(normal.direction);
  for (Term* t : {&normal, &tangent}) {
    t->arm_a = static_cast<real>(random.between(-0.7, 0.7));
    t->arm_b = static_cast<real>(random.between(-0.7, 0.7));
  }
  const std::size_t gap = group.rows.size();
  group.rows.push_back({RowKind::gap, gap, 0, normal});
  if (friction <= 0) return;
  group.rows.push_back({RowKind::slip, gap, 0, tangent, gap, 1, static_cast<real>(friction)});
}

/// Every body stands on an earlier one or on what does not move, and some touch once more.
Group random_group(Random& random, int bodies, double heaviest, double friction) {
  Group group;
  group.motions.emplace_back();
  for (int i = 0; i < bodies; ++i) {
    const auto body = static_cast<BodyIndex>(group.motions.size());
    group.motions.push_back(moving(random, std::exp(random.between(0, std::log(heaviest)))));
    touch(group, random.below(body), body, friction, random);
    if (random.below(2) == 0) touch(group, random.below(body), body, friction, random);
  }
  return group;
}

std::vector<double> responses(const Group& group) {
  std::vector<double> response;
  std::vector<Motion> still = group.motions;
  for (Motion& m : still) {
    m.velocity = {};
    m.spin = 0;
  }
  for (const ContactRow& row : group.rows) {
    for (const ContactRow& other : group.rows) {
      std::vector<Motion> pushed = still;
      push(other.term, 1, pushed);
      response.push_back(static_cast<double>(speed_of(row.term, pushed)));
    }
  }
  return response;
}

bool solve_by_newton(Group& group) {
  ContactNewton newton;
  REQUIRE(newton.plan(group.rows, group.motions, plenty_of_work));
  return newton.solve(group.rows, group.motions, plenty_of_rounds);
}

double size_of(const ContactRow& row, const std::vector<Motion>& motions) {
  std::vector<Motion> pushed(motions);
  push(row.term, 1, pushed);
  return std::sqrt(std::abs(static_cast<double>(speed_of(row.term, pushed) - speed_of(row.term, motions))));
}

/// By how much, in m/s times sqrt(kg), the laws of Signorini and Coulomb are missed.
double law_broken(const Group& group) {
  double worst = 0;
  for (const ContactRow& row : group.rows) {
    const double size = size_of(row, group.motions);
    const double speed = static_cast<double>(speed_of(row.term, group.motions) + row.bias) / size;
    const double impulse = static_cast<double>(row.given) * size;
    if (row.kind == RowKind::gap) {
      worst = std::max({worst, -speed, -impulse, std::min(std::abs(speed), std::abs(impulse))});
      continue;
    }
    const double bound = static_cast<double>(row.coefficient * group.rows[row.first_gap].given) * size;
    const double left_forwards = bound - impulse;
    const double left_backwards = bound + impulse;
    worst = std::max({worst, -left_forwards, -left_backwards});
    worst = std::max(worst, std::min(std::max(speed, 0.0), left_backwards));
    worst = std::max(worst, std::min(std::max(-speed, 0.0), left_forwards));
  }
  return worst;
}

double momentum_along_x(const Group& group) {
  double sum = 0;
  for (std::size_t i = 1; i < group.motions.size(); ++i)
    sum += static_cast<double>(group.motions[i].velocity.x / group.motions[i].inv_mass);
  return sum;
}

}  // namespace

TEST_CASE("Without friction Newton's method and pivoting find the same velocities", "[contact newton]") {
  Random random(1);
  for (int run = 0; run < 400; ++run) {
    Group group = random_group(random, 1 + static_cast<int>(random.below(8)), 10, 0);
    Group by_pivots = group;
    INFO("run " << run);
    REQUIRE(solve_by_newton(group));
    REQUIRE(solve_by_pivots(by_pivots.rows, responses(by_pivots), pick(1e-10, 1e-6), by_pivots.motions));
    for (std::size_t i = 0; i < group.motions.size(); ++i) {
      const Motion& one = group.motions[i];
      const Motion& other = by_pivots.motions[i];
      REQUIRE(length(Vec2d(one.velocity) - Vec2d(other.velocity)) < pick(1e-7, 1e-3));
      REQUIRE(std::abs(static_cast<double>(one.spin - other.spin)) < pick(1e-7, 1e-3));
    }
  }
}

TEST_CASE("With friction, what Newton's method settles on obeys Signorini and Coulomb", "[contact newton]") {
  Random random(2);
  int settled = 0;
  constexpr int runs = 400;
  for (int run = 0; run < runs; ++run) {
    Group group = random_group(random, 1 + static_cast<int>(random.below(8)), 10, random.between(0.05, 0.7));
    if (!solve_by_newton(group)) continue;
    ++settled;
    INFO("run " << run);
    REQUIRE(law_broken(group) < pick(1e-7, 1e-4));
  }
  // Bounds that follow the impulses need not settle; nearly all do.
  CHECK(settled > runs * 95 / 100);
}

TEST_CASE("A body a million times heavier than those below it is borne all the same", "[contact newton]") {
  Random random(3);
  for (int run = 0; run < 100; ++run) {
    Group group = random_group(random, 6, 1e6, 0);
    INFO("run " << run);
    REQUIRE(solve_by_newton(group));
    double fastest = 0;
    for (const ContactRow& row : group.rows)
      fastest = std::max(fastest, -static_cast<double>(speed_of(row.term, group.motions)));
    REQUIRE(fastest < pick(1e-6, 2e-3));
  }
}

TEST_CASE("What was found once is found again at once, and not changed", "[contact newton]") {
  Random random(4);
  Group group = random_group(random, 6, 10, 0.4);
  REQUIRE(solve_by_newton(group));
  const Group before = group;
  REQUIRE(solve_by_newton(group));
  for (std::size_t i = 0; i < group.rows.size(); ++i)
    CHECK(group.rows[i].given == Approx(before.rows[i].given).margin(pick(1e-7, 1e-4)));
}

TEST_CASE("Bodies that push only each other keep their momentum", "[contact newton]") {
  Random random(5);
  for (int run = 0; run < 100; ++run) {
    Group group;
    group.motions.emplace_back();
    for (int i = 0; i < 4; ++i) group.motions.push_back(moving(random, random.between(1, 5)));
    for (BodyIndex body = 2; body <= 4; ++body) touch(group, body - 1, body, 0.3, random);
    const double before = momentum_along_x(group);
    if (!solve_by_newton(group)) continue;
    REQUIRE(momentum_along_x(group) == Approx(before).margin(pick(1e-9, 1e-4)));
  }
}

TEST_CASE("A gap that is off takes no impulse, nor does its friction", "[contact newton]") {
  Random random(6);
  Group group = random_group(random, 1, 1, 0.5);
  for (Motion& m : group.motions) m.velocity = m.velocity - Vec2{0, 10};
  for (ContactRow& row : group.rows) row.off = row.kind == RowKind::gap;
  const Group before = group;
  REQUIRE(solve_by_newton(group));
  for (const ContactRow& row : group.rows) CHECK(row.given == 0);
  CHECK(group.motions[1].velocity == before.motions[1].velocity);
}

TEST_CASE("What is squeezed by a body that goes its way is told, and left as it was", "[contact newton]") {
  Group group;
  group.motions.resize(3);
  group.motions[1].inv_mass = 1;
  group.motions[2].velocity = {0, -1};  // presses the one between down
  group.rows.push_back({RowKind::gap, 0, 0, {0, 1, {0, 1}, 0, 0}});
  group.rows.push_back({RowKind::gap, 1, 0, {1, 2, {0, 1}, 0, 0}});
  const Group before = group;
  CHECK_FALSE(solve_by_newton(group));
  CHECK(group.motions[1].velocity == before.motions[1].velocity);
  CHECK(group.rows[0].given == 0);
}

TEST_CASE("A group whose factors would take too long is not begun", "[contact newton]") {
  Random random(7);
  const Group group = random_group(random, 30, 10, 0.5);
  ContactNewton newton;
  CHECK_FALSE(newton.plan(group.rows, group.motions, 100));
  CHECK(newton.plan(group.rows, group.motions, plenty_of_work));
}
