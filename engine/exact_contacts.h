#pragma once

/// Contacts and friction solved exactly, group by group: all points that hang together through bodies and joints at
/// once, so that neither the order of the contacts, nor the ratio of the masses, nor a number of sweeps shows in the
/// result. It is the truth the other contact solvers are measured against, and slow.
///
/// For every point: the gap after the drift (before it: the speed of parting) is not negative, nor is the impulse, and
/// one of the two is 0 (Signorini 1933). For friction: the slip is 0 as long as the impulse stays within mu times the
/// normal impulse, else it opposes the slip with all of that (Coulomb 1785), which two impulses along +t and -t and the
/// slip's magnitude turn into a linear complementarity problem (Anitescu and Potra 1997). The matrix tells what speed
/// at one point a unit impulse at another one causes; joints take their share in it, for they answer at once.
///
/// Where others would do as well (Share::affordable) it has to be cheap: a group in which one body alone moves is
/// solved by LoneBodyContacts, others by ContactNewton, and impulses that are the solution already cost no more than a
/// look. Large ones get a single round of it, and only at rest. A crowd that jostles, body rubbing along body, and does
/// not settle tick after tick is left to the sweeps for a while; contacts remember that from tick to tick (Patience).
///
/// In time it is what joints do (joint_solver.h): impulses before the drift that lead the positions to where they may
/// be, and after the second half of the forces the velocities are put right.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/contact_goals.h"
#include "engine/contact_newton.h"
#include "engine/contact_problem.h"
#include "engine/contact_solver.h"
#include "engine/joint_solver.h"
#include "engine/lone_body_contacts.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class ExactContacts {
 public:
  /// Which gaps are looked at.
  enum class Reach : std::uint8_t {
    all,    ///< what would overlap after the drift is held back, and stays where it has arrived
    closed  ///< only what touches before the drift: all others are impacts, which somebody else locates
  };

  /// Which groups are solved.
  enum class Share : std::uint8_t {
    all,
    affordable  ///< not those whose factors are large, and with joints only what soft contacts would carry badly;
                ///< large ones only while they hardly move and have not given way
  };

  /// Groups the contacts, makes their rows and tells the constraints whose they are. Once per tick, after
  /// `contacts.prepare`. Joints take part if there are any.
  void prepare(ContactSolver& contacts, const JointSolver* joints, const std::vector<Motion>& motions, real h,
               Share share);
  bool empty() const { return chosen_groups_ == 0; }
  /// What is solved and why the rest is not, as part of a sentence: "at the last tick 3 of 5 contacts were solved
  /// exactly, in 1 island, 2 softly: their islands are too large".
  std::string told() const;
  /// Changes velocities so that drifting for `h` leaves no overlap. Joints must have been solved for positions.
  void solve_positions(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene, real h, Reach reach);
  /// Changes velocities so that nothing that touches approaches. Joints must have been solved for velocities.
  void solve_velocities(ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene, Reach reach);
  /// Books which groups have settled in this tick. Before `contacts.store`.
  void end_tick(ContactSolver& contacts, const std::vector<Motion>& motions);
  /// Whether a group of contacts moves jointed bodies, whose joints have to be solved again after it.
  bool moves_joints() const { return moves_joints_; }

 private:
  /// Why a group is left to soft contacts.
  enum class Left : std::uint8_t { solved, squeezed, overlaps, nets, large, unloaded, tumbling, jostling };
  enum class Stage : std::uint8_t { before_drift, after_drift };

  struct Group {
    std::size_t contacts = 0;
    std::vector<BodyIndex> immovables;  ///< that its contacts press against
    int movers = 0;                     ///< how many of them move
    BodyIndex lone_body = 0;            ///< the only one that moves; 0 where there are more, or joints answer
    Left left = Left::solved;
    bool parts = false;     ///< some of its bodies are inside each other since they met
    std::size_t stops = 0;  ///< of its joints, reached or not
    bool tumbles = false;   ///< has stops, and something that touches is fast
    bool loaded = false;    ///< soft contacts would show what they bear
    bool large = false;     ///< solved in a single round per call, unless it moves
    bool presses = false;   ///< some of its points bore something in the substep before
    bool has_sunk = false;  ///< some of its points overlap as exact ones would not
    bool blurred = false;   ///< some of its gaps are hardly known
    real haste = 0;         ///< sum over its contacts of the bodies' squared speeds, in thicknesses per second
    std::vector<ContactRow> rows;
    std::vector<std::size_t> joint_groups;
    std::vector<double> response;  ///< of every row to every other one; empty where not needed
    ContactNewton newton;
    Patience patience;
    bool failed = false;     ///< to settle in this tick
    bool jostles = false;    ///< while failing
    bool by_newton = false;  ///< its factors are not too large, and no joint answers

    bool chosen() const { return left == Left::solved; }
  };

  void group_by_bodies(const ContactSolver& contacts, const JointSolver* joints, const std::vector<Motion>& motions);
  std::span<Group> groups() { return {groups_.data(), used_}; }
  void add_group();
  void add_contact(Group& group, std::size_t constraint, const ContactSolver& contacts) const;
  static void note_immovable(Group& group, BodyIndex body, const std::vector<Motion>& motions);
  static void note_rest(Group& group, const ContactConstraint& c, const std::vector<Motion>& motions);
  static bool is_at_rest(const Group& group);
  static double most_work_for(const Group& group, Share share);
  static Left first_look(const Group& group, const JointSolver* joints);
  static const char* reason(Left left);
  static bool is_patient_with(const Group& group) { return group.lone_body == 0 && group.joint_groups.empty(); }
  void lose_patience(const std::vector<ContactConstraint>& constraints);
  void look_for_load(const std::vector<ContactConstraint>& constraints, const JointSolver* joints,
                     const std::vector<Motion>& motions, real h);
  void add_rolling(const ContactSolver& contacts);
  void take_in_stops(Group& group, JointSolver* joints, const JointedBodies& scene, real h);
  bool solve(Group& group, ContactSolver& contacts, JointSolver* joints, const JointedBodies& scene, Stage stage);
  bool solve_rows(Group& group, const JointSolver* joints, std::vector<Motion>& motions, double negligible);
  bool solve_large(Group& group, ContactSolver& contacts, std::vector<Motion>& motions);
  bool solve_cheaply(Group& group, std::vector<Motion>& motions, double negligible);
  void find_responses(Group& group, const JointSolver* joints, const std::vector<Motion>& motions);
  void try_responses(Group& group, const JointSolver& joints, const std::vector<Motion>& motions);

  Share share_ = Share::all;
  std::vector<Group> groups_;  ///< the first of which are this tick's; the others are kept for their room
  std::size_t used_ = 0;
  std::vector<std::size_t> group_of_;  ///< of every constraint
  std::size_t chosen_groups_ = 0;
  ContactGoals goals_;
  LoneBodyContacts lone_body_contacts_;
  std::vector<Motion> scratch_;
  std::vector<Stop> stops_;   ///< scratch
  std::vector<real> before_;  ///< scratch: impulses of the rows of a group
  bool moves_joints_ = false;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
