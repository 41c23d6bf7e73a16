-- A shelf welded to a wall carries a bucket that sand runs into, until the weld gives way.
scenario {
  title = "The last straw",
  description = "A weld bears 140 N: it holds the shelf and the filling bucket until their weight is just above that.",
  duration = 5, view = { center = {1.7, 1.5}, height = 4.3 },
  layers = { "bodies", "joints" },
  golden = { frames = { 0, 180, 225, 419 } },
}

ground { y = 0 }
local g, bears = 9.81, 140
local wall = body { name = "wall", type = "static", at = {-0.35, 1.3}, shape = box { width = 0.3, height = 2.6 } }
local shelf = body { name = "shelf", at = {0.6, 2}, shape = box { width = 1.6, height = 0.1 }, mass = 1 }
local bucket = body { name = "bucket", at = {1.2, 1.2}, shape = hull { {-0.2, -0.2}, {0.2, -0.2}, {0.27, 0.2}, {-0.27, 0.2} }, mass = 1 }
local bond = weld { wall, shelf, at = {-0.2, 2}, break_force = bears }
distance { shelf, bucket, from = {1.2, 1.95}, to = {1.2, 1.4} }

local broke_at, pulled
every(0.05, function()
  if not broke_at then bucket:set { mass = bucket:mass() + 0.2 } end
end)
on_break(bond, function(e)
  broke_at, pulled = time(), math.sqrt(e.reaction.x ^ 2 + e.reaction.y ^ 2)
  caption { text = "Loaded with more than 140 N, the weld breaks" }
end)
measure("load", function() return bond:reaction().y end)
measure("weight", function() return (shelf:mass() + bucket:mass()) * g end)
expect("just below its strength the weld holds", function()
  return broke_at == nil and math.abs(bond:reaction().y - (shelf:mass() + bucket:mass()) * g) < 1e-3
end, { at = 3 })
expect("it breaks by the next cupful", function() return pulled > bears and pulled < bears + 0.21 * g end)
expect("a broken weld holds nothing, and the bucket falls", function()
  return bond:reaction().y == 0 and bucket:position().y < 0.5
end)
local grains = {}
every(0.05, function()
  while #grains > 0 and grains[1]:position().y < bucket:position().y do table.remove(grains, 1):remove() end   -- it is in
  if not broke_at then
    grains[#grains + 1] = body { name = "grain", at = { 1.33 + 0.06 * (math.random() - 0.5), 1.85 }, shape = circle { radius = 0.025 }, mass = 1e-6, mask = 0, color = 0xC9A75C }
  end
end)
plot { title = "Load of the weld (N)", seconds = 5, at = "top_right", y = { load = function() return bond:reaction().y end, ["strength"] = function() return bears end } }
freeze { at = 4.9, seconds = 2 }
caption { text = "Sand runs in, 4 kg every second", from = 0, to = 3 }
