// The bounding-volume hierarchy grows (thesis figure 4.2): every new box looks for the place that adds least perimeter.

#include <cassert>
#include <utility>

#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/tree_picture.h"

namespace proofreel {
namespace {

class Growth {
 public:
  explicit Growth(const Demonstration& asked) : asked_(asked), boxes_(boxes_of(asked)), board_(asked.pace) {
    panes_.boxes = board_.pane("boxes in the world");
    panes_.tree = board_.pane("the tree", 0.8, true);
    board_.heading("A tree of boxes");
  }

  Story tell() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) insert(i);
    picture_.show(board_, panes_, false);
    board_.step(filled("% boxes, height %. The perimeters of all inner boxes are $%$ times that of the root: the less, "
                       "the fewer boxes a query enters.",
                       {figure(boxes_.size()), figure(static_cast<std::size_t>(tree_.height())),
                        figure(static_cast<double>(tree_.area_ratio()))}),
                7);
    return board_.finish();
  }

 private:
  void insert(std::size_t index) {
    name_ = letter(index);
    keep_shape(board_, asked_, index, panes_.boxes);
    if (index > 0) announce(index);
    tree_.insert(Aabb(boxes_[index]), static_cast<std::uint32_t>(index), Observer([&](const Event& event) {
                   std::visit([&](const auto& e) { tell(e, boxes_[index]); }, event);
                 }));
    picture_ = TreePicture(tree_, boxes_);
    if (index == 0) return announce(index);
    picture_.show(board_, panes_, false);
    board_.step(filled("% is in: a new node above both, and every box up to the root holds it now.", {name_}), 2);
  }

  void announce(std::size_t index) {
    show_new(boxes_[index]);
    board_.counters({{"boxes", figure(index + 1)}});
    board_.step(
        index == 0
            ? "A is the first box: a tree of one leaf."
            : filled("Where does % go? Beside the node where it adds least to the perimeters of all boxes.", {name_}),
        2);
  }

  template <typename Other>
  void tell(const Other&, const Aabbd&) {}

  void tell(const SiblingTested& event, const Aabbd& added) {
    show_new(added);
    show_best();
    const PicturedNode& node = picture_.nodes()[next_tested(event.box)];
    TreePicture::highlight(board_, panes_, node, Role::candidate, filled("+%", {figure(event.cost, 1)}));
    board_.show(in_pane(box_mark(Role::candidate, merged(event.box, added)), panes_.boxes));
    const bool better = best_.empty() || event.cost < best_cost_;
    board_.step(filled("Beside %, $%$ m of perimeter would be added%",
                       {described(node), figure(event.cost, 1), better ? ": the least so far." : "."}));
    if (!better) return;
    best_ = {node};
    best_cost_ = event.cost;
  }

  void tell(const SiblingChosen& event, const Aabbd& added) {
    show_new(added);
    const PicturedNode& node = best_.front();
    TreePicture::highlight(board_, panes_, node, Role::chosen, filled("+%", {figure(event.cost, 1)}));
    board_.step(filled("No node further down can do better. % goes beside %.", {name_, described(node)}), 1.5);
    best_.clear();
    tested_.clear();
  }

  /// Told while the tree is changed: what it looks like at this moment is what is shown.
  void tell(const NodesRotated& event, const Aabbd&) {
    picture_ = TreePicture(tree_, boxes_);
    picture_.show(board_, panes_, false);
    const auto [lowered, raised] = rotated_nodes(event);
    TreePicture::highlight(board_, panes_, picture_.nodes()[lowered], Role::candidate);
    TreePicture::highlight(board_, panes_, picture_.nodes()[raised], Role::alert);
    board_.step(filled("Rotation: % and % change places, because that makes a box smaller.",
                       {described(picture_.nodes()[lowered]), described(picture_.nodes()[raised])}),
                3);
  }

  /// The search looks at the root, then at both children of the node it goes down to. A parent and a child may have
  /// the same box, so it is followed step by step.
  std::size_t next_tested(const Aabbd& box) {
    const std::vector<PicturedNode>& nodes = picture_.nodes();
    std::size_t found = 0;
    if (tested_.size() % 2 == 0 && !tested_.empty()) {
      found = nodes[nodes_parent(tested_.back())].children[1];
    } else if (!tested_.empty()) {
      const std::size_t last = tested_.back();
      std::vector<std::size_t> entered{last};
      if (last != 0) entered = nodes[nodes_parent(last)].children;
      for (const std::size_t parent : entered) {
        if (nodes[parent].leaf || !(nodes[nodes[parent].children[0]].box.lower == box.lower)) continue;
        if (nodes[nodes[parent].children[0]].box.upper == box.upper) found = nodes[parent].children[0];
      }
    }
    tested_.push_back(found);
    return found;
  }

  std::size_t nodes_parent(std::size_t node) const { return static_cast<std::size_t>(picture_.nodes()[node].parent); }

  /// A child of some node, and a child of that node's other child.
  std::pair<std::size_t, std::size_t> rotated_nodes(const NodesRotated& event) const {
    const std::vector<PicturedNode>& nodes = picture_.nodes();
    const auto is_at = [](const PicturedNode& node, const Aabbd& box) {
      return node.parent >= 0 && node.box.lower == box.lower && node.box.upper == box.upper;
    };
    for (std::size_t low = 0; low < nodes.size(); ++low) {
      for (std::size_t high = 0; is_at(nodes[low], event.lowered) && high < nodes.size(); ++high) {
        if (!is_at(nodes[high], event.raised) || nodes[high].parent == nodes[low].parent) continue;
        if (nodes[nodes_parent(high)].parent == nodes[low].parent) return {low, high};
      }
    }
    assert(false);  // the engine has just told of two such nodes
    return {};
  }

  void show_new(const Aabbd& added) {
    picture_.show(board_, panes_, false);
    board_.show(in_pane(box_mark(Role::alert, added), panes_.boxes));
  }

  void show_best() {
    for (const PicturedNode& node : best_)
      TreePicture::highlight(board_, panes_, node, Role::chosen, filled("+%", {figure(best_cost_, 1)}));
  }

  static std::string described(const PicturedNode& node) {
    if (node.leaf) return node.name;
    std::string text = "the box of ";
    for (std::size_t i = 0; i < node.below.size(); ++i) text += (i > 0 ? "\u2009" : "") + node.below.substr(i, 1);
    return text;
  }

  const Demonstration& asked_;
  std::vector<Aabbd> boxes_;
  Storyboard board_;
  TreePanes panes_;
  DynamicTree tree_;
  TreePicture picture_;
  std::string name_;
  std::vector<std::size_t> tested_;  ///< nodes of the picture, in the order they were tested
  std::vector<PicturedNode> best_;   ///< one, or none yet
  double best_cost_ = 0;
};

}  // namespace

Story tell_tree_insertion(const Demonstration& demonstration) { return Growth(demonstration).tell(); }

}  // namespace proofreel
