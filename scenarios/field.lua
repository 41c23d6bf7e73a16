-- A mass spectrometer: a magnetic field, always across the motion, bends light ions more than heavy ones.
scenario {
  title = "Mass spectrometer", duration = 4, view = { center = {2.75, 0.7}, height = 6.6 }, gravity = {0, 0},
  description = "A force field written in Lua: F = q B v, across the motion. Each ion lands 2 m v / (q B) away.",
  layers = { "bodies", "trails", "labels" }, golden = { frames = { 0, 60, 120, 389 } }, theme = "dark",
}

local qB, v = 2, 3                                          -- N s/m, m/s
field(function(x, y, vx, vy)
  if y < 0 then return 0, 0 end                             -- the magnet begins at the slit
  return qB * vy, -qB * vx
end)

body { name = "wall", type = "static", at = {-1.35, -0.15}, shape = box { width = 2.1, height = 0.3 } }
body { name = "detector", type = "static", at = {3.85, -0.15}, friction = 1, shape = box { width = 7.1, height = 0.3 } }

local ions = {}
for i, mass in ipairs { 0.5, 1, 1.5, 2 } do
  local ion = body { name = ("m = %g"):format(mass), at = {0, -0.25 - 0.35 * i}, velocity = {0, v}, mass = mass,
                     group = -1, friction = 1, fixed_rotation = true, shape = circle { radius = 0.1 }, color = ({0xF2CF5B, 0x6FE3C1, 0x5FA3DE, 0xC9A8FF})[i] }
  label { body = ion, text = ("%g kg"):format(mass) }
  trail { body = ion, seconds = 4 }
  ions[i] = { handle = ion, mass = mass, diameter = 2 * mass * v / qB }
end

for _, ion in ipairs(ions) do
  local name = ("landing of m = %g"):format(ion.mass)
  measure(name, function() return ion.handle:center().x end)
  reference(name, { { 4, ion.diameter } })
  expect(("m = %g lands a diameter of its circle away"):format(ion.mass), function()
    return math.abs(ion.handle:center().x - ion.diameter) < 0.03
  end)
end
expect("the field does no work before the first ion lands", function()
  return math.abs(energy().kinetic - 0.5 * (0.5 + 1 + 1.5 + 2) * v * v) < 0.01
end, { at = 0.9 })
freeze { at = 3.9, seconds = 2.5 }
caption { text = "A force q B v across the motion: circles of diameter 2 m v / (q B)", from = 0, to = 4 }
