#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "scenarios/formula.h"

namespace proofreel {
namespace {

using Atoms = std::vector<FormulaAtom>;
using Sign = std::pair<std::string_view, std::string_view>;

constexpr std::string_view arrow_above = "\u20d7";  // combines with the letter before it

// What fonts of players have; of raised letters that is little.
constexpr std::array<Sign, 35> lowered{
    {{"0", "\u2080"}, {"1", "\u2081"}, {"2", "\u2082"}, {"3", "\u2083"},      {"4", "\u2084"}, {"5", "\u2085"},
     {"6", "\u2086"}, {"7", "\u2087"}, {"8", "\u2088"}, {"9", "\u2089"},      {"+", "\u208a"}, {"-", "\u208b"},
     {"=", "\u208c"}, {"(", "\u208d"}, {")", "\u208e"}, {"\u2212", "\u208b"}, {"a", "\u2090"}, {"e", "\u2091"},
     {"o", "\u2092"}, {"x", "\u2093"}, {"h", "\u2095"}, {"k", "\u2096"},      {"l", "\u2097"}, {"m", "\u2098"},
     {"n", "\u2099"}, {"p", "\u209a"}, {"s", "\u209b"}, {"t", "\u209c"},      {"i", "\u1d62"}, {"r", "\u1d63"},
     {"u", "\u1d64"}, {"v", "\u1d65"}, {"j", "\u2c7c"}, {" ", " "},           {",", ","}}};
constexpr std::array<Sign, 18> raised{{{"0", "\u2070"},
                                       {"1", "\u00b9"},
                                       {"2", "\u00b2"},
                                       {"3", "\u00b3"},
                                       {"4", "\u2074"},
                                       {"5", "\u2075"},
                                       {"6", "\u2076"},
                                       {"7", "\u2077"},
                                       {"8", "\u2078"},
                                       {"9", "\u2079"},
                                       {"+", "\u207a"},
                                       {"-", "\u207b"},
                                       {"=", "\u207c"},
                                       {"(", "\u207d"},
                                       {")", "\u207e"},
                                       {"n", "\u207f"},
                                       {"i", "\u2071"},
                                       {"\u2212", "\u207b"}}};

std::string formula_text(const Atoms& atoms);

/// All characters in their small form, or nothing where one has none.
template <std::size_t count>
std::optional<std::string> as_script(const Atoms& atoms, const std::array<Sign, count>& signs) {
  std::string text;
  for (const FormulaAtom& atom : atoms) {
    if (!atom.subscript.empty() || !atom.superscript.empty()) return std::nullopt;
    if (atom.kind == FormulaAtom::Kind::group) {
      const auto inside = as_script(atom.inside, signs);
      if (!inside) return std::nullopt;
      text += *inside;
      continue;
    }
    const auto sign = std::find_if(signs.begin(), signs.end(), [&](const Sign& s) { return s.first == atom.text; });
    if (atom.kind != FormulaAtom::Kind::text || sign == signs.end()) return std::nullopt;
    text += sign->second;
  }
  return text;
}

/// What stands in braces is what is inside.
const Atoms& opened(const Atoms& atoms) {
  const bool group = atoms.size() == 1 && atoms[0].kind == FormulaAtom::Kind::group && atoms[0].subscript.empty() &&
                     atoms[0].superscript.empty();
  return group ? opened(atoms[0].inside) : atoms;
}

/// A letter, a number or a vector.
bool is_one_thing(const Atoms& atoms) {
  if (atoms.size() == 1) return atoms[0].kind != FormulaAtom::Kind::fraction;
  return std::all_of(atoms.begin(), atoms.end(), [](const FormulaAtom& atom) {
    return atom.kind == FormulaAtom::Kind::text && atom.text.find_first_not_of("0123456789.") == std::string::npos;
  });
}

std::string bracketed(const Atoms& atoms) {
  const Atoms& inside = opened(atoms);
  if (is_one_thing(inside)) return formula_text(inside);
  return std::string("(").append(formula_text(inside)).append(")");
}

template <std::size_t count>
std::string script(const Atoms& atoms, const std::array<Sign, count>& signs, const char* mark) {
  if (atoms.empty()) return {};
  if (const auto small = as_script(atoms, signs)) return *small;
  return std::string(mark).append(bracketed(atoms));
}

std::string base_text(const FormulaAtom& atom) {
  switch (atom.kind) {
    case FormulaAtom::Kind::text:
      return atom.text;
    case FormulaAtom::Kind::group:
      return formula_text(atom.inside);
    case FormulaAtom::Kind::vector:
      return formula_text(atom.inside).append(arrow_above);
    case FormulaAtom::Kind::fraction:
      return bracketed(atom.inside).append("/").append(bracketed(atom.below));
  }
  return {};
}

std::string formula_text(const Atoms& atoms) {
  std::string text;
  for (const FormulaAtom& atom : atoms) {
    text += base_text(atom);
    text += script(atom.subscript, lowered, "_");
    text += script(atom.superscript, raised, "^");
  }
  return text;
}

}  // namespace

std::string plain_text(std::string_view text) {
  const auto parsed = parse_formulas(text);
  const auto* parts = std::get_if<std::vector<TextPart>>(&parsed);
  if (parts == nullptr) return std::string(text);
  std::string plain;
  for (const TextPart& part : *parts) plain += part.is_formula ? formula_text(part.formula) : part.words;
  return plain;
}

}  // namespace proofreel
