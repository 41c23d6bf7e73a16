-- A block at rest on a plane of 30 degrees; it slides where mu < tan 30 = 0.57735 (Coulomb 1785).
function block_on_incline(mu)
  local slope, g = math.rad(30), 9.81
  local along = { -math.cos(slope), -math.sin(slope) }       -- downhill, to the left
  local up = { -math.sin(slope), math.cos(slope) }
  body { name = "plane", type = "static", angle = slope, friction = mu,
         shape = box { width = 8, height = 0.4, at = {0, -0.2} } }
  local start = { 3 * math.cos(slope) + 0.25 * up[1], 3 * math.sin(slope) + 0.25 * up[2] }
  local block = body { name = "block", at = start, angle = slope, friction = mu,
                       shape = box { width = 1, height = 0.5 } }
  local function slid()
    local p = block:position()
    return (p.x - start[1]) * along[1] + (p.y - start[2]) * along[2]
  end
  measure("slid", slid)
  -- g (sin - mu cos), or nothing at all
  local acceleration = math.max(0, g * (math.sin(slope) - mu * math.cos(slope)))
  reference("slid", function(t) return acceleration * t * t / 2 end)
  return block, slid, acceleration
end
