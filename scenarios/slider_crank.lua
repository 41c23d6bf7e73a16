-- Slider and crank: the closed loop of every piston engine. A motor turns the crank, the piston runs in its cylinder.
scenario {
  title = "Slider and crank",
  description = "A turning crank drives a piston: three hinges and a rail in a closed loop, exact to the last digits.",
  duration = 5, view = { center = {0.8, 0.25}, height = 2 },
  layers = { "bodies", "joints", "trails" },
  golden = { frames = { 0, 40, 299 } },
}

local r, l = 0.4, 1.3
local crank = body { name = "crank", at = { r / 2, 0 }, shape = capsule { a = {-r / 2, 0}, b = {r / 2, 0}, radius = 0.06 }, density = 8, group = -1 }
local rod = body { name = "rod", at = { r + l / 2, 0 }, shape = capsule { a = {-l / 2, 0}, b = {l / 2, 0}, radius = 0.04 }, density = 4, group = -1 }
local piston = body { name = "piston", at = { r + l, 0 }, shape = box { width = 0.34, height = 0.43 }, density = 4, group = -1 }
for _, side in ipairs { -1, 1 } do
  body { name = "cylinder", type = "static", at = { 1.4, side * 0.26 }, shape = box { width = 1.3, height = 0.08 }, group = -1 }
end
local joints = {
  revolute { world, crank, at = {0, 0}, motor = { speed = 2 * math.pi, max_torque = 40 } },
  revolute { crank, rod, at = { r, 0 } },
  revolute { rod, piston, at = { r + l, 0 } },
  prismatic { world, piston, at = { r + l, 0 }, axis = {1, 0} },
}

local function from_crank()
  local theta = crank:angle()
  return r * math.cos(theta) + math.sqrt(l ^ 2 - (r * math.sin(theta)) ^ 2)
end
measure("piston", function() return piston:position().x end)
measure("error", function() return piston:position().x - from_crank() end)
expect("the piston is where the crank puts it", function() return math.abs(piston:position().x - from_crank()) < 1e-9 end, { always = true })
expect("the loop stays closed", function()
  for _, j in ipairs(joints) do if j:gap() > 1e-9 then return false end end
  return true
end, { always = true })
expect("the crank turns once a second", function() return math.abs(crank:spin() - 2 * math.pi) < 1e-3 end)
trail { body = rod, seconds = 0.8 }
plot { title = "Piston (m)", seconds = 3, at = "top_right", y = { x = function() return piston:position().x end } }
caption { text = "One turn of the crank is one stroke there and back" }
