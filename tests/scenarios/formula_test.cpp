#include "scenarios/formula.h"

#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

std::vector<TextPart> parsed(const std::string& text) {
  const auto result = parse_formulas(text);
  REQUIRE(std::holds_alternative<std::vector<TextPart>>(result));
  return std::get<std::vector<TextPart>>(result);
}

}  // namespace

TEST_CASE("Words and formulas take turns at every $") {
  const auto parts = parsed("the depth $d_1$ of two");
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].words == "the depth ");
  CHECK(parts[2].words == " of two");
  REQUIRE(parts[1].formula.size() == 1);
  CHECK(parts[1].formula[0].text == "d");
  CHECK(parts[1].formula[0].subscript[0].text == "1");
}

TEST_CASE("A formula has Greek letters, scripts, vectors and fractions") {
  const auto parts = parsed("$\\alpha^2 \\vec{AB} \\frac{1}{S_P}$");
  const std::vector<FormulaAtom>& atoms = parts.at(0).formula;
  REQUIRE(atoms.size() == 5);
  CHECK(atoms[0].text == "\u03b1");
  CHECK(atoms[0].superscript[0].text == "2");
  CHECK(atoms[2].kind == FormulaAtom::Kind::vector);
  CHECK(atoms[2].inside.size() == 2);
  CHECK(atoms[4].kind == FormulaAtom::Kind::fraction);
  CHECK(atoms[4].below[0].subscript[0].text == "P");
}

TEST_CASE("A text without $ is its words, and a dollar can be written") {
  CHECK(parsed("a_1 ^ {").at(0).words == "a_1 ^ {");
  CHECK(parsed("5 \\$ each").at(0).words == "5 $ each");
  CHECK(parsed("").empty());
}

TEST_CASE("A caption whose formula cannot be read is refused with the line") {
  const auto [formula, problem] = GENERATE(table<std::string, std::string>({
      {"$a", "begins a formula without a $ that ends it"},
      {"$a_$", "ends after _ or ^"},
      {"$_1$", "of nothing"},
      {"$a_1_2$", "two subscripts or superscripts"},
      {"$\\\\frac{1}$", "lacks a { after"},
      {"${a$", "opens a { that is never closed"},
      {"$a}$", "closes a } that was never opened"},
      {"$\\\\alhpa$", "unknown command \"\\alhpa\", did you mean \"\\alpha\"?"},
  }));
  CHECK_THAT(error_of("scenario{}\n\ncaption{text='" + formula + "'}"),
             Catch::StartsWith("scene.lua: line 3: caption: text has a ") && Contains(problem));
}

TEST_CASE("Braces cannot nest without end") {
  const std::string deep(1000, '{');
  CHECK_THAT(std::get<std::string>(parse_formulas("$" + deep + "$")), Contains("more than 20 braces"));
}
