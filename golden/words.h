#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace proofreel {

/// Parts of a sentence, one after the other.
inline std::string words(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text.append(part);
  return text;
}

/// A number of things as people read it: 5310 as "5,310".
inline std::string count_text(std::int64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && digits[i - 1] != '-' && (digits.size() - i) % 3 == 0) text.push_back(',');
    text.push_back(digits[i]);
  }
  return text;
}

}  // namespace proofreel
