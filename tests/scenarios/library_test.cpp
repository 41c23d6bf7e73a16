#include <bit>
#include <catch2/catch.hpp>
#include <cstdio>

#include "engine/elementary.h"
#include "scene_text.h"

using namespace proofreel;

namespace {

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

TEST_CASE("The power operator is our own function, at run time and in folded constants") {
  const double x = GENERATE(0.1, 1.7, 2.0, 123.456, 1e-300, 7e250);
  const double y = GENERATE(0.5, -0.5, 3.0, 1.0 / 3, -7.25, 100.0);
  const double expected = elementary::pow(x, y);
  if (!std::isfinite(expected)) return;
  const std::string preamble = "local x, y = " + hex(x) + ", " + hex(y);
  CHECK(same_bits(value_of("x ^ y", preamble), expected));
  CHECK(same_bits(value_of(hex(x) + " ^ " + hex(y)), expected));
  CHECK(same_bits(value_of("('" + hex(x) + "') ^ y", preamble), expected));
  CHECK(is_true("string.format('%a', x ^ y) == '" + hex(expected) + "'", preamble));
}

TEST_CASE("A square is the product") { CHECK(same_bits(value_of("x ^ 2", "local x = 0.1"), 0.1 * 0.1)); }

TEST_CASE("Elementary functions are our own") {
  const double x = GENERATE(0.3, -0.7, 0.99999);
  const std::string preamble = "local x = " + hex(x);
  CHECK(same_bits(value_of("math.sin(x)", preamble), elementary::sin(x)));
  CHECK(same_bits(value_of("math.cos(x)", preamble), elementary::cos(x)));
  CHECK(same_bits(value_of("math.tan(x)", preamble), elementary::tan(x)));
  CHECK(same_bits(value_of("math.asin(x)", preamble), elementary::asin(x)));
  CHECK(same_bits(value_of("math.acos(x)", preamble), elementary::acos(x)));
  CHECK(same_bits(value_of("math.atan(x)", preamble), elementary::atan(x)));
  CHECK(same_bits(value_of("math.atan(x, -2)", preamble), elementary::atan2(x, -2)));
  CHECK(same_bits(value_of("math.exp(x)", preamble), elementary::exp(x)));
  CHECK(same_bits(value_of("math.log(x * x)", preamble), elementary::log(x * x)));
  CHECK(same_bits(value_of("math.log(x * x, 3)", preamble), elementary::log(x * x) / elementary::log(3)));
}

TEST_CASE("Logarithms to the bases 2 and 10 are exact where they can be") {
  CHECK(value_of("math.log(8, 2)") == 3);
  CHECK(value_of("math.log(1000, 10)") == 3);
}

TEST_CASE("The same seed gives the same random numbers, those committed here") {
  const std::string draw = "local a, b, c, d = math.random(), math.random(), math.random(10), math.random(-5, 5)";
  CHECK(is_true("a == 0x1.67e55eda1f8e2p-1 and b == 0x1.0a76ab2c8e6c9p-1 and c == 5 and d == 2", draw));
  const auto scenario = load_text("scenario{seed=2}\nlocal a = math.random()\nmeasure('a', function() return a end)");
  CHECK(scenario->script->measure(0) != value_of("a", draw));
}

TEST_CASE("Random numbers keep to their interval, and to whole numbers") {
  CHECK(is_true("ok", R"(
    ok = true
    for i = 1, 1000 do
      local u, k, z = math.random(), math.random(6), math.random(-2, 2)
      ok = ok and u >= 0 and u < 1 and k >= 1 and k <= 6 and z >= -2 and z <= 2
      ok = ok and math.type(k) == 'integer' and math.type(z) == 'integer'
    end)"));
  CHECK(is_true("math.random(4, 4) == 4 and math.type(math.random(0)) == 'integer'"));
  CHECK_THAT(error_of("scenario{}\nmath.random(2, 1)"), Catch::Contains("interval is empty"));
  CHECK_THAT(error_of("scenario{}\nmath.randomseed(3)"), Catch::Contains("set seed= in scenario"));
  CHECK_THAT(error_of("math.random()\nscenario{}"), Catch::Contains("call scenario{...} first"));
}

TEST_CASE("Measures cannot move the random numbers on") {
  CHECK_THAT(error_of("scenario{}\nmeasure('m', function() return math.random() end)"),
             Catch::Contains("math.random") && Catch::Contains("may only look"));
}

TEST_CASE("pairs goes through numbers, strings, booleans and handles in order") {
  CHECK(is_true("order == '-3 1 1.5 2 10 A a aa b false true '", R"(
    order = ''
    local t = {b=1, a=1, [10]=1, [2]=1, [1]=1, [-3]=1, [1.5]=1, A=1, aa=1, [true]=1, [false]=1}
    for k in pairs(t) do order = order .. tostring(k) .. ' ' end)"));
  CHECK(is_true("order == '213'", R"(
    local a, b, c = body{shape=circle{radius=1}}, body{shape=circle{radius=1}}, body{shape=circle{radius=1}}
    local t = {[b]='1', [a]='2', [c]='3'}
    order = ''
    for k, v in pairs(t) do order = order .. v end)"));
}

TEST_CASE("pairs compares whole and broken numbers exactly") {
  CHECK(is_true("order == 'abcd'", R"(
    order = ''
    local t = {[math.maxinteger] = 'c', [0x1p63] = 'd', [math.mininteger] = 'b', [-0x1p70] = 'a'}
    for k, v in pairs(t) do order = order .. v end)"));
}

TEST_CASE("pairs allows assigning to and removing what is there") {
  CHECK(is_true("t.a == 2 and t.b == nil and t.c == 6 and seen == 'ac'", R"(
    t, seen = {a=1, b=2, c=3}, ''
    for k, v in pairs(t) do
      seen = seen .. k
      t[k], t.b = v * 2, nil
    end)"));
}

TEST_CASE("pairs refuses keys that have no order") {
  CHECK_THAT(error_of("scenario{}\nfor k in pairs{[{}]=1, [{}]=2} do end"),
             Catch::Contains("line 2: pairs: the order"));
  CHECK(error_of("scenario{}\nfor k in pairs{[{}]=1} do end").empty());
  CHECK_THAT(error_of("scenario{}\nfor k in pairs(nil) do end"), Catch::Contains("pairs needs a table, got nothing"));
}

TEST_CASE("Sorting is stable and takes any consistent order") {
  CHECK(is_true("table.concat(t, ' ') == '1 2 3 5 8 9'", "t = {5, 2, 8, 1, 9, 3}\ntable.sort(t)"));
  CHECK(
      is_true("table.concat(t) == 'dcba'", "t = {'b', 'd', 'a', 'c'}\ntable.sort(t, function(a, b) return a > b end)"));
  CHECK(is_true("ok", R"(
    local t = {}
    for i = 1, 300 do t[i] = {key = i % 7, place = i} end
    table.sort(t, function(a, b) return a.key < b.key end)
    ok = #t == 300
    for i = 2, #t do
      local a, b = t[i - 1], t[i]
      ok = ok and (a.key < b.key or (a.key == b.key and a.place < b.place))
    end)"));
  CHECK_THAT(error_of("scenario{}\ntable.sort{1, 'a'}"), Catch::Contains("attempt to compare"));
}

TEST_CASE("The rest of the table library works as Lua has it") {
  CHECK(is_true("table.concat(t, ',') == '0,1,2,3'", "t = {1, 2}\ntable.insert(t, 3)\ntable.insert(t, 1, 0)"));
  CHECK(is_true("table.remove(t) == 3 and table.remove(t, 1) == 1 and #t == 1", "t = {1, 2, 3}"));
  CHECK(is_true("table.concat(table.move({1, 2, 3}, 1, 3, 2)) == '1123'"));
  CHECK(is_true("select('#', table.unpack({1, 2, 3})) == 3 and table.pack(1, nil, 3).n == 3"));
  CHECK_THAT(error_of("scenario{}\ntable.insert(nil, 1)"),
             Catch::Contains("line 2: bad argument #1 to 'table.insert'"));
}

TEST_CASE("What differs between machines is refused by name") {
  CHECK_THAT(error_of("scenario{}\nstring.pack('l', 1)"), Catch::Contains("results differ between machines"));
}
