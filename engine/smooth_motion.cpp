#include "engine/smooth_motion.h"

#include <cmath>
#include <limits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr int most_rounds = 200;

Slope operator+(const Slope& a, const Slope& b) {
  return {a.velocity + b.velocity, a.spin + b.spin, a.acceleration + b.acceleration,
          a.angular_acceleration + b.angular_acceleration, a.power + b.power};
}

Slope operator*(real factor, const Slope& s) {
  return {factor * s.velocity, factor * s.spin, factor * s.acceleration, factor * s.angular_acceleration,
          factor * s.power};
}

/// The motion that `change` leads to from `start`: a slope times a time.
Motion moved(const Motion& start, const Slope& change) {
  Motion m = start;
  m.delta += change.velocity;
  m.velocity += change.acceleration;
  m.spin += change.angular_acceleration;
  if (change.spin == 0) return m;
  m.angle += change.spin;
  m.rotation = turned(start.rotation, change.spin);
  return m;
}

real size_of(const Slope& s) {
  return std::abs(s.velocity.x) + std::abs(s.velocity.y) + std::abs(s.spin) + std::abs(s.acceleration.x) +
         std::abs(s.acceleration.y) + std::abs(s.angular_acceleration);
}

/// The rule of `stages` Gauss points: stage i lies `at[i]` of the step after its start, on the path that the slopes of
/// all stages, weighted by its row, make; the weights make the whole step. `spread` is sqrt(15).
template <int stages>
struct GaussRule;

template <>
struct GaussRule<1> {
  static constexpr double at[1] = {0.5};
  static constexpr double row[1][1] = {{0.5}};
  static constexpr double weight[1] = {1};
};

template <>
struct GaussRule<3> {
  static constexpr double spread = 3.872983346207416885;
  static constexpr double at[3] = {0.5 - spread / 10, 0.5, 0.5 + spread / 10};
  static constexpr double row[3][3] = {{5.0 / 36, 2.0 / 9 - spread / 15, 5.0 / 36 - spread / 30},
                                       {5.0 / 36 + spread / 24, 2.0 / 9, 5.0 / 36 - spread / 24},
                                       {5.0 / 36 + spread / 30, 2.0 / 9 + spread / 15, 5.0 / 36}};
  static constexpr double weight[3] = {5.0 / 18, 4.0 / 9, 5.0 / 18};
};

/// The sum of the stages' slopes of body i, weighted.
Slope weighted(const Slopes (&slopes)[4], std::size_t i, real h, std::span<const double> weights) {
  Slope sum = h * static_cast<real>(weights[0]) * slopes[0][i];
  for (std::size_t j = 1; j < weights.size(); ++j) sum = sum + h * static_cast<real>(weights[j]) * slopes[j][i];
  return sum;
}

/// Ends an iteration: when nothing changes any more but by rounding, or when it only gets worse.
class Convergence {
 public:
  /// `change` beside `size` is what the last round made of the unknowns.
  bool goes_on(real change, real size) {
    const bool settled = change <= std::numeric_limits<real>::epsilon() * size;  // not when they are no numbers
    const bool stuck = change >= last_ && change <= rounding * size;
    rounds_without_gain_ = change < least_ ? 0 : rounds_without_gain_ + 1;
    least_ = std::min(least_, change);
    last_ = change;
    done_ = settled || stuck || (rounds_without_gain_ >= patience && change <= noise * size);
    return !done_;
  }
  bool done() const { return done_; }

 private:
  static constexpr real rounding = 64 * std::numeric_limits<real>::epsilon();
  /// A stiff spring makes large accelerations of the last digits of places, and no round takes them away. What has got
  /// no smaller for a while and is this small is such noise: an iteration that diverges grows instead.
  static constexpr real noise = sizeof(real) == sizeof(double) ? real(1e-6) : real(1e-2);
  static constexpr int patience = 8;
  real last_ = std::numeric_limits<real>::max();
  real least_ = std::numeric_limits<real>::max();
  int rounds_without_gain_ = 0;
  bool done_ = false;
};

}  // namespace

void SmoothIntegrator::look(real after, const std::vector<Motion>& motions, const Accelerate& accelerate,
                            Slopes& slopes) const {
  slopes.assign(motions.size(), Slope{});
  accelerate(after, slopes);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    slopes[i].velocity = motions[i].velocity;
    slopes[i].spin = motions[i].spin;
  }
}

void SmoothIntegrator::rk4(real h, std::vector<Motion>& motions, const Accelerate& accelerate) {
  const real at[4] = {0, real(0.5) * h, real(0.5) * h, h};
  for (int stage = 0; stage < 4; ++stage) {
    for (std::size_t i = 0; stage > 0 && i < motions.size(); ++i)
      motions[i] = moved(start_[i], at[stage] * slopes_[stage - 1][i]);
    look(at[stage], motions, accelerate, slopes_[stage]);
  }
  constexpr double weights[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  finish(h, motions, weights);
}

void SmoothIntegrator::finish(real h, std::vector<Motion>& motions, std::span<const double> weights) {
  work_ = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Slope whole = weighted(slopes_, i, h, weights);
    motions[i] = moved(start_[i], whole);
    work_ += static_cast<double>(whole.power);
  }
}

template <int stages>
bool SmoothIntegrator::gauss(real h, std::vector<Motion>& motions, const Accelerate& accelerate) {
  using Rule = GaussRule<stages>;
  look(0, motions, accelerate, slopes_[0]);
  for (int stage = 1; stage < stages; ++stage) slopes_[stage] = slopes_[0];
  Convergence convergence;
  real change = 0;
  real size = 0;
  int round = 0;
  do {
    change = size = 0;
    for (int stage = 0; stage < stages; ++stage) {
      for (std::size_t i = 0; i < motions.size(); ++i)
        motions[i] = moved(start_[i], weighted(slopes_, i, h, Rule::row[stage]));
      look(static_cast<real>(Rule::at[stage]) * h, motions, accelerate, renewed_);
      for (std::size_t i = 0; i < motions.size(); ++i) {
        const real changed = size_of(renewed_[i] + real(-1) * slopes_[stage][i]);
        if (!(changed <= change)) change = changed;  // so that what is not a number stays
        size = std::max(size, size_of(renewed_[i]));
      }
      std::swap(slopes_[stage], renewed_);
    }
  } while (convergence.goes_on(change, size) && ++round < most_rounds);
  finish(h, motions, Rule::weight);
  return convergence.done();
}

bool SmoothIntegrator::step(Integrator integrator, real h, std::vector<Motion>& motions, const Accelerate& accelerate) {
  start_ = motions;
  if (integrator == Integrator::implicit_midpoint) return gauss<1>(h, motions, accelerate);
  if (integrator == Integrator::gauss_legendre6) return gauss<3>(h, motions, accelerate);
  rk4(h, motions, accelerate);
  return true;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
