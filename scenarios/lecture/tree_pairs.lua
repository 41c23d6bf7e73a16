-- Thesis chapter 4.1: the tree against itself, from the top down, with a queue of pairs.
scenario {
  title = "Which boxes overlap?", description = "Top-down traversal of a tree against itself: visited, pruned, found.",
  golden = { frames = { 300, 829, 2038, 3082 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "tree_pairs",
  shapes = {
    circle { at = {-3.2, 1.3}, radius = 0.6 }, box { at = {2.6, -1.1}, width = 1.2, height = 0.7, angle = 0.3 },
    polygon { {-2.9, 0.1}, {-1.4, 0.3}, {-1.8, 1.1} }, circle { at = {3.3, -0.6}, radius = 0.4 },
    box { at = {-2.6, -1.3}, width = 0.8, height = 0.8, angle = 0.6 }, polygon { {0.1, 1.2}, {1, 1.4}, {0.5, 2.1} },
    circle { at = {1.4, 0.2}, radius = 0.35 }, box { at = {-1.7, -1.9}, width = 0.6, height = 0.5 },
  },
}
