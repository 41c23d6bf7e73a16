-- A net of discs pinned to their neighbours at points between them, held by seven in the middle of its upper edge.
local side = 100   -- as the field's benchmark has it, for 120 of its 500 steps

scenario {
  title = "A grid of ten thousand pinned discs",
  description = "19794 pins in loops: Solver2D notes that some solvers blow up or crash on such a grid.",
  duration = 2, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = { (side - 1) / 2, -52 }, height = 125 }, layers = { "bodies" },
}
include "include/gates.lua"

local radius = 0.4
local discs, joints, grid = {}, {}, {}
for i = 0, side - 1 do
  grid[i] = {}
  for k = 0, side - 1 do   -- column k, row i from above
    local held = i == 0 and math.abs(k - side / 2) <= 3
    local disc = body { name = ("disc %d.%d"):format(i, k), type = held and "static" or "dynamic", at = { k, -i },
                        shape = circle { radius = radius }, group = -1 }
    grid[i][k] = disc
    if not held then discs[#discs + 1] = disc end
    if i > 0 then joints[#joints + 1] = revolute { grid[i - 1][k], disc, at = { k, -i + 0.5 } } end
    if k > 0 and not (held and math.abs(k - 1 - side / 2) <= 3) then
      joints[#joints + 1] = revolute { grid[i][k - 1], disc, at = { k - 0.5, -i } }
    end
  end
end

local function fastest()
  local v = 0
  for _, d in ipairs(discs) do v = math.max(v, math.abs(d:velocity().x), math.abs(d:velocity().y)) end
  return v
end
local function farthest()
  local most = 0
  for _, d in ipairs(discs) do most = math.max(most, math.abs(d:position().x), math.abs(d:position().y)) end
  return most
end
-- Two held discs and the two below them make a triangle of pins, which is rigid; so is each next pair beside and below
-- it. The grid is a rigid plate, held by seven: it hangs where it is.
local function sag()
  local most = 0
  for i = 0, side - 1, side - 1 do
    for k = 0, side - 1, side - 1 do
      local p = grid[i][k]:position()
      most = math.max(most, math.sqrt((p.x - k) ^ 2 + (p.y + i) ^ 2))
    end
  end
  return most
end
local function is_due() return math.abs(time() * 4 - math.floor(time() * 4 + 0.5)) < 1e-6 end
measure("fastest", function() return is_due() and fastest() or 0 end)
measure("sag", sag)
measure("gap", function()
  local most = 0
  if is_due() then for _, j in ipairs(joints) do most = math.max(most, j:gap()) end end
  return most
end)
expect("nothing is faster than 100 m/s", function() return not is_due() or fastest() < 100 end, { always = true })
expect("nothing is farther away than 500 m", function() return not is_due() or farthest() < 500 end, { always = true })
expect("the grid hangs together: no pin is open by a disc", function()
  for _, j in ipairs(joints) do if j:gap() > 2 * radius then return false end end
  return true
end)
expect("quality: no pin is open by a hundredth of a disc", function()
  for _, j in ipairs(joints) do if j:gap() > 0.02 * radius then return false end end
  return true
end)
expect("quality: the corners of the grid stay where they are, to a disc", function()
  return sag() < 2 * radius
end, { always = true })
