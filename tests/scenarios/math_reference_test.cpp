/// The special functions that reference problems are held against, scenarios/reference/include/math_reference.lua,
/// beside values found in other ways: closed forms where there are any; else computed once with 30 digits or more, how
/// is said at each table.

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>

#include "scene_text.h"

using namespace proofreel;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The value of a Lua expression that may use the special functions.
double exact(const std::string& expression) {
  const ScratchFolder folder;
  folder.write("include/math_reference.lua", text_of("scenarios/reference/include/math_reference.lua"));
  const std::string scene = "scenario{}\ninclude 'include/math_reference.lua'\n";
  const std::string path =
      folder.write("scene.lua", scene + "measure('value', function() return (" + expression + ") end)");
  return load_scenario(path, {})->script->measure(0);
}

constexpr double pi = 3.14159265358979323846;

struct Value {
  const char* expression;
  double value;
};

void check_all(const std::vector<Value>& values, double tolerance) {
  for (const Value& v : values) {
    INFO(v.expression);
    CHECK(std::abs(exact(v.expression) - v.value) <= tolerance);
  }
}

}  // namespace

TEST_CASE("Complete elliptic integrals are those of the circle, the lemniscate and the nearly straight line") {
  check_all(
      {
          {"elliptic_k(0)", pi / 2},
          {"elliptic_k(math.sqrt(0.5))", 1.85407467730137191843},  // Gamma(1/4)^2 / (4 sqrt(pi))
          // ln(4 / k') + (ln(4 / k') - 1) k'^2 / 4 for small k'
          {"elliptic_k(math.sqrt(1 - 1e-12), 1e-6)", 15.2018049190877154},
      },
      1e-13);
}

TEST_CASE("Incomplete elliptic integrals agree with their elementary cases and with the complete ones") {
  check_all(
      {
          {"elliptic_f(0.7, 0)", 0.7},
          {"elliptic_f(-0.7, 0)", -0.7},
          {"elliptic_f(1, 1)", 1.22619117088351707081},  // ln(tan 1 + sec 1)
          {"elliptic_f(math.pi / 2, 0.8) - elliptic_k(0.8)", 0},
          // sn(K / 2) = 1 / sqrt(1 + k')
          {"2 * elliptic_f(math.asin(1 / math.sqrt(1.6)), 0.8) - elliptic_k(0.8)", 0},
      },
      1e-13);
}

TEST_CASE("Jacobi's functions are circular for k = 0, hyperbolic beside k = 1, and know their quarter periods") {
  check_all(
      {
          {"jacobi(0.3, 0)", std::sin(0.3)},
          {"select(2, jacobi(0.3, 0))", std::cos(0.3)},
          {"select(3, jacobi(0.3, 0))", 1},
          {"jacobi(0.3, 1, 1e-9)", std::tanh(0.3)},
          {"jacobi(elliptic_k(0.8), 0.8)", 1},
          {"select(2, jacobi(elliptic_k(0.8), 0.8))", 0},
          {"select(3, jacobi(elliptic_k(0.8), 0.8))", 0.6},
          {"select(4, jacobi(6 * elliptic_k(0.8), 0.8))", 3 * pi},
          {"select(4, jacobi(elliptic_f(1.2, 0.8), 0.8))", 1.2},
      },
      2e-14);
}

/// Periods and angles of a pendulum of 1 m under 9.81 m/s^2 let go at 60, 90 and 179 degrees; of a rod of 1 m from 90
/// degrees. 4 K / omega and sn by Landen's transformation in 40-digit decimals.
TEST_CASE("The large pendulum has the period and the angles it should have") {
  check_all(
      {
          {"pendulum_period(math.rad(60), math.sqrt(9.81))", 2.15287466688051570},
          {"pendulum_period(math.rad(90), math.sqrt(9.81))", 2.36784194757623745},
          {"pendulum_period(math.rad(179), math.sqrt(9.81))", 7.82579683753768270},
          {"pendulum_period(math.rad(90), math.sqrt(1.5 * 9.81))", 1.93333485437324578},
          {"pendulum_at(10, math.rad(60), math.sqrt(9.81))", -0.651863046741975928},
          {"select(2, pendulum_at(10, math.rad(60), math.sqrt(9.81)))", 2.40562168033656533},
          {"pendulum_at(1, math.rad(90), math.sqrt(9.81))", -1.40502731152479915},
          {"select(2, pendulum_at(1, math.rad(90), math.sqrt(9.81)))", -1.79930901690707862},
          {"pendulum_at(100, math.rad(90), math.sqrt(9.81))", 0.182525148495790851},
          {"pendulum_at(10, math.rad(179), math.sqrt(9.81))", -1.26909916274281747},
          {"pendulum_at(10, math.rad(90), math.sqrt(1.5 * 9.81))", 0.770957622574773133},
      },
      1e-12);
}

/// A phase of six thousand radians leaves twelve digits of an angle.
TEST_CASE("After half an hour the pendulum's angle is still known") {
  CHECK(std::abs(exact("pendulum_at(2000, math.rad(90), math.sqrt(9.81))") + 0.952044523415683197) <= 5e-12);
}

/// A block of 0.2 m by 0.8 m tilted by half of alpha = atan(1/4) falls back in the integral of 1 / spin over the angle:
/// tanh-sinh quadrature, whose halving changes it by 3e-27.
TEST_CASE("An upside-down pendulum falls in the time that quadrature gives") {
  const char* fall = R"((function()
    local alpha = math.atan(0.25)
    local k, k1 = math.cos(alpha / 4), math.sin(alpha / 4)
    local p = math.sqrt(3 * 9.81 / (4 * math.sqrt(0.17)))
    return (elliptic_k(k, k1) - elliptic_f(math.asin(math.cos(alpha / 2) / k), k, k1)) / p
  end)())";
  CHECK(std::abs(exact(fall) - 0.3123085751126223) <= 1e-12);
}

/// Kepler's equation for e = 0.6, half axis and attraction 1, by Newton's method in 40-digit decimals.
TEST_CASE("The Kepler orbit is where it should be after one turn and a half, and after sixteen") {
  check_all(
      {
          {"kepler_at(0, 0.6)", 0.4},
          {"select(4, kepler_at(0, 0.6))", 2},
          {"kepler_at(10, 0.6)", -1.53502359190981369},
          {"select(2, kepler_at(10, 0.6))", -0.283668406499780862},
          {"select(3, kepler_at(10, 0.6))", 0.227150732077498338},
          {"select(4, kepler_at(10, 0.6))", -0.479187758203219565},
          {"kepler_at(100, 0.6)", -0.104183204434180605},
          {"select(2, kepler_at(100, 0.6))", -0.694741715567950599},
          {"select(3, kepler_at(100, 0.6))", 1.23617776268707632},
          {"select(4, kepler_at(100, 0.6))", 0.564623251085864574},
      },
      1e-12);
}

TEST_CASE("Straight ways fold at both ends") {
  check_all({{"folded(3, 10)", 3}, {"folded(13, 10)", 7}, {"folded(-1, 10)", 1}, {"folded(371, 10)", 9}}, 0);
}

TEST_CASE("A root is found to the last digit") {
  CHECK(exact("root_between(function(x) return x * x - 2 end, 0, 2)") == Approx(std::sqrt(2.0)).epsilon(1e-15));
}
