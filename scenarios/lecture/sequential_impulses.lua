-- Sequential impulses (Catto 2006), by which chapter 5.3 of the thesis keeps bodies apart: contact by contact, sweep by
-- sweep, with and without the impulses of the step before.
scenario {
  title = "Sequential impulses", description = "How the impulses in a stack are found, from a cold and from a warm start.",
  golden = { frames = { 1855, 3270, 4020, 4469 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "sequential_impulses",
  shapes = {
    box { at = {0, 0.4}, width = 1.4, height = 0.8 }, box { at = {0, 1.2}, width = 1.2, height = 0.8 },
    box { at = {0, 2}, width = 1, height = 0.8 }, box { at = {0, 2.8}, width = 0.8, height = 0.8 },
  },
}
