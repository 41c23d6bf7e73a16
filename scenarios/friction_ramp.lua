-- Where does a block begin to slide? Exactly where the slope's tangent exceeds the coefficient of friction.
scenario {
  title = "The angle of friction", duration = 6, view = { center = {4.4, 2.4}, height = 6.6 },
  description = "Five blocks of different friction on one plate that tilts slowly: each starts at atan(mu).",
  golden = { frames = { 0, 180, 280, 359 } }, layers = { "bodies", "labels", "vectors" },
}

-- The plate is lifted about its left end at a constant, slow rate, so that a block starts when tan(angle) = mu.
local rate = math.rad(6)
local plate = body { name = "plate", type = "kinematic", at = {0, 0}, friction = 1, shape = box { width = 9, height = 0.2, at = {4.5, 0} } }
every(1 / 240, function() plate:set { spin = rate * math.min(1, time()) } end)   -- set going without a jolt
local blocks = {}
for i, mu in ipairs { 0.1, 0.2, 0.3, 0.4, 0.5 } do
  local x = 1.5 + 1.5 * (i - 1)
  -- sqrt(mu * mu_plate) is the mixed coefficient
  local block = body { name = ("mu = %.1f"):format(mu), at = { x, 0.3 }, friction = mu^2, density = 1,
                       shape = box { width = 0.6, height = 0.4 }, color = ({ 0x4a7fb5, 0x3c9a8f, 0xd98c2b, 0xb8433f, 0x8c6bb1 })[i] }
  label { body = block, text = ("µ = %.1f"):format(mu) }
  blocks[i] = { handle = block, mu = mu, x = x }
end
local function along(b)
  local p, a = b.handle:position(), plate:angle()
  return p.x * math.cos(a) + p.y * math.sin(a)
end
every(1 / 60, function()
  for _, b in ipairs(blocks) do
    if not b.started and math.abs(along(b) - b.x) > 0.002 then b.started = plate:angle() end
  end
end)
for _, b in ipairs(blocks) do
  expect(("mu = %.1f starts near %.1f degrees"):format(b.mu, math.deg(math.atan(b.mu))), function()
    local angle = b.started or plate:angle()
    return angle > math.atan(b.mu) - math.rad(0.5) and angle < math.atan(b.mu) + math.rad(2.5)
  end, { finally = true })
end
plot { title = "Slope (degrees)", seconds = 6, at = "top_left", y = { slope = function() return math.deg(plate:angle()) end } }
