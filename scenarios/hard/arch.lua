-- The arch of Solver2D's samples (E. Catto, 2024; a quarter of the size it is written in): a catenary, thinner upwards.
scenario {
  title = "Arch with four slabs", duration = 20, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Seventeen voussoirs that nothing but pressure and friction holds, and four slabs on top.",
  view = { center = {0, 7.4}, height = 16.4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 1199 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.6 }
local inner = { {16, 0}, {14.93803712795643, 5.133601056842984}, {13.79871746027416, 10.24928069555078},
                {12.56252963284711, 15.34107019122473}, {11.20040987372525, 20.39856541571217},
                {9.66521217819836, 25.40369899225096}, {7.87179930638133, 30.3179337000085},
                {5.635199558196225, 35.03820717801641}, {2.405937953536585, 39.09554102558315} }
local outer = { {24, 0}, {22.33619528222415, 6.02299846205841}, {20.54936888969905, 12.00964361211476},
                {18.60854610798073, 17.9470321677465}, {16.46769273811807, 23.81367936585418},
                {14.05325025774858, 29.57079353071012}, {11.23551045834022, 35.13775818285372},
                {7.752568160730571, 40.30450679009583}, {3.016931552701656, 44.28891593799322} }
local function at_scale(p, side) return { side * p[1] / 4, p[2] / 4 } end
local stones = {}
local function stone(name, corners)
  local x, y = 0, 0
  for _, p in ipairs(corners) do x, y = x + p[1] / 4, y + p[2] / 4 end
  for _, p in ipairs(corners) do p[1], p[2] = p[1] - x, p[2] - y end
  stones[#stones + 1] = body { name = name, at = {x, y}, friction = 0.6, shape = hull(corners) }
  return stones[#stones]
end
for i = 1, 8 do
  for name, side in pairs { left = -1, right = 1 } do
    stone(("voussoir %d %s"):format(i, name), { at_scale(inner[i], side), at_scale(outer[i], side),
                                                at_scale(outer[i + 1], side), at_scale(inner[i + 1], side) })
  end
end
local key = stone("keystone", { at_scale(inner[9], 1), at_scale(outer[9], 1),
                                at_scale(outer[9], -1), at_scale(inner[9], -1) })
local crown, slab = outer[9][2] / 4, nil
for i = 1, 4 do
  slab = body { name = "slab " .. i, at = { 0, crown + i - 0.5 }, friction = 0.6,
                shape = box { width = 4, height = 1 } }
  stones[#stones + 1] = slab
end

local key_start, slab_start = key:position(), slab:position()
measure("keystone sinks", function() return key_start.y - key:position().y end)
measure("top slab sinks", function() return slab_start.y - slab:position().y end)
expect("it stands: the keystone sinks by less than 3 cm",
       function() return key_start.y - key:position().y <= 0.03 end, { always = true })
expect("it stands: the top slab sinks by less than 3 cm",
       function() return slab_start.y - slab:position().y <= 0.03 end, { always = true })
expect("it stands straight: keystone and top slab stay within 3 cm of the axis", function()
  return math.abs(key:position().x) <= 0.03 and math.abs(slab:position().x) <= 0.03
end, { always = true })
expect("quality: in the end the top moves slower than 1 mm/s", function()
  local v = slab:velocity()
  return math.sqrt(v.x^2 + v.y^2) < 1e-3
end)
no_overlap(1, 1)
no_energy_gained(stones, crown + 4)
