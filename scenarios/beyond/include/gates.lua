-- The same as hard/include/gates.lua, byte for byte but for this line: what is included lies in a scenario's own folder.
-- What every hard case is held to besides its own truth. Expectations named "quality: ..." say how well, all others
-- whether: a case whose quality alone is bad has degraded, it has not failed.

-- Looked at eight times a second once it has settled: often enough for what stays, and cheap.
local function is_due(settled)
  local eighths = time() * 8
  return time() >= settled and math.abs(eighths - math.floor(eighths + 0.5)) < 1e-6
end

-- Nothing overlaps by more than a hundredth of the smallest body (`size`, its thickness in metres) from `settled` on.
function no_overlap(size, settled)
  local function deepest()
    local least = 0
    for _, c in ipairs(contacts()) do least = math.min(least, c.separation) end
    return -least
  end
  measure("overlap", function() return is_due(0) and deepest() or 0 end)   -- of five thousand bodies it is dear
  expect("quality: nothing overlaps by more than a hundredth of the smallest body",
    function() return not is_due(settled) or deepest() <= 0.01 * size end, { always = true })
end

-- Nothing gains energy beyond the work done from outside: a thousandth of what `bodies` would gain by falling through
-- `height` metres is allowed.
function no_energy_gained(bodies, height, gravity)
  local weight = 0
  for _, b in ipairs(bodies) do weight = weight + b:mass() * (gravity or 10) end
  local first = energy().total
  local function gained() return energy().total - energy().work - first end
  measure("energy gained", gained)
  expect("energy does not grow beyond the work done on the scene",
    function() return gained() <= 1e-3 * weight * height end, { always = true })
end

-- The anchors of `joints` stay together to `size` metres / 100 from `settled` on.
function no_gap(joints, size, settled)
  local function widest()
    local most = 0
    for _, j in ipairs(joints) do most = math.max(most, j:gap()) end
    return most
  end
  measure("gap", widest)
  expect("quality: joints stay closed to a hundredth of the smallest body",
    function() return not is_due(settled) or widest() <= 0.01 * size end, { always = true })
end
