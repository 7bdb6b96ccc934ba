"""What a sheet shows of loads that vary: their diagrams, with the positions on them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard
from graphic_tmm.chapters.forces.given import braced, letters, sizes_of, varies
from graphic_tmm.chapters.forces.ink_loads import ACROSS, UP, At, Diagram, Part, draw_load
from graphic_tmm.chapters.forces.plan import FORCES
from graphic_tmm.chapters.forces.task import Load
from graphic_tmm.chapters.kinematics.plan import KINEMATICS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Stand
from graphic_tmm.paper.finish import finished
from graphic_tmm.paper.lettering.heights import heights
from graphic_tmm.paper.views import captioned, mu_text

PLACE = "load diagram"
"""The place of the diagrams of loads."""


def load_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagram of each load that is given by the travel of a slider, the turn or the position."""
    made = FORCES.of(drawn)
    if made is None:
        return []
    _, high, views = speaking(drawn.scene.language), heights(drawn.scene, PLACE), list[Drawing]()
    loads = made.order.loads
    for k, (letter, load, size) in enumerate(
        zip(letters(loads), loads, made.loads.given, strict=True)
    ):
        if not varies(load) or not any(sizes_of(load)):
            continue
        called = symbol(braced(letter), drawn.scene.language)
        title = _("Diagram of the load {letter}", letter=called)
        shown = _diagram(drawn, load, size, called)
        along = Scale("μ_S" if load.travel else "μ_φ", standard(shown.reach, ACROSS), _base(load))
        up = Scale(f"μ_{called[0]}", standard(shown.largest, UP), f"{_unit(load)}/mm")
        view = draw_load(
            shown,
            f"load-{k + 1}",
            title,
            (along.value, up.value),
            drawn.scene.language,
            high,
        )
        both = (along, up) if along.unit else (up,)
        scales = ", ".join(mu_text(scale, drawn.scene.language) for scale in both)
        view = finished(view._replace(stand=Stand(kind="table")), lettered)
        views.append(captioned(view, title, scales, heights=high))
    return views


def _unit(load: Load) -> str:
    return "N·m" if load.point is None else "N"


def _base(load: Load) -> str:
    """Return the unit of μ of the base; "" where positions stand on it."""
    if load.travel is not None:
        return "m/mm"
    return "°/mm" if load.by_angle else ""


def _diagram(drawn: Drawn, load: Load, size: Mark, letter: str) -> Diagram:
    language, largest = drawn.scene.language, max(map(abs, sizes_of(load)))
    up = f"{letter}, {unit(_unit(load), language)}"
    there = [k for k in range(drawn.scene.row.count) if k not in drawn.undrawn]
    if load.travel is not None:
        *_, way, stroke = next(s.uses for s in drawn.construction.steps if s.it == size)
        mu = float(drawn.reading[KINEMATICS.on(drawn).mu_l][0, 0])
        reach = float(drawn.reading[stroke][0, 0]) * mu
        parts = tuple(_strokes(load, reach))
        positions = tuple(_positions(drawn, size, way, mu, there))
        return Diagram(parts, positions, (f"S, {unit('m', language)}", up), reach, largest)
    if load.by_angle:
        line = Part("main", load.by_angle)
        return Diagram((line,), (), ("φ, °", up), 360.0, largest)
    sizes = sizes_of(load)
    line = Part("main", tuple((float(k), size) for k, size in enumerate(sizes)))
    at = tuple(
        At(drawn.names[k], float(k), sizes[k], k, size.slot) for k in there if k < len(sizes)
    )
    _ = speaking(language)
    return Diagram((line,), at, (_("position"), up), float(len(sizes) - 1 or 1), largest)


def _strokes(load: Load, reach: float) -> Iterator[Part]:
    """The stroke from the zero position in a main line, the stroke back dashed where both act."""
    assert load.travel is not None
    for pen, points in (("main", load.travel.out), ("main", load.travel.back)):
        if points:
            pen = "dashed" if points is load.travel.back and load.travel.out else pen
            yield Part(pen, tuple((share * reach, size) for share, size in points))


def _positions(drawn: Drawn, size: Mark, way: Mark, mu: float, there: list[int]) -> Iterator[At]:
    """The positions at which the load acts."""
    sizes, ways = (np.broadcast_to(drawn.reading[m][0], len(drawn.names)) for m in (size, way))
    for k in there:
        if np.isfinite(sizes[k] * ways[k]) and sizes[k]:
            yield At(drawn.names[k], float(ways[k]) * mu, float(sizes[k]), k, size.slot)
