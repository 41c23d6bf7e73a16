#pragma once

namespace proofreel {

/// The bits of a value, read as another type of the same size: std::bit_cast, which the C++ library of Debian 12's
/// Emscripten does not have yet.
template <typename To, typename From>
constexpr To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace proofreel
