"""Diagrams of the loads that vary over a travel or a swing, over the turn, or by positions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard
from graphic_tmm.chapters.forces.given_loads import between, index_of, numbered
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import LOADS as PLACE
from graphic_tmm.chapters.forces.task import TURN, Load, turns_of
from graphic_tmm.chapters.forces.travel import Traveller
from graphic_tmm.chapters.forces.words import LOAD
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import base_figures, tick_figures
from graphic_tmm.paper.drawing import Drawing, Ink, Stand, Stroke, Wanted, circle, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.formats import Heights, heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.paper.views import captioned, mu_text
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene


def letters(loads: tuple[Load, ...]) -> list[str]:
    """Return the letters of loads as they stand in the log: F_5; of a second one on its link F_{5(2)}."""
    return [letter for letter, _ in with_opposites(loads)]


def with_opposites(loads: tuple[Load, ...]) -> list[tuple[str, str]]:
    """Return the letters of loads, each with that of its opposite, "" where it has none."""
    count, found = Counter[str](), []
    for load in loads:
        symbol, pair = "M" if load.point is None else "F", [index_of(load)]
        if load.opposite is not None:
            pair.append(between(load.link, load.opposite))
        count.update(symbol + index for index in pair)
        told = [numbered(symbol, index, count[symbol + index]) for index in pair]
        found.append((told[0], "".join(told[1:])))
    return found


def braced(letter: str, more: str = "") -> str:
    """Return a letter with its index in braces, and something behind it: F_5 -> F_{5max}."""
    stem, _, index = letter.partition("_")
    return f"{stem}_{{{index.strip('{}')}{more}}}"


def varies(load: Load) -> bool:
    """Whether the size of a load is another at other positions."""
    told = load.by_angle or load.by_time or isinstance(load.size, tuple)
    return load.travel is not None or bool(told)


def sizes_of(load: Load) -> tuple[float, ...]:
    """Return the sizes that are given of a load, N or N·m."""
    if load.travel is not None:
        return tuple(size for _, size in (*load.travel.out, *load.travel.back)) or (0.0,)
    if points := load.by_time or load.by_angle:
        return tuple(size for _, size in points)
    return load.size if isinstance(load.size, tuple) else (load.size,)


ACROSS, UP = 70.0, 40.0
"""Room for the base and for the largest size, mm."""
VIEW = "load"
"""What the diagram of a load is called by code, before its letter."""


class Pictured(NamedTuple):
    """A load that varies: its place in the scene, its letter, its size on the board.

    ``reach``: of the base (m of travel, degrees of the turn, s, positions); ``largest``: size, N or N·m.
    ``base``, ``unit``: of what a mm of the base and of the height stands for; that of positions has no unit.
    """

    place: int
    letter: str
    load: Load
    size: Mark
    reach: float
    largest: float
    base: str
    unit: str

    @property
    def view(self) -> str:
        """What code calls the diagram."""
        return f"{VIEW} {self.letter}"

    @property
    def scales(self) -> tuple[str, str]:
        """The letters of the scale factors of the base and of the height; "" of one without: travel has μ_l."""
        along = {"°/mm": "μ_φ", "s/mm": "μ_t"}
        return along.get(self.base, ""), f"μ_{self.letter[0]}"


def pictured(drawn: Drawn) -> Iterator[Pictured]:
    """Yield the loads that are given by a travel, the turn, the time or the position, in order."""
    made = FORCES_PLAN.on(drawn)
    loads = made.order.loads
    for k, (letter, load, size) in enumerate(
        zip(letters(loads), loads, made.loads.given, strict=True)
    ):
        largest = max(map(abs, sizes_of(load)), default=0.0)
        if varies(load) and largest > 0.0:
            reach, base = _reach(drawn, load, size)
            unit = "N·m/mm" if load.point is None else "N/mm"
            yield Pictured(k, braced(letter), load, size, reach, largest, base, unit)


def on_plan(scene: Scene, load: Load) -> bool:
    """Tell whether a load stands on the plan of positions: by the travel of a slider, on a sheet of both."""
    by_slider = load.travel is not None and load.travel.slides
    return by_slider and any({PLACE, POSITIONS} <= set(sheet.place) for sheet in scene.sheets)


def called(one: Pictured, language: str) -> str:
    """Return the letter of a load in a language."""
    return symbol(one.letter, language)


def _reach(drawn: Drawn, load: Load, size: Mark) -> tuple[float, str]:
    """Return how far the base of a diagram reaches, and the unit of its scale factor."""
    if load.travel is not None:
        of = travelled(drawn, size)
        stroke = abs(drawn.value(of.stroke))
        return (stroke, "°/mm") if of.course.link else (stroke * mu_l(drawn), "m/mm")
    if load.by_time:
        return load.by_time[-1][0], "s/mm"
    if load.by_angle:
        return TURN * turns_of(load.by_angle), "°/mm"
    return float(len(sizes_of(load)) - 1 or 1), ""


def travelled(drawn: Drawn, size: Mark) -> Traveller:
    """Return what the size of a load goes by."""
    return FORCES_PLAN.on(drawn).loads.travels[size]


def mu_l(drawn: Drawn) -> float:
    """Return the scale factor of lengths, m a mm."""
    return float(drawn.reading[KINEMATICS_PLAN.on(drawn).mu_l][0, 0])


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
    """A diagram: its lines, the positions on them, what its axes are called, and how long both are (SI).

    ``begin``: where the base begins.
    """

    parts: tuple[Part, ...]
    positions: tuple[At, ...]
    axes: tuple[str, str]
    reach: float
    largest: float
    begin: float = 0.0


def draw_load(
    shown: Diagram, name: str, title: str, mu: tuple[float, float], language: str, high: Heights
) -> Drawing:
    """Return the diagram of a load; ``mu``: what a mm of its base and of its height stand for."""
    points = [point for part in shown.parts for point in part.points]
    lowest = min(0.0, *(size for _, size in points)) / mu[1]
    top = max(0.0, *(size for _, size in points)) / mu[1]
    begin = shown.begin
    base = (shown.reach - begin) / mu[0]
    strokes: list[Ink] = [*added(_axes(base, lowest, top), "axis")]
    wanted = [
        Wanted(shown.axes[1], complex(0.0, top + OVER), high.point, 1.5, 1 + 0j),
        Wanted(shown.axes[0], complex(base + OVER, 0.0), high.point, 1.5, -1j),
    ]
    for part in shown.parts:
        spots = [complex((x - begin) / mu[0], y / mu[1]) for x, y in part.points]
        strokes += added([line(part.pen, *spots)], "given")
    feet: list[tuple[float, str]] = []
    for x in divisions([x for x, _ in points], shown.reach):
        foot = (x - begin) / mu[0]
        strokes += added([line("thin", foot - TICK * 1j, foot + TICK * 1j)], "axis")
        feet += [(foot, number(x, language, 3))] if x else []
    ticks: list[tuple[float, str]] = []
    for y in divisions([0.0, *(y for _, y in points)], shown.largest):
        at = 1j * y / mu[1]
        far = (max((x for x, size in points if size == y), default=begin) - begin) / mu[0]
        strokes += added([line("thin", at - TICK, at + far)] if y else [], "axis")
        ticks.append((at.imag, number(y, language, 4)))
    numbers = (
        *tick_figures(ticks, high.number),
        *base_figures(feet, strokes, high.number),
    )
    for one in shown.positions:
        spot = complex((one.along - begin) / mu[0], one.size / mu[1])
        dot = circle("main", spot, DOT, filled=True)
        strokes.append(dot._replace(of=(one.of,), position=one.place))
        wanted.append(Wanted(one.name, spot, high.number, DOT, 1 + 1j, (one.of,), one.place))
    return Drawing(name, title, tuple(strokes), numbers, wanted=tuple(wanted))


def _axes(base: float, lowest: float, top: float) -> Iterator[Stroke]:
    """The two axes with their arrows."""
    for start, end in ((0j, complex(base + OVER)), (1j * lowest, 1j * (top + OVER))):
        yield line("thin", start, end)
        yield from arrowhead(end, end - start, pen="thin")


def divisions(values: Sequence[float], whole: float) -> list[float]:
    """Return the values that are there, each once, in order."""
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > SAME * whole:
            found.append(value)
    return found


def load_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagram of each load that is given by a travel, the turn, the time or the position."""
    if FORCES_PLAN.of(drawn) is None:
        return []
    language, high = drawn.scene.language, heights(drawn.scene, PLACE)
    views = list[Drawing]()
    for one in pictured(drawn):
        if on_plan(drawn.scene, one.load):
            continue
        letter = called(one, language)
        title = speaking(language)(LOAD, letter=letter)
        along, up = (choices(drawn).scale(one.view, mu) if mu else None for mu in one.scales)
        assert up is not None
        by = along.value if along is not None else standard(one.reach, ACROSS)
        if one.base == "m/mm":
            by, along = mu_l(drawn), drawn.scales[POSITIONS]
        shown = diagram_of(drawn, one, letter)
        view = draw_load(shown, f"load-{one.place + 1}", title, (by, up.value), language, high)
        told = ", ".join(mu_text(scale, language) for scale in (along, up) if scale is not None)
        view = finished(view._replace(stand=Stand(kind="table")), lettered)
        views.append(captioned(view, title, told, heights=high))
    return views


