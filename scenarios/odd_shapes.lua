-- Two hundred concave and rounded shapes fall into a tray. Thin lines show the convex parts that collide.
scenario {
  title = "Odd shapes", duration = 9, seed = 7, view = { center = {0, 4.3}, height = 10.4 },
  description = "Stars, hooks, gears and rounded boxes: concave outlines are cut into few convex parts.",
  layers = { "bodies", "parts" }, golden = { frames = { 60, 240, 539 } },
}

ground { y = 0 }
for _, side in ipairs { -1, 1 } do
  body { type = "static", shape = polygon { {8.5 * side, 0}, {9 * side, 0}, {9 * side, 6}, {8.5 * side, 5.7} } }
end

-- Corners at turns t = 0, 1/n, 2/n ... round the origin, as far out as radius(i) says.
local function ring(n, radius)
  local corners = {}
  for i = 0, n - 1 do
    local turn = 2 * math.pi * i / n + math.pi / 2
    corners[i + 1] = { radius(i) * math.cos(turn), radius(i) * math.sin(turn) }
  end
  return corners
end

local function crescent(r)
  local corners = {}
  for i = 0, 8 do
    local turn = math.pi * (0.15 + 1.7 * i / 8)
    corners[#corners + 1] = { r * math.cos(turn), r * math.sin(turn) }
  end
  for i = 7, 1, -1 do
    local turn = math.pi * (0.2 + 1.6 * i / 8)
    corners[#corners + 1] = { r * (0.35 + 0.62 * math.cos(turn)), 0.66 * r * math.sin(turn) }
  end
  return corners
end

local kinds = {
  function(s) return polygon(ring(10, function(i) return i % 2 == 0 and s or 0.45 * s end)) end,            -- a star
  function(s) return polygon(ring(24, function(i) return i % 4 < 2 and s or 0.74 * s end)) end,             -- a gear
  function(s) return polygon { {-s, -s}, {s, -s}, {s, -0.3 * s}, {-0.3 * s, -0.3 * s}, {-0.3 * s, s}, {-s, s} } end,
  function(s) return polygon { {-s, s}, {-s, -s}, {s, -s}, {s, s}, {0.45 * s, s}, {0.45 * s, -0.45 * s},
                               {-0.45 * s, -0.45 * s}, {-0.45 * s, s} } end,
  function(s) return polygon { {-0.3 * s, -s}, {0.3 * s, -s}, {0.3 * s, -0.3 * s}, {s, -0.3 * s}, {s, 0.3 * s},
                               {0.3 * s, 0.3 * s}, {0.3 * s, s}, {-0.3 * s, s}, {-0.3 * s, 0.3 * s}, {-s, 0.3 * s},
                               {-s, -0.3 * s}, {-0.3 * s, -0.3 * s} } end,
  function(s) return polygon { {s, 0}, {-0.7 * s, 0.8 * s}, {-0.25 * s, 0}, {-0.7 * s, -0.8 * s} } end,      -- a dart
  function(s) return polygon(crescent(s)) end,
  function(s) return box { width = 1.7 * s, height = 1.1 * s, rounding = 0.3 * s } end,
  function(s) return regular { sides = 3, radius = s, rounding = 0.2 * s } end,
  function(s) return hull { {-s, 0}, {0, -0.7 * s}, {s, -0.2 * s}, {0.4 * s, 0.7 * s}, rounding = 0.15 * s } end,
  function(s) return capsule { a = {-0.7 * s, 0}, b = {0.7 * s, 0}, radius = 0.4 * s } end,
}

local bodies = {}
for i = 1, 200 do
  local column = (i - 1) % 10
  local row = (i - 1 - column) / 10
  bodies[i] = body {
    at = { -7.4 + 1.6 * column + 0.4 * math.random(), 4 + 1.35 * row }, angle = 2 * math.pi * math.random(),
    shape = kinds[(i - 1) % #kinds + 1](0.38 + 0.2 * math.random()), friction = 0.4,
  }
end

expect("nothing falls through the ground", function()
  for _, b in ipairs(bodies) do
    local c = b:center()
    if c.y < 0.05 then return false end
  end
  return true
end, { always = true })

expect("the heap comes to rest", function() return energy().kinetic < 2 end)
