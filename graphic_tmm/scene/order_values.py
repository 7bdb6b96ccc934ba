"""The kinds of values of the sections of diagrams, indicator diagram and flywheel."""

from __future__ import annotations

from typing import Annotated

from graphic_tmm import bounds
from graphic_tmm.scene import quantities
from graphic_tmm.scene.quantities import kind_of
from graphic_tmm.scene.values import SCALE, Rule, bounded, choice, mu, number


def _pressures(value: object) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        raise ValueError(
            f'{kind_of(value)} stands here; write the pressure in each position, ["300 kPa", "240 kPa"]'
        )
    return tuple(quantities.parse(item, "pressure") for item in value)


def _traced(value: object) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(
            f'{kind_of(value)} stands here; write points of the stroke, [[0, "300 kPa"], [1, "60 kPa"]]'
        )
    found = []
    for item in value:
        if not isinstance(item, list) or len(item) != 2:
            raise ValueError(
                f'{kind_of(item)} in the list; a point is a share of the stroke and a pressure, [0.4, "2 bar"]'
            )
        found.append((within(item[0]), quantities.parse(item[1], "pressure")))
    return tuple(found)


def within(value: object) -> float:
    """Return a share of the stroke, 0 … 1; ValueError if it is none."""
    found = quantities.parse(value, "ratio") if isinstance(value, str) else value
    if not bounds.WITHIN.holds(found):
        raise ValueError(f"{kind_of(value)} stands here; a share of the stroke is between 0 and 1")
    return float(found)  # type: ignore[arg-type]


MuTime = Annotated[float, mu("scale of times")]
MuAngle = Annotated[float, mu("scale of angles")]
MuVelocity = Annotated[float, mu("scale of velocities")]
MuPressure = Annotated[float, mu("scale of pressures")]
MuMoment = Annotated[float, mu("scale of moments")]
Pressures = Annotated[
    tuple[float, ...],
    Rule(
        lambda value, names: _pressures(value),
        {"type": "array", "items": {"anyOf": [{"type": "number"}, {"type": "string"}]}},
    ),
]
Pressure = Annotated[float, Rule(lambda value, names: quantities.parse(value, "pressure"), SCALE)]
Traced = Annotated[
    tuple[tuple[float, float], ...],
    Rule(
        lambda value, names: _traced(value),
        {"type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2}, "minItems": 2},
    ),
]
Within = Annotated[float, Rule(lambda value, names: within(value), bounded(bounds.WITHIN, "ratio"))]
Exponent = Annotated[float, number(bounds.EXPONENT)]
"""n of p·V^n = const; 0 for a constant pressure."""
Way = Annotated[str, choice("out", "back", туда="out", обратно="back")]
Irregularity = Annotated[float, number(bounds.DELTA, "ratio")]
RimRatio = Annotated[float, number(bounds.RIM_RATIO, "ratio")]
Constant = Annotated[
    str, choice("resisting", "driving", сопротивления="resisting", движущий="driving")
]
Integration = Annotated[
    str,
    choice("areas", "middles", "chords", площади="areas", середины="middles", хорды="chords"),
]
Tangents = Annotated[
    str, choice("curve", "points", "none", кривая="curve", точки="points", нет="none")
]
Material = Annotated[str, choice("steel", "cast iron", сталь="steel", чугун="cast iron")]
Studs = Annotated[int, number(bounds.STUDS)]
Start = Annotated[
    str,
    choice("displacement", "velocity", перемещение="displacement", скорость="velocity"),
]
Over = Annotated[str, choice("time", "angle", время="time", угол="angle")]
Method = Annotated[str, choice("chords", "tangents", хорды="chords", касательные="tangents")]
