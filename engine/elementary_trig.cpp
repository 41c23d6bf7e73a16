/// Sine, cosine and tangent: subtract the nearest multiple of pi/2, then sum the Taylor series on [-pi/4, pi/4].

#include <array>

#include "engine/elementary.h"
#include "engine/elementary_parts.h"

namespace proofreel::elementary {
namespace {

constexpr double quarter_pi = 0x1.921fb54442d18p-1;
/// Below this x and sin x, x and tan x round to the same double: x^3/3 is less than a tenth of an ulp.
constexpr double tiny = 0x1p-28;

/// x = quadrant * pi/2 + rest, |rest| <= pi/4 and a little; only the quadrant's last two bits count.
struct Reduced {
  unsigned quadrant = 0;
  DoubleDouble rest;
};

/// The binary digits of 2/pi, 32 to a word, after 64 zeros for the digits left of the point.
constexpr std::array<std::uint32_t, 40> two_over_pi = {
    0,          0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
    0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

/// A 192-bit number, lowest word first.
using Words = std::array<std::uint32_t, 6>;

/// 192 digits of 2/pi from the given place on.
Words digits_from(std::size_t place) {
  Words digits{};
  const std::size_t first = place / 32;
  const std::size_t shift = place % 32;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::uint64_t next = first + i + 1 < two_over_pi.size() ? two_over_pi[first + i + 1] : 0;
    const std::uint64_t pair = std::uint64_t{two_over_pi[first + i]} << 32 | next;
    digits[digits.size() - 1 - i] = static_cast<std::uint32_t>(pair << shift >> 32);
  }
  return digits;
}

/// The lowest 192 bits of a * m.
Words product(const Words& a, std::uint64_t m) {
  Words result{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint64_t factor = m >> (32 * i) & 0xffffffffU;
    std::uint64_t carry = 0;
    for (std::size_t j = 0; i + j < result.size(); ++j) {
      carry += a[j] * factor + result[i + j];
      result[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }
  return result;
}

/// 2^190 - a for a < 2^190, the sign turned in two's complement; bits 190 and 191 are cleared.
Words complement(Words a) {
  std::uint64_t carry = 1;
  for (std::uint32_t& word : a) {
    carry += static_cast<std::uint32_t>(~word);
    word = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  a.back() &= 0x3fffffffU;
  return a;
}

/// a / 2^190.
DoubleDouble fraction_of(const Words& a) {
  DoubleDouble sum;
  for (std::size_t i = a.size(); i-- > 0;) sum = sum + a[i] * power_of_two(static_cast<int>(32 * i) - 190);
  return sum;
}

/// For every finite x > 1/2 (Payne and Hanek 1983). x * 2/pi in whole numbers: x is m * 2^e, and those digits of 2/pi
/// that contribute multiples of 4 quarter turns are never multiplied. No double comes closer than 2^-62 to a multiple
/// of pi/2, so 190 digits behind the point leave more than enough.
Reduced reduce_exactly(double x) {
  const auto bits = bits_as<std::uint64_t>(x);
  const int e = static_cast<int>(bits >> 52) - 1075;
  const std::uint64_t m = (bits & 0xfffffffffffffU) | 0x10000000000000U;
  // The digit with weight 2^-i stands at place i + 63; from i = e - 1 on, m * digit * 2^(e - i) is less than 4 * m / 2.
  Words turns = product(digits_from(static_cast<std::size_t>(e + 62)), m);
  unsigned quadrant = turns.back() >> 30;
  turns.back() &= 0x3fffffffU;
  if (turns.back() < 0x20000000U) return {quadrant, fraction_of(turns) * half_pi};
  return {quadrant + 1, -(fraction_of(complement(turns)) * half_pi)};
}

/// For x >= 0. Up to a million pi/2 is subtracted in three parts, the first two short enough that their products are
/// exact (Cody and Waite 1980); that is good to 2^-98. Where it cancels too much, and above, the exact way is taken.
Reduced reduce(double x) {
  if (x <= quarter_pi) return {0, {x, 0}};
  if (x > 1e6) return reduce_exactly(x);
  const double n = nearest_whole(x * 0x1.45f306dc9c883p-1);
  const DoubleDouble upper = two_sum(x - n * 0x1.921fb544p+0, -(n * 0x1.0b4611a6p-34));
  if (upper.hi < 0x1p-30 && upper.hi > -0x1p-30) return reduce_exactly(x);
  const DoubleDouble rest = fast_two_sum(upper.hi, upper.lo - n * 0x1.3198a2e037073p-69);
  return {static_cast<unsigned>(n), rest};
}

/// sin r = r - r^3/3! + ... - ... The cubic term is large enough for its rounding to show: the part of it that comes
/// from the upper 17 bits of r is exact before the division.
DoubleDouble sin_series(DoubleDouble r) {
  constexpr double c[] = {1.0 / 120,        -1.0 / 5040,          1.0 / 362880,         -1.0 / 39916800,
                          1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const double square = r.hi * r.hi;
  const double upper = (r.hi + 0x1.8p35) - 0x1.8p35;
  const double lower = r.hi - upper;
  const DoubleDouble first = fast_two_sum(r.hi, upper * upper * upper / -6);
  const double cubic_rest = lower * (square + upper * (r.hi + upper)) * (-1.0 / 6);
  const double higher = r.hi * (square * square) * polynomial(square, c);
  return fast_two_sum(first.hi, (higher + cubic_rest) + (first.lo + r.lo * (1 - 0.5 * square)));
}

/// cos r = 1 - r^2/2! + ...; r is split so that the large part of r^2/2 is exact.
DoubleDouble cos_series(DoubleDouble r) {
  constexpr double c[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
                          1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
  const double square = r.hi * r.hi;
  const DoubleDouble halves = split(r.hi);
  const DoubleDouble first = fast_two_sum(1, -0.5 * (halves.hi * halves.hi));
  const double rest = 0.5 * halves.lo * (r.hi + halves.hi) + r.hi * r.lo;
  return fast_two_sum(first.hi, square * square * polynomial(square, c) + (first.lo - rest));
}

/// The sine of `reduced` turned on by so many quarters: sin(x + pi/2) = cos x.
double sin_of(const Reduced& reduced, unsigned quarters) {
  const unsigned quadrant = reduced.quadrant + quarters;
  const double value = (quadrant & 1U) != 0 ? cos_series(reduced.rest).hi : sin_series(reduced.rest).hi;
  return (quadrant & 2U) != 0 ? -value : value;
}

}  // namespace

double sin(double x) {
  const double size = std::fabs(x);
  if (!(size < infinity)) return nan;
  if (size < tiny) return x;
  const double value = sin_of(reduce(size), 0);
  return x < 0 ? -value : value;
}

double cos(double x) {
  const double size = std::fabs(x);
  if (!(size < infinity)) return nan;
  return sin_of(reduce(size), 1);
}

double tan(double x) {
  const double size = std::fabs(x);
  if (!(size < infinity)) return nan;
  if (size < tiny) return x;
  const Reduced reduced = reduce(size);
  const DoubleDouble s = sin_series(reduced.rest);
  const DoubleDouble c = cos_series(reduced.rest);
  const double value = (reduced.quadrant & 1U) != 0 ? -(c / s).hi : (s / c).hi;
  return x < 0 ? -value : value;
}

}  // namespace proofreel::elementary
