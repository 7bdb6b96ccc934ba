"""The sections of a scene file that ask for wheels: a pair of gears, a planetary train."""

from __future__ import annotations

from typing import Annotated

from graphic_tmm.mechanism.trains import SCHEMES
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.quantities import kind_of
from graphic_tmm.scene.table import Table, key
from graphic_tmm.scene.values import SCALE, Names, Rule, choice, mu, whole

_NUMBERS = {"type": "array", "items": {"type": "integer"}}


def _number(least: float, most: float, what: str) -> Rule:
    def check(value: object, names: Names) -> float:
        plain = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not plain or not least <= float(value) <= most:  # type: ignore[arg-type]
            raise ValueError(
                f"{kind_of(value)} stands here; {what} is a number {least:g} to {most:g}"
            )
        return float(value)  # type: ignore[arg-type]

    return Rule(check, {"type": "number", "minimum": least, "maximum": most})


def _ratio(value: object, names: Names) -> float:
    plain = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not plain or value == 0 or abs(float(value)) > 1e4:  # type: ignore[arg-type]
        raise ValueError(
            f"{kind_of(value)} stands here; a ratio is a number, 4.55, negative if it reverses"
        )
    return float(value)  # type: ignore[arg-type]


def _tolerance(value: object, names: Names) -> float:
    number = quantities.parse(value, "ratio") if isinstance(value, str) else value
    if isinstance(number, bool) or not isinstance(number, (int, float)) or not 0 <= number <= 0.5:
        raise ValueError(f'{kind_of(value)} stands here; a tolerance is a share, "1 %"')
    return float(number)


def _teeth(value: object, names: Names) -> tuple[int | None, ...]:
    """Return tooth numbers; None for one that is to be found, written "?"."""

    def fine(z: object) -> bool:
        return z == "?" or (isinstance(z, int) and not isinstance(z, bool) and z > 0)

    if not isinstance(value, list) or not all(fine(z) for z in value):
        raise ValueError(
            f"{kind_of(value)} stands here; a list of tooth numbers is wanted, "
            '[25, "?", "?"], "?" for one to be found'
        )
    return tuple(None if z == "?" else z for z in value)


def _pair(value: object, names: Names) -> tuple[int, ...]:
    found = _teeth(value, names)
    if None in found:
        raise ValueError("tooth numbers of a pair that stands already are wanted, [15, 25]")
    return tuple(z for z in found if z is not None)


def _satellites(value: object, names: Names) -> tuple[int, ...]:
    listed = value if isinstance(value, list) else [value]
    if not listed or not all(
        isinstance(k, int) and not isinstance(k, bool) and 0 < k < 50 for k in listed
    ):
        raise ValueError(
            f"{kind_of(value)} stands here; write a number of satellites, 3, or [3, 4]"
        )
    return tuple(listed)


def _stations(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise ValueError(f'{kind_of(value)} stands here; a list of lengths is wanted, ["23.5 mm"]')
    return tuple(1000.0 * quantities.parse(item, "length") for item in value)


Teeth = Annotated[int, whole(1, 2000)]
Shift = Annotated[float, _number(-5.0, 5.0, "a shift coefficient")]
Coefficient = Annotated[float, _number(0.0, 5.0, "a coefficient")]
Steps = Annotated[int, whole(2, 500)]
Stations = Annotated[tuple[float, ...], Rule(_stations, {"type": "array"})]
MuSliding = Annotated[float, _number(1e-6, 1e3, "a scale, 1/mm,")]
Ratio = Annotated[float, Rule(_ratio, {"type": "number"})]
Tolerance = Annotated[float, Rule(_tolerance, SCALE)]
TeethList = Annotated[
    tuple[int | None, ...],
    Rule(_teeth, {"type": "array", "items": {"type": ["integer", "string"]}}),
]
PairTeeth = Annotated[tuple[int, ...], Rule(_pair, _NUMBERS)]
Satellites = Annotated[tuple[int, ...], Rule(_satellites, {"type": ["integer", "array"]})]
SchemeName = Annotated[str, choice(*SCHEMES)]
Driving = Annotated[str, choice("1", "H")]
MuVelocity = Annotated[float, mu("scale of velocities")]


class GearsTable(Table):
    """A pair of external spur gears with shift."""

    z1: Teeth = key("teeth of the driving wheel", 15)
    z2: Teeth = key("teeth of the driven wheel", 25)
    m: v.PositiveLength = key("the module", "8 mm")
    x1: Shift = key("shift coefficient of wheel 1", 0.83, 0.0)
    x2: Shift = key("shift coefficient of wheel 2", 0.445, 0.0)
    alpha: v.Angle = key("pressure angle of the rack", "20 deg", 20.0)
    ha: Coefficient = key("addendum coefficient", 1, 1.0)
    c: Coefficient = key("clearance coefficient", 0.25, 0.25)
    delta_y: Shift | None = key("equalising shift, if a table gives it", 0.19, None)
    steps: Steps = key("steps by which a flank is rolled", 12, 12)
    stations: Stations = key("distances from N1 where the sliding is wanted", ["23.5 mm"], ())
    mu_l: v.MuL | None = key('m/mm, or "5:1"', "5:1", None)
    mu_theta: MuSliding | None = key("specific sliding that 1 mm stands for", 0.05, None)


class PlanetaryTable(Table):
    """A planetary train 2K–H: tooth numbers wanted, or checked."""

    scheme: SchemeName = key("which wheels mesh", "ring", "ring")
    module: v.PositiveLength = key("the module", "8 mm")
    module_2: v.PositiveLength | None = key("the module of the second row", "6 mm", None)
    speed: v.Speed = key("angular velocity of the driving shaft", "2888 rpm")
    driving: Driving = key("which drives, wheel 1 or the carrier H", "1", "1")
    ratio: Ratio | None = key("wanted ratio, driving over driven", 4.55, None)
    tolerance: Tolerance = key("how far it may be off", "1 %", 0.01)
    teeth: TeethList = key('tooth numbers, "?" for one to be found', [25, "?", "?"], ())
    satellites: Satellites = key("number of satellites, or several to choose from", 3, (3,))
    alpha: v.Angle = key("pressure angle", "20 deg", 20.0)
    ha: Coefficient = key("addendum coefficient", 1, 1.0)
    c: Coefficient = key("clearance coefficient", 0.25, 0.25)
    least: Teeth = key("fewest teeth", 17, 17)
    most: Teeth = key("most teeth of a wheel", 150, 150)
    ring_most: Teeth = key("most teeth of a ring", 300, 300)
    behind: PairTeeth = key("teeth of the pair of gears behind the train", [15, 25], ())
    mu_l: v.MuL | None = key('m/mm, or "1:5"', "1:5", None)
    mu_v: MuVelocity | None = key("(m/s)/mm", "0.5 (m/s)/mm", None)
    pole: v.Drawn | None = key("pole distance of the plan of angular velocities", "40 mm", None)
