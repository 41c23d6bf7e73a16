-- Thesis figures 4.6 to 4.8: GJK in one dimension. Intervals that overlap, that touch in one point, and that are apart.
scenario {
  title = "GJK on a line", description = "Intervals, their difference, and a simplex of its ends around the origin.",
  golden = { frames = { 1660, 2215, 4135, 5100, 5600 }, size = { 960, 540 } },
}

local function show(a1, a2, b1, b2)
  demonstrate { algorithm = "gjk_line", shapes = { segment { a = {a1, 0}, b = {a2, 0} }, segment { a = {b1, 0}, b = {b2, 0} } } }
end
show(1, 3, 2, 4)   -- as in figure 4.6
show(1, 2, 2, 4)   -- figure 4.7: one point in common
show(-4, -2, 1, 2)
