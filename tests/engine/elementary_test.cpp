#include "engine/elementary.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

using Function = double (*)(double);
using Oracle = long double (*)(long double);
using Inputs = double (*)(Random&);

double any(Random& random) { return random.any_double(); }
double any_positive(Random& random) { return std::fabs(random.any_double()); }
double near_one(Random& random) { return 1 + random.of_size(-52, -1); }
double subnormal(Random& random) { return random.between(0, 0x1p-1022); }
double unit(Random& random) { return random.between(-1, 1); }
double below_one(Random& random) { return 1 - std::fabs(random.of_size(-53, 0)); }
double tiny_to_one(Random& random) { return random.of_size(-60, 0); }
double angle(Random& random) { return random.between(-7, 7); }
double large_angle(Random& random) { return random.between(-2e6, 2e6); }
double near_quarter_turns(Random& random) { return std::nextafter(1.5707963267948966 * random.below(700000), inf); }
double exponent(Random& random) { return random.between(-746, 710); }
double ordinary(Random& random) { return random.of_size(-80, 80); }

struct Sweep {
  std::string name;
  Function function;
  Oracle oracle;
  std::vector<Inputs> inputs;
};

const std::vector<Sweep>& sweeps() {
  static const std::vector<Sweep> all = {
      {"sin", elementary::sin, std::sin, {any, angle, large_angle, near_quarter_turns, tiny_to_one}},
      {"cos", elementary::cos, std::cos, {any, angle, large_angle, near_quarter_turns, tiny_to_one}},
      {"tan", elementary::tan, std::tan, {any, angle, large_angle, near_quarter_turns, tiny_to_one}},
      {"asin", elementary::asin, std::asin, {unit, below_one, tiny_to_one}},
      {"acos", elementary::acos, std::acos, {unit, below_one, tiny_to_one}},
      {"atan", elementary::atan, std::atan, {any, angle, ordinary}},
      {"exp", elementary::exp, std::exp, {any, unit, exponent, tiny_to_one}},
      {"log", elementary::log, std::log, {any_positive, near_one, subnormal}},
      {"log2", elementary::log2, std::log2, {any_positive, near_one, subnormal}},
      {"log10", elementary::log10, std::log10, {any_positive, near_one, subnormal}},
  };
  return all;
}

/// The error in units of the last place of the exact value.
double error_in_ulp(double value, long double exact) {
  const auto rounded = static_cast<double>(exact);
  if (value == rounded) return 0;
  if (!std::isfinite(value) || std::isnan(rounded)) return inf;
  int e = 0;
  std::frexp(std::fmin(std::fabs(rounded), largest), &e);
  return static_cast<double>(std::fabs(value - exact) / std::ldexp(1.0L, (e < -1021 ? -1021 : e) - 53));
}

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

struct Power {
  double x;
  double y;
};

/// All kinds of powers: everyday ones, any bits at all, results over the whole range, subnormal results, bases near 1.
Power random_power(Random& random, int kind) {
  if (kind == 0) return {random.between(0, 10), random.between(-10, 10)};
  if (kind == 1) return {any_positive(random), random.any_double()};
  const double x = kind == 2 ? near_one(random) : any_positive(random);
  const double range = kind == 3 ? random.between(-746, -707) : random.between(-746, 711);
  return {x, range / elementary::log(x)};
}

Power random_vector(Random& random, int kind) {
  if (kind == 0) return {random.between(-1, 1), random.between(-1, 1)};
  if (kind == 1) return {random.any_double(), random.any_double()};
  const double y = random.of_size(-80, 80);
  return {y, y * random.of_size(-70, 70)};
}

/// FNV-1a over the bits of results.
struct Checksum {
  std::uint64_t value = 0xcbf29ce484222325U;
  void add(double result) {
    const auto bits = std::bit_cast<std::uint64_t>(result);
    for (unsigned shift = 0; shift < 64; shift += 8) value = (value ^ (bits >> shift & 0xffU)) * 0x100000001b3U;
  }
};

