-- Thesis figure 2.3, equation 2.10: the signed area of a parallelogram, and the side of a line on which a point lies.
scenario {
  title = "Cross product", description = "A signed area, and on which side of a line a point lies.",
  golden = { frames = { 856, 2159, 3633, 4348 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "cross_product",
  points = { {2.2, 0.5}, {1.5, 1.2}, {1.2, 1.6}, {-1.4, 0.9}, {1.8, -1.1}, {-1.1, -0.25} },
}
