#pragma once

/// Double-double arithmetic: a number held as the unevaluated sum of two doubles, |lo| <= half an ulp of hi, which
/// gives about 106 bits. The building blocks are error-free transformations (Dekker 1971, Knuth vol. 2, 4.2.2): they
/// return a rounded result and, exactly, what the rounding lost. They need IEEE arithmetic rounded to nearest after
/// every single operation and no fused multiply-add (the build says -ffp-contract=off).

#include <cfloat>
#include <cmath>

namespace proofreel {

static_assert(FLT_EVAL_METHOD == 0, "every operation must round to the precision of its operands at once");

struct DoubleDouble {
  double hi = 0;
  double lo = 0;
};

/// a + b exactly; needs |a| >= |b| or a == 0.
constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly, whichever is larger.
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_seen = sum - a;
  return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

/// `a` as the sum of two doubles of at most 26 significant bits each, so that products of halves are exact. |a| must
/// stay below 2^996.
constexpr DoubleDouble split(double a) {
  const double t = 134217729.0 * a;  // 2^27 + 1
  const double upper = t - (t - a);
  return {upper, a - upper};
}

/// a * b exactly, unless it over- or underflows.
constexpr DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = split(a);
  const DoubleDouble y = split(b);
  return {product, x.lo * y.lo - (((product - x.hi * y.hi) - x.lo * y.hi) - x.hi * y.lo)};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

/// Sums and products are good to a few 2^-106 of the larger operand.
constexpr DoubleDouble operator+(DoubleDouble a, double b) {
  const DoubleDouble s = two_sum(a.hi, b);
  return fast_two_sum(s.hi, s.lo + a.lo);
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble s = two_sum(a.hi, b.hi);
  return fast_two_sum(s.hi, s.lo + (a.lo + b.lo));
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

constexpr DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble p = two_product(a.hi, b);
  return fast_two_sum(p.hi, p.lo + a.lo * b);
}

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble p = two_product(a.hi, b.hi);
  return fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double q = a.hi / b.hi;
  const DoubleDouble rest = a - b * q;
  return fast_two_sum(q, rest.hi / b.hi);
}

/// The square root; `a` must not be negative.
inline DoubleDouble sqrt(DoubleDouble a) {
  if (a.hi == 0) return {};
  const double root = std::sqrt(a.hi);
  const DoubleDouble rest = a - two_product(root, root);
  return fast_two_sum(root, rest.hi / (2 * root));
}

}  // namespace proofreel
