"""An upright steam engine with letters of its own, as the text of a scene."""

SCENE = """
title = "Upright engine"
language = "en"
[frame]
M = [0, 0]
y = { through = [0, 0], angle = "90 deg" }
[[link]]
number = 1
points = { M = [0, 0], K = ["100 mm", 0] }
[[link]]
number = 2
points = { E = ["0 mm", 0], K = ["400 mm", 0], D = ["0.1 m", 0] }
mass = "3 kg"
centre = "D"
[[link]]
number = 3
points = { E = [0, 0] }
slides = { on = "frame", along = "y", side = "above" }
mass = "2 kg"
centre = "E"
[drive]
link = 1
speed = "600 rpm"
positions = 8
zero = "90 deg"
[indicator]
point = "E"
bore = "120 mm"
clearance = 0.08
cover_strokes = [
  { stroke = "out", to = 0.3, p = "8 bar", n = 0 },
  { stroke = "out", to = 1.0, p = "8 bar", n = 1 },
  { stroke = "back", to = 0.0, p = "1.2 bar", n = 0 },
]
[engine]
point = "E"
[hand]
ruler = "exact"
[[sheet]]
format = "A1"
place = ["engine"]
"""
