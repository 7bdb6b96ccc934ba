"""The section of a scene file that asks for a cam."""

from __future__ import annotations

import math
from typing import Annotated

from graphic_tmm.bounds import CAM
from graphic_tmm.chapters.cam.task import LAWS
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.quantities import kind_of
from graphic_tmm.scene.table import Table, key
from graphic_tmm.scene.values import SCALE, Names, Rule, choice, number


def _stroke(value: object, names: Names) -> tuple[float, str]:
    """Return a stroke in m, or in rad for a rocking follower, and which of the two it is."""
    if isinstance(value, str):
        try:
            return math.radians(quantities.parse(value, "angle")), "rad"
        except ValueError:
            pass
    return quantities.parse(value, "length"), "m"


def _points(value: object, names: Names) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(
            f"{kind_of(value)} stands here; write points of the acceleration, [[0, 0], [0.25, 1], ...]"
        )
    found = []
    for item in value:
        plain = isinstance(item, list) and len(item) == 2
        if not plain or not all(
            isinstance(x, (int, float)) and not isinstance(x, bool) for x in item
        ):
            raise ValueError(
                f"{kind_of(item)} in the list; a point is a share of the phase and a number, [0.25, 1]"
            )
        found.append((float(item[0]), float(item[1])))
    return tuple(found)


Stroke = Annotated[tuple[float, str], Rule(_stroke, SCALE)]
LawName = Annotated[str, choice(*LAWS)]
FollowerName = Annotated[str, choice("roller", "rocker", "flat")]
Sense = Annotated[str, choice("against", "along")]
Points = Annotated[tuple[tuple[float, float], ...], Rule(_points, {"type": "array"})]
Share = Annotated[float, number(CAM["share_of_r0"])]
Parts = Annotated[int, number(CAM["parts"])]
Moving = Annotated[float, number(CAM["rise"], "angle")]
Dwell = Annotated[float, number(CAM["upper_dwell"], "angle")]
Pressure = Annotated[float, number(CAM["pressure"], "angle")]


class CamTable(Table):
    """A disc cam: the law of motion, the follower, limits, sizes of the drawing."""

    stroke: Stroke = key("the stroke of the follower; an angle for a rocker", "28 mm")
    rise: Moving = key("the angle of the rise", "100 deg")
    upper_dwell: Dwell = key("the angle of the upper dwell", "20 deg", 0.0)
    fall: Moving = key("the angle of the return", "90 deg")
    lower_dwell: Dwell | None = key(
        "the angle of the lower dwell; the rest of the turn", "150 deg", None
    )
    law: LawName = key("the law of motion of the rise", "sine", "sine")
    law_points: Points | None = key(
        "points of the acceleration diagram of the rise, for the law diagram",
        [[0, 0], [0.25, 1]],
        None,
    )
    return_law: LawName | None = key("the law of the return, if it is another", "3-4-5", None)
    return_points: Points | None = key(
        "points of the acceleration diagram of the return", [[0, 0], [0.25, 1]], None
    )
    follower: FollowerName = key("what follows the cam", "roller", "roller")
    offset: v.Length = key("offset of the roller's guide", "10 mm", 0.0)
    lever: v.PositiveLength | None = key("length of the rocker's lever", "80 mm", None)
    centres: v.PositiveLength | None = key(
        "distance of the rocker's pivot and the cam's", "100 mm", None
    )
    sense: Sense = key(
        "on the rise the lever turns against the cam, or along", "against", "against"
    )
    least_curvature: v.Length = key("least radius of curvature under a flat face", "5 mm", 0.0)
    turns: v.Turns = key("which way the cam turns", "counterclockwise", v.COUNTERCLOCKWISE)
    pressure: Pressure | None = key("largest pressure angle allowed", "30 deg", None)
    transmission: Pressure | None = key("or the least transmission angle", "60 deg", None)
    pressure_return: Pressure | None = key("largest pressure angle of the return", "45 deg", None)
    r0: v.PositiveLength | None = key("the least radius chosen", "52.1 mm", None)
    roller: v.PositiveLength | None = key("the radius of the roller", "16.8 mm", None)
    share_of_r0: Share = key("how much of r0 the roller may be", 0.4, 0.4)
    share_of_curvature: Share = key("how much of the least curvature radius", 0.7, 0.7)
    parts: Parts = key("parts into which a moving phase is divided", 12, 12)
    base: v.Drawn = key("length of the diagrams' base for a turn", "240 mm", 240.0)
    height: v.Drawn = key("drawn stroke", "50 mm", 50.0)
    mu_l: v.MuL | None = key('m/mm of centre and profile, or "1:1"', "0.00056 m/mm", None)
