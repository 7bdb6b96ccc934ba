"""Scenes of a part that no scene of the package has."""

from __future__ import annotations

from pathlib import Path

from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read
from support.boards import in_usual_size, parts
from support.scenes import written

HEAD = 'title = "T"\nlanguage = "ru"\n[[sheet]]\nplace = ["{kind}"]\n[{kind}]\n'
PARTS = {
    "an offset roller": (
        "cam",
        'stroke = "20 mm"\nrise = 90\nfall = 100\nupper_dwell = 30\noffset = "8 mm"\n',
    ),
    "a rocker": (
        "cam",
        'stroke = "20 deg"\nrise = 110\nfall = 80\nlaw = "3-4-5"\nfollower = "rocker"\nlever = "80 mm"\n'
        'centres = "110 mm"\n',
    ),
    "a flat face": (
        "cam",
        'stroke = "15 mm"\nrise = 120\nfall = 120\nlaw = "cosine"\nfollower = "flat"\n'
        'least_curvature = "8 mm"\n',
    ),
    "a flat face on a lever": (
        "cam",
        'stroke = "15 deg"\nrise = 120\nfall = 100\nlaw = "cosine"\nfollower = "flat rocker"\n'
        'centres = "90 mm"\nface = "10 mm"\nleast_curvature = "4 mm"\n',
    ),
    "a law by its diagram": (
        "cam",
        'stroke = "20 mm"\nrise = 90\nfall = 90\nlaw = "diagram"\n'
        "law_points = [[0, 1], [0.5, 1], [0.5, -1], [1, -1]]\n",
    ),
    "a pair of gears": (
        "gears",
        'z1 = 14\nz2 = 31\nm = "6 mm"\nx1 = 0.4\nx2 = -0.1\nstations = ["20 mm"]\n',
    ),
    "a train": (
        "planetary",
        'module = "4 mm"\nspeed = "100 1/s"\nratio = 4.6\nsatellites = [3, 4]\n',
    ),
}


EVERYDAY = ("a rocker", "a train")
"""Of these a test of one part is an everyday one."""
KEPT: dict[str, Drawn] = {}
"""What was drawn of them; it is shared: change nothing of it."""


def part_of(folder: Path, what: str) -> Drawn:
    """Write the scene of a part of PARTS into a folder; return the part, drawn once."""
    kind, text = PARTS[what]
    path = written(folder, HEAD.format(kind=kind) + text)
    if what not in KEPT:
        (KEPT[what],) = parts(in_usual_size(read(path)))
    return KEPT[what]
