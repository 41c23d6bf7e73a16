-- A box of 20 m falls onto two small feet; `foot` is their shape, one metre high, standing on its origin.
function heavy_box_on(foot, drop)
  ground { y = 0 }
  local left = body { name = "left foot", at = {-9, 0}, shape = foot }
  local right = body { name = "right foot", at = {9, 0}, shape = foot }
  local heavy = body { name = "heavy box", at = {0, 11 + drop}, shape = box { width = 20, height = 20 } }
  local function sink() return 11 - heavy:position().y end
  measure("sink", sink)
  measure("tilt", function() return heavy:angle() end)
  measure("mass ratio", function() return heavy:mass() / left:mass() end)
  expect("the feet are not crushed: the box lies on them within 2 cm",
         function() return math.abs(sink()) <= 0.02 end)
  expect("it never sinks by more than 5 percent of a foot", function() return sink() <= 0.05 end, { always = true })
  expect("it lies level to a thousandth", function() return math.abs(heavy:angle()) <= 1e-3 end)
  expect("the feet have not slid away", function()
    return math.abs(left:position().x + 9) <= 0.05 and math.abs(right:position().x - 9) <= 0.05
  end)
  no_overlap(1, math.sqrt(drop / 5) + 2)                 -- two seconds after it has landed
  no_energy_gained({ left, right, heavy }, drop + 21)
end
