#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

void check_unbuilt(const std::string& line, const std::string& name) {
  const std::string text = "scenario{}\nlocal b = body{shape=circle{radius=1}}\n" + line;
  INFO(line);
  CHECK_THAT(error_of(text), StartsWith("scene.lua: line 3: ") &&
                                 Contains("\"" + name + "\" is part of the language but not built yet"));
}

}  // namespace

TEST_CASE("Words that are not built are refused by name") {
  const std::string word = GENERATE("on_sleep", "ghost", "freeze", "section");
  check_unbuilt(word + "{b}", word);
}

TEST_CASE("Methods of bodies that are not built are refused by name") {
  check_unbuilt("b:wake()", "wake");
  check_unbuilt("b:asleep()", "asleep");
}

TEST_CASE("Ways of solving and effects that are not built are refused by name") {
  const auto [key, name] = GENERATE(table<std::string, std::string>({
      {"method={contact_solver='sequential_impulses'}", "sequential_impulses"},
      {"method={contact_solver='ngs'}", "ngs"},
      {"method={contact_solver='exact'}", "exact"},
      {"method={contact_solver='event'}", "event"},
      {"method={joint_solver='iterative'}", "iterative"},
      {"effects={'sleeping'}", "sleeping"},
  }));
  CHECK_THAT(
      error_of("scenario{" + key + "}"),
      StartsWith("scene.lua: line 1: ") && Contains("\"" + name + "\" is part of the language but not built yet"));
}
