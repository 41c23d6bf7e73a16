#pragma once

/// Lua's string patterns (Lua 5.4 reference manual, 6.4.1), matched with a bound on the work. The library's own matcher
/// is a C function that backtracks exponentially on hostile patterns and cannot be interrupted; this one counts its
/// steps and gives up. Letter classes are those of ASCII, whatever the locale.

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace proofreel {

/// The pattern is malformed, or matching it takes too many steps.
class PatternError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int max_pattern_captures = 32;

/// One piece of a pattern.
struct PatternItem {
  enum class Kind : std::uint8_t { one, optional, greedy, lazy, open, place, close, back, balance, frontier, end };
  Kind kind = Kind::one;
  std::bitset<256> set;     ///< one, optional, greedy, lazy, frontier: the characters that match
  std::uint8_t index = 0;   ///< back: which capture, from 0
  unsigned char left = 0;   ///< balance: opening character
  unsigned char right = 0;  ///< balance: closing character
};

/// A pattern ready to match. `x+` is held as `xx*`.
struct Pattern {
  bool anchored = false;  ///< began with '^'
  std::vector<PatternItem> items;
};

/// Throws PatternError when malformed. In gmatch a leading '^' is an ordinary character.
Pattern compile_pattern(std::string_view text, bool caret_anchors);

struct PatternCapture {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool is_place = false;  ///< `()`: only where, not what
};

struct PatternMatch {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::vector<PatternCapture> captures;
};

/// The first match that begins at `from` (an anchored pattern) or at or after it. `steps` is what matching may cost, in
/// characters compared, and is counted down. Throws PatternError when it runs out.
std::optional<PatternMatch> find_match(const Pattern& pattern, std::string_view subject, std::size_t from,
                                       std::uint64_t& steps);

/// Where `needle` first occurs in `subject` at or after `from`; counts `steps` down like find_match.
std::optional<std::size_t> find_plain(std::string_view needle, std::string_view subject, std::size_t from,
                                      std::uint64_t& steps);

}  // namespace proofreel
