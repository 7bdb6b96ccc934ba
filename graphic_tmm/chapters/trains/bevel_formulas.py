"""Formulas of trains of bevel wheels: by mean radii, those in the middle of the teeth."""

from __future__ import annotations

import math
from collections.abc import Mapping

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.trains.task import Scheme, Train
from graphic_tmm.language.said import said

_NO_WHEEL = "a wheel has no radius"
_BETWEEN = said(
    "B is where the line from A to C crosses the axis of the satellites: so far is it from the main axis."
)


@formula(why=_BETWEEN)
def mean_height(first: Number, last: Number) -> Number:
    """({first} + {last})/2"""


@formula(holds="{one} + {other} ≠ 0", fails=_NO_WHEEL, why=_BETWEEN)
def mean_height_of_two(first: Number, last: Number, one: Number, other: Number) -> Number:
    """({first}·{other} + {last}·{one})/({one} + {other})"""


@formula(
    holds="|{first} − {last}| < 2·{rim}",
    fails="no satellite touches both wheels",
    why=said(
        "The satellite touches both wheels at the ends of its mean diameter, which is square to its axis: so "
        "that axis leans toward the smaller wheel, and stands square to the main one between equal wheels."
    ),
)
def lean(first: Number, last: Number, rim: Number) -> Angle:
    """arccos(({first} − {last})/(2·{rim}))"""


@formula(
    holds="sin {lean} ≠ 0",
    fails="the axes are one",
    why=said("All cones have their tips where the axes cross; so far is B from there."),
)
def from_apex(height: Number, lean: Angle) -> Number:
    """{height}/sin {lean}"""


@formula(
    holds="{arm} ≠ 0",
    fails=_NO_WHEEL,
    why=said("The point goes round the main axis: its velocity over its distance from the axis."),
)
def rate_about_axis(velocity: Number, arm: Number) -> Number:
    """{velocity}/{arm}"""


def tip_cones(train: Train, second: float, ha: float) -> dict[str, tuple[float, float]]:
    """Return, by the rim, how far axes of neighbours are apart, and how wide its tip cone is, degrees.

    ``second``: module of the second row over that of the first. All cones have their tips in one point.
    """
    z = dict(zip(train.scheme.wheels, train.teeth, strict=True))
    first, last = train.scheme.meshes
    if train.scheme.rows == 1:
        leans = math.acos((z[first.wheel] - z[last.wheel]) / (2 * z[first.rim]))
        rims = {first.rim: (1.0, (z[first.wheel] + z[last.wheel]) / 2 / math.sin(leans))}
    else:
        leans = math.pi / 2
        rims = {first.rim: (1.0, float(z[first.wheel])), last.rim: (second, second * z[last.wheel])}
    between = 2 * math.asin(math.sin(leans) * math.sin(math.pi / train.satellites))
    found = {}
    for rim, (module, apex) in rims.items():
        radius = module * z[rim]
        half = math.atan2(radius, apex) + math.atan(2 * module * ha / math.hypot(radius, apex))
        found[rim] = (math.degrees(between), math.degrees(2 * half))
    return found


def draw_mean_radius(draft: Draft, scheme: Scheme, radii: Mapping[str, Mark]) -> Mark:
    """Calculate how far B of the satellites' axis is from the main axis, m."""
    first, last = scheme.meshes[0], scheme.meshes[-1]
    own = radii[first.wheel], radii[last.wheel]
    if scheme.rows == 1:
        return draft.draw(mean_height, "r_B", *own, unit="m")
    return draft.draw(mean_height_of_two, "r_B", *own, radii[first.rim], radii[last.rim], unit="m")
