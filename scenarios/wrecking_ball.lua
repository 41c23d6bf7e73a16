-- A chain of light links and a ball three hundred times as heavy as one of them.
scenario {
  title = "Wrecking ball", duration = 6, view = { center = {-0.4, 4}, height = 10.4 },
  description = "A heavy ball on a light chain knocks a wall down; the chain's joints do not open.",
  golden = { frames = { 0, 84, 100, 359 } }, layers = { "bodies", "joints" },
}

ground { y = 0, friction = 0.7 }
local anchor = { -1.5, 7.6 }
local links, length = 16, 0.32
local last, joints = world, {}
for i = 1, links do
  local link = body { name = "link " .. i, at = { anchor[1] - (i - 0.5) * length, anchor[2] }, group = -1, density = 2,
                      shape = capsule { a = {-0.11, 0}, b = {0.11, 0}, radius = 0.05 } }
  joints[#joints + 1] = revolute { last, link, at = { anchor[1] - (i - 1) * length, anchor[2] } }
  last = link
end
local ball = body { name = "ball", at = { anchor[1] - links * length - 0.7, anchor[2] }, group = -1, density = 8, shape = circle { radius = 0.7 } }
joints[#joints + 1] = revolute { last, ball, at = { anchor[1] - links * length, anchor[2] } }
body { name = "anchor", type = "static", at = anchor, shape = circle { radius = 0.16 }, group = -1 }

for row = 0, 8 do
  for i = 0, 2 do
    body { name = ("brick %d.%d"):format(row, i), at = { 1.6 + i * 0.92 + (row % 2) * 0.3, 0.25 + row * 0.5 }, friction = 0.7,
           shape = box { width = 0.9, height = 0.5 }, density = 1.5 }
  end
end
trail { body = ball, seconds = 0.6 }

measure("widest joint gap", function()
  local worst = 0
  for _, j in ipairs(joints) do worst = math.max(worst, j:gap()) end
  return worst
end)
expect("no joint ever opens by a millimetre", function()
  for _, j in ipairs(joints) do if j:gap() > 1e-3 then return false end end
  return true
end, { always = true })
