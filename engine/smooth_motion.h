#pragma once

/// Integrators for smooth motion: nothing collides and nothing is held rigidly, so that the motion is a plain system of
/// differential equations, x' = v and v' = a(x, v, t), and the whole of numerical analysis is at hand.
///
/// rk4: the classical fourth-order rule (Kutta 1901). Explicit and cheap; energy drifts away steadily.
/// implicit_midpoint, gauss_legendre6: collocation at the Gauss points, one and three of them (Kuntzmann 1961, Butcher
/// 1964), orders 2 and 6. Symplectic and time-reversible: energy only ripples, however long the run. Their equations
/// are solved by iterating to the last bit, which converges while h times the highest frequency stays below about 2.

#include <functional>
#include <span>
#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What a body's position and velocity change by, per second.
struct Slope {
  Vec2 velocity;
  real spin = 0;
  Vec2 acceleration;
  real angular_acceleration = 0;
  real power = 0;  ///< of forces without a potential, W
};
using Slopes = std::vector<Slope>;

/// Fills in the accelerations of all bodies as they now are in the motions being integrated, `after` seconds from the
/// start of the step. There is one slope per body.
using Accelerate = std::function<void(real after, Slopes& slopes)>;

class SmoothIntegrator {
 public:
  /// Moves all bodies on by `h` seconds. False when the equations of an implicit rule did not converge: then the
  /// motions are useless.
  bool step(Integrator integrator, real h, std::vector<Motion>& motions, const Accelerate& accelerate);
  /// What the power of the last step came to, J, as exactly as the motion itself.
  double work() const { return work_; }

 private:
  void finish(real h, std::vector<Motion>& motions, std::span<const double> weights);
  void rk4(real h, std::vector<Motion>& motions, const Accelerate& accelerate);
  template <int stages>
  bool gauss(real h, std::vector<Motion>& motions, const Accelerate& accelerate);
  void look(real after, const std::vector<Motion>& motions, const Accelerate& accelerate, Slopes& slopes) const;

  std::vector<Motion> start_;
  Slopes slopes_[4];
  Slopes renewed_;
  double work_ = 0;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
