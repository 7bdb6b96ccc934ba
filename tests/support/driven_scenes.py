"""Scenes of drives that a student would write: a rod in its cylinder, a slider, a crank."""

from __future__ import annotations

import graphic_tmm
from graphic_tmm.scene.records import Scene

BOOM = """title = "Boom"
language = "en"
[frame]
O = [0, 0]
G = [0.4, 0]
[[link]]
number = 1
points = {{ O = [0, 0], N = [0.5, 0], C = [1.0, 0] }}
side = "left of OG"
{loaded}[[link]]
number = 2
points = {{ G = [0, 0] }}
guides = {{ z = {{ through = [0, 0], angle = "0 deg" }} }}
[[link]]
number = 3
points = {{ N = [0, 0] }}
slides = {{ on = 2, along = "z", side = "+" }}
[drive]
link = 3
{drive}
"""
SLIDER = """title = "Slider drives"
language = "en"
[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = "0 deg" }}
[[link]]
number = 1
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.3, 0] }}
side = "left of OB"
[[link]]
number = 3
points = {{ O = [0, 0], A = [0.1, 0] }}
[drive]
link = 1
{drive}
"""
ROCKER = """title = "Crank and rocker"
language = "en"
[frame]
O = [0, 0]
C = [0.3, 0]
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.1, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.3, 0] }}
side = "left of AC"
[[link]]
number = 3
points = {{ C = [0, 0], B = [0.2, 0] }}
[drive]
link = 1
{drive}
"""
OUT = 'speed = "0.05 m/s"\nfrom = "600 mm"\nto = "850 mm"\npositions = 6\n'
"""The rod of the boom runs out."""
TORQUE = '[[load]]\nlink = 3\nmoment = "10 N*m"\n[forces]\npositions = [1]\n'
"""A moment on the rocker."""


def scene(text: str, drive: str, loaded: str = "") -> Scene:
    """Return a scene with what is driven, and keys of the boom."""
    return graphic_tmm.read(text.format(drive=drive, loaded=loaded))


NARROW = """title = "Narrow"
language = "en"
[frame]
A = [-3.74, -2.41]
G = [7.32, -3.51]
[[link]]
number = 1
points = { A = [0, 0], B = [3.47324, 0] }
[[link]]
number = 2
points = { B = [0, 0], C = [4.326708, 0], D = [2.120781, 3.355993] }
side = "left of BG"
[[link]]
number = 3
points = { G = [0, 0], C = [6.962126, 0], F = [3.206147, -6.119855] }
[[link]]
number = 4
points = { D = [0, 0], E = [5.476532, 0] }
side = "left of DF"
[[link]]
number = 5
points = { F = [0, 0], E = [3.633896, 0] }
[drive]
link = 1
speed = 1
"""
"""It can be assembled from 67.3 to 78.3 and from 270.4 to 281.4 degrees of its crank only."""
