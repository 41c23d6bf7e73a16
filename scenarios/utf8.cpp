#include "scenarios/utf8.h"

#include <cstddef>
#include <cstdint>

namespace proofreel {
namespace {

/// How many bytes the character that begins with `first` takes; 0 when none begins so.
std::size_t length_by(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

bool is_control(std::uint32_t code) { return (code < 0x20 && code != '\n' && code != '\t') || code == 0x7F; }
bool is_surrogate(std::uint32_t code) { return code >= 0xD800 && code < 0xE000; }

/// The smallest code that needs so many bytes; smaller ones must not be written so long.
std::uint32_t least_code(std::size_t length) {
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  return least[length];
}

}  // namespace

bool is_plain_text(std::string_view text) {
  while (!text.empty()) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = length_by(first);
    if (length == 0 || length > text.size()) return false;
    std::uint32_t code = length == 1 ? first : first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
      const auto next = static_cast<unsigned char>(text[i]);
      if ((next & 0xC0U) != 0x80U) return false;
      code = code << 6 | (next & 0x3FU);
    }
    if (code < least_code(length) || code > 0x10FFFF || is_surrogate(code) || is_control(code)) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace proofreel
