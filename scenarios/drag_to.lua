-- Pulled as if by a hand: a box follows a moving target on a pull of limited strength, and drags a chain along.
scenario {
  title = "Pulled along",
  description = "A pull of at most 400 N takes a box round a circle; a short chain hangs from it.",
  duration = 8, view = { center = {0.9, 1.25}, height = 4.4 },
  layers = { "bodies", "joints", "trails" },
  golden = { frames = { 0, 120, 479 } },
}

local box_body = body { name = "box", at = {1.2, 1.5}, shape = box { width = 0.5, height = 0.5, rounding = 0.06 }, density = 20, group = -1 }
local hand = drag_to { box_body, target = {1.2, 1.5}, max_force = 400 }
local last, links = box_body, {}
for i = 1, 5 do
  local link = body { name = "link " .. i, at = { 1.2, 1.35 - 0.24 * i }, shape = capsule { a = {0, -0.09}, b = {0, 0.09}, radius = 0.04 }, density = 20, group = -1 }
  links[i] = revolute { last, link, at = { 1.2, 1.47 - 0.24 * i } }
  last = link
end

local function target(t) return { 1.2 * math.cos(t), 1.5 + 0.6 * math.sin(2 * t) } end
every(1 / 60, function() hand:set { target = target(time()) } end)
local function force() local f = hand:reaction() return math.sqrt(f.x ^ 2 + f.y ^ 2) end
local function lag()
  local p, t = box_body:position(), target(time())
  return math.sqrt((p.x - t[1]) ^ 2 + (p.y - t[2]) ^ 2)
end
measure("force", force)
measure("lag", lag)
expect("the pull never exceeds 400 N", function() return force() <= 400 + 1e-6 end, { always = true })
expect("the box follows", function() return lag() < 0.25 end, { always = true })
expect("the chain stays whole", function()
  for _, j in ipairs(links) do if j:gap() > 1e-9 then return false end end
  return true
end, { always = true })
trail { body = box_body, seconds = 6.3 }
plot { title = "Pull (N)", seconds = 8, at = "top_right", y = { pull = force } }
caption { text = "The cross is the hand: the box lags behind it, the chain behind the box" }
