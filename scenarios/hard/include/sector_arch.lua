-- A semicircular arch of `count` equal voussoirs and the thinnest it may be (M. Milankovitch 1907: t/R = 0.1075 for
-- infinitely many): statics at the joints, nothing slides, the stone bears any pressure and no pull (J. Heyman 1966).
local function corners_of(count, thickness, k)
  local angle = math.pi / count
  local function at_angle(r, a) return { r * math.sin(a), r * math.cos(a) } end
  local from, to = (k - 0.5) * angle, (k + 0.5) * angle     -- from the crown, clockwise
  local inside, outside = 1 - thickness / 2, 1 + thickness / 2
  return { at_angle(inside, from), at_angle(inside, to), at_angle(outside, to), at_angle(outside, from) }
end

local function area_and_centre(corners)
  local area, x, y = 0, 0, 0
  for i, p in ipairs(corners) do
    local q = corners[i % #corners + 1]
    local cross = p[1] * q[2] - q[1] * p[2]
    area, x, y = area + cross / 2, x + (p[1] + q[1]) * cross / 6, y + (p[2] + q[2]) * cross / 6
  end
  return area, x / area, y / area
end

-- Whether a line of thrust exists: it leaves the keystone's axis with the horizontal force h at the height moment / h
-- and passes every joint between its inner and its outer end. For one h each joint bounds the moment from both sides.
local function slack(count, thickness, h)
  local weight, first_moment = 0, 0
  local least, most = -math.huge, math.huge
  for k = 0, (count - 1) / 2 do
    local area, x = area_and_centre(corners_of(count, thickness, k))
    if k == 0 then                                          -- half of the keystone
      local c = corners_of(count, thickness, 0)
      area, x = area_and_centre { {0, c[1][2]}, c[2], c[3], {0, c[4][2]} }
    end
    weight, first_moment = weight + area, first_moment + area * x
    local joint = (k + 0.5) * math.pi / count
    local inside, outside = 1 - thickness / 2, 1 + thickness / 2
    least = math.max(least, h * inside * math.cos(joint) + weight * inside * math.sin(joint) - first_moment)
    most = math.min(most, h * outside * math.cos(joint) + weight * outside * math.sin(joint) - first_moment)
  end
  return most - least
end

function thinnest_arch(count)
  local function stands(thickness)                          -- slack is concave in h
    local lo, hi = 0, thickness
    for _ = 1, 60 do
      local a, b = lo + (hi - lo) / 3, hi - (hi - lo) / 3
      if slack(count, thickness, a) < slack(count, thickness, b) then lo = a else hi = b end
    end
    return slack(count, thickness, (lo + hi) / 2) >= 0
  end
  local falls, holds = 0.02, 0.3
  for _ = 1, 40 do
    local middle = (falls + holds) / 2
    if stands(middle) then holds = middle else falls = middle end
  end
  return (falls + holds) / 2
end

-- Rough enough that nothing slides, as the theorem supposes.
function sector_arch(count, thickness, radius)
  ground { y = 0, friction = 1 }
  local stones = {}
  for k = -(count - 1) / 2, (count - 1) / 2 do
    local corners = corners_of(count, thickness, k)
    local _, x, y = area_and_centre(corners)
    for _, p in ipairs(corners) do p[1], p[2] = radius * (p[1] - x), radius * (p[2] - y) end
    stones[#stones + 1] = body { name = "voussoir " .. #stones + 1, at = { radius * x, radius * y }, friction = 1,
                                 shape = hull(corners) }
  end
  return stones, stones[(count + 1) // 2]
end
