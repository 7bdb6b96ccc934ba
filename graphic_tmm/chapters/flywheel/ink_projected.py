"""The energy–mass curve laid as by hand: level with ΔT, under J turned by 90°, its points carried over."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.chapters.flywheel.energy import EnergyMass
from graphic_tmm.chapters.flywheel.task import ENERGY_MASS, VIEWS
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.graph_rules import OVER, TICK, axis
from graphic_tmm.paper.labels import finished, interrupt
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.seen import Subject, finite

GAP = 12.0
"""Between the graphs and what stands beside them, and between the curve and J above it, mm."""


def draw_projected(
    on: Subject,
    made: EnergyMass,
    views: tuple[Drawing, Drawing],
    names: Sequence[str],
    length: float,
    axes: tuple[str, str],
    lettered: bool,
) -> Drawing:
    """Return the graphs with the curve and J beside them as one view.

    ``views``: the graphs, stacked, and the curve; ``length``: of the base, mm; ``axes``: what J and the base
    are called.
    """
    column, curve = views
    spots = [complex(z) for z in np.ravel(on.reading[made.points][0])[: len(names)]]
    feet = [length * k / len(names) for k in range(len(names))]
    zero = column.origin(VIEWS["energy"])
    at = complex(bounds(column)[2] + GAP - bounds(curve)[0], zero.imag)
    mass = finished(_turned(on, spots, feet, names, length, axes), lettered)
    top = at + 1j * (bounds(curve)[3] + GAP - bounds(mass)[1])
    lines = added(_carried(spots, feet, zero, at, top), "axis")
    parts = (column, curve.moved(at), mass.moved(top))
    labels = tuple(label for part in parts for label in part.labels)
    boxes = list(zip(*map(bounds, parts), strict=True))
    return column._replace(
        title="; ".join(part.title for part in (column, curve)),
        strokes=(
            *interrupt(list(lines), labels),
            *(stroke for part in parts for stroke in part.strokes),
        ),
        labels=labels,
        cell=(min(boxes[0]), min(boxes[1]), max(boxes[2]), max(boxes[3])),
        rubbed=(*column.rubbed, *parts[1].rubbed),
        shows=(*column.shows, *curve.shows),
        origins=(*column.origins, (ENERGY_MASS, curve.origin(ENERGY_MASS) + at)),
        apart=lambda within: [column, curve],
    )


def _turned(
    on: Subject,
    spots: Sequence[complex],
    feet: Sequence[float],
    names: Sequence[str],
    length: float,
    axes: tuple[str, str],
) -> Drawing:
    """Return J over the turn: J to the right, the turn downwards."""
    across = max([0.0, *(z.real for z in spots if finite(z))])
    points = [complex(z.real, -y) for z, y in zip(spots, feet, strict=True)]
    strokes: list[Ink] = [*axis(0j, complex(across + OVER)), *axis(0j, -1j * (length + OVER))]
    strokes += [line("thin", -TICK - 1j * y, TICK - 1j * y) for y in (*feet, length)]
    if all(map(finite, points)):
        strokes.append(_smooth([*points, points[0].real - 1j * length]))
    small, large = on.heights.number, on.heights.point
    wanted = [
        Wanted(axes[0], complex(across + OVER), large, 1.5, 1j),
        Wanted(axes[1], -1j * (length + OVER), large, 1.5, 1 + 0j),
        *(Wanted(name, -1j * y, small, TICK, -1 + 0j) for name, y in zip(names, feet, strict=True)),
    ]
    return Drawing("inertia", "", tuple(added(strokes, "axis")), wanted=tuple(wanted))


def _smooth(points: Sequence[complex]) -> Bezier:
    """Return a curve through points that closes over the turn: its tangents by the points on both sides."""
    z = np.array(points)
    turn = z[-1] - z[0]
    before, behind = np.r_[z[-2] - turn, z[:-1]], np.r_[z[1:], z[1] + turn]
    ways = (behind - before) / 6.0
    controls = [complex(z[0])]
    for k in range(len(z) - 1):
        controls += [
            complex(z[k] + ways[k]),
            complex(z[k + 1] - ways[k + 1]),
            complex(z[k + 1]),
        ]
    return Bezier("main", tuple(controls))


def _carried(
    spots: Sequence[complex], feet: Sequence[float], zero: complex, at: complex, top: complex
) -> Iterator[Ink]:
    """Yield the lines by which points come over: level from ΔT, upright from J."""
    for spot, foot in zip(spots, feet, strict=True):
        if finite(spot):
            yield line("thin", zero + complex(foot, spot.imag), at + spot)
            yield line("thin", top + complex(spot.real, -foot), at + spot)
