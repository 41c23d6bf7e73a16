#pragma once

/// What the sources of the elementary functions share. Nobody else includes this.

#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/bits.h"
#include "engine/double_double.h"

namespace proofreel::elementary {

/// One bit pattern for all NaNs made here: the sign of a computed NaN differs between processors.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// c[0] + c[1] x + c[2] x^2 + ... as two Horner chains in x^2, which the processor works through side by side.
template <std::size_t n>
constexpr double polynomial(double x, const double (&c)[n]) {
  const double square = x * x;
  double even = 0;
  double odd = 0;
  for (std::size_t i = (n - 1) / 2 * 2 + 2; i >= 2; i -= 2) even = even * square + c[i - 2];
  for (std::size_t i = n / 2 * 2 + 1; i >= 3; i -= 2) odd = odd * square + c[i - 2];
  return even + x * odd;
}

/// The whole number nearest to x, |x| < 2^51: adding 1.5 * 2^52 leaves no bits behind the point.
constexpr double nearest_whole(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/// 2^n for -1022 <= n <= 1023.
constexpr double power_of_two(int n) {
  return bits_as<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(n) + 1023) << 52);
}

}  // namespace proofreel::elementary
