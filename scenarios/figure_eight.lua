-- Three equal masses chase each other on one figure of eight (Chenciner and Montgomery 2000; numbers by Carles Simo).
scenario {
  title = "Figure of eight", duration = 6.32591398, rate = 480, gravity = {0, 0}, theme = "dark",
  description = "Three bodies that attract each other on the one orbit they share; nothing holds them but gravity.",
  view = { height = 1.7 }, layers = { "bodies", "trails" }, golden = { frames = { 0, 150, 378 } },
}

local x, y, vx, vy = 0.97000436, -0.24308753, -0.93240737, -0.86473146
local starts = {
  { at = { x, y }, velocity = { -vx / 2, -vy / 2 }, color = 0xE69F00 },
  { at = { -x, -y }, velocity = { -vx / 2, -vy / 2 }, color = 0x56B4E9 },
  { at = { 0, 0 }, velocity = { vx, vy }, color = 0x2FBF91 },
}
local bodies = {}
for i, start in ipairs(starts) do
  bodies[i] = body { name = "mass " .. i, at = start.at, velocity = start.velocity, mass = 1, color = start.color,
                     shape = circle { radius = 0.045 } }
  trail { body = bodies[i], seconds = 1.6 }
end
nbody { G = 1 }

-- After one period every mass is back where it began.
measure("distance from the start", function()
  local p, s = bodies[1]:position(), starts[1].at
  return math.sqrt((p.x - s[1]) ^ 2 + (p.y - s[2]) ^ 2)
end)
expect("the orbit closes", function()
  for i, b in ipairs(bodies) do
    local p, s = b:position(), starts[i].at
    if math.sqrt((p.x - s[1]) ^ 2 + (p.y - s[2]) ^ 2) > 0.01 then return false end
  end
  return true
end)
local at_first = energy().total
expect("energy stays", function() return math.abs(energy().total - at_first) < 1e-4 end, { always = true })
