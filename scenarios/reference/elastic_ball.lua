-- A hundred and ten impacts, each made at its own time: between them there is nothing to err by. Whoever makes them at
-- the end of a step is off by its length in each. Period 2 sqrt(2 h / g) of parabolas (G. Galilei 1638).
scenario {
  title = "A ball that gives back everything", duration = 100, rate = 120, fps = 60,
  description = "From 1 m with restitution 1: a hundred seconds later it must still be in step.",
  method = { contact_solver = "event" }, view = { center = {0, 0.6}, height = 1.6 },
  layers = { "bodies", "trails", "grid" },
  golden = { frames = { 0, 27, 5999 }, size = {480, 270} },
}

local drop, radius, g = 1, 0.1, 9.81
ground { y = 0, friction = 0 }
local ball = body { name = "ball", at = { 0, drop + radius }, restitution = 1, friction = 0,
                    shape = circle { radius = radius } }
local period = 2 * math.sqrt(2 * drop / g)
local function exact(t)
  local s = (t + period / 2) % period - period / 2                     -- from the nearest apex
  return drop - g * s * s / 2
end
measure("gap", function() return ball:position().y - radius end)
reference("gap", exact)
measure("energy", function() return energy().total / ball:mass() end)  -- J/kg
reference("energy", function() return g * (drop + radius) end)

expect("after 100 s the gap is 0.721581154448 m, to 1e-6 m",
       function() return math.abs(ball:position().y - radius - 0.7215811544478331) <= 1e-6 end)
expect("it never goes through the floor", function() return ball:position().y >= radius - 1e-9 end, { always = true })
trail { body = ball, seconds = 0.3 }
