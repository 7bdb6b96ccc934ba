"""Loads by the travel of a slider on the plan of positions: beside its guide, each size under its place.

The base lies along the guide, as long as the stroke is drawn; sizes are laid off away from the mechanism.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.chapters.forces.load_diagrams import (
    DOT,
    OVER,
    TICK,
    Diagram,
    Pictured,
    called,
    diagram_of,
    divisions,
    mu_l,
    on_plan,
    pictured,
    travelled,
)
from graphic_tmm.chapters.forces.words import LOAD
from graphic_tmm.chapters.kinematics.along import AlongGuide
from graphic_tmm.chapters.kinematics.ink_numbers import together
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.formats import Heights, heights
from graphic_tmm.paper.shapes import outline
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.paper.views import mu_text

CLEAR, ROOM = 14.0, 8.0
"""From the plan's ink to a diagram, for the numbers between them; what letters about a point take, mm."""
UNDER = 15.0
"""A diagram goes under its guide unless it comes so much nearer to it above, mm."""
PIECE = 5.0
"""Lines are looked at every so many mm."""


class _Guide:
    """Where a slider goes on the plan: its zero place, the way along and out, the stroke, mm."""

    def __init__(self, drawn: Drawn, one: Pictured) -> None:
        of = travelled(drawn, one.size)
        self.start, end = (complex(drawn.reading[k][0, 0]) for k in (*of.start, *of.last))
        self.stroke = abs(end - self.start)
        self.along = (end - self.start) / self.stroke
        self.out, self.off = -1j * self.along, 0.0

    def set_off(self, view: Drawing, lowest: float) -> None:
        """Set the base off the ink of a plan; ``lowest``: how far sizes go back towards the guide, mm."""
        spots = [z for stroke in view.strokes for z in _spots(outline(stroke))]
        found = list[tuple[float, float, complex]]()
        for out in (-1j * self.along, 1j * self.along):
            reach = max([0.0, *self._over(spots, out, 0.0), *self._over(_at(view), out, ROOM)])
            found.append((reach + UNDER * (out.imag > 1e-9), reach, out))
        _, reach, self.out = min(found, key=lambda one: one[0])
        self.off = reach + CLEAR + lowest

    def _over(self, spots: list[complex], out: complex, more: float) -> Iterator[float]:
        """Yield how far places over the stroke lie to a side."""
        for z in spots:
            seen = (z - self.start) / self.along
            if -CLEAR <= seen.real <= self.stroke + CLEAR:
                yield ((z - self.start) / out).real + more

    def place(self, x: float, y: float) -> complex:
        """Return where a travel and a size stand, mm of the diagram."""
        return self.start + x * self.along + (self.off + y) * self.out


def _at(view: Drawing) -> list[complex]:
    return [one.at for one in view.wanted]


def _spots(corners: list[complex]) -> Iterator[complex]:
    """Yield the corners of a line and places between them."""
    yield from corners[:1]
    for a, b in pairwise(corners):
        count = max(1, math.ceil(abs(b - a) / PIECE))
        yield from (a + (b - a) * k / count for k in range(1, count + 1))


def loads_along_guides(drawn: Drawn, view: Drawing) -> Iterator[AlongGuide]:
    """Yield the diagrams of loads by travel, each clear of the plan and of those before it."""
    language, high = drawn.scene.language, heights(drawn.scene, POSITIONS)
    shown = [one for one in pictured(drawn) if on_plan(drawn.scene, one.load)]
    for one in shown:
        letter, guide = called(one, language), _Guide(drawn, one)
        scale = choices(drawn).scale(one.view, one.scales[1])
        if len(shown) > 1:
            scale = scale._replace(symbol=f"μ_{{{''.join(k for k in letter if k not in '_{}')}}}")
        diagram, mu = diagram_of(drawn, one, letter), (mu_l(drawn), scale.value)
        sizes = [size / mu[1] for part in diagram.parts for _, size in part.points]
        guide.set_off(view, -min(0.0, *sizes))
        strokes = tuple(added(_ink(guide, diagram, mu, sizes), "given"))
        wanted = tuple(_letters(guide, diagram, mu, sizes, language, high))
        title = speaking(language)(LOAD, letter=letter)
        view = view._replace(strokes=(*view.strokes, *strokes))
        yield AlongGuide(strokes, wanted, f"{title}: {mu_text(scale, language)}")


def _ink(
    guide: _Guide, shown: Diagram, mu: tuple[float, float], sizes: list[float]
) -> Iterator[Ink]:
    """Yield axes, lines from both ends of the stroke, ordinates of positions, the load itself."""
    at = guide.place
    low, high = min(0.0, *sizes), max(0.0, *sizes)
    for start, end in (
        (at(0.0, 0.0), at(guide.stroke + OVER, 0.0)),
        (at(0.0, low), at(0.0, high + OVER)),
    ):
        yield line("thin", start, end)
        yield from arrowhead(end, end - start, pen="thin")
    for x in (0.0, guide.stroke):
        yield line("thin", guide.start + x * guide.along, at(x, 0.0))
    for part in shown.parts:
        yield line(part.pen, *(at(x / mu[0], size / mu[1]) for x, size in part.points))
    for size, far in _levels(shown):
        yield line("thin", at(-TICK, size / mu[1]), at(far / mu[0], size / mu[1]))
    for one in shown.positions:
        spot = at(one.along / mu[0], one.size / mu[1])
        yield line("thin", at(one.along / mu[0], 0.0), spot)
        yield circle("main", spot, DOT, filled=True)


def _levels(shown: Diagram) -> Iterator[tuple[float, float]]:
    """Yield the sizes that are given, but for 0, each with the travel to which its level goes."""
    points = [point for part in shown.parts for point in part.points]
    for size in divisions([y for _, y in points], shown.largest):
        if size:
            yield size, max(x for x, y in points if y == size)


def _letters(
    guide: _Guide,
    shown: Diagram,
    mu: tuple[float, float],
    sizes: list[float],
    language: str,
    high: Heights,
) -> Iterator[Wanted]:
    """Yield what the axes are called, sizes and travels along them, the numbers of positions."""
    at, (along, up) = guide.place, shown.axes
    yield Wanted(up, at(0.0, max(0.0, *sizes) + OVER), high.point, 1.5, -guide.along)
    yield Wanted(along, at(guide.stroke + OVER, 0.0), high.point, 1.5, -guide.out)
    for size, _ in _levels(shown):
        told, spot = number(size, language, 4), at(0.0, size / mu[1])
        yield Wanted(told, spot, high.number, TICK, -guide.along)
    travels = [x for part in shown.parts for x, _ in part.points if x]
    feet = {number(x, language, 3): x for x in divisions(travels, shown.reach)}
    for told, x in feet.items():
        yield Wanted(told, at(x / mu[0], 0.0), high.number, 0.8, -guide.out)
    dots = [at(one.along / mu[0], one.size / mu[1]) for one in shown.positions]
    for group in together(dots, high.number):
        told = ", ".join(shown.positions[k].name for k in group)
        yield Wanted(told, dots[group[0]], high.number, DOT, guide.out + guide.along)
