-- Bricks that hang over each other by 1/2, 1/4, 1/6 and over the table by 1/8 of their length, the harmonic stack (see
-- M. Paterson and U. Zwick 2009): whatever lies on top of an edge has its centre of mass exactly above that edge. With
-- `times` as much it lies half of (1 - times) brick lengths inside, here half a centimetre either way.
function overhanging(times)
  local count, length, high = 4, 1, 0.2
  body { name = "table", type = "static", friction = 0.6, shape = box { width = 1.6, height = 0.4, at = {-0.8, -0.2} } }
  local bricks, edge = {}, 0
  for k = count, 1, -1 do
    edge = edge + times * length / (2 * k)
    bricks[#bricks + 1] = body { name = ("brick %d from the top"):format(k), friction = 0.6,
                                 at = { edge - length / 2, (count - k + 0.5) * high },
                                 shape = box { width = length, height = high } }
  end
  local top = bricks[count]
  local start = top:position()
  measure("top sinks", function() return start.y - top:position().y end)
  measure("overhang", function() return top:position().x + length / 2 end)
  no_energy_gained(bricks, count * high + 0.4)
  return bricks, function() return start.y - top:position().y end
end
