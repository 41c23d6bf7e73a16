#pragma once

/// Numbers in sentences.

#include <cstdio>
#include <string>

namespace proofreel {

/// The number as printf writes it by `format`, which holds one conversion of a double: "%.3g", "%.1f ms".
inline std::string formatted(const char* format, double value) {
  const int length = std::snprintf(nullptr, 0, format, value);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::snprintf(text.data(), text.size() + 1, format, value);
  return text;
}

}  // namespace proofreel
