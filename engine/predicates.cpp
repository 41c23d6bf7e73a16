#include "engine/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "engine/bits.h"
#include "engine/double_double.h"

namespace proofreel {
namespace {

constexpr int digit_bits = 32;
constexpr int smallest_exponent = -1074;  ///< every double is a whole multiple of 2^-1074

/// |x| / 2^(smallest_exponent + 32 * lowest) as a whole number of three digits in base 2^32.
struct Digits {
  std::array<std::int64_t, 3> digit{};
  int lowest = 0;
};

Digits digits_of(double x) {
  constexpr std::uint64_t low_digit = 0xFFFF'FFFF;
  const auto bits = bits_as<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
  const std::uint64_t exponent = bits >> 52;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t mantissa = exponent > 0 ? fraction | std::uint64_t{1} << 52 : fraction;
  const std::uint64_t place = exponent > 0 ? exponent - 1 : 0;
  const std::uint64_t shift = place % digit_bits;
  const std::uint64_t upper = mantissa >> (digit_bits - shift);
  Digits result;
  result.lowest = static_cast<int>(place / digit_bits);
  result.digit = {static_cast<std::int64_t>((mantissa << shift) & low_digit),
                  static_cast<std::int64_t>(upper & low_digit), static_cast<std::int64_t>(upper >> digit_bits)};
  return result;
}

/// A sum of products of doubles, exact (after Kulisch's long accumulator): a fixed-point number that reaches from the
/// square of the smallest double to that of the largest. Its digits take sums of either sign without carrying; that
/// is done once at the end, so there must be fewer than 2^29 products.
class ExactSum {
 public:
  void add_product(double x, double y) {
    const bool negative = std::signbit(x) != std::signbit(y);
    const Digits a = digits_of(x);
    const Digits b = digits_of(y);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto product = static_cast<std::uint64_t>(a.digit[i]) * static_cast<std::uint64_t>(b.digit[j]);
        const std::size_t at = static_cast<std::size_t>(a.lowest + b.lowest) + i + j;
        add(at, static_cast<std::int64_t>(product & 0xFFFF'FFFF), negative);
        add(at + 1, static_cast<std::int64_t>(product >> digit_bits), negative);
      }
    }
  }

  /// Rounded, but never to zero.
  double value() {
    const bool negative = carry() < 0;
    if (negative) {
      for (std::int64_t& digit : digits_) digit = -digit;
      carry();
    }
    const auto top = std::find_if(digits_.rbegin(), digits_.rend() - 3, [](std::int64_t d) { return d != 0; });
    const double leading =
        (static_cast<double>(top[0]) * 0x1p32 + static_cast<double>(top[1])) * 0x1p32 + static_cast<double>(top[2]);
    if (leading == 0) return 0;
    const auto place = static_cast<int>(digits_.rend() - top) - 3;
    const double size = std::ldexp(leading, digit_bits * place + 2 * smallest_exponent);
    const double seen = std::max(size, std::numeric_limits<double>::denorm_min());
    return negative ? -seen : seen;
  }

 private:
  void add(std::size_t at, std::int64_t digit, bool negative) { digits_[at] += negative ? -digit : digit; }

  /// Brings all digits between 0 and 2^32 - 1; what is carried out of the topmost is -1 for a negative sum.
  std::int64_t carry() {
    std::int64_t carried = 0;
    for (std::int64_t& digit : digits_) {
      digit += carried;
      carried = digit >> digit_bits;
      digit &= 0xFFFF'FFFF;
    }
    return carried;
  }

  std::array<std::int64_t, 134> digits_{};
};

/// (b - a) x (c - a), multiplied out so that no difference is rounded.
double exact_orientation(Vec2d a, Vec2d b, Vec2d c) {
  ExactSum sum;
  sum.add_product(a.x, b.y);
  sum.add_product(b.x, c.y);
  sum.add_product(c.x, a.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(-b.y, c.x);
  sum.add_product(-c.y, a.x);
  return sum.value();
}

/// The same where the four differences are exact, which is the rule for points on a line: they have their coordinates
/// from a drawing or a grid. Both products are exact as two doubles each, since neither is tiny, and so is the sign of
/// what is returned: the leading doubles differ by whole units of their last place, the trailing ones by less.
std::optional<double> orientation_of_exact_differences(Vec2d a, Vec2d b, Vec2d c) {
  const DoubleDouble bx = two_sum(b.x, -a.x);
  const DoubleDouble by = two_sum(b.y, -a.y);
  const DoubleDouble cx = two_sum(c.x, -a.x);
  const DoubleDouble cy = two_sum(c.y, -a.y);
  if (bx.lo != 0 || by.lo != 0 || cx.lo != 0 || cy.lo != 0) return std::nullopt;
  if ((bx.hi == 0 || cy.hi == 0) && (by.hi == 0 || cx.hi == 0)) return 0;
  const DoubleDouble left = two_product(bx.hi, cy.hi);
  const DoubleDouble right = two_product(by.hi, cx.hi);
  if (std::min(std::fabs(left.hi), std::fabs(right.hi)) < 0x1p-900) return std::nullopt;
  return (left.hi - right.hi) + (left.lo - right.lo);
}

bool opposite(double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); }

}  // namespace

double orientation(Vec2d a, Vec2d b, Vec2d c) {
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  const double difference = left - right;
  // The second term is for products so small that they lose digits, or all.
  const double error_bound = 0x1p-51 * (std::fabs(left) + std::fabs(right)) + std::numeric_limits<double>::min();
  if (std::fabs(difference) > error_bound) return difference;
  const bool is_large = !(error_bound < 0x1p900);  // products of halves would overflow
  const auto exact = is_large ? std::nullopt : orientation_of_exact_differences(a, b, c);
  return exact ? *exact : exact_orientation(a, b, c);
}

bool is_between(Vec2d p, Vec2d a, Vec2d b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool segments_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  return opposite(orientation(a, b, c), orientation(a, b, d)) && opposite(orientation(c, d, a), orientation(c, d, b));
}

bool segments_meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double c_side = orientation(a, b, c);
  const double d_side = orientation(a, b, d);
  const double a_side = orientation(c, d, a);
  const double b_side = orientation(c, d, b);
  if (opposite(c_side, d_side) && opposite(a_side, b_side)) return true;
  return (c_side == 0 && is_between(c, a, b)) || (d_side == 0 && is_between(d, a, b)) ||
         (a_side == 0 && is_between(a, c, d)) || (b_side == 0 && is_between(b, c, d));
}

}  // namespace proofreel
