"""The sketch of a flywheel: section along the axis and view from its end, with key, stud holes, dimensions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import shapely

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.flywheel.task import FLYWHEEL, SKETCH
from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import millimetres, small
from graphic_tmm.paper.drawing import Drawing, Stroke, arc, circle, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.symbols.dimensions import Dimension, dimension, shelf
from graphic_tmm.paper.symbols.kinematic import hatched

KEYS = (
    (0.012, 4, 1.8), (0.017, 5, 2.3), (0.022, 6, 2.8), (0.030, 8, 3.3), (0.038, 10, 3.3), (0.044, 12, 3.3),
    (0.050, 14, 3.8), (0.058, 16, 4.3), (0.065, 18, 4.4), (0.075, 20, 4.9), (0.085, 22, 5.4),
    (0.095, 25, 5.4), (0.110, 28, 6.4), (0.130, 32, 7.4), (0.150, 36, 8.4), (0.170, 40, 9.4),
    (0.200, 45, 10.4), (0.230, 50, 11.4), (0.260, 56, 12.4), (0.290, 63, 12.4), (0.330, 70, 14.4),
    (0.380, 80, 15.4), (0.440, 90, 17.4), (0.500, 100, 19.5),
)  # fmt: skip
"""Keys of ГОСТ 23360: largest shaft (m), width of the key, depth of the groove in the hub (mm)."""
HUB = 1.8
"""Diameter of the hub, of that of the shaft."""
WEB = 0.25
"""Thickness of the web, of the width of the rim."""
WIDEST = 50.0
"""Width of a rim at the most, of its diameter: beyond it there is nothing to draw."""
OVERRUN = 4.0
"""How far a centre line goes on behind an outline, mm."""
GAP = 30.0
"""Between the section and the view, mm."""


class Sizes(NamedTuple):
    """A flywheel, m: diameters of the rim outside and inside, its width, the shaft, the stud holes."""

    outer: float
    inner: float
    width: float
    shaft: float
    studs: int = 3
    stud: float = 0.016


def draw_flywheel(
    sizes: Sizes, reduction: float, title: str, language: str, marks: Sequence[Mark] = ()
) -> Drawing:
    """Return the sketch at 1 : ``reduction``; ``marks``: of the log, which its sizes were read from.

    Raises
    ------
    SheetError
        If the hub and the stud holes find no room inside the rim, or that is no rim but a roll.
    """
    hub = HUB * sizes.shaft
    if not hub + 2.2 * sizes.stud < sizes.inner < sizes.outer:
        raise SheetError(
            said(
                "flywheel: a hub of {hub:.0f} mm and stud holes of {stud:.0f} mm find no room "
                "inside a rim of {inner:.0f} mm: take a smaller shaft, or a larger rim",
                hub=1000 * hub,
                stud=1000 * sizes.stud,
                inner=1000 * sizes.inner,
            )
        )
    if sizes.width > WIDEST * sizes.outer:
        raise SheetError(
            said(
                "flywheel: a rim of {outer:.4g} mm would be {width:.4g} mm wide: take a larger D_e",
                outer=1000 * sizes.outer,
                width=1000 * sizes.width,
            )
        )
    draft = _Sketch(sizes, 1000.0 / reduction)
    dimensions = draft.dimensions(language)
    strokes = [
        *body([*draft.section(), *draft.view()], "rim", marks),
        *body([s for made in dimensions for s in made.strokes], "dimension", marks),
    ]
    of = tuple(mark.slot for mark in marks)
    labels = tuple(made.label._replace(of=of) for made in dimensions)
    return Drawing(FLYWHEEL, title, tuple(strokes), labels, role=SKETCH)


class _Sketch:
    """The lengths of the sketch, mm of the sheet: radii, the width, the groove of the key."""

    def __init__(self, sizes: Sizes, scale: float) -> None:
        self.sizes = sizes
        self.outer, self.inner = sizes.outer / 2 * scale, sizes.inner / 2 * scale
        self.shaft, self.hub = sizes.shaft / 2 * scale, HUB * sizes.shaft / 2 * scale
        self.width, self.web = sizes.width * scale, WEB * sizes.width * scale
        self.stud, self.ring = sizes.stud / 2 * scale, (self.hub + self.inner) / 2
        key = next((k for k in KEYS if sizes.shaft <= k[0]), KEYS[-1])
        self.key, self.groove = key[1] / 2000 * scale, key[2] / 1000 * scale
        self.centre = complex(self.width + GAP + self.outer, 0.0)

    def section(self) -> list[Stroke]:
        """The section: both halves hatched, the key's groove above the bore, a stud hole in the web."""
        half = (self.width - self.web) / 2
        strokes: list[Stroke] = []
        open_: shapely.Geometry = shapely.Polygon()
        for sign in (1, -1):
            profile = [
                (0.0, self.shaft), (self.width, self.shaft), (self.width, self.hub),
                (self.width - half, self.hub), (self.width - half, self.inner), (self.width, self.inner),
                (self.width, self.outer), (0.0, self.outer), (0.0, self.inner), (half, self.inner),
                (half, self.hub), (0.0, self.hub),
            ]  # fmt: skip
            area = shapely.Polygon([(x, sign * r) for x, r in profile])
            strokes.append(line("main", *(complex(x, sign * r) for x, r in profile), closed=True))
            if sign > 0:
                top = self.shaft + self.groove
                hole = shapely.box(
                    half, self.ring - self.stud, self.width - half, self.ring + self.stud
                )
                open_ = shapely.union(shapely.box(0.0, self.shaft, self.width, top), hole)
                strokes.append(line("main", complex(0, top), complex(self.width, top)))
                for r in (self.ring - self.stud, self.ring + self.stud):
                    strokes.append(line("main", complex(half, r), complex(self.width - half, r)))
                strokes.append(
                    line(
                        "centre",
                        complex(half - OVERRUN, self.ring),
                        complex(self.width - half + OVERRUN, self.ring),
                    )
                )
            for part in shapely.get_parts(shapely.difference(area, open_)):
                strokes += hatched(part)
        for x in (0.0, self.width):
            strokes.append(line("main", complex(x, -self.shaft), complex(x, self.shaft)))
        strokes.append(line("centre", complex(-OVERRUN, 0), complex(self.width + OVERRUN, 0)))
        return strokes

    def view(self) -> list[Stroke]:
        """The view from the end: rim, hub, bore with its groove, stud holes on their circle."""
        c, reach = self.centre, self.outer + OVERRUN
        strokes = [circle("main", c, r) for r in (self.outer, self.inner, self.hub)]
        turn = math.degrees(math.asin(min(1.0, self.key / self.shaft)))
        strokes.append(arc("main", c, self.shaft, 90.0 + turn, 360.0 - 2 * turn))
        foot, top = math.sqrt(max(0.0, self.shaft**2 - self.key**2)), self.shaft + self.groove
        strokes.append(
            line(
                "main",
                c + complex(-self.key, foot),
                c + complex(-self.key, top),
                c + complex(self.key, top),
                c + complex(self.key, foot),
            )
        )
        strokes += [line("centre", c - reach * way, c + reach * way) for way in (1, 1j)]
        strokes.append(circle("centre", c, self.ring))
        for spot in self.holes():
            strokes.append(circle("main", spot, self.stud))
            way = (spot - c) / abs(spot - c)
            reach = self.stud + 2.0
            strokes.append(line("thin", spot - reach * way, spot + reach * way))
        return strokes

    def holes(self) -> list[complex]:
        """The middles of the stud holes, evenly on their circle, the first to the lower left."""
        count = self.sizes.studs
        turns = [math.radians(210.0 + 360.0 * k / count) for k in range(count)]
        return [self.centre + self.ring * complex(math.cos(t), math.sin(t)) for t in turns]

    def dimensions(self, language: str) -> list[Dimension]:
        """The dimensions of the flywheel, in mm or in."""

        def mm(metres: float) -> str:
            size, of = small(1000.0 * metres / millimetres(1.0, language), language)
            return number(round(size, 1 if of == "mm" else 2), language)

        sizes = self.sizes
        left = [(self.inner, sizes.inner, 10.0), (self.outer, sizes.outer, 19.0)]
        found = [
            dimension(complex(0, -r), complex(0, r), out, f"⌀{mm(real)}") for r, real, out in left
        ]
        right = complex(self.width, 0)
        found.append(
            dimension(right - 1j * self.shaft, right + 1j * self.shaft, -9.0, f"⌀{mm(sizes.shaft)}")
        )
        low = complex(0, -self.outer)
        found.append(dimension(low, low + self.width, -10.0, mm(sizes.width)))
        _ = speaking(language)
        holes = _("holes")
        bend = self.centre + complex(self.outer * 0.85, -self.outer * 0.95)
        spot = min(self.holes(), key=lambda hole: abs(hole - bend))
        text = f"{sizes.studs} {holes} ⌀{mm(sizes.stud)}"
        way = (spot - bend) / abs(spot - bend)
        found.append(shelf(spot - self.stud * way, bend, text))
        return found
