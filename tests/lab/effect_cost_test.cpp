#include "lab/effect_cost.h"

#include <catch2/catch.hpp>

namespace proofreel {
namespace {

TEST_CASE("Bodies under gravity cost at most two percent more than a loop written by hand", "[lab]") {
  REQUIRE(effect_cost("gravity") <= 1.02 * effect_cost("by hand"));
}

TEST_CASE("Gravity that is off costs nothing, and wind nothing beside drag", "[lab]") {
  REQUIRE(effect_cost("nothing") < effect_cost("gravity"));
  REQUIRE(effect_cost("wind") == effect_cost("drag"));
}

TEST_CASE("Friction and restitution are paid for only where they are called for", "[lab]") {
  const double contacts = effect_cost("contacts");
  REQUIRE(contacts < effect_cost("friction"));
  REQUIRE(contacts < effect_cost("restitution"));
}

}  // namespace
}  // namespace proofreel
