-- Thesis chapter 3.4, equations 3.13 to 3.16: about the own centre, about an axis beside it (Steiner), and a whole body.
scenario {
  title = "Moment of inertia", description = "A shape about its own centre, about an axis beside it, and a whole body.",
  golden = { frames = { 715, 1935, 2335, 3215, 3915 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "moment_of_inertia",
  shapes = {
    box { at = {-1.5, 0.7}, width = 1.6, height = 1.1 }, box { at = {0.3, 0}, width = 0.5, height = 2 },
    circle { at = {1.5, -0.9}, radius = 0.6 },
  },
}
