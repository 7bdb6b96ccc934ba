"""The energy–mass curve in ink: its points and numbers, its tangents with their angles, the segment ab."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import shapely

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.flywheel.energy import EnergyMass
from graphic_tmm.chapters.flywheel.task import ENERGY_MASS
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.graph import ASIDE
from graphic_tmm.paper.graph_rules import DOT, OVER, axis, dot, ruled
from graphic_tmm.paper.mark_rules import dotted, leaving
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.shapes import flat
from graphic_tmm.paper.symbols.dimensions import angular, dimension

ON = 10.0
"""How far a tangent goes on behind the point in which it touches, mm."""
ARC = 26.0
"""The radius of the arc of an angle, mm; chosen by eye."""
OUT = 4.0
"""So far from the curve it is tried on which side of it a number has more room, mm."""


def draw_energy_mass_ink(
    on: Subject,
    made: EnergyMass,
    names: Sequence[str],
    figures: tuple[str, str, str],
    axes: tuple[str, str] = ("ΔT", "J_{red}"),
) -> Drawing:
    """Return the energy–mass curve, its two tangents and the segment ab.

    ``figures``: of the segment and of the tangents' angles; ``axes``: what ordinates and base are called.
    """
    seen = on.seen((ENERGY_MASS,), range(len(names)))
    high, low, right = _extent(seen, made)
    traces = figure(seen, _manner(seen, made, (high, low, right)))
    strokes, labels = [*traces.staying], []
    small, large = on.heights.number, on.heights.point
    wanted = [
        Wanted(axes[0], complex(0, high + OVER), large, 1.5, -1 + 0j),
        Wanted(axes[1], complex(right + OVER, 0), large, 1.5, -1j),
    ]
    ends = [seen.point(mark, 0) for mark in made.ends]
    if finite(*ends):
        ab = dimension(ends[1], ends[0], ASIDE, figures[0], small)
        strokes += body(ab.strokes, "dimension", [made.segment])
        labels.append(ab.label._replace(of=(made.segment.slot,)))
    for mark, angle, end, text in zip(made.ends, made.angles, ends, figures[1:], strict=True):
        if finite(end):
            wanted.append(Wanted(mark.name, end, large, 1.0, -1 + 0j, (mark.slot,)))
            turn = seen.number(angle, 0)
            strokes += body(angular(end, 0.0, turn, ARC), "dimension", [angle, mark])
            middle = cmath.rect(1.0, math.radians(turn / 2))
            spot = end + ARC * middle
            wanted.append(Wanted(text, spot, small, 0.8, middle, (angle.slot, mark.slot)))
    wanted += _numbers(seen, made, names, small)
    return traces.drawing(on, strokes, wanted, labels)


def _extent(seen: Seen, made: EnergyMass) -> tuple[float, float, float]:
    """Return how high, how low and how far right curve and tangents reach, mm, the origin included."""
    spots = [0j, *(seen.point(made.points, k) for k in seen.positions)]
    spots += [
        complex(z)
        for run in bezier(seen.reading[made.curve])
        for z in flat([complex(z) for z in run])
    ]
    for tangent, end in zip(made.tangents, made.ends, strict=True):
        spots += _reach(seen, tangent, end)
    spots = [spot for spot in spots if finite(spot)]
    heights = [spot.imag for spot in spots]
    return max(heights), min(heights), max(spot.real for spot in spots)


def _reach(seen: Seen, tangent: Mark, end: Mark) -> tuple[complex, ...]:
    """Return the ends of a tangent, on the axis and behind the point in which it touches; none if not there."""
    spot, foot = seen.line(tangent, 0)[0], seen.point(end, 0)
    if not finite(spot, foot) or spot == foot:
        return ()
    return foot, spot + ON * (spot - foot) / abs(spot - foot)


def _manner(seen: Seen, made: EnergyMass, extent: tuple[float, float, float]) -> Manner:
    """Return how the curve is inked: what carried its points over is rubbed out."""
    high, low, right = extent
    along, up = (seen.by_mark[made.chart.ordinates[0]].uses[2], seen.by_mark[made.segment].uses[2])
    marks = {
        along: leaving(*axis(0j, complex(right + OVER, 0))),
        up: leaving(*axis(1j * low, 1j * (high + OVER))),
    }
    for tangent, end in zip(made.tangents, made.ends, strict=True):
        marks[tangent] = leaving(*_tangent(seen, tangent, end))

    def stays(seen: Seen, step: Step) -> bool:
        lasting = step.it in marks or step.it == made.points
        return lasting or (step.op is not lay_off and usual(seen, step))

    by_line: dict[str, Rule] = {s.op.name: ruled for s in seen.steps if s.it.kind is Line}
    return Manner({**by_line, lay_off.name: dotted(DOT)}, stays, marks)


def _tangent(seen: Seen, tangent: Mark, end: Mark) -> Iterator[Ink]:
    """A tangent, from the axis on behind the point in which it touches."""
    ends = _reach(seen, tangent, end)
    if ends:
        yield line("main", *ends)
        yield from dot(seen.line(tangent, 0)[0])


def _numbers(seen: Seen, made: EnergyMass, names: Sequence[str], size: float) -> Iterator[Wanted]:
    """The numbers of the positions, outwards of the loop: square to the curve, where there is more room."""
    curve = seen.reading[made.curve]
    flats = [flat([complex(z) for z in run]) for run in bezier(curve)]
    ink = shapely.union_all([shapely.LineString([(z.real, z.imag) for z in run]) for run in flats])
    ways = curve.tangents[0]
    for k, name in enumerate(names):
        spot, way = seen.point(made.points, k), complex(ways[k])
        if finite(spot):
            out = 1j * way / abs(way) if finite(way) and way else 1j
            sides = [OUT * out, -OUT * out]
            room = [ink.distance(shapely.Point((spot + s).real, (spot + s).imag)) for s in sides]
            toward = sides[0] if room[0] >= room[1] - 1e-6 else sides[1]
            yield Wanted(name, spot, size, 0.8, toward, (made.points.slot,), k)
