#pragma once

/// A vector b that turns about the origin beside a vector a that stays, and a product of the two as a curve over the
/// angle between them: what the films on the dot product and on the cross product share.

#include <array>
#include <functional>

#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {

/// The panes of such a film. The diagram goes from 0 to 4 and from -1 to 1: quarter turns, and parts of |a| |b|.
inline constexpr int plane_pane = 0;
inline constexpr int curve_pane = 1;

/// What is said of the four quarters of the way round: while b is on its way, and where it has arrived.
struct TurningWords {
  std::array<std::string, 4> underway;
  std::array<std::string, 4> arrived;
};

class Turning {
 public:
  using Product = double (*)(Vec2d, Vec2d);
  /// What of the picture is the film's own, for the present b.
  using ShowMore = std::function<void(Vec2d b)>;

  /// `sign` stands between a and b; neither may be zero.
  Turning(Storyboard& board, Vec2d a, Vec2d b, Product product, std::string sign);

  /// One step with b where it was given.
  void begin(const std::string& caption, const ShowMore& more);
  /// Turns b on, counter-clockwise, until it points along a, with a halt at every quarter.
  void turn(const TurningWords& words, const ShowMore& more);
  Vec2d given_b() const { return b_at(start_); }

 private:
  /// After so many quarter turns from a's direction; whole ones are exact.
  Vec2d b_at(double quarters) const;
  void show(double quarters, const ShowMore& more);
  void show_angle(double quarters);
  void show_curve(double quarters);
  double height_of_curve(double quarters) const;

  Storyboard& board_;
  Vec2d a_;
  double length_b_;
  double start_;  ///< quarter turns from a to b as given, 0 to 4
  Product product_;
  std::string sign_;
  std::vector<StoryMark> curve_;  ///< so far
  double drawn_to_;
};

/// An arrow with its name beside its point: on the left of its way for a `side` of 1, on the right for -1. Both move
/// from where they were.
void show_vector(Storyboard& board, Role role, Vec2d from, Vec2d to, const std::string& name, double side);

/// A sector about the origin around `middle`, a unit vector, as a convex region; `half_angle` up to a quarter turn.
StoryMark sector_mark(Role role, Vec2d middle, double radius, double half_angle);

/// A point that is looked at, and what came of it.
struct LookedAt {
  Vec2d at;
  double part = 0;    ///< how far its bar reaches: -1 to 1, to the left or to the right
  std::string value;  ///< what its bar stands for; empty while it has none
  Role role = Role::first;
};

/// All points with their names, and for those that have a value a bar from the middle of the diagram to its left or
/// right. `limit` is a line they may have to reach.
void show_looked_at(Storyboard& board, const std::vector<LookedAt>& points, double limit = 0);
/// "P_{2}"
std::string point_name(std::size_t index);

}  // namespace proofreel
