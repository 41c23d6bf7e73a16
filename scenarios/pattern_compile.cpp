#include "scenarios/pattern.h"

namespace proofreel {
namespace {

using CharSet = std::bitset<256>;
using Kind = PatternItem::Kind;

/// The characters `belongs` accepts.
template <typename Test>
CharSet set_of(Test belongs) {
  CharSet set;
  for (int c = 0; c < 256; ++c) {
    if (belongs(c)) set.set(static_cast<std::size_t>(c));
  }
  return set;
}

bool is_lower(int c) { return c >= 'a' && c <= 'z'; }
bool is_upper(int c) { return c >= 'A' && c <= 'Z'; }
bool is_letter(int c) { return is_lower(c) || is_upper(c); }
bool is_digit(int c) { return c >= '0' && c <= '9'; }
bool is_space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_control(int c) { return c < ' ' || c == 127; }
bool is_graphic(int c) { return c > ' ' && c < 127; }
bool is_hex(int c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// What `%c` stands for: a class for the letters that name one (complemented when upper case), else the character.
CharSet class_of(char name) {
  const bool complement = is_upper(name);
  const auto signed_as = [&](const CharSet& set) { return complement ? ~set : set; };
  switch (complement ? name - 'A' + 'a' : name) {
    case 'a':
      return signed_as(set_of(is_letter));
    case 'c':
      return signed_as(set_of(is_control));
    case 'd':
      return signed_as(set_of(is_digit));
    case 'g':
      return signed_as(set_of(is_graphic));
    case 'l':
      return signed_as(set_of(is_lower));
    case 'p':
      return signed_as(set_of([](int c) { return is_graphic(c) && !is_letter(c) && !is_digit(c); }));
    case 's':
      return signed_as(set_of(is_space));
    case 'u':
      return signed_as(set_of(is_upper));
    case 'w':
      return signed_as(set_of([](int c) { return is_letter(c) || is_digit(c); }));
    case 'x':
      return signed_as(set_of(is_hex));
    default:
      return set_of([name](int c) { return c == static_cast<unsigned char>(name); });
  }
}

/// Turns the text of a pattern into items, front to back.
class Compiler {
 public:
  explicit Compiler(std::string_view text) : text_(text) {}

  std::vector<PatternItem> items() {
    while (at_ < text_.size()) item();
    if (open_ != 0) throw PatternError("malformed pattern (unfinished capture)");
    return std::move(items_);
  }

 private:
  char next(const char* problem) {
    if (at_ >= text_.size()) throw PatternError(std::string("malformed pattern (") + problem + ")");
    return text_[at_++];
  }
  bool accept(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void add(Kind kind) { items_.push_back({kind, {}, 0, 0, 0}); }

  void item() {
    const char c = text_[at_++];
    if (c == '(') return open();
    if (c == ')') return close();
    if (c == '$' && at_ == text_.size()) return add(Kind::end);
    if (c == '%' && at_ < text_.size() && escape(text_[at_])) return;
    repeated(single(c));
  }

  void open() {
    if (++captures_ > max_pattern_captures) throw PatternError("too many captures in the pattern");
    if (accept(')')) return add(Kind::place);
    ++open_;
    add(Kind::open);
  }

  void close() {
    if (--open_ < 0) throw PatternError("invalid pattern capture: a ')' closes nothing");
    add(Kind::close);
  }

  /// Escapes that are no single characters. False, with nothing read, when this is one.
  bool escape(char c) {
    if (c == 'b') return balance(), true;
    if (c == 'f') return frontier(), true;
    if (is_digit(c)) return back(), true;
    return false;
  }

  void balance() {
    ++at_;
    add(Kind::balance);
    items_.back().left = static_cast<unsigned char>(next("missing arguments to '%b'"));
    items_.back().right = static_cast<unsigned char>(next("missing arguments to '%b'"));
  }

  void frontier() {
    ++at_;
    if (!accept('[')) throw PatternError("missing '[' after '%f' in pattern");
    const CharSet set = bracket();
    add(Kind::frontier);
    items_.back().set = set;
  }

  void back() {
    const int index = text_[at_++] - '1';
    if (index < 0 || index >= captures_) {
      throw PatternError("invalid capture index %" + std::to_string(index + 1) + " in pattern");
    }
    add(Kind::back);
    items_.back().index = static_cast<std::uint8_t>(index);
  }

  CharSet single(char c) {
    if (c == '.') return ~CharSet{};
    if (c == '[') return bracket();
    if (c == '%') return class_of(next("ends with '%'"));
    return set_of([c](int other) { return other == static_cast<unsigned char>(c); });
  }

  /// After '[': up to the closing ']', which is an ordinary character when it comes first.
  CharSet bracket() {
    const bool complement = accept('^');
    CharSet set;
    bool first = true;
    for (char c = next("missing ']'"); first || c != ']'; c = next("missing ']'")) {
      first = false;
      set |= c == '%' ? class_of(next("missing ']'")) : range(c);
    }
    return complement ? ~set : set;
  }

  /// `c`, or `c-d`; a '-' before the closing ']' is an ordinary character.
  CharSet range(char c) {
    const bool is_range = at_ + 1 < text_.size() && text_[at_] == '-' && text_[at_ + 1] != ']';
    const char last = is_range ? text_[at_ + 1] : c;
    if (is_range) at_ += 2;
    return set_of([c, last](int other) {
      return other >= static_cast<unsigned char>(c) && other <= static_cast<unsigned char>(last);
    });
  }

  void repeated(const CharSet& set) {
    Kind kind = Kind::one;
    if (accept('+')) {
      items_.push_back({Kind::one, set, 0, 0, 0});
      kind = Kind::greedy;
    } else if (accept('*')) {
      kind = Kind::greedy;
    } else if (accept('-')) {
      kind = Kind::lazy;
    } else if (accept('?')) {
      kind = Kind::optional;
    }
    items_.push_back({kind, set, 0, 0, 0});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<PatternItem> items_;
  int captures_ = 0;
  int open_ = 0;
};

}  // namespace

Pattern compile_pattern(std::string_view text, bool caret_anchors) {
  constexpr std::size_t longest_pattern = 10000;
  if (text.size() > longest_pattern) throw PatternError("the pattern is longer than 10000 characters");
  Pattern pattern;
  pattern.anchored = caret_anchors && text.starts_with('^');
  if (pattern.anchored) text.remove_prefix(1);
  pattern.items = Compiler(text).items();
  return pattern;
}

}  // namespace proofreel
