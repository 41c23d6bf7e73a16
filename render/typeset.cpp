#include "render/typeset.h"

#include <algorithm>
#include <cmath>

#include "render/draw_text.h"
#include "scenarios/formula.h"

namespace proofreel {
namespace {

using Atoms = std::vector<FormulaAtom>;

constexpr double script_size = 0.72;    ///< of a sub- or superscript, of the text's
constexpr double script_drop = 0.24;    ///< em
constexpr double script_rise = 0.4;     ///< em
constexpr double fraction_axis = 0.33;  ///< em: where a fraction's line lies above the baseline
constexpr double smallest_px = 9;

int scaled(int size_px, double by) { return static_cast<int>(std::max(smallest_px, std::round(by * size_px))); }

void append(TypesetLine& line, const TypesetLine& piece, Vec2d at) {
  for (TypesetText text : piece.texts) {
    text.at += at;
    line.texts.push_back(std::move(text));
  }
  for (TypesetStroke stroke : piece.strokes) {
    stroke.from += at;
    stroke.to += at;
    line.strokes.push_back(stroke);
  }
  line.ascent = std::max(line.ascent, piece.ascent - at.y);
  line.descent = std::max(line.descent, piece.descent + at.y);
}

class Setter {
 public:
  explicit Setter(Canvas& canvas) : canvas_(canvas) {}

  TypesetLine words(const std::string& text, int size_px) {
    return {{{text, {}, size_px}}, {}, canvas_.text_width(text, size_px), cap_height * size_px, 0};
  }

  TypesetLine formula(const Atoms& atoms, int size_px) {
    TypesetLine line;
    for (std::size_t i = 0; i < atoms.size();) {
      const TypesetLine base = next_base(atoms, i, size_px);
      append(line, base, {line.width, 0});
      line.width += base.width;
      add_scripts(line, atoms[i - 1], size_px);
    }
    return line;
  }

 private:
  /// A run of plain characters is one piece, so that its letters are spaced as in a word.
  TypesetLine next_base(const Atoms& atoms, std::size_t& i, int size_px) {
    if (atoms[i].kind != FormulaAtom::Kind::text) return special(atoms[i++], size_px);
    std::string run;
    do {
      run += atoms[i++].text;
    } while (i < atoms.size() && atoms[i].kind == FormulaAtom::Kind::text && has_no_scripts(atoms[i - 1]));
    return words(run, size_px);
  }

  static bool has_no_scripts(const FormulaAtom& atom) { return atom.subscript.empty() && atom.superscript.empty(); }

  void add_scripts(TypesetLine& line, const FormulaAtom& atom, int size_px) {
    const int size = scaled(size_px, script_size);
    const TypesetLine below = formula(atom.subscript, size);
    const TypesetLine above = formula(atom.superscript, size);
    if (!atom.subscript.empty()) append(line, below, {line.width, std::round(script_drop * size_px)});
    if (!atom.superscript.empty()) append(line, above, {line.width, -std::round(script_rise * size_px)});
    line.width += std::max(below.width, above.width);
  }

  TypesetLine special(const FormulaAtom& atom, int size_px) {
    if (atom.kind == FormulaAtom::Kind::vector) return vector(atom, size_px);
    if (atom.kind == FormulaAtom::Kind::fraction) return fraction(atom, size_px);
    return formula(atom.inside, size_px);
  }

  TypesetLine vector(const FormulaAtom& atom, int size_px) {
    TypesetLine line = formula(atom.inside, size_px);
    const double y = -line.ascent - 0.16 * size_px;
    line.strokes.push_back({{0.02 * size_px, y}, {line.width + 0.02 * size_px, y}, stroke_width(size_px), true});
    line.ascent += 0.3 * size_px;
    return line;
  }

  TypesetLine fraction(const FormulaAtom& atom, int size_px) {
    const int size = scaled(size_px, 0.85);
    const TypesetLine above = formula(atom.inside, size);
    const TypesetLine below = formula(atom.below, size);
    const double axis = -std::round(fraction_axis * size_px);
    const double gap = 0.17 * size_px;
    const double side = 0.12 * size_px;
    TypesetLine line;
    line.width = std::max(above.width, below.width) + 2 * side;
    append(line, above, {0.5 * (line.width - above.width), std::round(axis - gap - above.descent)});
    append(line, below, {0.5 * (line.width - below.width), std::round(axis + gap + below.ascent)});
    line.strokes.push_back({{0.5 * side, axis}, {line.width - 0.5 * side, axis}, stroke_width(size_px), false});
    return line;
  }

