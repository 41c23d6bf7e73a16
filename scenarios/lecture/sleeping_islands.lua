-- Thesis, 5.4: bodies that touch form an island; islands rest, sleep and wake as a whole.
scenario {
  title = "Islands that sleep",
  description = "Bodies that touch form an island, tinted alike. Islands fall asleep as a whole, and a hit wakes one of them only.",
  duration = 6, view = { center = {0, 2}, height = 5.6 }, layers = { "bodies", "islands" },
  golden = { frames = {10, 290, 550, 770, 1079}, size = {640, 360} },
}

ground { y = 0 }
local function brick(x, y) return body { name = ("brick at %g, %g"):format(x, y), at = {x, y}, friction = 0.6, shape = box { width = 0.8, height = 0.5 } } end
local middle = { brick(0, 0.25), brick(0, 0.75), brick(0, 1.25) }
local right = { brick(3.2, 0.25), brick(4.1, 0.25), brick(3.65, 1.6) }
local left = { brick(-4.2, 0.25), brick(-3.3, 0.25), brick(-3.75, 0.75) }
local groups = { left, middle, right }

local slept = 0
for _, group in ipairs(groups) do
  for _, b in ipairs(group) do on_sleep(b, function() slept = slept + 1 end) end
end
local function asleep(group)
  for _, b in ipairs(group) do if not b:asleep() then return false end end
  return true
end

local ball
at(3, function()
  ball = body { name = "ball", at = {-5.6, 1.6}, velocity = {3, 0.5}, shape = circle { radius = 0.25 }, density = 2, friction = 0.8, rolling_resistance = 0.02 }
end)

section { at = 0, name = "Islands" }
section { at = 0.42, name = "Asleep" }
section { at = 3, name = "One is woken" }
freeze { at = 0.2, seconds = 3 }
freeze { at = 2, seconds = 3 }
freeze { at = 3.6, seconds = 3 }
freeze { at = 5.5, seconds = 3 }
caption { text = "What touches belongs to one island: one tint each", from = 0, to = 0.42 }
caption { text = "An island that has rested for a moment sleeps: it is drawn paler and not stepped", from = 0.42, to = 3 }
caption { text = "A hit wakes the island it meets; the others sleep on", from = 3, to = 4.2 }
caption { text = "What has come to rest sleeps again, now with the ball", from = 4.2 }

measure("bricks asleep", function()
  local n = 0
  for _, group in ipairs(groups) do for _, b in ipairs(group) do if b:asleep() then n = n + 1 end end end
  return n
end)
expect("all three islands sleep before the ball comes", function() return asleep(left) and asleep(middle) and asleep(right) and slept == 9 end, { at = 3 })
expect("the ball wakes the left one", function() return not asleep(left) end, { at = 3.75 })
expect("the other two sleep on", function() return time() < 3 or (asleep(middle) and asleep(right)) end, { always = true })
expect("in the end all sleep again", function() return asleep(left) and ball:asleep() end)
