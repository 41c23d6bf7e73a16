#include "golden/state_change.h"

#include <catch2/catch.hpp>

namespace proofreel {
namespace {

GoldenFrame then_with(const std::vector<BodyPose>& bodies, const std::vector<Touch>& touching = {}) {
  GoldenFrame frame{0, "", "", "", "", bodies};
  frame.touching = touching;
  return frame;
}

ObservedFrame now_with(const std::vector<BodyPose>& bodies, const std::vector<Touch>& touching = {}) {
  return {0, "", {}, bodies, "", touching};
}

std::string sentence(const GoldenFrame& then, const ObservedFrame& now) {
  BodyNames names;
  names.add(now.bodies);
  names.add(then.bodies);
  return sentence_about(change_between(then, now), names);
}

const BodyPose a{1, "a", 0, 0, 0}, b{2, "b", 5, 0, 0}, c{3, "c", 9, 0, 0};

TEST_CASE("The body that moved farthest is told, with its turn in degrees and how many moved", "[state_change]") {
  CHECK(sentence(then_with({a, b, c}), now_with({{1, "a", 0.3, 0.4, 0}, b, c})) == "a moved 0.5 m");
  CHECK(sentence(then_with({a, b, c}), now_with({a, {2, "b", 5, 0, -0.2}, c})) == "b turned 11 deg");
  CHECK(sentence(then_with({a, b, c}), now_with({{1, "a", 0.1, 0, 0}, b, {3, "c", 9, 150, 3.14159265}})) ==
        "c moved 150 m, turned 180 deg, the farthest of 2 bodies");
  CHECK(sentence(then_with({a}), now_with({{1, "a", 0.3, 0.4, 1e-9}})) == "a moved 0.5 m");
  CHECK(sentence(then_with({a}), now_with({{1, "a", 0, 0, 1e-9}})) == "a turned 5.7e-08 deg");
}

TEST_CASE("Bodies that came and went, and contacts that did, are named; of many, three", "[state_change]") {
  CHECK(sentence(then_with({a, b}), now_with({b, c})) == "a is gone; c is new");
  CHECK(sentence(then_with({a, b}, {{1, 2}}), now_with({a, b})) == "contact a - b gone");
  CHECK(sentence(then_with({a, b, c}, {{1, 2}, {1, 3}}), now_with({a, b, c}, {{1, 3}, {2, 3}})) ==
        "contact a - b gone; contact b - c new");
  std::vector<BodyPose> many;
  for (std::uint32_t i = 1; i <= 9; ++i) many.push_back({i, "", 0, 0, 0});
  CHECK(sentence(then_with(many), now_with({})) == "body 1, body 2, body 3 and 6 more are gone");
}

TEST_CASE("Contacts that were not kept are not said to be new", "[state_change]") {
  GoldenFrame then = then_with({a, b});
  then.touching.reset();
  CHECK(change_between(then, now_with({a, b}, {{1, 2}})).met.empty());
}

TEST_CASE("When no body stands elsewhere it is said to be the velocities or the way", "[state_change]") {
  CHECK(sentence(then_with({a}), now_with({a})).find("velocities") != std::string::npos);
}

TEST_CASE("A name that two bodies share is told with the number", "[state_change]") {
  BodyNames names;
  names.add({{1, "ball", 0, 0, 0}, {2, "ball", 0, 0, 0}, {3, "box", 0, 0, 0}, {4, "", 0, 0, 0}});
  names.add({{1, "ball", 0, 0, 0}});
  CHECK(names.of(1) == "ball (body 1)");
  CHECK(names.of(3) == "box");
  CHECK(names.of(4) == "body 4");
  CHECK(names.of(9) == "body 9");
  CHECK(names.of(0) == "the world");
}

TEST_CASE("What became of one body", "[state_change]") {
  const StateChange change = change_between(then_with({a, b}), now_with({{2, "b", 5, 2, 0}, c}));
  CHECK(change.fate_of(1) == "gone");
  CHECK(change.fate_of(2) == "moved 2 m");
  CHECK(change.fate_of(3) == "new");
  CHECK(change.fate_of(4).empty());
}

}  // namespace
}  // namespace proofreel
