// GJK, EPA and clipping (thesis figures 4.9 to 4.11): the world beside the Minkowski difference, from the first support
// point to the contact points.

#include "engine/collide_gjk.h"
#include "engine/polygon.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/shape_pair.h"

namespace proofreel {
namespace {

/// The pane of the Minkowski difference, beside that of the world.
constexpr int difference = 1;

std::vector<Vec2d> all_differences(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
  std::vector<Vec2d> points;
  for (const Vec2d p : a) {
    for (const Vec2d q : b) points.push_back(q - p);
  }
  return points;
}

/// The point of the segment nearest the origin.
Vec2d foot_of_origin(Vec2d a, Vec2d b) {
  const Vec2d edge = b - a;
  const double squared = length_squared(edge);
  return squared > 0 ? lerp(a, b, std::clamp(-dot(a, edge) / squared, 0.0, 1.0)) : a;
}

class Search {
 public:
  explicit Search(const Demonstration& asked)
      : a_(asked.shapes[0].parts[0]), b_(asked.shapes[1].parts[0]), board_(asked.pace), frame_(centroid_of(a_)) {
    differences_ = all_differences(a_, b_);
    outline_ = convex_hull(differences_);
    unit_ = std::max(extent_of(a_), extent_of(b_));
    board_.pane("world");
    board_.pane("Minkowski difference $B \u2296 A$");
    keep_pair(board_, asked);
    board_.keep(in_pane(labelled(origin_mark({0, 0}), {1, 1}, "O"), difference));
  }

  void begin() {
    board_.heading("Minkowski difference");
    show_differences();
    board_.step(
        "Every corner of B minus every corner of A: what these points span is the Minkowski difference of B and A.", 4);
    show_outline();
    board_.step(
        "A and B share a point where $b \u2212 a = 0$. So they overlap exactly when the difference holds the origin O.",
        4);
    board_.heading("GJK: a simplex around the origin");
  }

  void tell(const SimplexReduced& event) {
    simplex_.assign(event.points.begin(), event.points.begin() + event.count);
    closest_ = event.closest;
    show_outline();
    show_simplex();
    const bool first = board_steps_++ == 0;
    if (first) {
      board_.step("GJK asks for single corners only and never builds the rest. It starts from any one of them.", 3);
    } else if (event.count == 3) {
      board_.step("The triangle encloses O: A and B overlap. How deep, and which way out?", 4);
    } else {
      const std::string kept = event.count == 2 ? "The edge nearest to O is kept" : "The corner nearest to O is kept";
      board_.step(
          filled("%, at a distance of $%$ m. Look from there towards O again.", {kept, figure(length(closest_))}), 2.5);
    }
  }

  void tell(const SupportFound& event) {
    const Vec2d d = normalized(event.direction);
    const Vec2d on_a = event.on_a + frame_;
    const Vec2d on_b = event.on_b + frame_;
    show_outline();
    show_simplex();
    board_.show(in_pane(arrow_mark(Role::candidate, closest_, closest_ + 0.35 * unit_ * d), difference));
    board_.show(in_pane(labelled(dot_mark(Role::candidate, event.difference), d, "$b \u2212 a$"), difference));
    board_.show(labelled(dot_mark(Role::candidate, on_b), perp(d), "b"));
    board_.show(labelled(dot_mark(Role::candidate, on_a), perp(d), "a"));
    board_.show(labelled(arrow_mark(Role::candidate, on_b, on_b + 0.3 * unit_ * d), d, "d"));
    board_.show(labelled(arrow_mark(Role::candidate, on_a, on_a - 0.3 * unit_ * d), -d, "\u2212d"));
    board_.counters({{"support points", figure(++supports_)}});
    board_.step(
        "Support function: $b$ is the point of B farthest along $d$, $a$ that of A farthest along $\u2212d$. "
        "$b \u2212 a$ is the corner farthest along $d$.",
        3);
  }

