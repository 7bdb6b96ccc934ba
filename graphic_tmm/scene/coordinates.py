"""What a drive is given: speeds, accelerations and places of what turns or of what slides."""

from __future__ import annotations

from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene.declare import Kind, Names
from graphic_tmm.scene.misfits import stands
from graphic_tmm.scene.units import Dimension
from graphic_tmm.scene.values import ROW, not_negative, quantity_schema

OTHER_EXTREME = "other extreme"


class Metres(float):
    """A number of metres, m/s or m/s²: of what slides."""


class Bare(float):
    """A number without a unit: of what slides, or of what turns."""


def sliding(value: object, along: Dimension, turning: Dimension) -> float:
    """Read a quantity of what slides, where its unit says so, as `Metres`; else one of what turns."""
    if quantities.is_a(value, along):
        return Metres(quantities.parse(value, along))
    number = quantities.parse(value, turning)
    return number if isinstance(value, str) else Bare(number)


def _speed(value: object, names: Names) -> float:
    return not_negative(sliding(value, "speed", "angular speed"), value)


def _coordinates(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        raise ValueError(stands(value, said('a list of places is wanted, ["0 deg", "35 deg"]')))
    return tuple(sliding(item, "length", "angle") for item in value)


def _extra(value: object, names: Names) -> float | str:
    if value in (OTHER_EXTREME, "другое крайнее"):
        return OTHER_EXTREME
    return sliding(value, "length", "angle")


def _speeds(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        remedy = said('a list of speeds is wanted, one for each position, ["0 rpm", "60 rpm"]')
        raise ValueError(stands(value, remedy))
    return tuple(_speed(item, names) for item in value)


def _gains(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        remedy = said("a list of accelerations is wanted, one for each position")
        raise ValueError(stands(value, remedy))
    return tuple(sliding(item, "acceleration", "angular acceleration") for item in value)


SPEEDS, GAINS = Kind(_speeds, ROW), Kind(_gains, ROW)
SPEED = Kind(_speed, quantity_schema("angular speed"), unit="angular speed")
GAIN = Kind(
    lambda value, names: sliding(value, "acceleration", "angular acceleration"),
    quantity_schema("angular acceleration"),
    unit="angular acceleration",
)
COORDINATE = Kind(
    lambda value, names: sliding(value, "length", "angle"), quantity_schema("angle"), unit="angle"
)
COORDINATES = Kind(_coordinates, ROW)
EXTRA = Kind(_extra, quantity_schema("angle"), unit="angle")
