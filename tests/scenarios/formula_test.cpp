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

TEST_CASE("Formulas as plain text are Unicode where it has signs, and brackets where it has none") {
  CHECK(plain_text("speed $v_0$ and $x^2$") == "speed v\u2080 and x\u00b2");
  CHECK(plain_text("$\\frac{J}{m}$, $\\frac{a + b}{2 c}$, $\\frac{10}{25}$") == "J/m, (a + b)/(2 c), 10/25");
  CHECK(plain_text("$\\frac{\\frac{a}{b}}{c}$") == "(a/b)/c");
  CHECK(plain_text("$a_{12}$ $m_i$ $F_A$ $F_{AB}$") == "a\u2081\u2082 m\u1d62 F_A F_(AB)");
  CHECK(plain_text("$e^{-kt}$ $2^{10}$ $r^{x_1}$") == "e^(-kt) 2\u00b9\u2070 r^x\u2081");
  CHECK(plain_text("$\\vec{v} = \\omega \\times \\vec{AB}$") == "v\u20d7 = \u03c9 \u00d7 AB\u20d7");
  CHECK(plain_text("5 \\$ and no formula") == "5 $ and no formula");
  CHECK(plain_text("a $ alone") == "a $ alone");
  CHECK(plain_text("").empty());
}