  void tell(const DistanceFound& event) {
    touching_ = simplex_.size() == 3 || event.distance <= 0;
    if (touching_) {
      polytope_ = simplex_;
      board_.heading("EPA: from the inside to the nearest edge");
      return;
    }
    show_outline();
    show_simplex();
    board_.show(in_pane(path_mark(Role::result, {{0, 0}, closest_}), difference));
    board_.show(path_mark(Role::result, {event.on_a + frame_, event.on_b + frame_}));
    board_.show(dot_mark(Role::result, event.on_a + frame_));
    board_.show(dot_mark(Role::result, event.on_b + frame_));
    board_.step(filled("No corner is nearer to O. A and B are $%$ m apart, as far as the difference is from O.",
                       {figure(event.distance)}),
                6);
  }

  void tell(const ClosestEdge& event) {
    edge_ = event;
    for (const Vec2d p : {event.a, event.b}) add_to_polytope(p);
    board_.counters({{"corners", figure(polytope_.size())}});
    show_outline();
    show_polytope(Role::chosen);
    show_edge(Role::candidate);
    board_.step(filled("The polytope's edge nearest to O is $%$ m away: A and B are at least that deep in each other.",
                       {figure(event.distance)}),
                3);
  }

  void tell(const PolytopeExpanded& event) {
    show_outline();
    show_polytope(Role::chosen);
    show_edge(Role::candidate);
    add_to_polytope(event.corner);
    board_.show(in_pane(path_mark(Role::candidate, {edge_.a, event.corner, edge_.b}), difference));
    board_.show(in_pane(labelled(dot_mark(Role::candidate, event.corner), edge_.normal, "w"), difference));
    board_.step("Beyond that edge the difference has a corner $w$. It goes between the ends of the edge.", 3);
  }

  void tell(const FacesChosen& event) {
    tell_depth();
    board_.heading("Clipping: where they touch");
    board_.counters({});
    const Vec2d face = event.reference_b - event.reference_a;
    const Vec2d outward = normalized(-perp(face));
    faces_ = {path_mark(Role::chosen, {event.reference_a + frame_, event.reference_b + frame_}),
              path_mark(Role::candidate, {event.incident_a + frame_, event.incident_b + frame_})};
    for (const Vec2d end : {event.reference_a + frame_, event.reference_b + frame_}) {
      faces_.push_back(path_mark(Role::quiet, {end - 0.45 * unit_ * outward, end + 0.3 * unit_ * outward}));
    }
    show_faces();
    const std::string names = event.reference_of_a ? "A has the reference face, B the incident one"
                                                   : "B has the reference face, A the incident one";
    board_.step(filled("The normal stands on the reference face. %: the face that lies most against it.", {names}), 4);
  }

  void tell(const PointClipped& event) {
    show_faces();
    const bool cut = distance(event.before, event.after) > 0;
    const Vec2d before = event.before + frame_;
    const Vec2d after = event.after + frame_;
    if (cut) {
      board_.show(path_mark(Role::rejected, {before, after}));
      board_.show(dot_mark(Role::rejected, before));
    }
    board_.show(dot_mark(event.kept ? Role::alert : Role::rejected, after));
    if (event.kept) ends_.push_back(dot_mark(Role::alert, after));
    const std::string first =
        cut ? "Beyond the side plane the incident face is cut off. " : "This end lies between the side planes. ";
    const std::string then =
        event.kept ? filled("The end is $%$ m behind the reference face: a contact point.", {figure(-event.separation)})
                   : "The end is in front of the reference face: no contact point.";
    board_.step(first + then, 4);
  }

  Story finish(const Manifold& manifold) {
    if (touching_) {
      tell_depth();
      board_.heading("Contact points");
      show_manifold(manifold);
      show_edge(Role::result);
      board_.step(filled("The manifold: normal $n = %$ from A to B, depth $%$ m, %",
                         {figure(Vec2d(manifold.normal)), figure(-static_cast<double>(deepest(manifold))),
                          manifold.count == 2 ? "two points." : "one point."}),
                  6);
    }
    return board_.finish();
  }

