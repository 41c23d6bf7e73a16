-- Friction while sliding: what is left of gravity on a slope, g (sin 30 - 0.3 cos 30). An impulse solver is off by
-- a T h / 2 however well it converges, a verlet kick is not (C. A. Coulomb 1785).
scenario {
  title = "A block slides down", duration = 2, rate = 240, view = { center = {0, 0.2}, height = 5 },
  description = "30 degrees, coefficient 0.3: 4.7126 m in 2 s.",
  layers = { "bodies", "contacts", "vectors" }, golden = { frames = { 0, 80, 119 }, size = {480, 270} },
}
include "include/incline.lua"

local slid, exact, block = block_on_incline(0.3, {2, 1.2}, 6.2)
measure("slid", slid)
reference("slid", exact)
expect("after 2 s it has slid by 4.71257447332 m, to 1e-6 m",
       function() return math.abs(slid() - 4.712574473324794) <= 1e-6 end)
vector { body = block, of = "velocity", scale = 0.2 }
