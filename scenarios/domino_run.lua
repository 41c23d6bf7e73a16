-- One small push and forty dominoes: the wave runs at its own speed, whatever the push was.
scenario {
  title = "Domino run", duration = 4, rate = 480, view = { center = {0, 1.5}, height = 5.2 },
  description = "A wave of falling dominoes ends in a ball that rolls off the table.",
  golden = { frames = { 0, 60, 120, 239 } }, layers = { "bodies", "clock" },
}

local table_top = body { name = "table", type = "static", at = {-0.4, -0.25}, shape = box { width = 8.6, height = 0.5 }, friction = 0.6 }
body { name = "floor", type = "static", at = {0, -1}, shape = box { width = 40, height = 0.5 } }
local dominoes = {}
for i = 1, 40 do
  dominoes[i] = body { name = "domino " .. i, at = { -4.4 + 0.18 * i, 0.3 }, friction = 0.4,
                       shape = box { width = 0.06, height = 0.6 }, color = i % 10 == 0 and 0xd98c2b or nil }
end
local ball = body { name = "ball", at = { -4.4 + 0.18 * 40 + 0.42, 0.2 }, shape = circle { radius = 0.2 }, density = 0.4, friction = 0.4 }
at(0.25, function() dominoes[1]:impulse({ 0.03, 0 }, { -4.22, 0.55 }) end)

local fallen_at = {}
every(1 / 480, function()
  for i = 1, 40 do
    if not fallen_at[i] and math.abs(dominoes[i]:angle()) > 0.3 then fallen_at[i] = time() end
  end
end)
measure("fallen", function()
  local n = 0
  for i = 1, 40 do if fallen_at[i] then n = n + 1 end end
  return n
end)
expect("all dominoes have fallen", function()
  for i = 1, 40 do if not fallen_at[i] then return false end end
  return true
end, { finally = true })
expect("the wave settles to a steady speed", function()
  local early = fallen_at[25] - fallen_at[15]
  local late = fallen_at[35] - fallen_at[25]
  return math.abs(early / late - 1) < 0.15
end, { finally = true })
caption { text = "The wave finds its own speed", at = "top" }
plot { title = "Dominoes fallen", seconds = 4, at = "top_left", y = { fallen = function()
  local n = 0
  for i = 1, 40 do if fallen_at[i] then n = n + 1 end end
  return n
end } }
