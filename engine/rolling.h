#pragma once

/// Rolling resistance: what rolls presses into its ground a little, so the normal force acts a lever ahead of the
/// middle and brakes the turning. A pair of shapes brakes its relative spin with a torque of at most lever * normal
/// force (Coulomb's law of rolling, 1785), and holds still as long as less is enough.

#include <vector>

#include "engine/contact.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

struct ContactConstraint;

/// The rows of those contacts that resist rolling; none where no shape does. They lie apart from the contact points, so
/// that scenes without them pay nothing.
class RollingRows {
 public:
  struct Row {
    std::uint32_t constraint = 0;
    BodyIndex body_a = 0;
    BodyIndex body_b = 0;
    real lever = 0;    ///< m
    real inertia = 0;  ///< effective, kg m^2
    real impulse = 0;  ///< N m s on B, of this substep so far
    real warm = 0;     ///< of the substep before: where this one starts from
    real total = 0;    ///< of this tick so far
  };

  void prepare(const std::vector<Contact>& contacts, const std::vector<ContactConstraint>& constraints,
               const std::vector<Motion>& motions);
  void clear() { rows_.clear(); }
  void begin_substep();
  void add_share(std::vector<Motion>& motions, real share);
  void sweep(const std::vector<ContactConstraint>& constraints, std::vector<Motion>& motions);
  void end_substep();
  void store(const std::vector<ContactConstraint>& constraints, std::vector<Contact>& contacts) const;
  const std::vector<Row>& rows() const { return rows_; }
  std::vector<Row>& rows() { return rows_; }

 private:
  std::vector<Row> rows_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
