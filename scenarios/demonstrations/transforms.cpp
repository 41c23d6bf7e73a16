// From local to world coordinates (thesis figures 2.4 and 2.5, equations 2.11 to 2.29): scale, turn and move a shape
// one after the other, its own axes carried along, and why the order matters. The maps are those of engine/transform.h.

#include <algorithm>
#include <array>
#include <numbers>

#include "engine/transform.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {
namespace {

constexpr Transformd identity{{{1, 0}, {0, 1}}, {0, 0}};
constexpr int steps_of_a_motion = 24;

/// One of the three parts of a placing.
enum class Part : std::uint8_t { scale, rotation, translation };
using Order = std::array<Part, 3>;
constexpr Order right_order{Part::scale, Part::rotation, Part::translation};
constexpr Order wrong_order{Part::translation, Part::rotation, Part::scale};

/// The first `way` of a part, 0 to 1.
Transformd transform_of(Part part, const Placing& placing, double way) {
  const Vec2d none{1, 1};
  switch (part) {
    case Part::scale:
      return make_transform({}, Rotd{}, lerp(none, placing.scale, way));
    case Part::rotation:
      return make_transform({}, Rotd(way * placing.angle), none);
    case Part::translation:
      return make_transform(way * placing.at, Rotd{}, none);
  }
  return identity;
}

std::string symbol_of(Part part) { return part == Part::scale ? "S" : part == Part::rotation ? "R" : "T"; }

std::vector<Vec2d> mapped(const Transformd& map, const std::vector<Vec2d>& points) {
  std::vector<Vec2d> images;
  for (const Vec2d p : points) images.push_back(map * p);
  return images;
}

/// A shape on its way into a pane's world, with its own axes: unit vectors at its origin.
class LocalShape {
 public:
  LocalShape(const Demonstration& asked, int pane) : shape_(asked.shapes[0]), pane_(pane) {}

  void show(Storyboard& board, const Transformd& map) const {
    for (const std::vector<Vec2d>& trace : traces_) board.show(in_pane(closed_path(Role::rejected, trace), pane_));
    DemonstrationShape moved = shape_;
    moved.parts[0] = mapped(map, shape_.parts[0]);
    board.show(in_pane(keyed(shape_mark(Role::first, moved), filled("shape %", {name()})), pane_));
    show_axis(board, map, {1, 0}, Role::candidate, "x");
    show_axis(board, map, {0, 1}, Role::result, "y");
  }

  /// Where the shape is now stays visible.
  void leave_trace(const Transformd& map) { traces_.push_back(mapped(map, shape_.parts[0])); }

  /// Beyond the shape where it begins, also when it is scaled.
  void keep_world_axes(Storyboard& board, Vec2d scale) const {
    const Aabbd box = bounds_of(shape_.parts[0]);
    const double reach = std::max({1.0, box.upper.x, box.upper.y, scale.x * box.upper.x, scale.y * box.upper.y});
    board.keep(in_pane(origin_mark({0, 0}), pane_));
    for (const Vec2d axis : {Vec2d{1, 0}, Vec2d{0, 1}}) {
      board.keep(in_pane(arrow_mark(Role::quiet, {0, 0}, 1.2 * reach * axis), pane_));
      board.keep(in_pane(text_mark(Role::quiet, 1.35 * reach * axis, {}, axis.x > 0 ? "x" : "y"), pane_));
    }
  }

 private:
  std::string name() const { return figure(static_cast<std::size_t>(pane_)); }

  void show_axis(Storyboard& board, const Transformd& map, Vec2d unit, Role role, const std::string& axis) const {
    const Vec2d from = map.translation, to = map * unit;
    const std::string key = filled("axis % %", {axis, name()});
    board.show(in_pane(keyed(arrow_mark(role, from, to), key), pane_));
    const Vec2d aside = (unit.x > 0 ? -1 : 1) * perp(normalized(to - from));  // on the outer side of the two axes
    const Vec2d at = to + 0.08 * (to - from) + 0.17 * aside;
    board.show(in_pane(keyed(text_mark(role, at, {}, filled("$%\u2032$", {axis})), key), pane_));
  }

  DemonstrationShape shape_;
  int pane_;
  std::vector<std::vector<Vec2d>> traces_;
};

/// The 2x3 matrix with its figures, and which product it is. Columns are marked by the colours of the axes.
void show_matrix(Storyboard& board, int pane, const Transformd& map, const std::string& name) {
  const std::array<Vec2d, 3> columns{map.linear * Vec2d{1, 0}, map.linear * Vec2d{0, 1}, map.translation};
  constexpr std::array<const char*, 3> heads{"$x\u2032$", "$y\u2032$", "origin"};
  constexpr std::array<Role, 3> roles{Role::candidate, Role::result, Role::first};
  const auto show = [&](StoryMark mark) { board.show(in_pane(std::move(mark), pane)); };
  show(text_mark(Role::first, {1, 1.35}, {}, filled("$% =$", {name})));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto x = static_cast<double>(i);
    show(text_mark(Role::first, {x, 0.5}, {}, figure(columns[i].x)));
    show(text_mark(Role::first, {x, -0.5}, {}, figure(columns[i].y)));
    show(bar_mark(roles[i], {{x - 0.35, -1.25}, {x + 0.35, -1.25}, {x + 0.35, -1.17}, {x - 0.35, -1.17}}));
    show(text_mark(Role::quiet, {x, -1.55}, {}, heads[i]));
  }
  for (const double side : {-1.0, 1.0}) {
    const double out = 1 + 1.55 * side, in = 1 + 1.42 * side;
    show(path_mark(Role::first, {{in, 1}, {out, 1}, {out, -1}, {in, -1}}));
  }
}

