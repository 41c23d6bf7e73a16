-- Five boxes on one slope: those stand whose coefficient exceeds its tangent, the others slide as Coulomb has it.
local slope, g, ramp = 0.25, 10, 0.2
local steepest = math.tan(slope)   -- 0.2553; Coulomb 1781: a box stands where mu is larger

scenario {
  title = "Five boxes on a slope",
  description = "0.25 rad; coefficients 0.39, 0.32 and 0.26 (by 4 percent) stand, 0.14 and 0 slide.",
  duration = 2, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {-1.2, 2.7}, height = 7.2 }, layers = { "bodies", "contacts", "labels" },
  golden = { frames = { 119 }, size = {480, 270} },
}
include "include/gates.lua"

local c, s = math.cos(slope), math.sin(slope)
-- The ramp's upper side goes through the origin and falls to the left.
body { name = "ramp", type = "static", at = { -5 * c + 0.1 * s, -5 * s - 0.1 * c + 3 }, angle = slope, friction = ramp,
       shape = box { width = 26, height = 0.2 } }
local boxes, half = {}, 0.25
for i, mu in ipairs { 0.75, 0.5, 0.35, 0.1, 0 } do
  local along = 4 - 1.4 * (i - 1)
  local mixed = math.sqrt(mu * ramp)
  local b = body { name = ("mu = %.2f"):format(mixed), at = { along * c - half * s, along * s + half * c + 3 },
                   angle = slope,
                   friction = mu, shape = box { width = 0.7, height = 2 * half } }
  label { body = b, text = ("%.2f"):format(mixed) }
  boxes[i] = b
  local start = b:position()
  local function slid()
    local p = b:position()
    return -((p.x - start.x) * c + (p.y - start.y) * s)
  end
  local a = math.max(0, g * (s - mixed * c))
  local name = ("slid, mu = %.2f"):format(mixed)
  measure(name, slid)
  reference(name, function(t) return a * t * t / 2 end)
  if mixed > steepest then
    expect(("mu = %.2f stands"):format(mixed), function() return math.abs(slid()) < 0.01 end, { always = true })
    expect(("quality: mu = %.2f does not creep by a tenth of a millimetre"):format(mixed), function()
      return math.abs(slid()) < 1e-4
    end, { always = true })
  else
    expect(("mu = %.2f slides as it should, to one percent"):format(mixed), function()
      return math.abs(slid() / (a * time() ^ 2 / 2) - 1) < 0.01
    end)
  end
end

no_overlap(2 * half, 0.5)
no_energy_gained(boxes, 3)
