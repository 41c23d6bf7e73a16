-- Nothing but gravity: x = v t, y = -g t^2 / 2, to the last digits.
scenario {
  title = "Free fall",
  description = "Two seconds of fall and throw: engines that push the speed first are off by g T h / 2, 42 mm here.",
  duration = 2, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {6, -8}, height = 27 }, layers = { "bodies", "trails" },
  golden = { frames = { 119 }, size = {480, 270} },
}

local dropped = body { name = "dropped", at = {0, 0}, shape = box { width = 1, height = 1 } }
local thrown = body { name = "thrown", at = {2, 0}, velocity = { 5, 8 }, spin = 7,
                      shape = box { width = 1.5, height = 0.5 } }
trail { body = dropped, seconds = 2 }
trail { body = thrown, seconds = 2 }

local function off()
  local t, p, q = time(), dropped:position(), thrown:position()
  local fall = 5 * t * t
  return math.max(math.abs(p.x), math.abs(p.y + fall), math.abs(q.x - 2 - 5 * t), math.abs(q.y - 8 * t + fall))
end
measure("off", off)
expect("both are where Galilei has them, to a tenth of a millimetre", function()
  return off() < 1e-4
end, { always = true })
expect("quality: to a billionth of a metre", function() return off() < 1e-9 end, { always = true })
expect("the spin stays what it was", function()
  return math.abs(thrown:angle() - 7 * time()) < 1e-4
end, { always = true })
