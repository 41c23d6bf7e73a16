#pragma once

/// The kinds of joints, each in the file of its name: which rows it has, its equation C and the directions J in which C
/// changes (dC/dt = J v). Derivatives are taken once here and used everywhere; for the general recipe see Catto,
/// "Modeling and Solving Constraints" (2009).

#include "engine/joint_rows.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

using RowPlans = std::vector<RowPlan>;

void plan_revolute(const Joint& joint, RowsWanted wanted, RowPlans& rows);
void plan_distance(const Joint& joint, RowPlans& rows);
void plan_rope(const Joint& joint, RowsWanted wanted, RowPlans& rows);
void plan_prismatic(const Joint& joint, RowsWanted wanted, RowPlans& rows);
void plan_weld(RowPlans& rows);
void plan_wheel(const Joint& joint, RowsWanted wanted, RowPlans& rows);
void plan_gear(const Joint& joint, RowPlans& rows);
void plan_pulley(const Joint& joint, RowPlans& rows);
void plan_motor(const Joint& joint, RowsWanted wanted, RowPlans& rows);
/// Stops at both limits of a coordinate, or one equation where they are the same.
void plan_limits(const Joint& joint, Coordinate coordinate, RowPlans& rows);

Term anchor_term(const Joint& joint, const JointPlace& place, Vec2 direction);   // revolute.cpp
Term stretch_term(const Joint& joint, const JointPlace& place);                  // distance.cpp
Term axis_term(const Joint& joint, const JointPlace& place, Vec2 direction);     // prismatic.cpp
Term turn_term(const Joint& joint);                                              // weld.cpp
Term carried_term(const Joint& joint, const JointPlace& place, Vec2 direction);  // motor.cpp
Terms gear_terms(const Joint& joint, const JointedBodies& scene);                // gear.cpp
Terms pulley_terms(const Joint& joint, const JointPlace& place);                 // pulley.cpp

/// The gap across and along the axis of a prismatic joint or a wheel.
inline real across(const JointPlace& place) { return dot(place.gap, perp(place.axis)); }
inline real along(const JointPlace& place) { return dot(place.gap, place.axis); }

/// coordinate1 + ratio * coordinate2 of a gear, with all bodies `ahead` seconds further at their velocities.
real geared(const Joint& gear, const std::vector<Joint>& joints, const std::vector<Body>& bodies,
            const std::vector<Motion>& motions, real ahead = 0);
/// length_a + ratio * length_b of a pulley.
real roped(const Joint& pulley, const JointPlace& place);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
