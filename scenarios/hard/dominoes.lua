-- Fifteen dominoes, a push at the first, and then peace.
scenario {
  title = "Fifteen dominoes",
  description = "A push of 0.2 N s fells them all; afterwards a heap of thin leaning boxes must not creep.",
  duration = 15, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0.6, 2}, height = 9.6 }, layers = { "bodies", "contacts" },
  golden = { frames = { 240, 899 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.6 }
local dominoes, count, width, height = {}, 15, 0.25, 1
for i = 1, count do
  dominoes[i] = body { name = "domino " .. i, at = { i - (count + 1) / 2, height / 2 }, friction = 0.6,
                       shape = box { width = width, height = height } }
end
dominoes[1]:impulse({ 0.2, 0 }, { -(count - 1) / 2, height })

no_overlap(width, 12)
no_energy_gained(dominoes, height)
local function fallen()
  local n = 0
  for _, d in ipairs(dominoes) do if math.abs(d:angle()) > 0.5 then n = n + 1 end end
  return n
end
local function fastest()
  local v = 0
  for _, d in ipairs(dominoes) do
    v = math.max(v, math.abs(d:velocity().x) + math.abs(d:velocity().y) + math.abs(d:spin()))
  end
  return v
end
local seen = {}
at(12, function() for i, d in ipairs(dominoes) do seen[i] = d:position() end end)
local function crept()
  local most = 0
  for i, d in ipairs(dominoes) do
    if seen[i] then
      local p = d:position()
      most = math.max(most, math.sqrt((p.x - seen[i].x) ^ 2 + (p.y - seen[i].y) ^ 2))
    end
  end
  return most
end
measure("fallen", fallen)
measure("fastest", fastest)
measure("crept since 12 s", crept)
expect("all dominoes fall", function() return fallen() == count end)
expect("none falls before it is hit: the last stands at 1 s", function()
  return math.abs(dominoes[count]:angle()) < 0.01
end, { at = 1 })
expect("they lie still", function() return fastest() < 0.01 end)
expect("they do not creep: less than a millimetre in three seconds", function() return crept() < 1e-3 end)