  static double stroke_width(int size_px) { return std::max(1.0, 0.06 * size_px); }

  Canvas& canvas_;
};

/// What must not be broken, whether a space comes before it, and whether that space is within a formula.
struct Word {
  TypesetLine line;
  bool after_space = false;
  bool within_formula = false;
};

bool is_space(const FormulaAtom& atom) { return atom.kind == FormulaAtom::Kind::text && atom.text == " "; }

class WordList {
 public:
  WordList(Canvas& canvas, int size_px) : setter_(canvas), size_px_(size_px) {}

  void add_words(const std::string& text) {
    std::string word;
    for (const char c : text) {
      if (c == ' ' || c == '\n') {
        add(setter_.words(word, size_px_), word.empty());
        word.clear();
        space_ = true;
      } else {
        word += c;
      }
    }
    add(setter_.words(word, size_px_), word.empty());
  }

  void add_formula(const Atoms& atoms) {
    const std::size_t first = words_.size();
    Atoms piece;
    for (const FormulaAtom& atom : atoms) {
      if (!is_space(atom)) {
        piece.push_back(atom);
        continue;
      }
      add(setter_.formula(piece, size_px_), piece.empty());
      piece.clear();
      space_ = true;
    }
    add(setter_.formula(piece, size_px_), piece.empty());
    for (std::size_t i = first + 1; i < words_.size(); ++i) words_[i].within_formula = true;
  }

  const std::vector<Word>& words() const { return words_; }

 private:
  void add(TypesetLine line, bool empty) {
    if (empty) return;
    words_.push_back({std::move(line), space_, false});
    space_ = false;
  }

