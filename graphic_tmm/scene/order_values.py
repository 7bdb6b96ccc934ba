"""The kinds of values of the sections of diagrams, indicator diagram and flywheel."""

from __future__ import annotations

from typing import Annotated

from graphic_tmm.scene import quantities
from graphic_tmm.scene.quantities import kind_of
from graphic_tmm.scene.values import SCALE, Rule, choice, mu, whole


def _pressures(value: object) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        raise ValueError(
            f'{kind_of(value)} stands here; write the pressure in each position, ["300 kPa", "240 kPa"]'
        )
    return tuple(quantities.parse(item, "pressure") for item in value)


def _share(value: object, most: float) -> float:
    number = quantities.parse(value, "ratio") if isinstance(value, str) else value
    if isinstance(number, bool) or not isinstance(number, (int, float)) or not 0 < number < most:
        raise ValueError(
            f"{kind_of(value)} stands here; a number greater than 0 and less than {most:g} is wanted"
        )
    return float(number)


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
Irregularity = Annotated[float, Rule(lambda value, names: _share(value, 2.0), SCALE)]
RimRatio = Annotated[float, Rule(lambda value, names: _share(value, 1.0), SCALE)]
Constant = Annotated[
    str, choice("resisting", "driving", сопротивления="resisting", движущий="driving")
]
Integration = Annotated[str, choice("middles", "chords", середины="middles", хорды="chords")]
Tangents = Annotated[
    str, choice("points", "curve", "none", точки="points", кривая="curve", нет="none")
]
Material = Annotated[str, choice("steel", "cast iron", сталь="steel", чугун="cast iron")]
Studs = Annotated[int, whole(1, 24)]
Start = Annotated[
    str,
    choice("displacement", "velocity", перемещение="displacement", скорость="velocity"),
]
Over = Annotated[str, choice("time", "angle", время="time", угол="angle")]
Method = Annotated[str, choice("chords", "tangents", хорды="chords", касательные="tangents")]
