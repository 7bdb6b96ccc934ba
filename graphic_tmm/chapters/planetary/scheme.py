"""The scheme of a planetary train for its task: the signs of its wheels, in proportions of no teeth."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.chapters.planetary.ink_numbers import BESIDE
from graphic_tmm.chapters.planetary.ink_scheme import Scheme2KH, Side, draw_scheme, spots
from graphic_tmm.chapters.planetary.reach import ARM, ROW, SHAFT
from graphic_tmm.chapters.planetary.task import ASKED, SCHEMES, PlanetaryTask, Scheme
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Wanted
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.finish import finished
from graphic_tmm.paper.lettering.heights import HEIGHTS
from graphic_tmm.paper.packing import bounds
from graphic_tmm.readers.task_sheet import Scheme as Shown
from graphic_tmm.scene.records import Scene

RADII: Mapping[str, tuple[float, ...]] = {
    "ring": (13.0, 9.0),
    "external-internal": (10.0, 13.0, 8.0),
    "external-external": (10.0, 15.0, 11.0),
    "internal-internal": (33.0, 14.0, 9.0),
}
"""Radii of the wheels of a scheme but for the fixed one, mm: signs, all the same whatever the teeth."""
BEHIND = (7.0, 11.0)
"""Radii of the pair behind the train, mm."""
SMALLEST = 0.7
"""It is drawn no smaller than this."""
TITLE = said("Scheme of the planetary train", context="task")


def scheme(scene: Scene, room: complex) -> Shown | None:
    """Return the train along its axis, not to scale, as wide as its signs; None if there is none."""
    order = ASKED.of(scene)
    if order is None:
        return None
    view = _drawing(order, 1.0)
    _, low, _, top = bounds(view)
    if top - low > room.imag:
        view = _drawing(order, max(room.imag / (top - low), SMALLEST))
    return Shown(view._replace(title=speaking(scene.language)(TITLE)), 0.0)


def _drawing(order: PlanetaryTask, share: float) -> Drawing:
    made = _placed(order, share)
    strokes = tuple(
        stroke
        for name, some in draw_scheme(made)
        for stroke in added(some, "carrier" if name == "H" else "wheel")
    )
    size = HEIGHTS["A4"].point
    wanted = [Wanted(name, at, size, BESIDE, toward) for name, (at, toward) in spots(made).items()]
    return finished(Drawing("scheme", "", strokes, wanted=tuple(wanted)))


def _placed(order: PlanetaryTask, share: float) -> Scheme2KH:
    """Return where everything stands, mm; ``share``: of the usual radii."""
    kind: Scheme = SCHEMES[order.scheme]
    radii = [share * radius for radius in RADII[kind.name]]
    axis, last = radii[0] + kind.first * radii[1], ROW * (kind.rows - 1)
    fixed = axis - kind.second * radii[-1]
    wheels = {"1": _central(0.0, radii[0]), "2": _satellite(0.0, axis, kind.first, radii[1])}
    if kind.rows == 2:
        wheels["3"] = _satellite(last, axis, kind.second, radii[2])
    wheels[kind.wheels[-1]] = _central(last, fixed)
    arm = last + (-ROW / 2.0 if kind.second > 0 else ARM)
    pair = dict[str, Side]()
    if order.behind:
        station = max(last, arm) + SHAFT if order.driving == "1" else -SHAFT
        number = len(kind.wheels) + 1
        small, large = (share * radius for radius in BEHIND)
        at = complex(station)
        contact, below = at - 1j * small, at - 1j * (small + large)
        pair[str(number)] = Side(contact, at + 1j * small, at)
        pair[str(number + 1)] = Side(contact, below - 1j * large, below)
    return Scheme2KH(kind, wheels, (complex(arm, axis), complex(arm)), pair, order.driving)


def _central(x: float, radius: float) -> Side:
    return Side(complex(x, radius), complex(x, -radius), complex(x))


def _satellite(x: float, axis: float, sense: int, radius: float) -> Side:
    """Return a rim of the satellites; ``sense``: +1 where it meshes below its axis."""
    by = sense * radius
    return Side(complex(x, axis - by), complex(x, axis + by), complex(x, axis))
