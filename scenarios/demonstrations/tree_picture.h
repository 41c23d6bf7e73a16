#pragma once

/// A dynamic tree twice over: its boxes in the world, and its nodes as a diagram.

#include <string>
#include <vector>

#include "engine/dynamic_tree.h"
#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {

/// A node as the film shows it. Leaves are called by letters in the order of their boxes, inner nodes by numbers from
/// the root down.
struct PicturedNode {
  Aabbd box;
  bool leaf = false;
  int parent = -1;  ///< index into TreePicture::nodes; -1 of the root
  std::vector<std::size_t> children;
  std::string name;
  std::string key;    ///< the same node after the tree has changed
  std::string below;  ///< the letters of the leaves below
  Vec2d place;        ///< in the diagram
};

/// The panes a tree is shown in.
struct TreePanes {
  int boxes = 0;
  int tree = 1;
};

class TreePicture {
 public:
  TreePicture() = default;
  /// The tree as it is now; `boxes` are those of all leaves there ever were, no two alike, and give them their letters.
  TreePicture(const DynamicTree& tree, const std::vector<Aabbd>& boxes);

  const std::vector<PicturedNode>& nodes() const { return nodes_; }
  /// All boxes and all nodes, quietly. `numbered`: inner nodes with their numbers.
  void show(Storyboard& board, TreePanes panes, bool numbered) const;
  /// One node in both panes; `note` stands beside it in the diagram.
  static void highlight(Storyboard& board, TreePanes panes, const PicturedNode& node, Role role,
                        const std::string& note = {});
  /// How deep the diagram is.
  int height() const;

 private:
  void name_nodes(const std::vector<Aabbd>& boxes);
  double place_below(std::size_t node, double depth, double& next_leaf);

  std::vector<PicturedNode> nodes_;
};

/// The boxes the shapes are stored by.
std::vector<Aabbd> boxes_of(const Demonstration& demonstration);

/// Keeps the shapes themselves in the picture, with their letters.
void keep_shape(Storyboard& board, const Demonstration& demonstration, std::size_t shape, int pane);

}  // namespace proofreel
