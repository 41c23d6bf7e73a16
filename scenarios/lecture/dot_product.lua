-- Thesis figures 2.1 and 2.2, equations 2.5 to 2.7: a projection, and what lies in front, in view, and nearest.
scenario {
  title = "Dot product", description = "The length of a shadow; what is in front, in the field of view, and nearest.",
  golden = { frames = { 200, 2305, 3269, 3934, 4579 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "dot_product",
  points = { {2.4, 0.6}, {1.4, 1.6}, {1.3, 1.1}, {1.5, -1.3}, {-0.9, 1.5}, {-1.7, -0.8} },
}
