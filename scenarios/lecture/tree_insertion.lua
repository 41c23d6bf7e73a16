-- Thesis figure 4.2: a bounding-volume hierarchy grows box by box, beside its tree.
scenario {
  title = "A tree of boxes", description = "Insertion with cost candidates, and rotations.",
  golden = { frames = { 2970, 4115, 4265, 5045, 5810 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "tree_insertion",
  shapes = {
    circle { at = {-0.7, 1.3}, radius = 0.4 }, box { at = {-3.2, 1.2}, width = 1, height = 1 },
    circle { at = {-0.2, -1.2}, radius = 0.4 }, box { at = {3.2, -0.1}, width = 0.6, height = 0.6 },
    circle { at = {-2, -0.9}, radius = 0.4 }, box { at = {1.9, 0}, width = 0.8, height = 0.8 },
  },
}
