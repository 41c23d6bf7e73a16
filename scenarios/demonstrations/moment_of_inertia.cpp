// Moments of inertia (thesis chapter 3.4, equations 3.13 to 3.16): a shape about its own centre and about an axis
// beside it, and by Steiner's theorem a body put together. All figures are those of engine/mass.h.

#include <algorithm>
#include <numbers>

#include "engine/elementary.h"
#include "engine/pose.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"
#include "scenarios/demonstrations/weighed.h"

namespace proofreel {
namespace {

constexpr int steps_of_a_turn = 72;
/// So many that figures that are rounded still add up by eye.
constexpr int digits = 3;
constexpr double full_turn = 2 * std::numbers::pi;

std::vector<Vec2d> ring(Vec2d center, double radius) {
  constexpr int corners = 72;
  std::vector<Vec2d> points;
  for (int i = 0; i < corners; ++i)
    points.push_back(center + radius * rotate(Rotd(full_turn * i / corners), Vec2d{1, 0}));
  return points;
}

double farthest_from(Vec2d center, const DemonstrationShape& shape) {
  double reach = 0;
  for (const Vec2d p : shape.parts[0]) reach = std::max(reach, distance(center, p) + shape.radius);
  return reach;
}

/// What a part contributes: its own moment, and its mass at a distance from the axis. kg m^2
struct Term {
  double own = 0;
  double moved = 0;
};

class Steiner {
 public:
  explicit Steiner(const Demonstration& asked)
      : asked_(asked), masses_(weighed(asked)), whole_(combined(masses_)), board_(asked.pace) {
    board_.pane("");
    bars_ = board_.pane("", 0.55, true);
  }

  Story tell() {
    tell_own();
    const bool is_beside =
        distance(masses_[0].center, whole_.center) > 0.01 * farthest_from(masses_[0].center, first());
    if (is_beside) tell_beside();
    tell_body();
    return board_.finish();
  }

 private:
  const DemonstrationShape& first() const { return asked_.shapes[0]; }

  Term term_of(std::size_t part, Vec2d axis) const {
    return {masses_[part].inertia, masses_[part].mass * length_squared(masses_[part].center - axis)};
  }

  void tell_own() {
    board_.heading("Moment of inertia about the own centre");
    const MassProperties& m = masses_[0];
    show_alone(first(), m.center);
    board_.step(
        "How hard is a shape to turn? Each piece of its mass counts by the square of its distance from the axis.", 4);
    show_turn(m.center, "About an axis through its own centre $C_1$ the moment of inertia is the least there is.");
    show_alone(first(), m.center);
    board_.show(labelled(dot_mark(Role::alert, m.center), {-1, 0}, "$C_1$"));
    board_.step(filled("$I_1 = \u2211 \u0394m\u2009r^2 = %$ kg\u2009m\u00b2 for a mass $m_1$ of $%$ kg",
                       {figure(m.inertia, digits), figure(m.mass)}),
                5);
  }

  void tell_beside() {
    board_.heading("Steiner: an axis beside the centre");
    const MassProperties& m = masses_[0];
    const double d = distance(m.center, whole_.center);
    board_.glide("The axis moves away, to where the centre of a whole body will be: $m_1 d_1^2$ grows.", 5, 48,
                 [&](double part) { show_alone(first(), lerp(m.center, whole_.center, part)); });
    show_turn(whole_.center, "Now the shape goes round the axis while it turns, and sweeps more.");
    show_alone(first(), whole_.center);
    const Vec2d way = whole_.center - m.center;
    board_.show(labelled(dot_mark(Role::first, m.center), {-1, 0}, "$C_1$"));
    board_.show(text_mark(Role::first, m.center + 0.8 * way + 0.2 * perp(way), {}, "$d_1$"));
    board_.step(filled("$I = I_1 + m_1 d_1^2 = % + % \u00b7 % = %$ kg\u2009m\u00b2, with $d_1 = %$ m",
                       {figure(m.inertia, digits), figure(m.mass, digits), figure(d * d, digits),
                        figure(m.inertia + m.mass * d * d, digits), figure(d, digits)}),
                6);
  }

