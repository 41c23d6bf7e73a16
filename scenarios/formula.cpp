#include "scenarios/formula.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "scenarios/suggest.h"

namespace proofreel {
namespace {

using Atoms = std::vector<FormulaAtom>;

constexpr std::array<std::pair<const char*, const char*>, 42> signs{{
    {"alpha", "\u03b1"}, {"beta", "\u03b2"},  {"gamma", "\u03b3"},  {"delta", "\u03b4"}, {"epsilon", "\u03b5"},
    {"zeta", "\u03b6"},  {"eta", "\u03b7"},   {"theta", "\u03b8"},  {"kappa", "\u03ba"}, {"lambda", "\u03bb"},
    {"mu", "\u03bc"},    {"nu", "\u03bd"},    {"xi", "\u03be"},     {"pi", "\u03c0"},    {"rho", "\u03c1"},
    {"sigma", "\u03c3"}, {"tau", "\u03c4"},   {"phi", "\u03c6"},    {"chi", "\u03c7"},   {"psi", "\u03c8"},
    {"omega", "\u03c9"}, {"Gamma", "\u0393"}, {"Delta", "\u0394"},  {"Theta", "\u0398"}, {"Lambda", "\u039b"},
    {"Pi", "\u03a0"},    {"Sigma", "\u03a3"}, {"Phi", "\u03a6"},    {"Psi", "\u03a8"},   {"Omega", "\u03a9"},
    {"times", "\u00d7"}, {"cdot", "\u00b7"},  {"le", "\u2264"},     {"ge", "\u2265"},    {"ne", "\u2260"},
    {"sum", "\u2211"},   {"infty", "\u221e"}, {"approx", "\u2248"}, {"to", "\u2192"},    {"perp", "\u22a5"},
    {"pm", "\u00b1"},    {"in", "\u2208"},
}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// What a formula says wrongly: the end of the sentence.
class Wrong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  Atoms all() {
    Atoms atoms = until_brace();
    if (!rest_.empty()) throw Wrong("closes a } that was never opened");
    return atoms;
  }

 private:
  Atoms until_brace() {
    Atoms atoms;
    while (!rest_.empty() && rest_.front() != '}') {
      if (rest_.front() == '_' || rest_.front() == '^') {
        add_script(atoms);
      } else {
        atoms.push_back(atom());
      }
    }
    return atoms;
  }

  void add_script(Atoms& atoms) {
    const bool lower = rest_.front() == '_';
    rest_.remove_prefix(1);
    if (atoms.empty()) throw Wrong("begins with a subscript or superscript of nothing");
    if (rest_.empty()) throw Wrong("ends after _ or ^");
    Atoms& script = lower ? atoms.back().subscript : atoms.back().superscript;
    if (!script.empty()) throw Wrong("has two subscripts or superscripts at one place: group them, a_{12}");
    script.push_back(atom());
  }

  FormulaAtom atom() {
    if (rest_.front() == '{') return {FormulaAtom::Kind::group, {}, braced(), {}, {}, {}};
    if (rest_.front() == '\\') return command();
    return {FormulaAtom::Kind::text, character(), {}, {}, {}, {}};
  }

  /// One character of UTF-8.
  std::string character() {
    std::size_t size = 1;
    while (size < rest_.size() && (static_cast<unsigned char>(rest_[size]) & 0xC0U) == 0x80U) ++size;
    const std::string text(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return text;
  }

  Atoms braced() {
    if (rest_.empty() || rest_.front() != '{') throw Wrong("lacks a { after \\frac or \\vec");
    if (++depth_ > 20) throw Wrong("nests more than 20 braces");
    rest_.remove_prefix(1);
    Atoms atoms = until_brace();
    if (rest_.empty()) throw Wrong("opens a { that is never closed");
    rest_.remove_prefix(1);
    --depth_;
    return atoms;
  }

  FormulaAtom command() {
    rest_.remove_prefix(1);
    if (!rest_.empty() && !is_letter(rest_.front())) return {FormulaAtom::Kind::text, character(), {}, {}, {}, {}};
    const auto end = static_cast<std::size_t>(std::find_if_not(rest_.begin(), rest_.end(), is_letter) - rest_.begin());
    const std::string name(rest_.substr(0, end));
    rest_.remove_prefix(end);
    if (name == "vec") return {FormulaAtom::Kind::vector, {}, braced(), {}, {}, {}};
    if (name == "frac") {
      Atoms above = braced();
      return {FormulaAtom::Kind::fraction, {}, std::move(above), braced(), {}, {}};
    }
    const auto known = std::find_if(signs.begin(), signs.end(), [&](const auto& sign) { return name == sign.first; });
    if (known != signs.end()) return {FormulaAtom::Kind::text, known->second, {}, {}, {}, {}};
    std::vector<std::string> names{"\\frac", "\\vec"};
    for (const auto& sign : signs) names.push_back(std::string("\\") + sign.first);
    throw Wrong("has an unknown command " + quote("\\" + name) + ", " + did_you_mean("\\" + name, names));
  }

  std::string_view rest_;
  int depth_ = 0;
};

/// What stands before the next $ that is not written \$; false when there is none.
bool take_until_dollar(std::string_view& rest, std::string& taken) {
  while (!rest.empty()) {
    if (rest.starts_with("\\$")) {
      taken += "\\$";
      rest.remove_prefix(2);
      continue;
    }
    const char next = rest.front();
    rest.remove_prefix(1);
    if (next == '$') return true;
    taken += next;
  }
  return false;
}

std::string with_plain_dollars(std::string words) {
  for (std::size_t at = words.find("\\$"); at != std::string::npos; at = words.find("\\$", at + 1)) words.erase(at, 1);
  return words;
}

}  // namespace

std::variant<std::vector<TextPart>, std::string> parse_formulas(std::string_view text) {
  std::vector<TextPart> parts;
  std::string taken;
  bool in_formula = false;
  while (take_until_dollar(text, taken)) {
    try {
      if (in_formula) {
        parts.push_back({{}, Reader(taken).all(), true});
      } else if (!taken.empty()) {
        parts.push_back({with_plain_dollars(taken), {}, false});
      }
    } catch (const Wrong& wrong) {
      return "has a formula " + quote(taken) + " that " + wrong.what();
    }
    in_formula = !in_formula;
    taken.clear();
  }
  if (in_formula) return std::string("has a $ that begins a formula without a $ that ends it: write \\$ for a dollar");
  if (!taken.empty()) parts.push_back({with_plain_dollars(taken), {}, false});
  return parts;
}

}  // namespace proofreel
