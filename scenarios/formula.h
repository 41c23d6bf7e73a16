#pragma once

/// Formulas in captions: what stands between two $ is read as in TeX, by a few rules.
///
///     a_1  a_{12}  x^2  \frac{a}{b}  \vec{AB}  \alpha ... \omega  \Gamma ... \Omega  \times \cdot \le \ge \ne \sum
///     \infty
///
/// Everything else stands for itself, spaces too, and so do Greek letters and signs that are typed as they are. \$ is a
/// dollar sign, inside formulas and outside.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace proofreel {

/// A piece of a formula, and what is written at its upper and lower right.
struct FormulaAtom {
  enum class Kind : std::uint8_t { text, group, vector, fraction };
  Kind kind = Kind::text;
  std::string text;                 ///< of Kind::text
  std::vector<FormulaAtom> inside;  ///< of the others; of a fraction what is above the line
  std::vector<FormulaAtom> below;   ///< of a fraction
  std::vector<FormulaAtom> subscript;
  std::vector<FormulaAtom> superscript;
};

/// A stretch of a caption: plain words, or a formula.
struct TextPart {
  std::string words;
  std::vector<FormulaAtom> formula;
  bool is_formula = false;
};

/// Parts a text at its $; where that cannot be read, a sentence without a subject: "has a formula that ...".
std::variant<std::vector<TextPart>, std::string> parse_formulas(std::string_view text);

/// The text in letters and signs alone, as subtitles need it: a fraction is (a + b)/c, x squared is x². Sub- and
/// superscripts that Unicode lacks are written a_(AB) and e^(kt); what cannot be read as formulas stays as it is.
std::string plain_text(std::string_view text);

}  // namespace proofreel
