"""Scenes that something else than a crank drives all round: rods, sliders, racks, levers that turn in part."""

from __future__ import annotations

import graphic_tmm as tmm
from graphic_tmm.scene.records import Scene

BOOM = """
title = "Boom"
language = "en"
[frame]
O = [0, 0]
G = [0.4, 0]
[[link]]
number = 1
points = { O = [0, 0], N = [0.5, 0], C = [1.0, 0] }
[[link]]
number = 2
points = { G = [0, 0] }
side = "left of OG"
guides = { z = { through = [0, 0], angle = "0 deg" } }
[[link]]
number = 3
points = { N = [0, 0] }
slides = { on = 2, along = "z", side = "+" }
[drive]
link = 3
speed = "0.05 m/s"
acceleration = "0.3 m/s^2"
from = "600 mm"
to = "850 mm"
positions = 6
accelerations = "all"
"""
"""A rod that runs out of its cylinder lifts a boom."""
SLIDER = """
title = "Slider drives"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
side = "left of BO"
[[link]]
number = 3
points = { O = [0, 0], A = [0.1, 0] }
[drive]
link = 1
speed = "0.5 m/s"
from = "250 mm"
to = "350 mm"
positions = 6
accelerations = "all"
"""
"""A piston that turns a crank."""
LEVER = """
title = "Lever"
language = "en"
[frame]
O = [0, 0]
C = [0.4, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.35, 0] }
side = "left of AC"
[[link]]
number = 3
points = { B = [0.3, 0], C = [0, 0] }
[drive]
link = 1
speed = "2 rad/s"
from = "20 deg"
to = "75 deg"
positions = 6
accelerations = "all"
"""
"""A crank that turns through a part of a turn."""
RACK = LEVER.replace(
    'speed = "2 rad/s"\nfrom = "20 deg"\nto = "75 deg"',
    'speed = "0.2 m/s"\nrack = "40 mm"\nfrom = "10 mm"\nto = "120 mm"',
)
"""A rack that turns a crank."""
LOADS = """
[forces]
positions = "all"
[[load]]
link = {link}
point = "{point}"
force = "500 N"
direction = "-90 deg"
"""


def rated(text: str) -> str:
    """Return a scene whose drive has another speed and acceleration in each of its six positions."""
    head, drive = text.split("[drive]")
    unit = "rad/s" if "rad/s" in drive else "m/s"
    kept = [line for line in drive.splitlines() if not line.startswith(("speed", "acceleration ="))]
    speeds = [f"{0.1 * (k + 1):g} {unit}" for k in range(6)]
    gains = [f"{0.2 * (k - 2):g} {unit}^2" for k in range(6)]
    listed = f"speed = {speeds}\nacceleration = {gains}".replace("'", '"')
    return "\n".join((f"{head}[drive]", listed, *kept, ""))


def scene(text: str, link: int = 0, point: str = "") -> Scene:
    """Return a scene; with a load downwards on a point of a link, if one is named."""
    return tmm.read(text + (LOADS.format(link=link, point=point) if link else ""))
