#include "golden/ticks.h"

#include <algorithm>
#include <array>

namespace proofreel {
namespace {

/// The largest prime below 2^16.
constexpr std::uint64_t prime = 65521;

using Sums = std::array<std::uint64_t, TickTrace::sums>;

std::uint64_t power(std::uint64_t base, std::uint64_t exponent) {
  std::uint64_t result = 1;
  for (; exponent > 0; exponent /= 2, base = base * base % prime) {
    if (exponent % 2 == 1) result = result * base % prime;
  }
  return result;
}

/// By Fermat: a^(p-2) a = 1.
std::uint64_t quotient(std::uint64_t a, std::uint64_t b) { return a * power(b, prime - 2) % prime; }

std::uint64_t less(std::uint64_t a, std::uint64_t b) { return (a + prime - b) % prime; }

std::uint64_t fingerprint(const BodyState& body) {
  const std::array<double, 6> motion{body.position.x, body.position.y, body.angle,
                                     body.velocity.x, body.velocity.y, body.spin};
  return hash_of(motion.data(), sizeof motion) % prime;
}

void add(Sums& sums, std::uint64_t body, std::uint64_t print) {
  for (std::uint64_t& sum : sums) {
    sum = (sum + print) % prime;
    print = print * (body % prime) % prime;
  }
}

Sums difference_at(const TickTrace& then, const TickTrace& now, std::size_t tick) {
  Sums sums{};
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const std::size_t at = tick * TickTrace::sums + k;
    sums[k] = less(now.body_sums[at], then.body_sums[at]);
  }
  return sums;
}

/// One body with fingerprints h off: S_k = h i^k.
std::optional<std::uint32_t> only_body(const Sums& s, std::size_t bodies) {
  if (s[0] == 0) return std::nullopt;
  const std::uint64_t body = quotient(s[1], s[0]);
  const bool fits = s[2] == body * s[1] % prime && s[3] == body * s[2] % prime;
  if (!fits || body == 0 || body > bodies) return std::nullopt;
  return static_cast<std::uint32_t>(body);
}

/// Two bodies i and j: all S_k obey S_(k+2) = (i + j) S_(k+1) - i j S_k, which gives i + j and i j, and so the bodies.
std::vector<std::uint32_t> two_bodies(const Sums& s, std::size_t bodies) {
  const std::uint64_t determinant = less(s[1] * s[1] % prime, s[0] * s[2] % prime);
  if (determinant == 0) return {};
  const std::uint64_t sum = quotient(less(s[1] * s[2] % prime, s[0] * s[3] % prime), determinant);
  const std::uint64_t product = quotient(less(s[2] * s[2] % prime, s[1] * s[3] % prime), determinant);
  std::vector<std::uint32_t> found;
  for (std::uint64_t body = 1; body <= bodies; ++body) {
    if ((body * body + product) % prime == sum * body % prime) found.push_back(static_cast<std::uint32_t>(body));
  }
  return found.size() == 2 ? found : std::vector<std::uint32_t>{};
}

std::vector<std::uint32_t> bodies_behind(const Sums& difference, std::size_t bodies) {
  if (const auto body = only_body(difference, bodies)) return {*body};
  return two_bodies(difference, bodies);
}

std::vector<std::uint32_t> first_bodies(const TickTrace& then, const TickTrace& now, std::size_t tick,
                                        std::size_t bodies) {
  if (bodies == 1) return {1};
  const bool summed = !then.body_sums.empty() && !now.body_sums.empty();
  return summed ? bodies_behind(difference_at(then, now, tick), bodies) : std::vector<std::uint32_t>{};
}

constexpr std::array<std::uint8_t, 4> signature{'P', 'T', 'K', '1'};
constexpr std::size_t header_size = signature.size() + 1;  // and how many sums there are per tick

void append(std::vector<std::uint8_t>& bytes, std::uint16_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value & 255U));
  bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
}

std::vector<std::uint16_t> values_in(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint16_t> values;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    values.push_back(static_cast<std::uint16_t>(bytes[i] | bytes[i + 1] << 8U));
  }
  return values;
}

}  // namespace

void TickRecorder::record(const Simulation& simulation, std::size_t bodies, std::uint64_t trajectory_hash) {
  Sums sums{};
  for (std::size_t id = 1; id <= bodies; ++id) {
    const auto body = static_cast<BodyId>(id);
    if (simulation.exists(body)) add(sums, id, fingerprint(simulation.body(body)));
  }
  most_bodies_ = std::max(most_bodies_, bodies);
  trace_.pieces.push_back(static_cast<std::uint16_t>(trajectory_hash & 0xffffU));
  for (const std::uint64_t sum : sums) trace_.body_sums.push_back(static_cast<std::uint16_t>(sum));
}

TickTrace TickRecorder::trace() const {
  if (most_bodies_ > 1) return trace_;
  return {trace_.pieces, {}};
}

std::optional<Divergence> first_divergence(const TickTrace& then, const TickTrace& now, std::size_t bodies) {
  const std::size_t common = std::min(then.pieces.size(), now.pieces.size());
  for (std::size_t tick = 0; tick < common; ++tick) {
    if (then.pieces[tick] == now.pieces[tick]) continue;
    return Divergence{static_cast<std::int64_t>(tick), first_bodies(then, now, tick, bodies)};
  }
  return std::nullopt;
}

std::vector<std::uint8_t> bytes_of(const TickTrace& trace) {
  std::vector<std::uint8_t> bytes(signature.begin(), signature.end());
  bytes.push_back(static_cast<std::uint8_t>(trace.body_sums.empty() ? 0 : TickTrace::sums));
  for (const std::uint16_t piece : trace.pieces) append(bytes, piece);
  for (const std::uint16_t sum : trace.body_sums) append(bytes, sum);
  return bytes;
}

std::optional<TickTrace> tick_trace_from(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < header_size || !std::equal(signature.begin(), signature.end(), bytes.begin())) {
    return std::nullopt;
  }
  const std::size_t sums = bytes[signature.size()], bytes_per_tick = 2 * (1 + sums);
  const std::span<const std::uint8_t> rest = bytes.subspan(header_size);
  if ((sums != 0 && sums != TickTrace::sums) || rest.size() % bytes_per_tick != 0) return std::nullopt;
  const std::size_t ticks = rest.size() / bytes_per_tick;
  return TickTrace{values_in(rest.first(2 * ticks)), values_in(rest.subspan(2 * ticks))};
}

}  // namespace proofreel
