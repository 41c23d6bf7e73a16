-- Thesis figures 2.4 and 2.5, equations 2.11 to 2.29: scale, turn, move, with the matrix of it all; and in another order.
scenario {
  title = "From local to world coordinates", description = "Scale, turn and move a shape, and why the order matters.",
  golden = { frames = { 540, 1570, 2420, 3125, 4005 }, size = { 960, 540 } },
}

local shape = polygon { {-1, -0.7}, {1.1, -0.7}, {1.1, 0.2}, {-0.2, 0.9}, {-1, 0.5} }
for _, algorithm in ipairs { "transforms", "transform_order" } do
  demonstrate { algorithm = algorithm, shapes = { shape }, scale = {1.5, 0.8}, angle = math.rad(50), at = {3.8, 0.6} }
end