def diagram_of(drawn: Drawn, one: Pictured, letter: str) -> Diagram:
    """Return the diagram of a load as given, and where positions stand on it."""
    language, load = drawn.scene.language, one.load
    up = f"{letter}, {unit(one.unit.removesuffix('/mm'), language)}"
    there = [k for k in range(drawn.scene.row.count) if k not in drawn.undrawn]
    if load.travel is not None:
        parts = tuple(_strokes(load, one.reach))
        of, swings = travelled(drawn, one.size), one.base == "°/mm"
        ways = drawn.reading[of.way][0] * (1.0 if swings else mu_l(drawn))
        positions = tuple(_positions(drawn, one.size, ways, there))
        axes = f"ψ_{of.course.link}, °" if swings else f"S, {unit('m', language)}", up
        return Diagram(parts, positions, axes, one.reach, one.largest)
    if load.by_time:
        plans, line = KINEMATICS_PLAN.on(drawn), Part("main", load.by_time)
        times = plans.pairs[0].time(1.0) * plans.steps if plans.steps is not None else np.nan
        positions = tuple(_positions(drawn, one.size, times, there))
        axes = f"t, {unit('s', language)}", up
        return Diagram((line,), positions, axes, one.reach, one.largest)
    if load.by_angle:
        line = Part("main", load.by_angle)
        return Diagram((line,), (), ("φ, °", up), one.reach, one.largest)
    sizes = sizes_of(load)
    line = Part("main", tuple((float(k), size) for k, size in enumerate(sizes)))
    at = tuple(
        At(drawn.names[k], float(k), sizes[k], k, one.size.slot) for k in there if k < len(sizes)
    )
    axes = captions(language)["position"], up
    return Diagram((line,), at, axes, one.reach, one.largest)


def _strokes(load: Load, reach: float) -> Iterator[Part]:
    """The stroke from the zero position in a main line, the stroke back dashed where both act."""
    assert load.travel is not None
    for pen, points in (("main", load.travel.out), ("main", load.travel.back)):
        if points:
            pen = "dashed" if points is load.travel.back and load.travel.out else pen
            yield Part(pen, tuple((share * reach, size) for share, size in points))


def _positions(drawn: Drawn, size: Mark, along: ArrayLike, there: list[int]) -> Iterator[At]:
    """The positions at which the load acts, as far along the base as they are."""
    told = drawn.reading[size][0], along
    sizes, ways = (np.broadcast_to(one, len(drawn.names)) for one in told)
    for k in there:
        if np.isfinite(sizes[k] * ways[k]) and sizes[k]:
            yield At(drawn.names[k], float(ways[k]), float(sizes[k]), k, size.slot)
