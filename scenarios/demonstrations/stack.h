#pragma once

/// Shapes that rest on each other and on level ground under the lowest of them, and the engine's contact solver at work
/// on them: one substep of symplectic Euler after the other, as a tick with so many substeps has them, contacts found
/// once.

#include "engine/contact_solver.h"
#include "engine/observer.h"
#include "scenarios/demonstration.h"

namespace proofreel {

class Stack {
 public:
  static constexpr double gravity = 9.81;  ///< m/s^2, downwards

  /// Convex polygons, of one part each; body 0 is the ground.
  explicit Stack(const std::vector<DemonstrationShape>& shapes);

  /// Those with points; the events of the sweeps count them in this order.
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// The two shapes as they are called: "ground" or the number from 1.
  std::string name(const Contact& contact) const;
  /// Where a point of a contact is, world.
  Vec2d at(const Contact& contact, int point) const;

  /// Gravity acts for `h` seconds, and the impulses of the substep before are applied at once if it is a warm start.
  void begin_substep(double h, bool warm);
  /// One sweep over all contacts, the production solver's.
  template <typename Watching = NoObserver>
  void sweep(Watching observer = {}) {
    solver_.solve(motions_, h_, observer);
  }
  /// The bodies move.
  void end_substep();
  /// Of the body's centre, m/s.
  Vec2d velocity(std::size_t body) const { return Vec2d(motions_[body].velocity); }
  /// How far it has moved, m.
  Vec2d moved(std::size_t body) const { return Vec2d(motions_[body].delta); }
  /// Both points' normal impulses of this substep so far, N s, by contact.
  std::vector<double> impulses() const;

 private:
  void add_body(const DemonstrationShape& shape, bool fixed);

  std::vector<Vec2d> centers_;
  std::vector<Shape> shapes_;
  std::vector<Motion> motions_;
  std::vector<Contact> contacts_;
  ContactSolver solver_{ContactMethod::sequential_impulses};
  real h_ = 0;
};

}  // namespace proofreel