  /// Once round the axis, with outlines left behind and the rim of what is swept.
  void show_turn(Vec2d axis, const std::string& caption) {
    std::vector<StoryMark> traces;
    int turns = 0;
    board_.glide(caption, 7, steps_of_a_turn, [&](double part) {
      const DemonstrationShape now = turned(first(), axis, full_turn * part);
      for (const StoryMark& trace : traces) board_.show(trace);
      if (turns++ % 6 == 0) traces.push_back(closed_path(Role::quiet, outline_of(now)));
      board_.show(closed_path(Role::candidate, ring(axis, farthest_from(axis, first()))));
      show_alone(now, axis);
    });
  }

  /// A disc as a ring; what is rounded otherwise by its core.
  static std::vector<Vec2d> outline_of(const DemonstrationShape& shape) {
    return shape.parts[0].size() == 1 ? ring(shape.parts[0][0], shape.radius) : shape.parts[0];
  }

  /// The first shape, which may have turned, and an axis.
  void show_alone(const DemonstrationShape& now, Vec2d axis) {
    const Vec2d center = weighed(now).center;
    board_.show(keyed(shape_mark(Role::first, now), "shape"));
    board_.show(keyed(path_mark(Role::chosen, {axis, center}), "d"));
    board_.show(keyed(dot_mark(Role::first, center), "C"));
    board_.show(keyed(dot_mark(Role::alert, axis), "axis"));
    const Vec2d below{0, -0.15 * farthest_from(whole_.center, first())};
    board_.show(keyed(text_mark(Role::first, axis + below, {}, "axis"), "axis"));
    show_sum({{masses_[0].inertia, masses_[0].mass * length_squared(center - axis)}});
  }

  void tell_body() {
    board_.heading("Moment of inertia of a whole body");
    show_parts(0);
    board_.step("All shapes of the body turn about their common centre of mass $C$. What does each add?", 4);
    for (std::size_t count = 1; count <= masses_.size(); ++count) {
      show_parts(count);
      const Term term = term_of(count - 1, whole_.center);
      board_.step(filled("Shape %: $% + %\u2009%^2 = % + %$ kg\u2009m\u00b2",
                         {figure(count), numbered("I", count - 1), numbered("m", count - 1), numbered("d", count - 1),
                          figure(term.own, digits), figure(term.moved, digits)}),
                  4);
    }
    show_parts(masses_.size());
    board_.step(filled("$I = \u2211 (I_i + m_i d_i^2) = %$ kg\u2009m\u00b2: what the engine turns the body by.",
                       {figure(whole_.inertia, digits)}),
                7);
  }

  /// Of all shapes the first `count` are counted.
  void show_parts(std::size_t count) {
    std::vector<Term> terms;
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      board_.show(shape_mark(i < count ? Role::first : Role::second, asked_.shapes[i]));
      if (i < count) board_.show(path_mark(Role::chosen, {whole_.center, masses_[i].center}));
      board_.show(labelled(dot_mark(Role::first, masses_[i].center), {0, -1}, filled("$%$", {numbered("C", i)})));
      if (i < count) terms.push_back(term_of(i, whole_.center));
    }
    board_.show(labelled(keyed(dot_mark(Role::alert, whole_.center), "axis"), {0, 1}, "C"));
    show_sum(terms);
  }

  /// A row for every part, own moment and the rest one after the other, and one for the sum.
  void show_sum(const std::vector<Term>& terms) {
    std::vector<Bar> bars;
    double sum = 0;
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      const std::string name = filled("$% + %\u2009%^2$", {numbered("I", i), numbered("m", i), numbered("d", i)});
      if (i >= terms.size()) {
        bars.push_back({Role::quiet, 0, name, ""});
        continue;
      }
      bars.push_back({Role::first, terms[i].own,
                      filled("%: % + %", {name, figure(terms[i].own, digits), figure(terms[i].moved, digits)}), name,
                      terms[i].moved, Role::chosen});
      sum += terms[i].own + terms[i].moved;
    }
    bars.push_back({Role::result, sum, filled("$I$: % kg\u2009m\u00b2", {figure(sum, digits)}), "sum"});
    show_bars(board_, bars_, bars, whole_.inertia);
  }

  const Demonstration& asked_;
  std::vector<MassProperties> masses_;
  MassProperties whole_;
  Storyboard board_;
  int bars_ = 0;
};

}  // namespace

Story tell_moment_of_inertia(const Demonstration& demonstration) { return Steiner(demonstration).tell(); }

}  // namespace proofreel
