-- Special functions and closed forms that reference problems are held against, in double precision. The tests hold
-- them to 1e-12 of values that were found in other ways (tests/scenarios/math_reference_test.cpp).

-- The modulus k of an elliptic function and its complement k' = sqrt(1 - k^2). Near 1 the complement has to be given:
-- what is left of 1 - k^2 has few digits. It must not be 0, where there is no period.
local function complement_of(k, complement) return complement or math.sqrt((1 - k) * (1 + k)) end

-- Means a of 1 and k', and half of the differences c, until those are below rounding (Gauss 1818; Abramowitz and
-- Stegun 1964, 17.6).
local function means(k, complement)
  local a, b, c = { 1 }, complement_of(k, complement), { k }
  while c[#c] > 1e-17 * a[#a] do
    local above = a[#a]
    a[#a + 1], c[#c + 1], b = (above + b) / 2, (above - b) / 2, math.sqrt(above * b)
    if a[#a] == above then break end
  end
  return a, c
end

-- K(k), the complete elliptic integral of the first kind.
function elliptic_k(k, complement)
  local a = means(k, complement)
  return math.pi / (2 * a[#a])
end

-- Carlson's symmetric integral R_F (B. C. Carlson 1995): duplication until the three are nearly one, then a series.
local function carlson_rf(x, y, z)
  local mean, far
  repeat
    local root = math.sqrt(x * y) + math.sqrt(y * z) + math.sqrt(z * x)
    x, y, z = (x + root) / 4, (y + root) / 4, (z + root) / 4
    mean = (x + y + z) / 3
    far = math.max(math.abs(mean - x), math.abs(mean - y), math.abs(mean - z)) / mean
  until far < 2e-3
  local dx, dy = 1 - x / mean, 1 - y / mean
  local dz = -dx - dy
  local e2, e3 = dx * dy - dz * dz, dx * dy * dz
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / math.sqrt(mean)
end

-- F(phi, k), the incomplete elliptic integral of the first kind, for |phi| <= pi / 2.
function elliptic_f(phi, k, complement)
  local s, c, k1 = math.sin(phi), math.cos(phi), complement_of(k, complement)
  return s * carlson_rf(c * c, c * c + k1 * k1 * s * s, 1)
end

-- Jacobi's sn, cn, dn and am of u: Landen's transformation down the ladder of means (Abramowitz and Stegun 1964, 16.4).
function jacobi(u, k, complement)
  local a, c = means(k, complement)
  local phi = 2 ^ (#a - 1) * a[#a] * u
  for n = #a, 2, -1 do phi = (phi + math.asin(c[n] / a[n] * math.sin(phi))) / 2 end
  local sn, cn, k1 = math.sin(phi), math.cos(phi), complement_of(k, complement)
  return sn, cn, math.sqrt(k1 * k1 + k * k * cn * cn), phi
end

-- Angle and angular velocity at time t of what swings by theta'' = -omega^2 sin theta, let go at theta0:
-- sin(theta / 2) = k sn(K + omega t), cos(theta / 2) = dn, k = sin(theta0 / 2) (see E. T. Whittaker 1904, 44).
function pendulum_at(t, theta0, omega)
  local k, k1 = math.sin(theta0 / 2), math.cos(theta0 / 2)
  local sn, cn, dn = jacobi(elliptic_k(k, k1) + omega * t, k, k1)
  return 2 * math.atan(k * sn, dn), 2 * k * omega * cn
end

function pendulum_period(theta0, omega) return 4 * elliptic_k(math.sin(theta0 / 2), math.cos(theta0 / 2)) / omega end

-- Place and velocity on Kepler's ellipse of half axis 1 under an attraction of 1 / r^2, nearest to the origin at t = 0;
-- Kepler's equation M = E - e sin E by Newton's method.
function kepler_at(t, e)
  local mean = t % (2 * math.pi)
  local anomaly = mean < math.pi and mean + e / 2 or mean - e / 2
  for _ = 1, 30 do
    local step = (anomaly - e * math.sin(anomaly) - mean) / (1 - e * math.cos(anomaly))
    anomaly = anomaly - step
    if math.abs(step) < 1e-16 then break end
  end
  local c, s, narrow = math.cos(anomaly), math.sin(anomaly), math.sqrt(1 - e * e)
  local rate = 1 / (1 - e * c)
  return c - e, narrow * s, -s * rate, narrow * c * rate
end

-- Where a straight way of length x ends when it is folded to and fro between 0 and width: the unfolding of billiards.
function folded(x, width)
  local rest = x % (2 * width)
  return rest <= width and rest or 2 * width - rest
end

-- Where a function that rises from below zero at lo to above zero at hi is zero.
function root_between(f, lo, hi)
  for _ = 1, 200 do
    local middle = (lo + hi) / 2
    if middle == lo or middle == hi then break end
    if f(middle) < 0 then lo = middle else hi = middle end
  end
  return (lo + hi) / 2
end