std::uint64_t checksum_of(const Sweep& sweep) {
  Random random(99);
  Checksum sum;
  for (int i = 0; i < 100000; ++i) {
    sum.add(sweep.function(sweep.inputs[static_cast<std::size_t>(i) % sweep.inputs.size()](random)));
  }
  return sum.value;
}

#if LDBL_MANT_DIG >= 64  // elsewhere long double is no better than what it should judge
TEST_CASE("Every elementary function of one number is within 0.7 ulp of the exact value") {
  for (const Sweep& sweep : sweeps()) {
    for (std::size_t kind = 0; kind < sweep.inputs.size(); ++kind) {
      Random random(kind + 1);
      double worst = 0;
      double worst_x = 0;
      for (int i = 0; i < 60000; ++i) {
        const double x = sweep.inputs[kind](random);
        const double error = error_in_ulp(sweep.function(x), sweep.oracle(x));
        if (error > worst) {
          worst = error;
          worst_x = x;
        }
      }
      CAPTURE(sweep.name, kind, worst_x);
      CHECK(worst <= 0.7);
    }
  }
}

TEST_CASE("Powers are within 0.6 ulp over the whole range, subnormal results included") {
  Random random(5);
  for (int i = 0; i < 300000; ++i) {
    const Power p = random_power(random, i % 5);
    const double error = error_in_ulp(elementary::pow(p.x, p.y), std::pow<long double, long double>(p.x, p.y));
    if (error > 0.6) {
      CAPTURE(p.x, p.y);
      CHECK(error <= 0.6);
    }
  }
}

TEST_CASE("The angle of a vector is within 0.6 ulp in every quadrant and at every scale") {
  Random random(6);
  for (int i = 0; i < 300000; ++i) {
    const Power v = random_vector(random, i % 3);
    const double error = error_in_ulp(elementary::atan2(v.y, v.x), std::atan2<long double, long double>(v.y, v.x));
    if (error > 0.6) {
      CAPTURE(v.x, v.y);
      CHECK(error <= 0.6);
    }
  }
}
#endif

TEST_CASE("Elementary functions give the same bits with every compiler and optimisation level") {
  const std::vector<std::uint64_t> expected = {
      0x9f9dbbad0e6e1207U, 0x5106f428279bac5fU, 0x1cb86954f3c4fa7bU, 0xb8cabf3a48f4d134U, 0xaf827933736e8a21U,
      0x3a93d2e85054dad7U, 0xe913aba9ad602b61U, 0xc567d3b0905cbcafU, 0xe98ba4b1baf530c3U, 0x6d84f557dd3ef4f6U};
  REQUIRE(expected.size() == sweeps().size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(sweeps()[i].name);
    CHECK(checksum_of(sweeps()[i]) == expected[i]);
  }
}

TEST_CASE("Powers and angles of vectors give the same bits with every compiler and optimisation level") {
  Random random(98);
  Checksum powers;
  Checksum angles;
  for (int i = 0; i < 100000; ++i) {
    const Power p = random_power(random, i % 5);
    powers.add(elementary::pow(p.x, p.y));
    const Power v = random_vector(random, i % 3);
    angles.add(elementary::atan2(v.y, v.x));
  }
  CHECK(powers.value == 0x709fdffd7bcee90U);
  CHECK(angles.value == 0x923cddff94064b59U);
}

TEST_CASE("Sine, cosine and tangent are right at arguments where the reduction is hardest") {
  CHECK(same(elementary::sin(3.141592653589793), 0x1.1a62633145c07p-53));
  CHECK(same(elementary::cos(1.5707963267948966), 0x1.1a62633145c07p-54));
  CHECK(same(elementary::cos(0x1.6ac5b262ca1ffp+849), -0x1.14ae72e6ba22fp-61));  // the double nearest to an odd pi/2
  CHECK(same(elementary::sin(0x1.6ac5b262ca1ffp+849), 1));
  CHECK(same(elementary::sin(largest), 0x1.452fc98b34e97p-8));
  CHECK(same(elementary::cos(largest), -0x1.fffe62ecfab75p-1));
}

