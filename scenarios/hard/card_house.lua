-- Five storeys of cards of 40 cm by 2 mm that lean by 25 degrees (the measures of PEEL's and Box2D's card house). Every
-- card begins exactly where it touches. What weighs on a leaning card asks for friction of tan 25 = 0.47 at most.
scenario {
  title = "House of cards", duration = 10, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Forty thin cards stand by friction alone: an overlap of 2 mm loses a whole card.",
  view = { center = {0, 0.93}, height = 2.1 }, layers = { "bodies" },
  golden = { frames = { 599 }, size = {480, 270} },
}
include "include/gates.lua"

local mu, half_thin, half_long, lean = 0.7, 0.001, 0.2, math.rad(25)
ground { y = 0, friction = mu }
local s, c = math.sin(lean), math.cos(lean)
local high = half_long * c + half_thin * s                 -- half the height of a leaning card
local aside = half_long * s + half_thin * c                -- its centre stands so far beside the ridge
local storey, pitch = 2 * high + 2 * half_thin, 2 * half_long + 0.001
local cards = {}
local function card(name, x, y, angle)
  cards[#cards + 1] = body { name = name, at = {x, y}, angle = angle, friction = mu,
                             shape = box { width = 2 * half_thin, height = 2 * half_long } }
  return cards[#cards]
end
local peak
for level = 0, 4 do
  local ridges = 5 - level
  for i = 1, ridges do
    local x, y = (i - (ridges + 1) / 2) * pitch, level * storey + high
    peak = card(("leaning right %d.%d"):format(level, i), x - aside, y, -lean)
    card(("leaning left %d.%d"):format(level, i), x + aside, y, lean)
    if i < ridges then card(("flat %d.%d"):format(level, i), x + pitch / 2, y + high + half_thin, math.pi / 2) end
  end
end
local start = peak:position()
measure("peak height", function() return peak:position().y end)
expect("it stands: the peak keeps 98 percent of its height", function() return peak:position().y >= 0.98 * start.y end,
       { always = true })
expect("quality: the peak keeps 99.9 percent of its height", function() return peak:position().y >= 0.999 * start.y end)
expect("nobody slips: the peak stays within 1 cm of the axis",
       function() return math.abs(peak:position().x - start.x) <= 0.01 end, { always = true })
no_overlap(2 * half_thin, 1)
no_energy_gained(cards, 5 * storey)
