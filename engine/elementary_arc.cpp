/// The inverse trigonometric functions, all of them from one: the angle of a vector in the first quadrant.

#include <array>

#include "engine/elementary.h"
#include "engine/elementary_parts.h"

namespace proofreel::elementary {
namespace {

constexpr double sign_applied(double size, double sign) { return sign < 0 ? -size : size; }

/// atan d = d - d^3/3 + d^5/5 - ... for 0 <= d <= 1/16, to the last bit of a double-double.
constexpr DoubleDouble atan_series(DoubleDouble d) {
  const DoubleDouble square = d * d;
  DoubleDouble sum;
  for (int k = 31; k >= 1; k -= 2) sum = DoubleDouble{1, 0} / DoubleDouble{static_cast<double>(k), 0} - square * sum;
  return d * sum;
}

/// atan(i/16), i = 0..16, summed from angle to angle: atan a - atan b = atan((a - b) / (1 + a b)).
constexpr std::array<DoubleDouble, 17> make_atan_table() {
  std::array<DoubleDouble, 17> table{};
  for (std::size_t i = 1; i < table.size(); ++i) {
    const double denominator = static_cast<double>(256 + i * (i - 1));
    table[i] = table[i - 1] + atan_series(DoubleDouble{16, 0} / DoubleDouble{denominator, 0});
  }
  return table;
}
constexpr std::array<DoubleDouble, 17> atan_table = make_atan_table();

/// The angle of (x, y), 0 <= y <= x: the vector is turned back by the nearest angle in the table, what is left has a
/// tangent of at most 1/32 and a short series.
DoubleDouble eighth_turn_angle(DoubleDouble y, DoubleDouble x) {
  constexpr double c[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11};
  const double tangent = nearest_whole(y.hi / x.hi * 16) / 16;
  const DoubleDouble t = (y - x * tangent) / (x + y * tangent);
  const double square = t.hi * t.hi;
  const DoubleDouble rest = fast_two_sum(t.hi, t.lo + t.hi * square * polynomial(square, c));
  return atan_table[static_cast<std::size_t>(tangent * 16)] + rest;
}

/// The angle of (x, y), neither negative, not both zero.
DoubleDouble quarter_turn_angle(DoubleDouble y, DoubleDouble x) {
  return y.hi > x.hi ? half_pi - eighth_turn_angle(x, y) : eighth_turn_angle(y, x);
}

/// sqrt(1 - x^2) for |x| <= 1.
DoubleDouble other_leg(double x) {
  const DoubleDouble square = two_product(x, x);
  const DoubleDouble first = two_sum(1, -square.hi);
  return sqrt(first + DoubleDouble{-square.lo, 0});
}

/// atan2 of sizes, where `left` says that x was negative; y and x finite and not zero.
double angle_of_sizes(double y, double x, bool left) {
  const double tangent = y / x;
  if (!left && tangent < 0x1p-30) return tangent;  // the next term, tangent^3/3, is below 2^-61 of it
  const double larger = y > x ? y : x;
  const double scale = larger > 0x1p500 ? 0x1p-600 : larger < 0x1p-400 ? 0x1p600 : 1;
  const DoubleDouble angle = quarter_turn_angle({y * scale, 0}, {x * scale, 0});
  return left ? (pi - angle).hi : angle.hi;
}

}  // namespace

double atan(double x) {
  const double size = std::fabs(x);
  if (!(size <= infinity)) return nan;
  if (size < 0x1p-28) return x;
  if (size > 0x1p60) return sign_applied(half_pi.hi, x);
  return sign_applied(quarter_turn_angle({size, 0}, {1, 0}).hi, x);
}

double atan2(double y, double x) {
  double height = std::fabs(y);
  double width = std::fabs(x);
  if (!(height <= infinity && width <= infinity)) return nan;
  const bool left = std::signbit(x);
  if (height == infinity && width == infinity) height = width = 1;
  double angle = 0;
  if (height == 0 || width == infinity) {
    angle = left ? pi.hi : 0;
  } else if (width == 0 || height == infinity) {
    angle = half_pi.hi;
  } else {
    angle = angle_of_sizes(height, width, left);
  }
  return std::signbit(y) ? -angle : angle;
}

double asin(double x) {
  const double size = std::fabs(x);
  if (!(size <= 1)) return nan;
  if (size < 0x1p-28) return x;
  return sign_applied(quarter_turn_angle({size, 0}, other_leg(size)).hi, x);
}

double acos(double x) {
  const double size = std::fabs(x);
  if (!(size <= 1)) return nan;
  const DoubleDouble angle = quarter_turn_angle(other_leg(size), {size, 0});
  return x < 0 ? (pi - angle).hi : angle.hi;
}

}  // namespace proofreel::elementary
