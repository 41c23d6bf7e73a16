-- How thin a semicircular arch of fifteen equal voussoirs may be, bracketed: 0.1062658242 of its radius, by limit
-- analysis at the joints, where nothing slides (J. Heyman 1966; M. Milankovitch 1907: 0.107478 for infinitely many).
-- A threshold has no order in h.
scenario {
  title = "The thinnest arch, bracketed", duration = 3, rate = 240, view = { center = {0, 1.35}, height = 6.2 },
  description = "Six arches a little thinner or thicker than they may be: the upper three fall, the lower three stand.",
  layers = { "bodies", "labels" }, golden = { frames = { 0, 120, 179 }, size = {480, 270} },
}

local count, critical, radius, arches = 15, 0.1062658242, 1, {}
local function arch(times, middle, lane)
  local thickness, angle = times * critical, math.pi / count
  local function corner(r, a) return { r * math.sin(a), r * math.cos(a) } end
  body { name = ("ground at %+.1f %%"):format(100 * (times - 1)), type = "static", friction = 2, at = middle,
         category = lane, mask = lane, shape = box { width = 3, height = 0.1, at = {0, -0.05} } }
  local inside, outside, key = radius - thickness / 2, radius + thickness / 2, nil
  for k = -(count - 1) / 2, (count - 1) / 2 do
    local from, to = (k - 0.5) * angle, (k + 0.5) * angle
    local stone = body { name = ("voussoir %d at %+.1f %%"):format(k, 100 * (times - 1)), friction = 2, category = lane,
                         mask = lane, at = middle,
                         shape = hull { corner(inside, from), corner(inside, to),
                                        corner(outside, to), corner(outside, from) } }
    if k == 0 then key = stone end
  end
  local start = key:center().y
  label { body = key, text = ("%+.1f %%"):format(100 * (times - 1)) }
  return { thickness = thickness, sunk = function() return start - key:center().y end }
end
for i, off in ipairs { -0.05, -0.02, -0.005, 0.005, 0.02, 0.05 } do
  local column, row = (i - 1) % 3, (i - 1) // 3
  arches[i] = arch(1 + off, { 3.2 * (column - 1), 2.2 - 2.1 * row }, 1 << i)
end
local function bracketed()
  local fell, stood = 0, 2 * critical
  for _, a in ipairs(arches) do
    if a.sunk() > 0.1 then fell = math.max(fell, a.thickness) else stood = math.min(stood, a.thickness) end
  end
  return (fell + stood) / 2
end
measure("thinnest arch by its radius", bracketed)
reference("thinnest arch by its radius", { { 3, critical } })
for i = 3, 4 do
  measure(("sinking of arch %d"):format(i), arches[i].sunk)
end
expect("those and only those stand that are thicker", function()
  for i, a in ipairs(arches) do if (a.sunk() > 0.1) ~= (i <= 3) then return false end end
  return true
end)
