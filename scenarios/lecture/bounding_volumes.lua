-- Thesis figure 4.1: circle, AABB, OBB and convex hull around the same shape.
scenario {
  title = "Bounding volumes", description = "How tight they are, and what a test costs.",
  golden = { frames = { 730, 1280, 1845, 2225 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "bounding_volumes",
  shapes = { polygon { {-2, -1.3}, {-0.4, -0.7}, {1.9, -0.2}, {0.9, 0.3}, {1.7, 1.2}, {-0.3, 0.5}, {-1.4, 0.2} } },
}