TEST_CASE("Odd functions keep the sign of zero and pass the smallest numbers through") {
  for (const Function f : {elementary::sin, elementary::tan, elementary::asin, elementary::atan}) {
    CHECK(same(f(0.0), 0.0));
    CHECK(same(f(-0.0), -0.0));
    CHECK(same(f(-smallest), -smallest));
    CHECK(same(f(0x1p-1022), 0x1p-1022));
  }
}

TEST_CASE("What has no value is not a number, always with the same bits") {
  for (const Function f : {elementary::sin, elementary::cos, elementary::tan}) {
    CHECK(same(f(inf), nan));
    CHECK(same(f(-inf), nan));
  }
  for (const Function f : {elementary::asin, elementary::acos}) {
    CHECK(same(f(1.0000000000000002), nan));
    CHECK(same(f(-inf), nan));
  }
  for (const Function f : {elementary::log, elementary::log2, elementary::log10}) {
    CHECK(same(f(-smallest), nan));
    CHECK(same(f(-inf), nan));
  }
  for (const Sweep& sweep : sweeps()) {
    CAPTURE(sweep.name);
    CHECK(same(sweep.function(-nan), nan));
  }
  CHECK(same(elementary::atan2(nan, 1), nan));
  CHECK(same(elementary::atan2(inf, nan), nan));
}

TEST_CASE("Exponential and logarithms reach the ends of the range") {
  CHECK(same(elementary::exp(inf), inf));
  CHECK(same(elementary::exp(-inf), 0.0));
  CHECK(same(elementary::exp(0.0), 1.0));
  CHECK(same(elementary::exp(-0.0), 1.0));
  CHECK(same(elementary::exp(0x1.62e42fefa39efp+9), 0x1.fffffffffff2ap+1023));
  CHECK(same(elementary::exp(0x1.62e42fefa39f0p+9), inf));
  CHECK(same(elementary::exp(-0x1.74910d52d3051p+9), smallest));
  CHECK(same(elementary::exp(-0x1.74910d52d3052p+9), 0.0));
  for (const Function f : {elementary::log, elementary::log2, elementary::log10}) {
    CHECK(same(f(0.0), -inf));
    CHECK(same(f(-0.0), -inf));
    CHECK(same(f(inf), inf));
    CHECK(same(f(1.0), 0.0));
  }
}

TEST_CASE("Inverse trigonometric functions hit the ends of their range") {
  const double pi = 3.141592653589793;
  CHECK(same(elementary::asin(1), pi / 2));
  CHECK(same(elementary::asin(-1), -pi / 2));
  CHECK(same(elementary::acos(1), 0.0));
  CHECK(same(elementary::acos(-1), pi));
  CHECK(same(elementary::acos(0), pi / 2));
  CHECK(same(elementary::atan(inf), pi / 2));
  CHECK(same(elementary::atan(-inf), -pi / 2));
  CHECK(same(elementary::atan(1), pi / 4));
}

TEST_CASE("The angle of a vector on an axis or at infinity is exact, with the sign of its height") {
  const double pi = 3.141592653589793;
  struct Row {
    double y, x, expected;
  };
  const std::vector<Row> rows = {{0, 1, 0},
                                 {0, 0, 0},
                                 {0, -0.0, pi},
                                 {0, -1, pi},
                                 {1, 0, pi / 2},
                                 {1, -0.0, pi / 2},
                                 {inf, 1, pi / 2},
                                 {inf, -1, pi / 2},
                                 {1, inf, 0},
                                 {1, -inf, pi},
                                 {0, inf, 0},
                                 {0, -inf, pi},
                                 {inf, inf, pi / 4},
                                 {3, 3, pi / 4},
                                 {3, -3, pi / 4 * 3},
                                 {inf, -inf, pi / 4 * 3},
                                 {inf, 0, pi / 2},
                                 {smallest, largest, 0},
                                 {largest, smallest, pi / 2},
                                 {smallest, -largest, pi},
                                 {smallest, smallest, pi / 4},
                                 {largest, largest, pi / 4}};
  for (const Row& row : rows) {
    CAPTURE(row.y, row.x);
    CHECK(same(elementary::atan2(row.y, row.x), row.expected));
    CHECK(same(elementary::atan2(-row.y, row.x), -row.expected));
  }
}

