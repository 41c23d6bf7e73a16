-- Thesis figures 4.9 to 4.11: GJK, EPA and clipping, the world beside the Minkowski difference.
scenario {
  title = "GJK, EPA and clipping", description = "From the first support point to the contact points.",
  golden = { frames = { 200, 1460, 2455, 3240, 3835, 4665, 5390 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "gjk_epa",
  shapes = {
    polygon { {0.4, 0.4}, {2.6, 0.2}, {1.5, 2.3} },
    polygon { {1.75, 0.75}, {3.8, 0.5}, {4, 2.6}, {1.2, 2.2} },
  },
}
