"""The sections of a scene file that ask for wheels: a pair of gears, a planetary train."""

from __future__ import annotations

from typing import Annotated

from graphic_tmm.bounds import GEARS, PLANETARY, Bound
from graphic_tmm.chapters.planetary.task import SCHEMES
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.quantities import kind_of
from graphic_tmm.scene.table import Table, key
from graphic_tmm.scene.values import Names, Rule, bounded, choice, mu, number

_NUMBERS = {"type": "array", "items": dict(PLANETARY["behind"].schema)}


def _ratio(value: object, names: Names) -> float:
    if not PLANETARY["ratio"].holds(value) or value == 0:
        raise ValueError(
            f"{kind_of(value)} stands here; a ratio is a number, 4.55, negative if it reverses"
        )
    return float(value)  # type: ignore[arg-type]


def _teeth(value: object, names: Names) -> tuple[int | None, ...]:
    """Return tooth numbers; None for one that is to be found, written "?"."""

    def fine(z: object) -> bool:
        return z == "?" or (isinstance(z, int) and PLANETARY["teeth"].holds(z))

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
    known = PLANETARY["satellites"]
    if not listed or not all(isinstance(k, int) and known.holds(k) for k in listed):
        raise ValueError(
            f"{kind_of(value)} stands here; write a number of satellites, 3, or [3, 4]"
        )
    return tuple(listed)


def _stations(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise ValueError(f'{kind_of(value)} stands here; a list of lengths is wanted, ["23.5 mm"]')
    found = tuple(1000.0 * quantities.parse(item, "length") for item in value)
    for item, station in zip(value, found, strict=True):
        if not GEARS["stations"].holds(station):
            raise ValueError(
                f"{kind_of(item)} in the list; a station lies beyond N1: write it positive"
            )
    return found


Teeth = Annotated[int, number(GEARS["z1"])]
Shift = Annotated[float, number(GEARS["x1"])]
Rack = Annotated[float, number(GEARS["alpha"], "angle")]
Addendum = Annotated[float, number(GEARS["ha"])]
Clearance = Annotated[float, number(GEARS["c"])]
Steps = Annotated[int, number(GEARS["steps"])]
Stations = Annotated[tuple[float, ...], Rule(_stations, {"type": "array"})]
MuSliding = Annotated[float, number(Bound(1e-6, 1e3))]
Ratio = Annotated[float, Rule(_ratio, bounded(PLANETARY["ratio"]))]
Tolerance = Annotated[float, number(PLANETARY["tolerance"], "ratio")]
Limit = Annotated[int, number(PLANETARY["least"])]
TeethList = Annotated[
    tuple[int | None, ...],
    Rule(
        _teeth,
        {
            "type": "array",
            "items": {"anyOf": [dict(PLANETARY["teeth"].schema), {"type": "string", "const": "?"}]},
        },
    ),
]
PairTeeth = Annotated[tuple[int, ...], Rule(_pair, _NUMBERS)]
Satellites = Annotated[
    tuple[int, ...],
    Rule(
        _satellites,
        {
            "anyOf": [
                dict(PLANETARY["satellites"].schema),
                {"type": "array", "items": dict(PLANETARY["satellites"].schema), "minItems": 1},
            ]
        },
    ),
]
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
    alpha: Rack = key("pressure angle of the rack", "20 deg", 20.0)
    ha: Addendum = key("addendum coefficient", 1, 1.0)
    c: Clearance = key("clearance coefficient", 0.25, 0.25)
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
    alpha: Rack = key("pressure angle", "20 deg", 20.0)
    ha: Addendum = key("addendum coefficient", 1, 1.0)
    c: Clearance = key("clearance coefficient", 0.25, 0.25)
    least: Limit = key("fewest teeth", 17, 17)
    most: Limit = key("most teeth of a wheel", 150, 150)
    ring_most: Limit = key("most teeth of a ring", 300, 300)
    behind: PairTeeth = key("teeth of the pair of gears behind the train", [15, 25], ())
    mu_l: v.MuL | None = key('m/mm, or "1:5"', "1:5", None)
    mu_v: MuVelocity | None = key("(m/s)/mm", "0.5 (m/s)/mm", None)
    pole: v.Drawn | None = key("pole distance of the plan of angular velocities", "40 mm", None)
