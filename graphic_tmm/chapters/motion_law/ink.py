"""The energy–mass diagram with its true origin in ink: points and their numbers, the curve, the rays."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.instruments import join, lay_off
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.motion_law.plan import MotionLaw
from graphic_tmm.chapters.motion_law.task import MASS
from graphic_tmm.paper.drawing import Drawing, Wanted
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.graph_rules import DOT, OVER, axis, ruled
from graphic_tmm.paper.mark_rules import dotted, leaving
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.shapes import flat


def draw_rays(on: Subject, law: MotionLaw, names: Sequence[str], axes: tuple[str, str]) -> Drawing:
    """Return the diagram; ``axes``: what ordinates and base are called."""
    seen = on.seen((MASS,), range(len(names)))
    spots = [0j, *(seen.point(law.points.row, k) for k in seen.positions)]
    spots.append(seen.point(law.points.end, 0))
    curves = bezier(seen.reading[law.curve])
    spots += [complex(z) for run in curves for z in flat([complex(z) for z in run])]
    spots = [spot for spot in spots if finite(spot)]
    high, low = max(z.imag for z in spots), min(z.imag for z in spots)
    right = max(z.real for z in spots)
    traces = figure(seen, _manner(law, (high, low, right)))
    large, small = on.heights.point, on.heights.number
    wanted = [
        Wanted(axes[0], complex(0, high + OVER), large, 1.5, -1 + 0j),
        Wanted(axes[1], complex(right + OVER, 0), large, 1.5, -1j),
    ]
    places = [(law.points.row, k, name) for k, name in enumerate(names)]
    for mark, k, name in [*places, (law.points.end, 0, f"{names[0]} ({len(names)})")]:
        spot = seen.point(mark, k)
        if finite(spot):
            toward = spot / abs(spot) if abs(spot) else 1j
            wanted.append(Wanted(name, spot, small, 0.8, toward, (mark.slot,), k))
    return traces.drawing(on, [*traces.staying], wanted)


def _manner(law: MotionLaw, extent: tuple[float, float, float]) -> Manner:
    """Return how the diagram is inked: what carried its points over is rubbed out, rays stay."""
    high, low, right = extent
    own = law.inertia
    marks = {
        own.along: leaving(*axis(0j, complex(right + OVER, 0))),
        own.up: leaving(*axis(1j * low, 1j * (high + OVER))),
    }
    kept = {law.points.row, law.points.end, law.rays.row, law.rays.end}

    def stays(seen: Seen, step: Step) -> bool:
        return step.it in marks or step.it in kept or (step.op is not lay_off and usual(seen, step))

    by_line: dict[str, Rule] = {join.name: ruled}
    return Manner({**by_line, lay_off.name: dotted(DOT)}, stays, marks)
