-- The least coefficient that holds a block on 30 degrees, tan 30 = 0.577350269190, bracketed by twelve blocks: a
-- threshold has no order in h, only an interval it was found in (C. A. Coulomb 1785).
scenario {
  title = "The angle of friction, bracketed", duration = 3, rate = 240, view = { center = {0, 0.35}, height = 9.2 },
  description = "Blocks whose coefficients close in on tan 30 degrees from both sides: the first six must slide.",
  layers = { "bodies", "labels" }, golden = { frames = { 0, 179 }, size = {480, 270} },
}
include "include/incline.lua"

local critical, blocks = math.tan(math.rad(30)), {}
for i, off in ipairs { -0.1, -0.03, -0.01, -0.003, -0.001, -0.0003, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1 } do
  local column, row = (i - 1) % 3, (i - 1) // 3
  local mu = critical * (1 + off)
  local slid, exact, block = block_on_incline(mu, { 4.6 * column - 3.4, 3.6 - 2 * row }, 3.4)
  label { body = block, text = ("%+.2f %%"):format(100 * off) }
  blocks[i] = { mu = mu, slid = slid, exact = exact }
end
-- Three seconds take the slowest that must slide by 6.6 mm.
local holds = blocks[6].exact(3) / 2
local function bracketed()
  local slides, held = 0, 2 * critical
  for _, b in ipairs(blocks) do
    if b.slid() > holds then slides = math.max(slides, b.mu) else held = math.min(held, b.mu) end
  end
  return (slides + held) / 2
end
measure("least coefficient that holds", bracketed)
reference("least coefficient that holds", { { 3, critical } })
measure("slid, 0.03 % below", blocks[6].slid)
reference("slid, 0.03 % below", blocks[6].exact)
measure("slid, 0.03 % above", blocks[7].slid)
reference("slid, 0.03 % above", blocks[7].exact)
expect("those slide and only those whose coefficient is below tan 30", function()
  for i, b in ipairs(blocks) do if (b.slid() > holds) ~= (i <= 6) then return false end end
  return true
end)
expect("the slowest slides as far as Coulomb says, to 0.01 mm",
       function() return math.abs(blocks[6].slid() - blocks[6].exact(time())) <= 1e-5 end)