  Setter setter_;
  int size_px_;
  std::vector<Word> words_;
  bool space_ = false;
};

/// Words that hang together without a space are moved to the next line together.
std::vector<Word> joined(const std::vector<Word>& words) {
  std::vector<Word> units;
  for (const Word& word : words) {
    if (units.empty() || word.after_space) {
      units.push_back(word);
      continue;
    }
    TypesetLine& unit = units.back().line;
    append(unit, word.line, {unit.width, 0});
    unit.width += word.line.width;
  }
  return units;
}

/// How wide the formula is that `units[first]` begins with, to its end.
double width_from(const std::vector<Word>& units, std::size_t first, double space) {
  double width = units[first].line.width;
  for (std::size_t i = first + 1; i < units.size() && units[i].within_formula; ++i)
    width += space + units[i].line.width;
  return width;
}

/// Lines of at most `width`, if what hangs together allows that. A formula does, too, unless it is wider than `widest`.
std::vector<TypesetLine> in_lines(const std::vector<Word>& words, double space, double width, double widest) {
  std::vector<TypesetLine> lines(1);
  bool whole = false;  // the formula we are in
  const std::vector<Word> units = joined(words);
  for (std::size_t i = 0; i < units.size(); ++i) {
    const Word& unit = units[i];
    const double wide = width_from(units, i, space);
    if (!unit.within_formula) whole = wide <= widest;
    TypesetLine* line = &lines.back();
    const double before = unit.after_space && line->width > 0 ? space : 0;
    const bool may_break = line->width > 0 && !(unit.within_formula && whole);
    if (may_break && line->width + before + (whole ? wide : unit.line.width) > width) {
      line = &lines.emplace_back();
    } else {
      line->width += before;
    }
    append(*line, unit.line, {std::round(line->width), 0});
    line->width += unit.line.width;
  }
  return lines;
}

std::vector<TypesetLine> plain(Canvas& canvas, std::string_view text, int size_px, double width) {
  std::vector<TypesetLine> lines;
  for (std::string& line : wrapped(canvas, text, size_px, width)) {
    const double wide = canvas.text_width(line, size_px);
    lines.push_back({{{std::move(line), {}, size_px}}, {}, wide, cap_height * size_px, 0});
  }
  return lines;
}

/// How much farther than usual a line stands from the one before it, px.
double extra_above(const TypesetLine& line, const TypesetLine* before, int size_px) {
  const double usual = (line_height - cap_height) * size_px;
  const double below = before != nullptr ? before->descent : 0;
  const bool denominator = below > 1.5 * script_drop * size_px;  // its letters hang lower still, as a g does
  const double room = (denominator ? 0.3 : 0.12) * size_px;
  const double needed = line.ascent - cap_height * size_px + below + room;
  return std::round(std::max(0.0, needed - usual));
}

/// Lines of at most `width`; formulas are broken where they are wider than `widest`.
std::vector<TypesetLine> set_in(Canvas& canvas, std::string_view text, int size_px, double width, double widest) {
  const auto parsed = parse_formulas(text);
  const auto* parts = std::get_if<std::vector<TextPart>>(&parsed);
  if (parts == nullptr) return plain(canvas, text, size_px, width);
  const bool formulas = std::any_of(parts->begin(), parts->end(), [](const TextPart& part) { return part.is_formula; });
  if (!formulas) return plain(canvas, parts->empty() ? std::string() : parts->front().words, size_px, width);
  WordList words(canvas, size_px);
  for (const TextPart& part : *parts) {
    if (part.is_formula) {
      words.add_formula(part.formula);
    } else {
      words.add_words(part.words);
    }
  }
  return in_lines(words.words(), canvas.text_width(" ", size_px), width, widest);
}

}  // namespace

std::vector<TypesetLine> typeset(Canvas& canvas, std::string_view text, int size_px, double width) {
  return set_in(canvas, text, size_px, width, width);
}

std::vector<TypesetLine> balanced(Canvas& canvas, std::string_view text, int size_px, double width) {
  std::vector<TypesetLine> best = typeset(canvas, text, size_px, width);
  for (double narrower = 0.95 * width; best.size() > 1 && narrower > 0.5 * width; narrower -= 0.05 * width) {
    std::vector<TypesetLine> lines = set_in(canvas, text, size_px, narrower, width);
    if (lines.size() > best.size()) break;
    best = std::move(lines);
  }
  return best;
}

TypesetLine typeset_line(Canvas& canvas, std::string_view text, int size_px) {
  constexpr double endless = 1e9;
  std::vector<TypesetLine> lines = typeset(canvas, text, size_px, endless);
  return lines.empty() ? TypesetLine{} : std::move(lines.front());
}

double height_of(const std::vector<TypesetLine>& lines, int size_px) {
  if (lines.empty()) return 0;
  double height = lines.front().ascent + lines.back().descent;
  for (std::size_t i = 1; i < lines.size(); ++i)
    height += line_height * size_px + extra_above(lines[i], &lines[i - 1], size_px);
  return height;
}

void draw_line(Canvas& canvas, const TypesetLine& line, Vec2d start, Color color) {
  for (const TypesetText& text : line.texts) canvas.text(text.text, start + text.at, text.size_px, Align::left, color);
  for (const TypesetStroke& stroke : line.strokes) {
    canvas.line(start + stroke.from, start + stroke.to, stroke.width, color);
    if (!stroke.arrow) continue;
    const Vec2d tip = start + stroke.to;
    const double barb = 2.6 * stroke.width;
    canvas.line(tip, tip + Vec2d{-barb, -0.8 * barb}, stroke.width, color);
    canvas.line(tip, tip + Vec2d{-barb, 0.8 * barb}, stroke.width, color);
  }
}

void draw_lines(Canvas& canvas, const std::vector<TypesetLine>& lines, int size_px, Vec2d top, Align align,
                Color color) {
  if (lines.empty()) return;
  double baseline = top.y + lines.front().ascent;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) baseline += line_height * size_px + extra_above(lines[i], &lines[i - 1], size_px);
    const double part = align == Align::left ? 0 : align == Align::right ? 1 : 0.5;
    draw_line(canvas, lines[i], {top.x - part * lines[i].width, baseline}, color);
  }
}

}  // namespace proofreel
