// Outlines: convex or concave by the diagonals of a quadrilateral and by a walk along the edges (thesis figures 3.4 and
// 3.5), and the centroid by triangulation with signed areas (figure 3.9).

#include "engine/outline.h"
#include "engine/polygon.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {
namespace {

/// The corners counter-clockwise, whatever their order was.
std::vector<Vec2d> outline_of(const Demonstration& demonstration) {
  return std::get<std::vector<Vec2d>>(clean_polygon(demonstration.points));
}

Vec2d outward(const std::vector<Vec2d>& corners, Vec2d p) { return towards(middle_of(corners), p); }

/// The outline with names at its corners, and the first sentence.
Storyboard begun(const Demonstration& asked, const std::vector<Vec2d>& corners, const std::string& prefix,
                 const std::string& heading, const std::string& sentence) {
  Storyboard board(asked.pace);
  board.pane("");
  board.heading(heading);
  board.keep(closed_path(Role::first, corners));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string name = prefix.empty() ? letter(i) : filled("$%_{%}$", {prefix, std::to_string(i + 1)});
    board.keep(labelled(dot_mark(Role::first, corners[i]), outward(corners, corners[i]), name));
  }
  board.step(sentence, 3);
  return board;
}

std::string sign_of(double value) { return value > 0 ? " > 0" : value < 0 ? " < 0" : ""; }

class Diagonals {
 public:
  explicit Diagonals(Storyboard& board) : board_(board) {}

  void tell(const DiagonalTested& event) {
    const std::string names = told_++ == 0 ? "ACBD" : "BDAC";  // the diagonal, then the two other corners
    const double one = orientation(event.a, event.c, event.one);
    const double other = orientation(event.a, event.c, event.other);
    const Role role = event.separates ? Role::result : Role::alert;
    board_.show(region_mark(Role::chosen, {event.a, event.c, event.one}));
    board_.show(region_mark(event.separates ? Role::candidate : Role::chosen, {event.a, event.c, event.other}));
    board_.show(path_mark(role, {event.a, event.c}));
    const auto product = [&](char to, double value) {
      return filled("$\\vec{%} \u00d7 \\vec{%} = %%$",
                    {names.substr(0, 2), {names[0], to}, figure(value), sign_of(value)});
    };
    board_.step(
        filled("% and %: the diagonal %%", {product(names[2], one), product(names[3], other), names.substr(0, 2),
                                            event.separates ? " has the other two corners on its two sides."
                                                            : " has both other corners on the same side."}),
        4);
  }

 private:
  Storyboard& board_;
  int told_ = 0;
};

class EdgeWalk {
 public:
  EdgeWalk(const std::vector<Vec2d>& corners, Storyboard& board) : corners_(corners), board_(board) {}

  void tell(const CornerTested& event) {
    const Role role = event.convex ? Role::result : Role::alert;
    for (const StoryMark& mark : done_) board_.show(mark);
    board_.show(region_mark(role, {event.before, event.corner, event.after}));
    board_.show(keyed(arrow_mark(Role::chosen, event.before, event.corner), "in"));
    board_.show(keyed(arrow_mark(Role::candidate, event.corner, event.after), "out"));
    board_.show(dot_mark(role, event.corner));
    done_.push_back(dot_mark(role, event.corner));
    const std::size_t n = corners_.size();
    const std::size_t here = done_.size();
    const auto corner = [n](std::size_t number) { return filled("V_{%}", {figure((number + n - 1) % n + 1)}); };
    board_.counters({{"corners", filled("% of %", {figure(here), figure(n)})}});
    board_.step(filled("$\\vec{%%} \u00d7 \\vec{%%} = %%$: %",
                       {corner(here + n - 1), corner(here), corner(here), corner(here + 1), figure(event.turn),
                        sign_of(event.turn), event.convex ? "a left turn." : "a right turn."}));
  }

  void finish(bool convex) {
    for (const StoryMark& mark : done_) board_.show(mark);
    board_.show(closed_path(convex ? Role::result : Role::alert, corners_));
    board_.step(convex ? "Left turns only, once round: every inner angle is below 180\u00b0, the polygon is convex."
                       : "One right turn is enough: an inner angle is above 180\u00b0, the polygon is concave.",
                5);
  }

 private:
  const std::vector<Vec2d>& corners_;
  Storyboard& board_;
  std::vector<StoryMark> done_;
};

