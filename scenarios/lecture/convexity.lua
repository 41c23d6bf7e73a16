-- Thesis figures 3.4 and 3.5, equation 3.4: convex or concave, by the diagonals and by a walk along the edges.
scenario {
  title = "Convex or concave?", description = "The diagonal test for quadrilaterals, the edge walk for all polygons.",
  golden = { frames = { 665, 2080, 3196, 4236 }, size = { 960, 540 } },
}

demonstrate { algorithm = "diagonal_test", points = { {-2, -1}, {1.7, -1.4}, {2.2, 1.2}, {-1.2, 1.5} } }
demonstrate { algorithm = "diagonal_test", points = { {-2, -1.2}, {2.2, -0.2}, {-0.5, -0.1}, {-0.8, 1.7} } }
demonstrate { algorithm = "edge_walk", points = { {-1.8, -1}, {0.2, -1.6}, {2, -0.4}, {1.4, 1.3}, {-1.1, 1.4} } }
demonstrate {
  algorithm = "edge_walk",
  points = { {-1.8, -1}, {0.2, -1.6}, {2, -0.4}, {0.3, 0.1}, {1.4, 1.5}, {-1.1, 1.4} },
}
