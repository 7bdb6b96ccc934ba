"""The indicator diagram and the energy–mass curve in ink: what the log drew, from where to where."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.flywheel.energy_mass import VIEW as ENERGY_MASS
from graphic_tmm.chapters.flywheel.energy_mass import EnergyMass
from graphic_tmm.paper.axes import ASIDE, DOT, NUMBER, OVER, SIZE, Spots, axes, finished, largest
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, circle, line
from graphic_tmm.paper.symbols.dimensions import dimension


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
    ink = Spots(construction, reading, len(names))
    points = ink.all(made.points)
    right, low, high = largest(points.real), -largest(-points.imag), largest(points.imag)
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
    strokes += axes(0.0, right, min(low, 0.0), max(high, 0.0))
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
    return finished(ENERGY_MASS, title, strokes, wanted, lettered, cell, figures)
