"""The indicator diagram and the energy–mass curve in ink: what the log drew, from where to where."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.curve import bezier
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.paper.dimensions import dimension
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, circle, line
from graphic_tmm.paper.placing import Wanted, interrupt, leaders, place
from graphic_tmm.paper.symbols import arrowhead
from graphic_tmm.plans.energy_mass import VIEW as ENERGY_MASS
from graphic_tmm.plans.energy_mass import EnergyMass
from graphic_tmm.plans.indicator import VIEW as INDICATOR
from graphic_tmm.plans.indicator import Indicator

OVER = 9.0
"""How far an axis goes on behind what stands on it, mm."""
DOT = 0.5
ASIDE = 14.0
"""From the axis of the ordinates to a dimension line, mm."""
ROOM = 8.0
SIZE, NUMBER = 5.0, 3.5


class _Sheet:
    """The numbers of the log while they are inked: the first ``row`` positions."""

    def __init__(self, construction: Construction, reading: Reading, row: int) -> None:
        self.construction, self.reading, self.row = construction, reading, row

    def all(self, mark: Mark) -> Complexes:
        return np.broadcast_to(self.reading[mark][0], (self.reading.positions,))[: self.row]

    def one(self, mark: Mark) -> complex:
        return complex(self.reading[mark][0, 0])

    def curve(self, mark: Mark) -> Iterator[Bezier]:
        for controls in bezier(self.reading[mark]):
            yield Bezier("main", tuple(complex(z) for z in controls), mark.name)

    def dots(self, mark: Mark) -> Iterator[Stroke]:
        for z in self.all(mark):
            if np.isfinite(z):
                yield circle("main", complex(z), DOT, filled=True)

    def lines(self, starts: Complexes, ends: Complexes) -> Iterator[Stroke]:
        for a, b in zip(starts, ends, strict=True):
            if np.isfinite(a) and np.isfinite(b) and abs(b - a) > 0.3:
                yield line("thin", complex(a), complex(b))


def _axes(left: float, right: float, low: float, high: float) -> list[Stroke]:
    tips = complex(right + OVER, 0), complex(0, high + OVER)
    return [
        line("thin", complex(left, 0), tips[0]),
        line("thin", complex(0, low), tips[1]),
        *arrowhead(tips[0], 1 + 0j, pen="thin"),
        *arrowhead(tips[1], 1j, pen="thin"),
    ]


def _finished(
    name: str,
    title: str,
    strokes: Sequence[Stroke | Bezier],
    wanted: Sequence[Wanted],
    lettered: bool,
    cell: tuple[float, float, float, float],
    figures: Sequence[Label] = (),
) -> Drawing:
    if not lettered:
        left, low, right, high = cell
        room = (left - ROOM, low - ROOM, right + OVER + ROOM, high + OVER + ROOM)
        return Drawing(name, title, tuple(strokes), cell=room)
    labels = place(wanted, strokes, figures)
    ink = interrupt([*strokes, *leaders(wanted, labels)], labels)
    return Drawing(name, title, ink, (*labels, *figures))


def _most(values: Reals) -> float:
    """Return the largest of the values that are there, at least 0."""
    return float(np.max(values, initial=0.0, where=np.isfinite(values)))


def draw_indicator_ink(
    construction: Construction,
    reading: Reading,
    made: Indicator,
    names: Sequence[str],
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the indicator diagram with the division of its base; ``names``: of the positions of the row."""
    ink = _Sheet(construction, reading, len(names))
    origin, end, feet = ink.one(made.origin), ink.one(made.end), ink.all(made.feet)
    auxiliary = next(s for s in construction.steps if s.it.view == INDICATOR and s.it.name == "q")
    spots = ink.all(auxiliary.it)
    strokes: list[Stroke | Bezier] = list(ink.lines(spots, feet))
    far = complex(spots[int(np.argmax(np.nan_to_num(np.abs(spots - origin))))])
    if np.isfinite(far) and far != origin:
        strokes.append(line("thin", origin, far + 4.0 * (far - origin) / abs(far - origin)))
    high = 0.0
    for side in made.sides:
        points = ink.all(side.points)
        high = max(high, _most(points.imag))
        strokes += ink.lines(feet, points)
    strokes += _axes(0.0, end.real, 0.0, high)
    for side in made.sides:
        strokes += ink.curve(side.curve)
        strokes += ink.dots(side.points)
    wanted = [
        Wanted("p", complex(0, high + OVER), SIZE, 1.5, -1 + 0j),
        Wanted("S", complex(end.real + OVER, 0), SIZE, 1.5, -1j),
    ]
    groups: list[tuple[complex, list[str]]] = []
    for name, foot in zip(names, feet, strict=True):
        if not np.isfinite(foot):
            continue
        near = next((texts for spot, texts in groups if abs(spot - foot) < 1.0), None)
        if near is None:
            groups.append((complex(foot), [name]))
        else:
            near.append(name)
    wanted += [Wanted(", ".join(texts), spot, NUMBER, 1.0, -1j) for spot, texts in groups]
    cell = (0.0, -_most(-spots.imag), end.real, high)
    return _finished(INDICATOR, title, strokes, wanted, lettered, cell)


def draw_energy_mass_ink(
    construction: Construction,
    reading: Reading,
    made: EnergyMass,
    names: Sequence[str],
    title: str,
    figure: str,
    *,
    along: str = "J_{red}",
    lettered: bool = True,
) -> Drawing:
    """Return the energy–mass curve, its two tangents and the segment ab.

    ``figure``: the length of the segment; ``along``: the letter of the base.
    """
    ink = _Sheet(construction, reading, len(names))
    points = ink.all(made.points)
    right, low, high = _most(points.real), -_most(-points.imag), _most(points.imag)
    strokes: list[Stroke | Bezier] = []
    wanted = [
        Wanted("ΔT", complex(0, high + OVER), SIZE, 1.5, -1 + 0j),
        Wanted(along, complex(right + OVER, 0), SIZE, 1.5, -1j),
    ]
    for tangent, mark in zip(made.tangents, made.ends, strict=True):
        spot, foot = complex(reading[tangent].at[0, 0]), ink.one(mark)
        if np.isfinite(spot) and np.isfinite(foot):
            way = (spot - foot) / abs(spot - foot)
            strokes.append(line("main", foot, spot + 10.0 * way))
            strokes.append(circle("main", spot, DOT, filled=True))
            wanted.append(Wanted(mark.name, foot, SIZE, 1.0, -1 + 0j))
            low, high = min(low, foot.imag), max(high, foot.imag)
    strokes += _axes(0.0, right, min(low, 0.0), max(high, 0.0))
    wanted[0] = wanted[0]._replace(at=complex(0, max(high, 0.0) + OVER))
    strokes += ink.curve(made.curve)
    strokes += ink.dots(made.points)
    ends = [ink.one(mark) for mark in made.ends]
    made_figures = [dimension(ends[1], ends[0], ASIDE, figure)] if np.isfinite(ends).all() else []
    strokes += [stroke for one in made_figures for stroke in one.strokes]
    there = points[np.isfinite(points)]
    middle = complex(there.mean()) if there.size else 0j
    for name, spot in zip(names, points, strict=True):
        if np.isfinite(spot):
            wanted.append(Wanted(name, complex(spot), NUMBER, 0.8, complex(spot) - middle))
    cell = (-ASIDE, min(low, 0.0), right, max(high, 0.0))
    figures = [one.label for one in made_figures]
    return _finished(ENERGY_MASS, title, strokes, wanted, lettered, cell, figures)
