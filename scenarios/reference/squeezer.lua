-- Seven bodies in closed loops, driven from rest to thousands of turns a minute within 30 ms: Andrews' squeezing
-- mechanism (G. Andrews, M. Ormrod 1986; data by W. Schiehlen 1990, E. Hairer and G. Wanner 1996). Angles by RK4 with
-- 80 bits and extrapolation, in angles and again in Cartesian coordinates: all digits the same, the energy kept to
-- 2e-14 J (own computations; the published ones keep it to 2e-10 J).
scenario {
  title = "Andrews' squeezing mechanism", duration = 0.03, rate = 24000, fps = 60, gravity = {0, 0},
  description = "A crank of 7 mm, a spring, and six links: the test of every solver of constrained motion.",
  view = { center = {-0.018, 0.027}, height = 0.135 }, layers = { "bodies", "joints" },
  golden = { frames = { 0, 70, 239 }, size = {480, 270} },
}
slow { from = 0, to = 0.03, factor = 1 / 133.33333333333333 }

local sin, cos = math.sin, math.cos
local A, B, C = { -0.06934, -0.00227 }, { -0.03635, 0.03273 }, { 0.014, 0.072 }
local start = { beta = -0.0617138900142764496, Theta = 0, gamma = 0.455279819163070380, Phi = 0.222668390165885885,
                delta = 0.487364979543842550, Omega = -0.222668390165885885, epsilon = 1.23054744454982120 }
local function from(p, x, y) return { p[1] + x, p[2] + y } end
-- The point `along` and `beside` from p, where `angle` is that of the direction along.
local function beyond(p, angle, along, beside)
  return from(p, along * cos(angle) - beside * sin(angle), along * sin(angle) + beside * cos(angle))
end

-- A body of thin bars between points, with its centre of mass where the data say: bars weigh one part, a knob nine.
local function part(name, mass, inertia, center, bars)
  local radius, knob, weight, x, y, shapes = 0.0009, 0.0022, 0, 0, 0, {}
  for i = 1, #bars - 1 do
    local a, b = bars[i], bars[i + 1]
    local area = math.pi * radius ^ 2 + 2 * radius * math.sqrt((a[1] - b[1]) ^ 2 + (a[2] - b[2]) ^ 2)
    weight, x, y = weight + area, x + area * (a[1] + b[1]) / 2, y + area * (a[2] + b[2]) / 2
    shapes[i] = capsule { a = from(a, -center[1], -center[2]), b = from(b, -center[1], -center[2]), radius = radius,
                          density = 1 }
  end
  x, y = x / weight - center[1], y / weight - center[2]
  shapes[#shapes + 1] = circle { radius = knob, at = { -x / 9, -y / 9 }, density = 9 * weight / (math.pi * knob ^ 2) }
  return body { name = name, at = center, mass = mass, inertia = inertia, group = -1, shapes = shapes }
end

local crank_end = beyond({0, 0}, start.beta, 0.007, 0)
local rod_angle = start.beta + start.Theta
local knee = beyond(crank_end, rod_angle, -0.028, 0)                 -- where four of them meet
local elbow = beyond(A, start.delta, 0.04, 0)
local heel = beyond(A, start.epsilon - math.pi / 2, 0.04, 0)
local spring_end = beyond(B, start.gamma - math.pi / 2, 0.018, 0.02)
local upper, lower = start.Phi + start.delta - math.pi / 2, start.Omega + start.epsilon
local crank, rod, rocker, upper_toe, upper_arm, lower_toe, lower_arm = table.unpack {
  part("crank", 0.04325, 2.194e-6, beyond({0, 0}, start.beta, 0.00092, 0), { {0, 0}, crank_end }),
  part("rod", 0.00365, 4.410e-7, beyond(crank_end, rod_angle, -0.0115, 0), { crank_end, knee }),
  part("rocker", 0.02373, 5.255e-6, beyond(B, start.gamma - math.pi / 2, 0.01874, 0.01043), { B, knee, spring_end, B }),
  part("upper toe", 0.00706, 5.667e-7, beyond(elbow, upper, 0.02 - 0.01421, 0), { elbow, knee }),
  part("upper arm", 0.07050, 1.169e-5, beyond(A, start.delta, 0.02308, 0.00916), { A, elbow }),
  part("lower toe", 0.00706, 5.667e-7, beyond(heel, lower, 0.02 - 0.01421, 0), { heel, knee }),
  part("lower arm", 0.05498, 1.912e-5, beyond(A, start.epsilon - math.pi / 2, 0.01228, -0.00449), { A, heel }),
}
local joints = {
  revolute { world, crank, at = {0, 0}, motor = { speed = 1e6, max_torque = 0.033 } },   -- a constant torque
  revolute { crank, rod, at = crank_end }, revolute { world, rocker, at = B }, revolute { rod, rocker, at = knee },
  revolute { world, upper_arm, at = A }, revolute { upper_arm, upper_toe, at = elbow },
  revolute { rod, upper_toe, at = knee }, revolute { world, lower_arm, at = A },
  revolute { lower_arm, lower_toe, at = heel }, revolute { rod, lower_toe, at = knee },
}
spring { world, rocker, from = C, to = spring_end, stiffness = 4530, length = 0.07785 }

local angles = { beta = function() return crank:angle() end, Theta = function() return rod:angle() - crank:angle() end,
                 gamma = function() return rocker:angle() end, delta = function() return upper_arm:angle() end,
                 Phi = function() return upper_toe:angle() - upper_arm:angle() end,
                 Omega = function() return lower_toe:angle() - lower_arm:angle() end,
                 epsilon = function() return lower_arm:angle() end }
-- t, beta, Theta, gamma, Phi, delta, epsilon; Omega is -Phi throughout
local exact = {
  { 0.005, 0.2110763859033, -0.2015871709341, 0.4491151900115, 0.2102507979300, 0.4887437654619, 1.2258667940349 },
  { 0.010, 2.1601131315315, -1.8833642311070, 0.1585167580012, -0.3286410751747, 0.5251547747977, 1.0684272046324 },
  { 0.015, 5.6554297499918, -5.8337967651088, 0.4258919257524, 0.1640128375726, 0.4936765269686, 1.2087125419092 },
  { 0.020, 8.1849058896617, -7.8905053637304, 0.2095369133847, -0.2383255965959, 0.5225369171560, 1.0862751085999 },
  { 0.025, 12.1071492344477, -12.2570301035755, 0.4409733555830, 0.1939451660545, 0.4905195446816, 1.2197667718104 },
  { 0.030, 15.8107711951537, -15.7563710584118, 0.0408222401196, -0.5347301163421, 0.5244099658800, 1.0480807410419 },
}
local column = { beta = 2, Theta = 3, gamma = 4, Phi = 5, delta = 6, Omega = 5, epsilon = 7 }
for name, angle in pairs(angles) do
  local points = { { 0, start[name] } }
  for _, row in ipairs(exact) do
    points[#points + 1] = { row[1], name == "Omega" and -row[column.Omega] or row[column[name]] }
  end
  measure(name, function() return start[name] + angle() end)
  reference(name, points)
  expect(("after 30 ms %s is %.10f, to a thousandth"):format(name, points[#points][2]),
         function() return math.abs(start[name] + angle() - points[#points][2]) <= 1e-3 end)
end
measure("energy", function() return energy().total - 0.033 * (start.beta + crank:angle()) end)
reference("energy", function() return 1.437832957532140 end)

expect("the loops stay closed to 1e-12 m", function()
  for _, j in ipairs(joints) do if j:gap() > 1e-12 then return false end end
  return true
end, { always = true })
