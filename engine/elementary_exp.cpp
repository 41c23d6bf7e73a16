/// Exponential, logarithms and powers. The logarithm is made as a double-double of about 68 good bits, because a power
/// multiplies its error by up to 745.

#include <array>

#include "engine/elementary.h"
#include "engine/elementary_parts.h"

namespace proofreel::elementary {
namespace {

constexpr DoubleDouble ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr DoubleDouble one_over_ln_2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr DoubleDouble one_over_ln_10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

/// e^x = 1 + x (1 + x/2 (1 + x/3 (...))) for 0 <= x < 0.7, to the last bits of a double-double.
constexpr DoubleDouble exp_series(DoubleDouble x) {
  DoubleDouble sum{1, 0};
  for (int k = 26; k >= 1; --k) sum = x / DoubleDouble{static_cast<double>(k), 0} * sum + 1.0;
  return sum;
}

/// 2^(i/32), i = 0..31.
constexpr std::array<DoubleDouble, 32> make_root_table() {
  std::array<DoubleDouble, 32> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = exp_series(ln_2 * (static_cast<double>(i) / 32));
  return table;
}
constexpr std::array<DoubleDouble, 32> root_table = make_root_table();

/// a * 2^k rounded once, also where the result is subnormal; 1/2 < a < 2, -1080 <= k <= 1024.
double scaled(DoubleDouble a, int k) {
  if (k > 0) return a.hi * power_of_two(k - 1) * 2;
  if (k > -1022 || (k == -1022 && a.hi >= 1)) return a.hi * power_of_two(k);
  // The sum with `anchor`, whose last bit weighs as much as the last bit of a subnormal result, is rounded there.
  const double anchor = power_of_two(-1022 - k);
  const DoubleDouble sum = fast_two_sum(anchor, a.hi);
  const double rounded = (sum.hi + (sum.lo + a.lo)) - anchor;
  return rounded * power_of_two(k + 200) * 0x1p-200;
}

/// e^x for -746 < x < 711: x = n ln2/32 + r, e^x = 2^(n/32) e^r with |r| < 0.011. The upper part of ln2/32 is short
/// enough for n times it to be exact.
double exp_of(DoubleDouble x) {
  constexpr double c[] = {1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040};
  const double n = nearest_whole(x.hi * 0x1.71547652b82fep+5);
  const double r = ((x.hi - n * 0x1.62e42fefap-6) - n * 0x1.cf79abc9e3b3ap-45) + x.lo;
  const double grown = r + r * r * polynomial(r, c);
  const int thirty_seconds = static_cast<int>(n);
  const int rest = thirty_seconds & 31;
  const DoubleDouble root = root_table[static_cast<std::size_t>(rest)];
  return scaled(fast_two_sum(root.hi, root.lo + root.hi * grown), (thirty_seconds - rest) / 32);
}

/// ln a for rational a near 1: 2 (z + z^3/3 + z^5/5 + ...) with z = (a - 1) / (a + 1), |z| <= 0.18.
constexpr DoubleDouble log_series(DoubleDouble a) {
  const DoubleDouble z = (a + -1.0) / (a + 1.0);
  const DoubleDouble square = z * z;
  DoubleDouble sum;
  for (int k = 43; k >= 1; k -= 2) sum = square * sum + DoubleDouble{1, 0} / DoubleDouble{static_cast<double>(k), 0};
  return z * sum * 2.0;
}

/// For the i-th of the intervals of width 1/128 that cover [sqrt(1/2), sqrt(2)], the first being centred on 91/128:
/// `factor`, a multiple of 1/512 near the inverse of its centre, and the logarithm of 1/factor.
struct LogEntry {
  double factor = 0;
  DoubleDouble log;
};

constexpr int first_interval = 91;
constexpr std::array<LogEntry, 91> make_log_table() {
  std::array<LogEntry, 91> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double factor = nearest_whole(512 * 128 / static_cast<double>(first_interval + i)) / 512;
    table[i] = {factor, -log_series({factor, 0})};
  }
  return table;
}
constexpr std::array<LogEntry, 91> log_table = make_log_table();

/// x = m * 2^exponent, sqrt(1/2) <= m <= sqrt(2).
struct Parts {
  double m = 0;
  int exponent = 0;
};

Parts parts_of(double x) {
  int exponent = -1023;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    exponent -= 54;
  }
  const auto bits = bits_as<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52);
  const double m = bits_as<double>((bits & 0xfffffffffffffU) | 0x3ff0000000000000U);
  return m > 0x1.6a09e667f3bcdp+0 ? Parts{m / 2, exponent + 1} : Parts{m, exponent};
}

