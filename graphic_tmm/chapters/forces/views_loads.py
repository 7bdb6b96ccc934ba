"""What a sheet shows of loads that vary: their diagrams, with the positions on them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard
from graphic_tmm.chapters.forces.given import sizes_of
from graphic_tmm.chapters.forces.ink_loads import At, Diagram, Part, draw_load
from graphic_tmm.chapters.forces.names import LOADS as PLACE
from graphic_tmm.chapters.forces.pictured import ACROSS, Pictured, mu_l, pictured, travelled
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import Load
from graphic_tmm.chapters.forces.words import LOAD
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Stand
from graphic_tmm.paper.finish import finished
from graphic_tmm.paper.lettering.heights import heights
from graphic_tmm.paper.views import captioned, mu_text
from graphic_tmm.scene.captions import captions


def load_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagram of each load that is given by the travel of a slider, the turn or the position."""
    if FORCES_PLAN.of(drawn) is None:
        return []
    language, high = drawn.scene.language, heights(drawn.scene, PLACE)
    views = list[Drawing]()
    for one in pictured(drawn):
        called = symbol(one.letter, language)
        title = speaking(language)(LOAD, letter=called)
        along, up = (
            choices(drawn).scale(one.view, letter) if letter else None for letter in one.scales
        )
        assert up is not None
        by = along.value if along is not None else standard(one.reach, ACROSS)
        shown = _diagram(drawn, one, called)
        view = draw_load(shown, f"load-{one.place + 1}", title, (by, up.value), language, high)
        told = ", ".join(mu_text(scale, language) for scale in (along, up) if scale is not None)
        view = finished(view._replace(stand=Stand(kind="table")), lettered)
        views.append(captioned(view, title, told, heights=high))
    return views


def _diagram(drawn: Drawn, one: Pictured, called: str) -> Diagram:
    language, load = drawn.scene.language, one.load
    up = f"{called}, {unit(one.unit.removesuffix('/mm'), language)}"
    there = [k for k in range(drawn.scene.row.count) if k not in drawn.undrawn]
    if load.travel is not None:
        parts = tuple(_strokes(load, one.reach))
        way = travelled(drawn, one.size)[0]
        positions = tuple(_positions(drawn, one.size, way, mu_l(drawn), there))
        axes = f"S, {unit('m', language)}", up
        return Diagram(parts, positions, axes, one.reach, one.largest)
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


def _positions(drawn: Drawn, size: Mark, way: Mark, mu: float, there: list[int]) -> Iterator[At]:
    """The positions at which the load acts."""
    sizes, ways = (np.broadcast_to(drawn.reading[m][0], len(drawn.names)) for m in (size, way))
    for k in there:
        if np.isfinite(sizes[k] * ways[k]) and sizes[k]:
            yield At(drawn.names[k], float(ways[k]) * mu, float(sizes[k]), k, size.slot)
