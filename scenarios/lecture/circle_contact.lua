-- Thesis figures 4.3 and 4.4: circles against circles and polygons, special cases included.
scenario {
  title = "Contacts of circles", description = "Standard and special cases.",
  golden = { frames = { 797, 1508, 3158, 3837, 5020 }, size = { 960, 540 } },
}

local house = polygon { {0, -1.2}, {2.4, -0.9}, {2.2, 0.9}, {0.3, 1.1} }
local function show(a, b) demonstrate { algorithm = "circle_contact", shapes = { a, b } } end

show(circle { at = {-0.7, 0}, radius = 1.1 }, circle { at = {0.8, 0.4}, radius = 0.8 })
show(circle { radius = 1.1 }, circle { radius = 0.8 })      -- coincident centres
show(circle { at = {-0.6, 0}, radius = 1 }, house)          -- in front of an edge
show(circle { at = {-0.3, 1.8}, radius = 1.1 }, house)      -- beyond a corner
show(circle { at = {0.7, 0.1}, radius = 0.8 }, house)       -- the centre inside
