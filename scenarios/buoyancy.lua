-- What floats, how deep, and what turns over: Archimedes' law with shapes of every kind.
scenario {
  title = "What floats", duration = 14, view = { center = {-0.05, -1.1}, height = 7 },
  description = "Crates float as deep as their density says, a stone sinks, a tower turns over, a ship rights itself.",
  layers = { "bodies", "labels" }, golden = { frames = { 0, 90, 240, 839 } },
}

local water = 1000                                         -- kg/m^2
ground { y = -3.3 }
buoyancy { level = 0, density = water, drag = 1200 }       -- N s/m for every wetted square metre

-- A body that floats upright has this share of its height under water: its density over the water's.
local crates = {}
for i, density in ipairs { 0.25, 0.5, 0.75 } do
  local crate = body { name = ("crate %g"):format(density), at = { -6.2 + 1.5 * i, 1.2 }, density = density * water,
                       shape = box { width = 1, height = 0.8 } }
  label { body = crate, text = ("%g"):format(density) }
  crates[i] = { handle = crate, density = density }
end

local tower = body { name = "tower", at = {-0.1, 0.3}, angle = 0.01, density = 0.5 * water,
                     shape = box { width = 0.5, height = 1.7 } }
local log = body { name = "log", at = {1.25, 0.9}, angle = 0.5, density = 0.6 * water,
                   shape = capsule { a = {-0.45, 0}, b = {0.45, 0}, radius = 0.2 } }
local stone = body { name = "stone", at = {2.5, 0.7}, density = 2.6 * water, shape = circle { radius = 0.3 } }
local ship = body { name = "ship", at = {4.6, 0.5}, angle = 0.35, shapes = {
  polygon { {-1.1, 0.3}, {-0.8, -0.3}, {0.8, -0.3}, {1.1, 0.3}, density = 0.55 * water },
  box { width = 0.8, height = 0.35, at = {-0.2, 0.475}, density = 0.12 * water } } }
label { body = tower, text = "tower" }
label { body = log, text = "log" }
label { body = stone, text = "stone" }
label { body = ship, text = "ship" }

for _, crate in ipairs(crates) do
  local name = ("draught of crate %g"):format(crate.density)
  measure(name, function() return 0.4 - crate.handle:center().y end)
  reference(name, { { 14, 0.8 * crate.density } })
  expect(("crate %g floats with that share of its height under water"):format(crate.density), function()
    return math.abs(0.4 - crate.handle:center().y - 0.8 * crate.density) < 2e-3
  end)
end
expect("the stone lies on the ground", function() return math.abs(stone:center().y + 3.0) < 0.01 end)
expect("the tower lies on its side", function() return math.abs(math.cos(tower:angle())) < 0.1 end)
expect("the ship floats upright", function() return math.abs(ship:angle()) < 0.03 end)
expect("all comes to rest", function() return energy().kinetic < 1 end)

caption { text = "A crate of density 0.25 floats with a quarter of its height under water", from = 0, to = 14 }
