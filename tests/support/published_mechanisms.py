"""Mechanisms of published problems of centres, curvature, hodographs: lengths in m, the crank turns about O.

Source, unless a test says more: Мещерский И. В., Задачи по теоретической механике, sections 12, 16 and 18. The
book itself was not at hand: data, answers and numbers are as a public collection of its solved problems gives
them. Where that collection says that a printed answer differs from its own figure, the test has both.
"""

from __future__ import annotations

import math
from typing import Any

Scene = dict[str, Any]


def _scene(frame: Scene, links: list[Scene], drive: Scene, **more: Any) -> Scene:
    told = {"link": 1, "turns": "counterclockwise", **drive}
    if "from" not in told:
        told = {"zero": "0 deg", "positions": 12, **told}
    return {"title": "T", "language": "en", "frame": frame, "link": links, "drive": told, **more}


def crank(length: float) -> Scene:
    """Link 1, a crank OA."""
    return {"number": 1, "points": {"O": [0, 0], "A": [length, 0]}}


def slider_crank(
    r: float, rod: float, speed: str, through: float = 0.0, angle: float = 0.0, **more: Any
) -> Scene:
    """A crank OA, a rod AB with its middle M, a slider B.

    Its guide, at ``angle``°, passes O at the distance ``through`` on its left.
    """
    turn = math.radians(angle)
    past = [-through * math.sin(turn), through * math.cos(turn)]
    slide = {"on": "frame", "along": "x", "side": "+"}
    links = [
        crank(r),
        {"number": 2, "points": {"A": [0, 0], "B": [rod, 0], "M": [rod / 2, 0]}},
        {"number": 3, "points": {"B": [0, 0]}, "slides": slide},
    ]
    drive = {"speed": speed, **more.pop("drive", {})}
    frame = {"O": [0, 0], "x": {"through": past, "angle": f"{angle!r} deg"}}
    return _scene(frame, links, drive, **more)


def four_bar(
    lengths: tuple[float, float, float], pivot: complex, speed: str, side: str, **more: Any
) -> Scene:
    """A crank OA, a coupler AB, a rocker DB, by their lengths; D stands at ``pivot``."""
    a, b, c = lengths
    links = [
        crank(a),
        {"number": 2, "points": {"A": [0, 0], "B": [b, 0]}},
        {"number": 3, "points": {"D": [0, 0], "B": [c, 0]}, "side": f"{side} of AD"},
    ]
    drive = {"speed": speed, **more.pop("drive", {})}
    return _scene({"O": [0, 0], "D": [pivot.real, pivot.imag]}, links, drive, **more)


def swinging_cylinder(**more: Any) -> Scene:
    """16.27, 18.20: OA 12 cm, a rod AB of 60 cm through a cylinder that swings about C, OC 60 cm; 5 1/s."""
    guides = {"z": {"through": [0, 0], "angle": "0 deg"}}
    links = [
        crank(0.12),
        {"number": 2, "points": {"A": [0, 0], "B": [0.6, 0]}, "guides": guides},
        {"number": 3, "points": {"C": [0, 0]}, "slides": {"on": 2, "along": "z", "side": "+"}},
    ]
    drive = {"speed": "5 rad/s", **more.pop("drive", {})}
    return _scene({"O": [0, 0], "C": [0.6, 0]}, links, drive, **more)


def cardioid(a: float, omega: float, **more: Any) -> Scene:
    """12.30 to 12.32: a crank of a/2, a rod AM = a that passes through a sleeve on the crank's circle.

    From the sleeve C the way to M is r = a·(1 + cos(ωt/2)), at the angle ωt/2: M goes along a cardioid.
    """
    guides = {"z": {"through": [0, 0], "angle": "0 deg"}}
    links = [
        crank(a / 2),
        {"number": 2, "points": {"A": [0, 0], "M": [a, 0]}, "guides": guides},
        {"number": 3, "points": {"C": [0, 0]}, "slides": {"on": 2, "along": "z", "side": "-"}},
    ]
    drive = {"speed": f"{omega!r} rad/s", "from": "-150 deg", "to": "150 deg", "positions": 11}
    drive |= more.pop("drive", {})
    return _scene({"O": [0, 0], "C": [-a / 2, 0]}, links, drive, **more)
