#include "scenarios/suggest.h"

#include <algorithm>

namespace proofreel {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string_view nearest(std::string_view name, std::span<const std::string> candidates) {
  constexpr std::size_t longest_name = 64;  // nobody mistypes more, and the distance costs its square
  if (name.size() > longest_name) return {};
  const int too_far = static_cast<int>(std::max<std::size_t>(2, name.size() / 2 + 1));
  int best = std::min(too_far, static_cast<int>(name.size()));
  std::string_view found;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(name, candidate);
    if (distance >= best) continue;
    best = distance;
    found = candidate;
  }
  return found;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  const std::string_view near = nearest(name, candidates);
  if (near.empty()) return "known are " + quoted_list(candidates);
  return "did you mean " + quote(near) + "?";
}

std::string quoted_list(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + quote(name);
  return list;
}

std::string quote(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::size_t end = std::min(longest, text.size());
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (end < text.size() && end > 0 && continues(text[end])) --end;  // not within a character of UTF-8
  std::string shown(text.substr(0, end));
  if (text.size() > longest) shown += "...";
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return '"' + shown + '"';
}

}  // namespace proofreel
