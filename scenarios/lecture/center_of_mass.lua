-- Thesis figures 3.1 and 3.2, equations 3.1 and 3.2: two masses on a beam, then a body put together shape by shape.
scenario {
  title = "Centre of mass", description = "Where a beam balances, and the centre of a body made of several shapes.",
  golden = { frames = { 150, 615, 965, 2364, 2614 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "center_of_mass",
  shapes = {
    box { at = {-1.6, 0}, width = 0.8, height = 2.6 }, box { at = {0.4, -0.9}, width = 3.2, height = 0.8 },
    circle { at = {2.4, 0.2}, radius = 0.7, density = 2 },
  },
}