/// ln(1 + r) for |r| < 1/160: the first two terms exactly, the rest in double.
DoubleDouble log_of_one_plus(DoubleDouble r) {
  constexpr double c[] = {1.0 / 3, -1.0 / 4, 1.0 / 5, -1.0 / 6, 1.0 / 7, -1.0 / 8, 1.0 / 9, -1.0 / 10};
  const DoubleDouble square = two_product(r.hi, r.hi);
  const double tail = r.hi * square.hi * polynomial(r.hi, c);
  const DoubleDouble upper = fast_two_sum(r.hi, -0.5 * square.hi);
  return fast_two_sum(upper.hi, tail + (upper.lo + (r.lo - (0.5 * square.lo + r.hi * r.lo))));
}

/// ln x for 0 < x < infinity: x = 2^k m, m * factor = 1 + r.
DoubleDouble log_of(double x) {
  const Parts parts = parts_of(x);
  const LogEntry& entry = log_table[static_cast<std::size_t>(parts.m * 128 + 0.5) - first_interval];
  const DoubleDouble halves = split(parts.m);
  const DoubleDouble r = two_sum(halves.hi * entry.factor - 1, halves.lo * entry.factor);
  const DoubleDouble m_log = entry.log + log_of_one_plus(r);
  return ln_2 * static_cast<double>(parts.exponent) + m_log;
}

/// What a logarithm is where it is not an ordinary number.
double log_at_the_edge(double x) {
  if (x == 0) return -infinity;
  return x > 0 ? x : nan;
}

bool is_ordinary(double x) { return x > 0 && x < infinity; }

bool is_whole(double y) {
  const double size = std::fabs(y);
  return size >= 0x1p53 || static_cast<double>(static_cast<std::int64_t>(size)) == size;
}

bool is_odd(double y) {
  const double size = std::fabs(y);
  return size < 0x1p53 && is_whole(size) && (static_cast<std::int64_t>(size) & 1) != 0;
}

/// x^y where x is 0 or infinite (its size given) or y is infinite; the sign is left to the caller.
double power_at_the_edge(double size, double y) {
  if (size == 1) return 1;
  return (size > 1) == (y > 0) ? infinity : 0;
}

/// x^y for ordinary x.
double power_of(double x, double y) {
  if (x == 1) return 1;
  const DoubleDouble log = log_of(x);
  if (std::fabs(y) > 0x1p65) return power_at_the_edge(x, y);  // |log x| is at least 2^-53
  const double estimate = y * log.hi;
  if (estimate > 710) return infinity;
  if (estimate < -746) return 0;
  return exp_of(log * y);
}

}  // namespace

double exp(double x) {
  if (x > 710) return infinity;
  if (x < -746) return 0;
  return x == x ? exp_of({x, 0}) : nan;
}

double log(double x) { return is_ordinary(x) ? log_of(x).hi : log_at_the_edge(x); }
double log2(double x) { return is_ordinary(x) ? (log_of(x) * one_over_ln_2).hi : log_at_the_edge(x); }
double log10(double x) { return is_ordinary(x) ? (log_of(x) * one_over_ln_10).hi : log_at_the_edge(x); }

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  const double size = std::fabs(x);
  if (!(size <= infinity && std::fabs(y) <= infinity)) return nan;
  if (y == 2) return x * x;  // rounded once: nothing is closer
  if (std::fabs(y) == infinity) return power_at_the_edge(size, y);
  if (x < 0 && size < infinity && !is_whole(y)) return nan;
  const double value = is_ordinary(size) ? power_of(size, y) : power_at_the_edge(size, y);
  return std::signbit(x) && is_odd(y) ? -value : value;
}

}  // namespace proofreel::elementary