std::string degrees(double radians) { return filled("%\u00b0", {figure(radians * 180 / std::numbers::pi, 0)}); }

class Placement {
 public:
  explicit Placement(const Demonstration& asked)
      : placing_(*asked.placing),
        corner_(asked.shapes[0].parts[0][0]),
        board_(asked.pace),
        shape_(asked, board_.pane("world")) {
    matrix_ = board_.pane("matrix", 0.55, true);
    shape_.keep_world_axes(board_, placing_.scale);
    board_.heading("From local to world coordinates");
  }

  Story tell() {
    show(identity, "I");
    board_.step(
        "A shape in its own coordinates, with its own axes $x\u2032$ and $y\u2032$. At first they are the world's.", 4);
    Transformd done = identity;
    std::string name;
    for (const Part part : right_order) {
      shape_.leave_trace(done);
      name = name.empty() ? symbol_of(part) : filled("%\u2009%", {symbol_of(part), name});
      board_.glide(announced(part), 3, steps_of_a_motion,
                   [&](double way) { show(transform_of(part, placing_, way) * done, name); });
      done = transform_of(part, placing_, 1) * done;
      show(done, name);
      board_.step(told(part), 5);
    }
    return finish(done, name);
  }

 private:
  Story finish(const Transformd& done, const std::string& name) {
    const Vec2d image = done * corner_;
    show(done, name);
    board_.show(labelled(dot_mark(Role::alert, image), {1, 0}, "P"));
    board_.step(filled("Every point goes the same way: $P = %$ in local coordinates is $% P = %$ in the world.",
                       {figure(corner_), name, figure(image)}),
                6);
    return board_.finish();
  }

  std::string announced(Part part) const {
    switch (part) {
      case Part::scale:
        return filled("First scale: $x$ by $%$ and $y$ by $%$, along the shape's own axes.",
                      {figure(placing_.scale.x), figure(placing_.scale.y)});
      case Part::rotation:
        return filled("Then turn by $%$, about the origin.", {degrees(placing_.angle)});
      case Part::translation:
        return filled("Last, move by $%$.", {figure(placing_.at)});
    }
    return {};
  }

  static std::string told(Part part) {
    switch (part) {
      case Part::scale:
        return "Scaling is linear: the origin stays. The columns of the matrix are the images of the unit vectors.";
      case Part::rotation:
        return "Turning is linear too: its matrix goes to the left. In the product the scales are in all four figures.";
      case Part::translation:
        return "Moving is not linear: the origin moves. A third column takes the way, and the others stay as they are.";
    }
    return {};
  }

  void show(const Transformd& map, const std::string& name) {
    shape_.show(board_, map);
    show_matrix(board_, matrix_, map, name);
  }

  Placing placing_;
  Vec2d corner_;  ///< the point that is followed
  Storyboard board_;
  LocalShape shape_;
  int matrix_ = 0;
};

/// The same three parts in two orders, side by side.
class Orders {
 public:
  explicit Orders(const Demonstration& asked)
      : placing_(*asked.placing),
        board_(asked.pace),
        right_{LocalShape(asked, board_.pane("scale, turn, move: $T\u2009R\u2009S$")), right_order, identity},
        wrong_{LocalShape(asked, board_.pane("move, turn, scale: $S\u2009R\u2009T$")), wrong_order, identity} {
    board_.heading("The order matters");
    board_.share_bounds();
    for (const Side* side : {&right_, &wrong_}) side->shape.keep_world_axes(board_, placing_.scale);
  }

  Story tell() {
    show(right_, identity);
    show(wrong_, identity);
    board_.step("The same scale, the same turn and the same way, in two orders.", 3);
    constexpr std::array<const char*, 3> sentences{
        "Left: scale first. Right: move first.",
        "Then both turn about the origin of the world: on the right the way turns along.",
        "Left: move last. Right: scale last, along the world's axes: the way is scaled as well, and the shape."};
    for (std::size_t i = 0; i < 3; ++i) {
      for (Side* side : {&right_, &wrong_}) side->shape.leave_trace(side->done);
      board_.glide(sentences[i], 3, steps_of_a_motion, [&](double way) {
        for (const Side* side : {&right_, &wrong_})
          show(*side, transform_of(side->order[i], placing_, way) * side->done);
      });
      for (Side* side : {&right_, &wrong_}) {
        side->done = transform_of(side->order[i], placing_, 1) * side->done;
        show(*side, side->done);
      }
      board_.step(sentences[i], 2);
    }
    return finish();
  }

 private:
  struct Side {
    LocalShape shape;
    Order order;
    Transformd done;
  };

  void show(const Side& side, const Transformd& map) { side.shape.show(board_, map); }

  Story finish() {
    const Vec2d right = right_.done.translation, wrong = wrong_.done.translation;
    int pane = 0;
    for (const Side* side : {&right_, &wrong_}) {
      show(*side, side->done);
      board_.show(in_pane(labelled(dot_mark(Role::alert, side->done.translation), {-1, 1}, "O"), pane++));
    }
    const std::string where =
        filled("On the left the shape's origin $O$ ends at $%$, on the right at $%$", {figure(right), figure(wrong)});
    board_.step(figure(right) == figure(wrong)
                    ? where + ": here the order of the parts does not show."
                    : where + ": matrices do not commute, $T\u2009R\u2009S \u2260 S\u2009R\u2009T$.",
                6);
    return board_.finish();
  }

  Placing placing_;
  Storyboard board_;
  Side right_;
  Side wrong_;
};

}  // namespace

Story tell_transforms(const Demonstration& demonstration) { return Placement(demonstration).tell(); }

Story tell_transform_order(const Demonstration& demonstration) { return Orders(demonstration).tell(); }

}  // namespace proofreel
