-- A box half as wide as high on a slope: it tips where the slope's tangent exceeds width by height (its centre of mass
-- stands above the lower corner), here at 26.565 degrees; friction 0.8 keeps it from sliding up to 38.7 degrees.
function tilted_box(times)
  local width, height = 0.5, 1
  local slope = times * math.atan(width, height)
  local up = { -math.sin(slope), math.cos(slope) }
  body { name = "slope", type = "static", angle = slope, friction = 0.8,
         shape = box { width = 4, height = 0.3, at = {0, -0.15} } }
  local box_ = body { name = "box", at = { up[1] * height / 2, up[2] * height / 2 }, angle = slope, friction = 0.8,
                      shape = box { width = width, height = height } }
  local start = box_:position()
  local function turned() return box_:angle() - slope end
  local function moved()
    local p = box_:position()
    return math.sqrt((p.x - start.x)^2 + (p.y - start.y)^2)
  end
  -- what it may turn by before it tips
  local function away() return math.abs(times - 1) * math.atan(width, height) end
  measure("turned", turned)
  measure("moved", moved)
  no_energy_gained({ box_ }, height)
  return turned, moved, away
end
