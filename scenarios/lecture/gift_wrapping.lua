-- Thesis figures 3.6 to 3.8 and table 3.1: the convex hull of a set of points, with every comparison counted.
scenario {
  title = "Gift wrapping", description = "The convex hull corner by corner, by Jarvis' march.",
  golden = { frames = { 75, 1825, 3140, 4260 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "gift_wrapping",
  points = {
    {-3.2, 0.1}, {-2, 2}, {-1.6, -1.7}, {-0.8, 0.6}, {0.3, 2.6}, {0.5, -0.7}, {1.4, 1.1}, {2, -2.1}, {3.1, 0.7},
  },
}
