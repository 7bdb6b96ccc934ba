"""What is asked of a gear pair: two spur wheels cut by one rack (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Kind, Names, Section, key
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tasks import SectionKey

GEARS = "gears"


def _stations(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise ValueError(stands(value, said('a list of lengths is wanted, ["23.5 mm"]')))
    found = tuple(1000.0 * quantities.parse(item, "length") for item in value)
    for item, station in zip(value, found, strict=True):
        if not POSITIVE.holds(station):
            raise ValueError(
                fault_in_list(item, said("a station lies beyond N1: write it positive"))
            )
    return found


_TEETH = v.number(Bound(5, 2000, whole=True))
"""With fewer teeth no flank is left between the root and the tip that could drive."""
_SHIFT = v.number(Bound(-5, 5))
_STATIONS = Kind(_stations, {"type": "array"}, POSITIVE, "length")


@dataclass(frozen=True)
class GearTask:
    """A pair of external spur gears with shift.

    Its module is ``m`` (m), the shift coefficients are ``x1``, ``x2``. Wheel 1 drives. ``alpha`` (degrees),
    ``ha`` and ``c`` are those of the basic rack. ``delta_y``: the equalising shift if a table gives it, else it
    follows exactly. ``steps``: by how many steps a flank is rolled. ``least_tip``: the least thickness at the
    tip, in modules; no scene sets it. ``stations``: further distances from N1 along the drawn line of action,
    mm, at which the specific sliding is found. ``mu`` (m/mm) and ``mu_sliding`` (1/mm): scales if the task
    fixes them, else standard ones are chosen. ``axes``: the centre distance on the sheet, mm, from which μ_l
    follows instead.
    """

    z1: int = key(_TEETH, "teeth of the driving wheel", 15)
    z2: int = key(_TEETH, "teeth of the driven wheel", 25)
    m: float = key(v.POSITIVE_LENGTH, "the module", "8 mm")
    x1: float = key(_SHIFT, "shift coefficient of wheel 1", 0.83, 0.0)
    x2: float = key(_SHIFT, "shift coefficient of wheel 2", 0.445, 0.0)
    delta_y: float | None = key(
        _SHIFT, "equalising shift, if a table gives it", 0.19, None, symbol="Δy"
    )
    alpha: float = key(v.RACK, "pressure angle of the rack", "20 deg", 20.0, symbol="α")
    ha: float = key(v.ADDENDUM, "addendum coefficient", 1, 1.0, symbol="h_a^*")
    c: float = key(v.CLEARANCE, "clearance coefficient", 0.25, 0.25, symbol="c^*")
    steps: int = key(v.number(Bound(4, 60, whole=True)), "steps by which a flank is rolled", 12, 12)
    least_tip: float = 0.2
    stations: tuple[float, ...] = key(
        _STATIONS, "distances from N1 where the sliding is wanted", ["23.5 mm"], ()
    )
    mu: float | None = key(v.MU_L, 'm/mm, or "5:1"', "5:1", None, written="mu_l", fixes="size")
    axes: float | None = key(
        v.DRAWN,
        "or the centre distance as drawn, from which μ_l follows",
        "400 mm",
        None,
        written="a_w",
        fixes="size",
    )
    mu_sliding: float | None = key(
        v.number(Bound(1e-6, 1e3)), "specific sliding that 1 mm stands for", 0.05, None,
        written="mu_theta",
    )  # fmt: skip


ASKED: SectionKey[GearTask] = SectionKey("gears")


SECTIONS = (
    Section(
        "gears", GearTask, "a pair of gears", alone=True, metric=True,
        begin='z1 = 15, z2 = 25, m = "8 mm"',
        refuse="graphic_tmm.chapters.gears.refusals:refuse_order",
    ),
)  # fmt: skip