 private:
  /// EPA's answer, once it is known that nothing lies farther out.
  void tell_depth() {
    if (told_depth_) return;
    told_depth_ = true;
    show_outline();
    show_polytope(Role::chosen);
    show_edge(Role::result);
    const Vec2d foot = foot_of_origin(edge_.a, edge_.b);
    board_.show(in_pane(arrow_mark(Role::alert, foot, {0, 0}), difference));
    board_.step(filled("Nothing lies beyond this edge: it is one of the difference itself. Depth $%$ m, and B leaves "
                       "along $n = %$.",
                       {figure(edge_.distance), figure(-edge_.normal)}),
                5);
  }

  void show_differences() {
    for (const Vec2d p : differences_) board_.show(in_pane(dot_mark(Role::rejected, p), difference));
    show_outline();
  }

  void show_outline() {
    if (outline_.size() <= 16) board_.show(in_pane(region_mark(Role::quiet, outline_), difference));
    board_.show(in_pane(closed_path(Role::quiet, outline_), difference));
  }

  void show_simplex() {
    if (simplex_.size() == 3) board_.show(in_pane(region_mark(Role::chosen, simplex_), difference));
    if (simplex_.size() > 1) board_.show(in_pane(closed_path(Role::chosen, simplex_), difference));
    for (const Vec2d p : simplex_) board_.show(in_pane(dot_mark(Role::chosen, p), difference));
  }

  void show_polytope(Role role) {
    if (polytope_.size() < 3) return;
    board_.show(in_pane(region_mark(role, polytope_), difference));
    board_.show(in_pane(closed_path(role, polytope_), difference));
    for (const Vec2d p : polytope_) board_.show(in_pane(dot_mark(role, p), difference));
  }

  void show_edge(Role role) {
    const Vec2d foot = foot_of_origin(edge_.a, edge_.b);
    board_.show(in_pane(path_mark(role, {edge_.a, edge_.b}), difference));
    board_.show(in_pane(keyed(path_mark(role, {{0, 0}, foot}), "foot"), difference));
  }

  void show_faces() {
    for (const StoryMark& mark : faces_) board_.show(mark);
    for (const StoryMark& mark : ends_) board_.show(mark);
    show_outline();
    show_edge(Role::result);
  }

  void show_manifold(const Manifold& manifold) {
    const Vec2d normal(manifold.normal);
    for (int i = 0; i < manifold.count; ++i) {
      const Vec2d at = Vec2d(manifold.points[i].point) + frame_;
      board_.show(arrow_mark(Role::alert, at, at + 0.3 * unit_ * normal));
      board_.show(dot_mark(Role::alert, at));
    }
    show_outline();
  }

  /// EPA's polytope is convex, and all of its corners have been told by now.
  void add_to_polytope(Vec2d p) {
    polytope_.push_back(p);
    polytope_ = convex_hull(polytope_);
  }

  std::vector<Vec2d> a_;
  std::vector<Vec2d> b_;
  Storyboard board_;
  Vec2d frame_;  ///< where the origin of A's frame is, in which events speak of points of A and B
  std::vector<Vec2d> differences_;
  std::vector<Vec2d> outline_;
  double unit_ = 1;
  std::vector<Vec2d> simplex_;
  Vec2d closest_;
  int board_steps_ = 0;
  std::size_t supports_ = 0;
  bool touching_ = false;
  std::vector<Vec2d> polytope_;
  ClosestEdge edge_;
  bool told_depth_ = false;
  std::vector<StoryMark> faces_;
  std::vector<StoryMark> ends_;
};

}  // namespace

Story tell_gjk_epa(const Demonstration& demonstration) {
  Search search(demonstration);
  search.begin();
  const PlacedHull a = placed_hull_of(demonstration.shapes[0]);
  const PlacedHull b = placed_hull_of(demonstration.shapes[1]);
  return search.finish(collide_gjk(a.hull, a.pose, b.hull, b.pose, 0, telling(search)));
}

}  // namespace proofreel
