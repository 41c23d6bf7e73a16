-- Blocks at rest on planes of 30 degrees that fall to the left. They slide where mu < tan 30 degrees, by
-- g (sin - mu cos) t^2 / 2 (C. A. Coulomb 1785). `from` is where a block touches its plane, `length` that of the plane,
-- which ends half a block's width above it.
function block_on_incline(mu, from, length)
  local slope, g, width, height = math.rad(30), 9.81, 0.6, 0.4
  local c, s = math.cos(slope), math.sin(slope)
  body { name = ("plane of mu = %g"):format(mu), type = "static", at = from, angle = slope, friction = mu,
         shape = box { width = length, height = 0.2, at = { width - length / 2, -0.1 } } }
  local start = { from[1] - height / 2 * s, from[2] + height / 2 * c }
  local block = body { name = ("mu = %g"):format(mu), at = start, angle = slope, friction = mu,
                       shape = box { width = width, height = height } }
  local function slid()
    local p = block:position()
    return -(p.x - start[1]) * c - (p.y - start[2]) * s
  end
  local function exact(t) return math.max(0, g * (s - mu * c)) * t * t / 2 end
  return slid, exact, block
end
