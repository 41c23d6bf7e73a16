#pragma once

/// The impulses of a group of contacts in which one body alone moves: what lies on the ground, leans in a corner,
/// slides down a chute. Most groups are of that kind, and however many rows they have there is little to solve: three
/// unknowns, the velocity and the spin.
///
/// As in ContactNewton every row has a spring that presses with l(u) = l0 - r u at speed u, cut off at 0 for a gap, at
/// -mu N and +mu N for friction. Guess which rows act, which slide and which are cut off; bring the body in balance
/// with those; look again. When the guess was right, l0 becomes l, until no spring gives way any more (the method of
/// multipliers: Hestenes, Powell 1969). The first guess is what acted last time, and it is nearly always right.
///
/// Beyond ContactNewton, N is not that of the round before: what slides follows its normal force at once, as if the
/// force of that gap leant by mu to one side. That makes the matrix of 3 x 3 unsymmetric, which costs nothing here, and
/// sliding as quick to find as sticking (Newton's method on Coulomb's law: Alart and Curnier 1991).
///
/// Where rows are redundant, as the four of a box on the ground are, they share the load as they did before.

#include <array>
#include <cstdint>
#include <vector>

#include "engine/contact_problem.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class LoneBodyContacts {
 public:
  enum class Outcome : std::uint8_t {
    unchanged,  ///< the impulses given were the solution
    solved,     ///< now they are
    unsolved    ///< nothing has changed: no guess was right
  };

  /// Gives all rows their impulses at once. `body` is the one that moves; all others in the rows' terms are not pushed.
  /// Impulses that are off by no more than `negligible` of the largest are left as they are. In double precision
  /// whatever the engine's.
  Outcome solve(std::vector<ContactRow>& rows, BodyIndex body, std::vector<Motion>& motions, double negligible);

 private:
  using Vec3 = std::array<double, 3>;

  /// What a row gives at present: nothing, or what its spring wants, or all that its bound allows.
  enum class Role : std::uint8_t { cut_off, acts, slides_forwards, slides_backwards };

  /// In units in which what moves has mass 1 whichever row pushes it: m/s times sqrt(kg), for speeds and impulses.
  struct Row {
    Vec3 way;        ///< what a unit impulse does to the body, of length 1; 0 for what it cannot move
    double size;     ///< what the length was before, 1 / sqrt(kg)
    double start;    ///< speed at the start
    double given;    ///< impulse at the start
    double from;     ///< l0
    double impulse;  ///< l
    double speed;    ///< u
    Role role;
  };

  void begin(const std::vector<ContactRow>& rows, BodyIndex body, const std::vector<Motion>& motions);
  double most_of(const ContactRow& row, std::size_t i, double Row::*impulse) const;
  bool is_in_balance(const std::vector<ContactRow>& rows, double negligible) const;
  bool find_balance(const std::vector<ContactRow>& rows);
  void sweep(const std::vector<ContactRow>& rows);
  bool respond(const std::vector<ContactRow>& rows);
  bool invert(const std::vector<ContactRow>& rows);
  Vec3 find_missing() const;
  bool take_impulses();
  void apply(std::vector<ContactRow>& rows, Motion& motion) const;

  std::vector<Row> rows_;
  std::array<Vec3, 3> inverse_ = {};
  Vec3 change_ = {};  ///< of the body's velocity and spin since the start
  double root_inv_mass_ = 0;
  double root_inv_inertia_ = 0;
  double scale_ = 0;  ///< the largest impulse
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
