#include "scenarios/suggest.h"

#include <catch2/catch.hpp>

using namespace proofreel;

TEST_CASE("Distances count insertions, removals, changes and swaps") {
  CHECK(edit_distance("friction", "friction") == 0);
  CHECK(edit_distance("frcition", "friction") == 1);
  CHECK(edit_distance("fricton", "friction") == 1);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("mass", "mask") == 1);
}

TEST_CASE("Only names that can be meant are suggested") {
  const std::vector<std::string> names{"friction", "mass", "at"};
  CHECK(nearest("frction", names) == "friction");
  CHECK(nearest("zzzzzz", names).empty());
  CHECK(nearest("b", names).empty());
  CHECK(did_you_mean("maß", names) == "did you mean \"mass\"?");
  CHECK(did_you_mean("zzzzzz", names) == "known are \"friction\", \"mass\", \"at\"");
}

TEST_CASE("Quoted text is cut and keeps to one line") {
  CHECK(quote("a\nb") == "\"a b\"");
  CHECK(quote(std::string(500, 'x')).size() < 100);
}
