-- Thesis figure 4.5: two polygons projected on the normal of every edge; the axis of least overlap is the way out.
scenario {
  title = "Separating axes", description = "Projections on every axis, the least overlap kept.",
  golden = { frames = { 150, 910, 1710, 2919 }, size = { 960, 540 } },
}

local kite = polygon { {-2.2, -0.6}, {0.3, -1.1}, {0.9, 0.7}, {-1.2, 1.4} }
demonstrate { algorithm = "separating_axes", shapes = { kite, polygon { {0.2, 0}, {2.6, -0.5}, {1.9, 1.7} } } }
-- The same triangle a metre farther away: one axis with a gap is enough.
demonstrate { algorithm = "separating_axes", shapes = { kite, polygon { {1.2, 0}, {3.6, -0.5}, {2.9, 1.7} } } }
