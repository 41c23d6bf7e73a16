-- The angles between which no finite force keeps a sliding rod out of the ground, bracketed: tan^2 - 3 mu tan + 4 < 0,
-- so that for a coefficient of 1.4 a uniform one jams at once from 55.5858 to 69.9519 degrees (P. Painleve 1895).
scenario {
  title = "Painleve's angles, bracketed", duration = 0.25, rate = 240, gravity = {0, -0.01}, fps = 60,
  description = "Rods pushed tip first over a rough floor: those inside the interval jam at once, the others slide.",
  view = { center = {0, 1}, height = 5 }, layers = { "bodies", "labels", "vectors" },
  method = { contact_solver = "exact" }, golden = { frames = { 0, 14 }, size = {480, 270} },
}

local mu, length, speed = 1.4, 1, 3
local first, last = (3 * mu - math.sqrt(9 * mu ^ 2 - 16)) / 2, (3 * mu + math.sqrt(9 * mu ^ 2 - 16)) / 2
first, last = math.atan(first), math.atan(last)
-- Gravity is small, so that what slides does not turn into the interval while it is looked at.
local function rods(row, critical, y)
  body { name = "floor " .. row, type = "static", friction = mu, at = {0, y},
         shape = box { width = 9.4, height = 0.1, at = {0, -0.05} } }
  local made = {}
  for i, off in ipairs { -1, -0.3, -0.1, 0.1, 0.3, 1 } do
    local angle = critical + math.rad(off)
    local tip = 1.5 * i - 5.35
    local rod = body { name = ("%s %+.1f degrees"):format(row, off), angle = angle, velocity = { -speed, 0 },
                       group = -1, at = { tip + length / 2 * math.cos(angle), y + length / 2 * math.sin(angle) },
                       mass = 1, inertia = length ^ 2 / 12, friction = mu,
                       shape = hull { {-length / 2, 0}, {0, -0.03}, {length / 2, 0}, {0, 0.03} } }
    label { body = rod, text = ("%.1f°"):format(math.deg(angle)) }
    made[i] = { angle = math.deg(angle), jams = function() return rod:spin() > 1 end }   -- sliding turns it slowly
  end
  return made
end
local low, high = rods("first", first, 1.7), rods("last", last, -0.6)

-- Between the last rod of a row that does as its first one and the next one; outside the row when all do.
local function bracketed(row)
  for i = 2, #row do
    if row[i].jams() ~= row[1].jams() then return (row[i - 1].angle + row[i].angle) / 2 end
  end
  return row[#row].angle
end
local soon = 3 / 240
measure("first angle that jams (degrees)", function() return bracketed(low) end)
reference("first angle that jams (degrees)", { { soon, math.deg(first) } })
measure("last angle that jams (degrees)", function() return bracketed(high) end)
reference("last angle that jams (degrees)", { { soon, math.deg(last) } })
expect("the closed form gives 55.585810807887 and 69.951866984087 degrees", function()
  return math.abs(math.deg(first) - 55.585810807887) <= 1e-11 and math.abs(math.deg(last) - 69.951866984087) <= 1e-11
end)
expect("those and only those jam at once whose angle lies between", function()
  for i = 1, 6 do if low[i].jams() ~= (i > 3) or high[i].jams() ~= (i <= 3) then return false end end
  return true
end, { at = soon })
