#include "lab/child.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>

#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

constexpr double plenty_s = 10;

TEST_CASE("Work in a child comes back as bytes, however many", "[child]") {
  const std::string bytes = std::string(300000, 'x') + '\0' + "end";
  REQUIRE(Child([&] { return bytes; }, plenty_s).end().answer == bytes);
}

TEST_CASE("What a child changes is changed in the child alone", "[child]") {
  int value = 1;
  const ChildEnd end = Child([&] { return std::to_string(++value); }, plenty_s).end();
  REQUIRE(end.answer == "2");
  REQUIRE(value == 1);
}

TEST_CASE("Work that does not end is stopped at its limit of CPU time", "[child]") {
  const auto endless = []() -> std::string {
    volatile bool on = true;
    while (on) {
    }
    return {};
  };
  const ChildEnd end = Child(endless, 0.5).end();
  REQUIRE(end.out_of_time);
  REQUIRE(end.answer.empty());
}

TEST_CASE("Work that crashes says what it died of, with its last words", "[child]") {
  const auto crash = []() -> std::string {
    std::fputs("first line\nthe spring broke\n", stderr);
    std::abort();
  };
  const ChildEnd end = Child(crash, plenty_s).end();
  REQUIRE_THAT(end.died_of, Contains("Aborted") && Contains(": the spring broke"));
}

TEST_CASE("Errors of the work are errors of who asked for it", "[child]") {
  const auto no_disk = []() -> std::string { throw EnvironmentError("no disk"); };
  REQUIRE_THROWS_AS(Child(no_disk, plenty_s).end(), EnvironmentError);
  const auto odd = []() -> std::string { throw std::logic_error("odd"); };
  REQUIRE_THROWS_WITH(Child(odd, plenty_s).end(), "odd");
}

}  // namespace
}  // namespace proofreel
