-- Fifteen voussoirs, a twentieth thinner than statics asks for: crown, haunches and feet hinge open.
scenario {
  title = "An arch just too thin", duration = 4, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A semicircular arch 5 percent thinner than the thinnest that stands: contacts that stick hold it up.",
  view = { center = {0, 3.4}, height = 8 }, layers = { "bodies", "contacts" },
  golden = { frames = { 60, 239 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/sector_arch.lua"

local thickness, radius = 0.95 * thinnest_arch(15), 4
local stones, key = sector_arch(15, thickness, radius)
measure("thickness by radius", function() return thickness end)
measure("keystone height", function() return key:position().y end)
expect("it falls: the keystone lies below half its height", function() return key:position().y < radius / 2 end)
no_energy_gained(stones, radius)
