-- Two points of 1 kg on massless rods of 1 m, let go at rest, both level with the pivot: angles and their rates from
-- straight down at five times. Taylor series of order 36 in steps of 5 ms with 50 digits; order 44 in steps of 10 ms
-- gives the same to 1e-26 (own computation). The motion is chaotic: what is off at first grows.
local exact = {
  { t = 1, -0.625087699806390630, -1.03458508568001234, -3.92227957288797662, -1.30309924869633124 },
  { t = 2, -0.482971534251754377, -1.32404871230236255, 3.06528819207340132, 2.94927154757161898 },
  { t = 5, -0.627186705066530730, -1.30131555020981168, 2.12540867384291065, 3.88188872726560744 },
  { t = 10, -0.568474664015950189, -0.526393727932404698, 6.07838488576196485, -9.68136068170887876 },
  { t = 20, 0.748760975479181827, -25.8324619988937768, 4.07800396927508778, 2.77988945538666974 },
}

-- {t, value} of the function of (theta1, theta2, their rates), until `last`.
function double_pendulum_table(f, last)
  local points = {}
  for _, e in ipairs(exact) do
    if e.t <= last then points[#points + 1] = { e.t, f(table.unpack(e)) } end
  end
  return points
end
