#include "scenarios/pattern.h"

#include <algorithm>

namespace proofreel {
namespace {

using Kind = PatternItem::Kind;

/// Tries one pattern at one place after another. Each repetition continues recursively, so the depth is bounded by the
/// number of items that repeat or capture.
class Matcher {
 public:
  Matcher(const Pattern& pattern, std::string_view subject, std::uint64_t& steps)
      : items_(pattern.items), subject_(subject), steps_(steps) {}

  std::optional<PatternMatch> at(std::size_t begin) {
    captures_.clear();
    const std::size_t end = rest(0, begin);
    if (end == none) return std::nullopt;
    return PatternMatch{begin, end, captures_};
  }

 private:
  static constexpr std::size_t none = std::string_view::npos;
  static constexpr std::size_t still_open = none - 1;
  static constexpr int deepest = 1000;

  void spend(std::uint64_t count) {
    if (count > steps_) throw PatternError("matching this pattern takes too many steps; use a simpler pattern");
    steps_ -= count;
  }
  bool holds(const PatternItem& item, std::size_t at) {
    spend(1);
    return at < subject_.size() && item.set[static_cast<unsigned char>(subject_[at])];
  }

  /// Where a match of the items from `item` on that begins at `at` ends; `none` when there is none.
  std::size_t rest(std::size_t item, std::size_t at) {
    if (depth_ == deepest) throw PatternError("the pattern is too complex");
    ++depth_;
    for (; item < items_.size(); ++item) {
      const Kind kind = items_[item].kind;
      if (is_fork(kind)) {
        at = fork(item, at);
        break;
      }
      at = straight(items_[item], at);
      if (at == none) break;
    }
    --depth_;
    return at;
  }

  static bool is_fork(Kind kind) {
    return kind == Kind::optional || kind == Kind::greedy || kind == Kind::lazy || kind == Kind::open ||
           kind == Kind::place || kind == Kind::close;
  }

  /// Items that match in one way only: where they end.
  std::size_t straight(const PatternItem& item, std::size_t at) {
    switch (item.kind) {
      case Kind::balance:
        return balanced(item, at);
      case Kind::back:
        return repeated_capture(item, at);
      case Kind::frontier:
        return at_frontier(item, at) ? at : none;
      case Kind::end:
        return at == subject_.size() ? at : none;
      default:
        return holds(item, at) ? at + 1 : none;
    }
  }

  /// Items with more than one way to go on, or with something to undo.
  std::size_t fork(std::size_t item, std::size_t at) {
    switch (items_[item].kind) {
      case Kind::greedy:
        return longest_first(item, at);
      case Kind::lazy:
        return shortest_first(item, at);
      case Kind::open:
        return with_capture({at, still_open, false}, item, at);
      case Kind::place:
        return with_capture({at, at, true}, item, at);
      case Kind::close:
        return closing(item, at);
      default:
        break;
    }
    const std::size_t taken = holds(items_[item], at) ? rest(item + 1, at + 1) : none;
    return taken != none ? taken : rest(item + 1, at);
  }

  std::size_t longest_first(std::size_t item, std::size_t at) {
    std::size_t last = at;
    while (holds(items_[item], last)) ++last;
    for (;; --last) {
      const std::size_t end = rest(item + 1, last);
      if (end != none || last == at) return end;
      spend(1);
    }
  }

  std::size_t shortest_first(std::size_t item, std::size_t at) {
    while (true) {
      const std::size_t end = rest(item + 1, at);
      if (end != none || !holds(items_[item], at)) return end;
      ++at;
    }
  }

  std::size_t with_capture(PatternCapture capture, std::size_t item, std::size_t at) {
    captures_.push_back(capture);
    const std::size_t end = rest(item + 1, at);
    if (end == none) captures_.pop_back();
    return end;
  }

  std::size_t closing(std::size_t item, std::size_t at) {
    const auto innermost =
        std::find_if(captures_.rbegin(), captures_.rend(), [](const auto& c) { return c.end == still_open; });
    const auto index = static_cast<std::size_t>(captures_.rend() - innermost) - 1;
    captures_[index].end = at;
    const std::size_t end = rest(item + 1, at);
    if (end == none) captures_[index].end = still_open;
    return end;
  }

  std::size_t balanced(const PatternItem& item, std::size_t at) {
    if (at >= subject_.size() || static_cast<unsigned char>(subject_[at]) != item.left) return none;
    int depth = 1;
    for (std::size_t i = at + 1; i < subject_.size(); ++i) {
      spend(1);
      const auto c = static_cast<unsigned char>(subject_[i]);
      if (c == item.right) {
        if (--depth == 0) return i + 1;
      } else if (c == item.left) {
        ++depth;
      }
    }
    return none;
  }

  std::size_t repeated_capture(const PatternItem& item, std::size_t at) {
    const PatternCapture& capture = captures_[item.index];
    if (capture.end == still_open) throw PatternError("the pattern refers to a capture that is not finished");
    if (capture.is_place) return none;  // a place has no text to come again
    const std::string_view text = subject_.substr(capture.begin, capture.end - capture.begin);
    spend(1 + text.size());
    return subject_.substr(at).starts_with(text) ? at + text.size() : none;
  }

  bool at_frontier(const PatternItem& item, std::size_t at) {
    spend(1);
    const unsigned char before = at == 0 ? 0 : static_cast<unsigned char>(subject_[at - 1]);
    const unsigned char after = at == subject_.size() ? 0 : static_cast<unsigned char>(subject_[at]);
    return !item.set[before] && item.set[after];
  }

  const std::vector<PatternItem>& items_;
  std::string_view subject_;
  std::uint64_t& steps_;
  std::vector<PatternCapture> captures_;
  int depth_ = 0;
};

}  // namespace

std::optional<PatternMatch> find_match(const Pattern& pattern, std::string_view subject, std::size_t from,
                                       std::uint64_t& steps) {
  Matcher matcher(pattern, subject, steps);
  const std::size_t last = pattern.anchored ? from : subject.size();
  for (std::size_t begin = from; begin <= last; ++begin) {
    if (auto match = matcher.at(begin)) return match;
  }
  return std::nullopt;
}

std::optional<std::size_t> find_plain(std::string_view needle, std::string_view subject, std::size_t from,
                                      std::uint64_t& steps) {
  // Compares letter by letter instead of calling find, whose worst case nobody counts.
  for (std::size_t begin = from; begin + needle.size() <= subject.size(); ++begin) {
    const auto stop = std::mismatch(needle.begin(), needle.end(), subject.begin() + static_cast<std::ptrdiff_t>(begin));
    const auto compared = static_cast<std::uint64_t>(stop.first - needle.begin()) + 1;
    if (compared > steps) throw PatternError("searching this text takes too many steps");
    steps -= compared;
    if (stop.first == needle.end()) return begin;
  }
  return std::nullopt;
}

}  // namespace proofreel
