// The tree against itself (thesis chapter 4.1): pairs of nodes wait in a queue, and whatever does not overlap is left
// out with all that lies below it.

#include <algorithm>
#include <deque>

#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/tree_picture.h"

namespace proofreel {
namespace {

class Traversal {
 public:
  explicit Traversal(const Demonstration& asked) : boxes_(boxes_of(asked)), board_(asked.pace) {
    panes_.boxes = board_.pane("boxes in the world");
    panes_.tree = board_.pane("the tree", 0.9, true);
    board_.heading("Which boxes overlap?");
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      keep_shape(board_, asked, i, panes_.boxes);
      tree_.insert(Aabb(boxes_[i]), static_cast<std::uint32_t>(i));
    }
    picture_ = TreePicture(tree_, boxes_);
  }

  Story tell() {
    std::vector<PairVisited> visited;
    tree_.for_each_pair([](ProxyId, ProxyId) {}, Observer([&](const Event& event) {
                          if (const auto* pair = std::get_if<PairVisited>(&event)) visited.push_back(*pair);
                        }));
    queue_.push_back({0, 0});
    show_state();
    board_.step(
        "The traversal begins with the root against itself. A pair that overlaps is replaced by the pairs of its "
        "children.",
        4);
    for (const PairVisited& pair : visited) tell(pair);
    show_state();
    show_found();
    const std::size_t n = boxes_.size();
    board_.step(
        filled("The queue is empty: % for the narrow phase. % pairs of nodes were looked at; every box with every "
               "other would have been %.",
               {found_.size() == 1 ? "1 pair" : filled("% pairs", {figure(found_.size())}), figure(visited_),
                figure(n * (n - 1) / 2)}),
        7);
    return board_.finish();
  }

 private:
  using NodePair = std::pair<std::size_t, std::size_t>;

  /// First in, first out: what the engine has looked at is what waited longest.
  void tell(const PairVisited& event) {
    const NodePair pair = queue_.front();
    queue_.pop_front();
    const PicturedNode& a = node(pair.first);
    const PicturedNode& b = node(pair.second);
    const std::vector<NodePair> children = event.pruned ? std::vector<NodePair>{} : children_of(pair);
    queue_.insert(queue_.end(), children.begin(), children.end());
    ++visited_;
    pruned_ += event.pruned ? 1 : 0;
    if (event.leaves && !event.pruned) found_.push_back({event.a, event.b});
    show_state();
    show_found();
    const Role role = event.pruned ? Role::alert : event.leaves ? Role::result : Role::candidate;
    TreePicture::highlight(board_, panes_, a, role);
    TreePicture::highlight(board_, panes_, b, role);
    board_.step(caption(event, a, b, children.size()), event.pruned || !event.leaves ? 1 : 1.5);
  }

  std::string caption(const PairVisited& event, const PicturedNode& a, const PicturedNode& b,
                      std::size_t children) const {
    const std::string name = filled("(%, %)", {a.name, b.name});
    if (event.pruned && event.leaves) return filled("% do not overlap.", {name});
    if (event.pruned) return filled("% do not overlap: pruned, with all that lies below them.", {name});
    if (event.leaves) return filled("% overlap, and both are leaves: a pair for the narrow phase.", {name});
    const std::string lined_up =
        children == 1 ? "1 pair of children lines up." : filled("% pairs of children line up.", {figure(children)});
    if (a.name == b.name) return filled("% is a node against itself: %", {name, lined_up});
    return filled("% overlap: %", {name, lined_up});
  }

  const PicturedNode& node(std::size_t index) const { return picture_.nodes()[index]; }

  /// The pairs that take the place of one that overlaps, by the rules of the thesis; a leaf is not paired with itself.
  std::vector<NodePair> children_of(NodePair pair) const {
    const auto [a, b] = pair;
    if (node(a).leaf && node(b).leaf) return {};
    if (node(a).leaf) return {{a, node(b).children[0]}, {a, node(b).children[1]}};
    const std::size_t left = node(a).children[0];
    const std::size_t right = node(a).children[1];
    if (node(b).leaf) return {{left, b}, {right, b}};
    if (a != b)
      return {{left, node(b).children[0]},
              {left, node(b).children[1]},
              {right, node(b).children[1]},
              {right, node(b).children[0]}};
    std::vector<NodePair> pairs{{left, right}};
    for (const std::size_t child : {left, right}) {
      if (!node(child).leaf) pairs.push_back({child, child});
    }
    return pairs;
  }

  void show_state() {
    picture_.show(board_, panes_, true);
    constexpr std::size_t most = 6;
    std::string queue = "queue:";
    for (std::size_t i = 0; i < std::min(queue_.size(), most); ++i)
      queue += filled(" (%, %)", {node(queue_[i].first).name, node(queue_[i].second).name});
    if (queue_.size() > most) queue += filled(" and % more", {figure(queue_.size() - most)});
    if (queue_.empty()) queue += " empty";
    board_.show(in_pane(text_mark(Role::first, {0, -picture_.height() - 0.75}, {1, 0}, queue), panes_.tree));
    board_.counters({{"visited", figure(visited_)}, {"pruned", figure(pruned_)}, {"found", figure(found_.size())}});
  }

  void show_found() {
    for (const auto& [a, b] : found_) {
      for (const Aabbd& box : {a, b}) board_.show(in_pane(box_mark(Role::result, box), panes_.boxes));
      board_.show(in_pane(region_mark(Role::result, corners_of_overlap(a, b)), panes_.boxes));
    }
  }

  static std::vector<Vec2d> corners_of_overlap(const Aabbd& a, const Aabbd& b) {
    const Vec2d low{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)};
    const Vec2d high{std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)};
    return {low, {high.x, low.y}, high, {low.x, high.y}};
  }

  std::vector<Aabbd> boxes_;
  Storyboard board_;
  TreePanes panes_;
  DynamicTree tree_;
  TreePicture picture_;
  std::deque<NodePair> queue_;
  std::size_t visited_ = 0;
  std::size_t pruned_ = 0;
  std::vector<std::pair<Aabbd, Aabbd>> found_;
};

}  // namespace

Story tell_tree_pairs(const Demonstration& demonstration) { return Traversal(demonstration).tell(); }

}  // namespace proofreel
