#include "scenarios/demonstrations/tree_picture.h"

#include <algorithm>

#include "scenarios/demonstrations/shape_pair.h"

namespace proofreel {
namespace {

bool same(const Aabbd& a, const Aabbd& b) { return a.lower == b.lower && a.upper == b.upper; }

}  // namespace

TreePicture::TreePicture(const DynamicTree& tree, const std::vector<Aabbd>& boxes) {
  std::vector<std::size_t> path;  // from the root to the node visited last
  tree.visit([&](const Aabb& box, int depth, bool leaf) {
    path.resize(static_cast<std::size_t>(depth));
    PicturedNode node;
    node.box = Aabbd(box);
    node.leaf = leaf;
    if (!path.empty()) {
      node.parent = static_cast<int>(path.back());
      nodes_[path.back()].children.push_back(nodes_.size());
    }
    path.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
  });
  name_nodes(boxes);
  double next_leaf = 0;
  if (!nodes_.empty()) place_below(0, 0, next_leaf);
}

void TreePicture::name_nodes(const std::vector<Aabbd>& boxes) {
  int inner = 0;
  for (PicturedNode& node : nodes_) {
    if (!node.leaf) {
      node.name = std::to_string(++inner);
      continue;
    }
    const auto found = std::find_if(boxes.begin(), boxes.end(), [&](const Aabbd& box) { return same(box, node.box); });
    node.name = letter(static_cast<std::size_t>(found - boxes.begin()));
    node.key = filled("leaf %", {node.name});
    node.below = node.name;
  }
}

/// Leaves stand side by side, parents above the middle of their children. Between two neighbouring leaves there is
/// exactly one inner node: it is told again by the leaf on its left. Returns where the node stands.
double TreePicture::place_below(std::size_t index, double depth, double& next_leaf) {
  PicturedNode& node = nodes_[index];
  double x = 0;
  if (node.leaf) {
    x = next_leaf;
    next_leaf += 1;
  } else {
    const double left = place_below(node.children[0], depth + 1, next_leaf);
    const double right = place_below(node.children[1], depth + 1, next_leaf);
    x = 0.5 * (left + right);
    node.below = nodes_[node.children[0]].below + nodes_[node.children[1]].below;
    node.key = filled("after %", {nodes_[node.children[0]].below.substr(nodes_[node.children[0]].below.size() - 1)});
  }
  node.place = {x, -depth};
  return x;
}

void TreePicture::show(Storyboard& board, TreePanes panes, bool numbered) const {
  for (const PicturedNode& node : nodes_) {
    board.show(in_pane(keyed(box_mark(node.leaf ? Role::first : Role::quiet, node.box), filled("% box", {node.key})),
                       panes.boxes));
    if (node.parent >= 0) {
      const Vec2d above = nodes_[static_cast<std::size_t>(node.parent)].place;
      board.show(in_pane(keyed(path_mark(Role::quiet, {above, node.place}), filled("% edge", {node.key})), panes.tree));
    }
    StoryMark dot = keyed(dot_mark(node.leaf ? Role::first : Role::rejected, node.place), node.key);
    if (node.leaf) dot = labelled(std::move(dot), {0, -1}, node.name);
    if (!node.leaf && numbered) dot = labelled(std::move(dot), {-1, 0.6}, node.name);
    board.show(in_pane(std::move(dot), panes.tree));
  }
}

void TreePicture::highlight(Storyboard& board, TreePanes panes, const PicturedNode& node, Role role,
                            const std::string& note) {
  board.show(in_pane(box_mark(role, node.box), panes.boxes));
  StoryMark dot = dot_mark(role, node.place);
  if (!note.empty()) dot = labelled(std::move(dot), {1, 0.6}, note);
  board.show(in_pane(std::move(dot), panes.tree));
}

int TreePicture::height() const {
  double deepest = 0;
  for (const PicturedNode& node : nodes_) deepest = std::max(deepest, -node.place.y);
  return static_cast<int>(deepest);
}

std::vector<Aabbd> boxes_of(const Demonstration& demonstration) {
  std::vector<Aabbd> boxes;
  for (const DemonstrationShape& shape : demonstration.shapes) {
    Aabbd box;
    for (const std::vector<Vec2d>& part : shape.parts) {
      DemonstrationShape alone{{part}, shape.radius};
      box = merged(box, Aabbd(bounds(hull_of(alone), Pose{})));
    }
    boxes.push_back(box);
  }
  return boxes;
}

void keep_shape(Storyboard& board, const Demonstration& demonstration, std::size_t index, int pane) {
  const DemonstrationShape& shape = demonstration.shapes[index];
  for (StoryMark& mark : shape_marks(Role::second, shape, static_cast<int>(index) + 1))
    board.keep(in_pane(std::move(mark), pane));
  board.keep(in_pane(text_mark(Role::second, middle_of(shape.parts[0]), {}, letter(index)), pane));
}

}  // namespace proofreel
