"""What is asked of a gear pair: two wheels, spur or helical, one in a ring or on a rack (SI; drawn mm)."""

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


_COUNT, RING = Bound(5, 2000, whole=True), Bound(-2000, -6, whole=True)
"""With fewer teeth no flank is left between the root and the tip that could drive."""
RACK = "rack"
"""What stands for the teeth of wheel 2 where it drives a rack."""
_TEETH = v.number(_COUNT)


def _second(value: object, names: Names) -> int | str:
    if isinstance(value, str):
        if value == RACK:
            return RACK
        raise ValueError(stands(value, said('a whole number is wanted, or "rack"')))
    if RING.holds(value):
        return int(value)  # type: ignore[call-overload,no-any-return]
    return int(_TEETH.read(value, names))


_SECOND = Kind(
    _second,
    {"anyOf": [_COUNT.schema, RING.schema, {"type": "string", "const": RACK}]},
    _COUNT,
)
LARGEST_SHIFT = 5.0
"""Shifts that are given lie between minus and plus so much."""
_SHIFT = v.number(Bound(-LARGEST_SHIFT, LARGEST_SHIFT))
_SUM = v.number(Bound(-10, 10))
_HELIX = v.number(Bound(0, 60, below=True), "angle")


def _addenda(value: object, names: Names) -> float | tuple[float, float]:
    if not isinstance(value, list):
        return float(v.ADDENDUM.read(value, names))
    if len(value) != 2:
        raise ValueError(
            stands(value, said("a number is wanted, or a list of two, [1.1, 0.9]: of each wheel"))
        )
    one, other = (float(v.ADDENDUM.read(item, names)) for item in value)
    return one, other


_ONE = v.ADDENDUM.told if isinstance(v.ADDENDUM.told, dict) else {}
_ADDENDA = Kind(
    _addenda,
    {"anyOf": [_ONE, {"type": "array", "items": _ONE, "minItems": 2, "maxItems": 2}]},
    v.ADDENDUM.bound,
)
_STATIONS = Kind(_stations, {"type": "array"}, POSITIVE, "length")


@dataclass(frozen=True)
class GearTask:
    """A pair of gears with shift.

    Its module is ``m`` (m), the shift coefficients are ``x1``, ``x2``: 0 where they are left out, but what
    ``distance`` (that of the axes, m) or ``x_sum`` leaves. Wheel 1 drives. ``z2`` is negative for a ring about
    wheel 1; the sum of its shifts is x2 − x1. It is ``"rack"`` for a rack, which has no shift of its own:
    ``distance`` then is that of its datum line from the axis.
    ``alpha`` (degrees), ``ha`` and ``c`` are those of the basic
    rack; of two ``ha`` each is a wheel's own addendum, which its mate has room for; a ring with the shorter
    one leaves its wheel as it is. ``beta``: the helix angle
    (degrees); m, alpha, ha, c and the shifts then are those of the normal section. ``width``: of the rims (m).
    ``speed``: of wheel 1, rad/s. ``delta_y``: the equalising shift if a table gives it, else it
    follows exactly. ``steps``: by how many steps a flank is rolled. ``least_tip``: the least thickness at the
    tip, in modules; no scene sets it. ``stations``: further distances from N1 along the drawn line of action,
    mm, at which the specific sliding is found. ``mu`` (m/mm) and ``mu_sliding`` (1/mm): scales if the task
    fixes them, else standard ones are chosen. ``axes``: the centre distance on the sheet, mm, from which μ_l
    follows instead. ``chart``: the region of x1 and x2 in which a pair can mesh is drawn, with those that are
    taken.
    """

    z1: int = key(_TEETH, "teeth of the driving wheel", 15)
    z2: int | str = key(_SECOND, 'teeth of the driven wheel, of a ring with a minus, or "rack"', 25)
    m: float = key(v.POSITIVE_LENGTH, "the module", "8 mm")
    x1: float | None = key(_SHIFT, "shift coefficient of wheel 1", 0.83, None)
    x2: float | None = key(_SHIFT, "shift coefficient of wheel 2", 0.445, None)
    delta_y: float | None = key(
        _SHIFT, "equalising shift, if a table gives it", 0.19, None, symbol="Δy"
    )
    alpha: float = key(v.RACK, "pressure angle of the rack", "20 deg", 20.0, symbol="α")
    ha: float | tuple[float, float] = key(
        _ADDENDA, "addendum coefficient, or those of both wheels", 1, 1.0, symbol="h_a^*"
    )
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
    distance: float | None = key(
        v.POSITIVE_LENGTH, "the distance of the axes, if it fixes the shifts", "84 mm", None
    )
    x_sum: float | None = key(_SUM, "or x1 + x2, of a ring x2 − x1", 0.5, None, symbol="x_Σ")
    beta: float | None = key(_HELIX, "helix angle", "30 deg", None, symbol="β")
    width: float | None = key(v.POSITIVE_LENGTH, "width of the rims", "40 mm", None, symbol="b")
    speed: float | None = key(
        v.quantity("angular speed", POSITIVE), "speed of wheel 1", "100 rpm", None, symbol="ω_1"
    )
    chart: bool = key(v.SWITCH, "whether the shifts that the teeth may have are shown", True, False)

    @property
    def addenda(self) -> tuple[float, float]:
        """The addendum coefficients of both wheels."""
        return self.ha if isinstance(self.ha, tuple) else (self.ha, self.ha)

    @property
    def teeth(self) -> tuple[int, ...]:
        """How many teeth both wheels have; of a rack only those of wheel 1."""
        return (self.z1,) if isinstance(self.z2, str) else (self.z1, abs(self.z2))

    @property
    def internal(self) -> bool:
        """Whether wheel 2 is a ring about wheel 1."""
        return not isinstance(self.z2, str) and self.z2 < 0

    @property
    def racked(self) -> bool:
        """Whether wheel 1 drives a rack."""
        return self.z2 == RACK


ASKED: SectionKey[GearTask] = SectionKey("gears")


SECTIONS = (
    Section(
        "gears", GearTask, "a pair of gears", alone=True, metric=True,
        begin='z1 = 15, z2 = 25, m = "8 mm"',
        refuse="graphic_tmm.chapters.gears.refusals:refuse_order",
    ),
)  # fmt: skip