TEST_CASE("Powers follow C99 annex F where an argument is zero, infinite or not a number") {
  struct Row {
    double x, y, expected;
  };
  const std::vector<Row> rows = {{0, 3, 0},
                                 {-0.0, 3, -0.0},
                                 {-0.0, 2, 0},
                                 {-0.0, 0.5, 0},
                                 {0, -1, inf},
                                 {-0.0, -1, -inf},
                                 {-0.0, -2, inf},
                                 {0, -inf, inf},
                                 {0, inf, 0},
                                 {-1, inf, 1},
                                 {-1, -inf, 1},
                                 {1, nan, 1},
                                 {nan, 0, 1},
                                 {nan, -0.0, 1},
                                 {nan, 1, nan},
                                 {2, nan, nan},
                                 {0.5, inf, 0},
                                 {-0.5, -inf, inf},
                                 {2, inf, inf},
                                 {-2, -inf, 0},
                                 {-inf, -3, -0.0},
                                 {-inf, -2, 0},
                                 {-inf, 3, -inf},
                                 {-inf, 2.5, inf},
                                 {inf, -1, 0},
                                 {inf, 0.1, inf},
                                 {-8, 1.0 / 3, nan},
                                 {-2, 3, -8},
                                 {-2, -2, 0.25},
                                 {-1, 0x1p53, 1},
                                 {-1, 0x1p53 - 1, -1},
                                 {1, 1e300, 1},
                                 {-inf, 0, 1},
                                 {1.5, 1e300, inf},
                                 {0.5, 1e300, 0},
                                 {-1.5, 1e300, inf},
                                 {0x1.fffffffffffffp-1, 0x1p63, 0},
                                 {-3, 1023, -inf},
                                 {-3, -1023, -0.0},
                                 {7, smallest, 1},
                                 {largest, -smallest, 1}};
  for (const Row& row : rows) {
    CAPTURE(row.x, row.y);
    CHECK(same(elementary::pow(row.x, row.y), row.expected));
  }
}

TEST_CASE("Powers that are doubles come out exactly") {
  for (int n = -1074; n <= 1023; ++n) {
    CHECK(elementary::pow(2, n) == std::ldexp(1.0, n));
    CHECK(elementary::log2(std::ldexp(1.0, n)) == n);
  }
  double power_of_ten = 1;
  for (int n = 0; n <= 22; ++n, power_of_ten *= 10) {
    CHECK(elementary::pow(10, n) == power_of_ten);
    CHECK(elementary::log10(power_of_ten) == n);
  }
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.any_double();
    const double whole = random.below(1U << 26);
    REQUIRE(same(elementary::pow(x, 1), x));
    REQUIRE(same(elementary::pow(x, 2), x * x));
    REQUIRE(elementary::pow(whole * whole, 0.5) == whole);
    const double small = random.below(1U << 17);
    REQUIRE(elementary::pow(-small, 3) == -small * small * small);
  }
}

TEST_CASE("Sine and cosine lie on the unit circle and give their angle back") {
  Random random(8);
  for (int i = 0; i < 20000; ++i) {
    const double a = random.between(-3.14, 3.14);
    const double s = elementary::sin(a);
    const double c = elementary::cos(a);
    REQUIRE(std::fabs(s * s + c * c - 1) < 4e-16);
    REQUIRE(elementary::atan2(s, c) == Approx(a).epsilon(0).margin(3e-16));
    REQUIRE(elementary::tan(a) == Approx(s / c).epsilon(4e-16));
    REQUIRE(elementary::asin(s) + elementary::acos(s) == Approx(1.5707963267948966).epsilon(4e-16));
  }
}

TEST_CASE("Logarithm undoes exponential") {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.between(-700, 700);
    REQUIRE(elementary::log(elementary::exp(x)) == Approx(x).epsilon(3e-16).margin(3e-16));
  }
}

}  // namespace
}  // namespace proofreel
