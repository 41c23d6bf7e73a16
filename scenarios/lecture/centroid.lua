-- Thesis figure 3.9, equations 3.7 and 3.8: triangles with signed areas, the negative ones outside the outline.
scenario {
  title = "Centroid by triangulation", description = "Signed areas cancel what lies outside a concave polygon.",
  golden = { frames = { 565, 830, 1545 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "centroid",
  points = { {2.6, 0.2}, {0.3, 0.1}, {1.5, 1.9}, {-1.9, 1.3}, {-2.6, -1.2}, {0.4, -1.7} },
}
