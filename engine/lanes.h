#pragma once

/// Several numbers at once.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "engine/real.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Four floats or two doubles at once. This is how GCC and Clang spell it on every processor, WebAssembly included:
/// each lane computes what a plain number would, so the bits are those of the loop over single numbers.
using Lanes [[gnu::vector_size(16)]] = real;
inline constexpr int lanes = sizeof(Lanes) / sizeof(real);

/// Two numbers at once.
using Pair [[gnu::vector_size(2 * sizeof(real))]] = real;

/// As many numbers as `Numbers` has, from where they lie one after the other; they need not be aligned.
template <typename Numbers>
inline Numbers packed(const real* from) {
  Numbers values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
template <typename Numbers>
inline void put_packed(real* to, Numbers values) {
  std::memcpy(to, &values, sizeof values);
}
inline Lanes lanes_at(const real* from) { return packed<Lanes>(from); }
inline void put_lanes(real* to, Lanes values) { put_packed(to, values); }

/// Room for `count` numbers in whole lanes.
inline std::size_t in_whole_lanes(std::size_t count) { return (count + lanes - 1) / lanes * lanes; }

/// Whole numbers as wide, which is what a comparison of lanes gives: all bits set where it holds.
using Mark = std::conditional_t<sizeof(real) == 4, std::int32_t, std::int64_t>;
using Marks [[gnu::vector_size(16)]] = Mark;

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
