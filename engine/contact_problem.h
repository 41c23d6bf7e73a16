#pragma once

/// A group of contacts as one problem: rows, each a number that is kept and an impulse that keeps it, and how to find
/// the impulses of all of them (exact_contacts.h tells what for).

#include <cstdint>
#include <vector>

#include "engine/joint_rows.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

enum class RowKind : std::uint8_t {
  gap,   ///< the gap of a point: its impulse is not negative
  slip,  ///< a slip that friction holds, with no more than the coefficient times the impulse of its gap
  roll,  ///< a roll that rolling resistance holds, with no more than the lever times the impulses of its gaps
  stop   ///< what is left to a joint's stop, as a gap: its impulse is not negative
};

struct ContactRow {
  RowKind kind = RowKind::gap;
  std::size_t constraint = 0;  ///< or the group of joints
  std::size_t place = 0;       ///< of the point in the constraint, or of the rolling row, or of the stop in its group
  Term term;
  std::size_t first_gap = 0;  ///< slip, roll: the rows whose impulses bound this one
  std::size_t gap_count = 0;
  real coefficient = 0;  ///< of that bound: of friction, or the lever in m
  real bias = 0;         ///< added to the speed
  real given = 0;        ///< impulse of this substep so far
  real expected = 0;     ///< what it held before, and will hold if nothing has changed
  bool closed = false;   ///< a gap that is closed at the start, as far as can be told
  bool off = false;      ///< a gap that is open: takes no impulse
};

/// Whether its impulse is bound by nothing but its sign.
inline bool only_pushes(const ContactRow& row) { return row.kind == RowKind::gap || row.kind == RowKind::stop; }

/// Pivoting takes time in proportion to the cube of the rows; more than these are swept.
inline constexpr std::size_t most_rows_to_pivot = 64;

/// Whether impulses move it.
inline bool is_moved(const Motion& m) { return m.inv_mass > 0 || m.inv_inertia > 0; }

/// Goes its way whatever pushes back.
inline bool is_mover(const Motion& m) { return !is_moved(m) && (!(m.velocity == Vec2{}) || m.spin != 0); }

/// As speed_of, to all the digits that the motions have.
inline double speed_in_double(const Term& t, const std::vector<Motion>& motions) {
  const Motion& a = motions[t.body_a];
  const Motion& b = motions[t.body_b];
  return dot(Vec2d(b.velocity) - Vec2d(a.velocity), Vec2d(t.direction)) +
         static_cast<double>(t.arm_b) * static_cast<double>(b.spin) -
         static_cast<double>(t.arm_a) * static_cast<double>(a.spin);
}

/// Gives all rows their impulses at once, by complementary pivoting (lcp.h). `response` is the speed along row i per
/// impulse along row j, at i * rows + j, known to `noise` where a row's own is 1. False, and nothing has changed, where
/// there is no solution.
bool solve_by_pivots(std::vector<ContactRow>& rows, const std::vector<double>& response, double noise,
                     std::vector<Motion>& motions);

/// Whether one of the rows' bodies goes its way whatever pushes back.
bool has_mover(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions);

/// Row after row takes the impulse it needs at the moment, until nothing changes any more, or so many times.
void solve_by_sweeps(std::vector<ContactRow>& rows, std::vector<Motion>& motions, int most_sweeps);
/// The same by the responses of the rows to each other: where joints answer, what the bodies alone would do is not it.
void solve_by_sweeps(std::vector<ContactRow>& rows, const std::vector<double>& response, std::vector<Motion>& motions,
                     int most_sweeps);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
