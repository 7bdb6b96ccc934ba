"""The diagram of a load that varies, as the sheet of a task gives it: over a slider's travel, or the turn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.language.numbers import number
from graphic_tmm.paper.axes import base_figures, tick_figures
from graphic_tmm.paper.drawing import Drawing, Ink, Stroke, Wanted, circle, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 8.0
"""How far an axis goes on behind the diagram, mm."""
TICK = 1.2
"""Half a tick of a division, mm."""
DOT = 0.8
"""The radius of a point that stands for a position, mm."""
SAME = 1e-9
"""Two divisions nearer than this share of the whole are one."""


class Part(NamedTuple):
    """A line of the diagram: its pen, its points (abscissa, size), in SI or degrees."""

    pen: str
    points: tuple[tuple[float, float], ...]


class At(NamedTuple):
    """A position on the diagram: its number, its abscissa and size, its index, the slot of its size."""

    name: str
    along: float
    size: float
    place: int
    of: int


class Diagram(NamedTuple):
    """A diagram: its lines, the positions on them, what its axes are called, and how long both are (SI)."""

    parts: tuple[Part, ...]
    positions: tuple[At, ...]
    axes: tuple[str, str]
    reach: float
    largest: float


def draw_load(
    shown: Diagram, name: str, title: str, mu: tuple[float, float], language: str, high: Heights
) -> Drawing:
    """Return the diagram of a load; ``mu``: what a mm of its base and of its height stand for."""
    points = [point for part in shown.parts for point in part.points]
    lowest = min(0.0, *(size for _, size in points)) / mu[1]
    top = max(0.0, *(size for _, size in points)) / mu[1]
    base = shown.reach / mu[0]
    strokes: list[Ink] = [*added(_axes(base, lowest, top), "axis")]
    wanted = [
        Wanted(shown.axes[1], complex(0.0, top + OVER), high.point, 1.5, 1 + 0j),
        Wanted(shown.axes[0], complex(base + OVER, 0.0), high.point, 1.5, -1j),
    ]
    for part in shown.parts:
        spots = [complex(x / mu[0], y / mu[1]) for x, y in part.points]
        strokes += added([line(part.pen, *spots)], "given")
    feet: list[tuple[float, str]] = []
    for x in _divisions([x for x, _ in points], shown.reach):
        strokes += added([line("thin", x / mu[0] - TICK * 1j, x / mu[0] + TICK * 1j)], "axis")
        feet += [(x / mu[0], number(x, language, 3))] if x else []
    ticks: list[tuple[float, str]] = []
    for y in _divisions([0.0, *(y for _, y in points)], shown.largest):
        at = 1j * y / mu[1]
        far = max((x for x, size in points if size == y), default=0.0) / mu[0]
        strokes += added([line("thin", at - TICK, at + far)] if y else [], "axis")
        ticks.append((at.imag, number(y, language, 4)))
    numbers = (
        *tick_figures(ticks, high.number),
        *base_figures(feet, strokes, high.number),
    )
    for one in shown.positions:
        spot = complex(one.along / mu[0], one.size / mu[1])
        dot = circle("main", spot, DOT, filled=True)
        strokes.append(dot._replace(of=(one.of,), position=one.place))
        wanted.append(Wanted(one.name, spot, high.number, DOT, 1 + 1j, (one.of,), one.place))
    return Drawing(name, title, tuple(strokes), numbers, wanted=tuple(wanted))


def _axes(base: float, lowest: float, top: float) -> Iterator[Stroke]:
    """The two axes with their arrows."""
    for start, end in ((0j, complex(base + OVER)), (1j * lowest, 1j * (top + OVER))):
        yield line("thin", start, end)
        yield from arrowhead(end, end - start, pen="thin")


def _divisions(values: Sequence[float], whole: float) -> list[float]:
    """Return the values that are there, each once, in order."""
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > SAME * whole:
            found.append(value)
    return found