class Centroid {
 public:
  explicit Centroid(Storyboard& board) : board_(board) {}

  void tell(const TriangleAdded& event) {
    ++count_;
    area_ += event.signed_area;
    moment_ += event.signed_area * event.centroid;
    show_triangles();
    const Role role = event.signed_area < 0 ? Role::alert : Role::chosen;
    triangles_.push_back(region_mark(role, {event.a, event.b, event.c}));
    triangles_.push_back(closed_path(role, {event.a, event.b, event.c}));
    const std::string number = std::to_string(count_);
    board_.show(region_mark(Role::candidate, {event.a, event.b, event.c}));
    board_.show(closed_path(Role::candidate, {event.a, event.b, event.c}));
    centres_.push_back(labelled(dot_mark(role, event.centroid), {0, -1}, filled("$C_%$", {number})));
    show_centres();
    board_.counters({{"S so far", filled("% m\u00b2", {figure(area_)})},
                     {"C so far", area_ != 0 ? figure((1 / area_) * moment_) : "none"}});
    board_.step(filled("$S_% = \\frac{1}{2} \\vec{V_1V_%} \u00d7 \\vec{V_1V_%} = %$\u2009m\u00b2%",
                       {number, std::to_string(count_ + 1), std::to_string(count_ + 2), figure(event.signed_area),
                        event.signed_area < 0 ? ": it lies outside and counts negative."
                                              : filled(", with its centre in $C_%$.", {number})}),
                3);
  }

  void finish(Vec2d centroid) {
    show_triangles();
    for (const StoryMark& mark : centres_) board_.show(mark);
    board_.show(labelled(keyed(dot_mark(Role::result, centroid), "centroid"), {0, 1}, "$C_P$"));
    board_.step(filled("$C_P = \\frac{1}{S_P} \u2211 S_i C_i = %$ with $S_P = \u2211 S_i = %$\u2009m\u00b2",
                       {figure(centroid), figure(area_)}),
                6);
  }

 private:
  void show_triangles() {
    for (const StoryMark& mark : triangles_) board_.show(mark);
  }
  /// Each a dot, and where they are weighed so far.
  void show_centres() {
    for (const StoryMark& mark : centres_) board_.show(mark);
    if (area_ != 0)
      board_.show(labelled(keyed(dot_mark(Role::result, (1 / area_) * moment_), "centroid"), {0, 1}, "C"));
  }

  Storyboard& board_;
  std::vector<StoryMark> triangles_;
  std::vector<StoryMark> centres_;
  int count_ = 0;
  double area_ = 0;
  Vec2d moment_;
};

}  // namespace

Story tell_diagonal_test(const Demonstration& demonstration) {
  const std::vector<Vec2d> p = outline_of(demonstration);
  Storyboard board =
      begun(demonstration, p, "", "Convex? The diagonals of a quadrilateral",
            "A quadrilateral is convex exactly when each diagonal has the other two corners on its two sides.");
  Diagonals diagonals(board);
  const bool convex = quadrilateral_is_convex(p[0], p[1], p[2], p[3], telling(diagonals));
  board.show(path_mark(Role::chosen, {p[0], p[2]}));
  board.show(path_mark(Role::chosen, {p[1], p[3]}));
  board.show(closed_path(convex ? Role::result : Role::alert, p));
  board.step(convex ? "Both do: the diagonals cross inside, ABCD is convex."
                    : "So one diagonal lies outside: ABCD is concave.",
             4);
  return board.finish();
}

Story tell_edge_walk(const Demonstration& demonstration) {
  const std::vector<Vec2d> corners = outline_of(demonstration);
  Storyboard board = begun(demonstration, corners, "V", "Convex? A walk along the edges",
                           "Go round counter-clockwise. A convex polygon turns left at every corner.");
  EdgeWalk walk(corners, board);
  walk.finish(is_convex(corners, telling(walk)));
  return board.finish();
}

Story tell_centroid(const Demonstration& demonstration) {
  const std::vector<Vec2d> corners = outline_of(demonstration);
  Storyboard board = begun(demonstration, corners, "V", "Centroid by triangulation",
                           "A fan of triangles from $V_1$. Each has a signed area $S_i$ and a centre $C_i$.");
  Centroid sum(board);
  sum.finish(centroid_of(corners, telling(sum)));
  return board.finish();
}

}  // namespace proofreel
