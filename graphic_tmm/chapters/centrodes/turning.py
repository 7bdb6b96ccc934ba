"""Centrodes at any angle of the crank: instantaneous centres, the moving centrode rolling on the fixed one."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from graphic_tmm.chapters.centrodes.ink import CentrodesInk, draw_fixed
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN
from graphic_tmm.chapters.centrodes.table import link_columns
from graphic_tmm.chapters.centrodes.task import CENTRODES
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.strands import Moving, MovingFigures
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turning, TurnQuantity
from graphic_tmm.scene.captions import view_name


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield P_20: ``x20``, ``y20`` from the frame's first pivot, ``xi20``, ``eta20`` in the link's axes."""
    for made in CENTRODES_PLAN.of(project) or ():
        fixed, moving = made.sides
        index = f"{moving.link}{fixed.link}"
        named = zip(("x", "y", "xi", "eta"), (fixed.x, fixed.y, moving.x, moving.y), strict=True)
        for name, mark in named:
            yield TurnQuantity(CENTRODES, "columns", f"{name}{index}", mark, made.mu)


def moving(drawn: Drawn) -> Iterator[Moving]:
    """Yield each link's centrodes, the moving one as it has rolled."""
    language = drawn.scene.language
    for made in CENTRODES_PLAN.of(drawn) or ():
        ink = CentrodesInk(drawn.construction, drawn.reading, made, [*drawn.all])
        yield Moving(
            made.view,
            view_name(made.view, language),
            mu_text(drawn.scales[made.view], language),
            partial(_rolled, ink),
            partial(_view, made.view),
            still=partial(_still, ink),
            columns=partial(link_columns, drawn, made),
        )


def _view(view: str, position: str) -> str:
    return view


def _still(ink: CentrodesInk) -> Drawing:
    return Drawing(ink.made.view, "", tuple(draw_fixed(ink)))


def _rolled(ink: CentrodesInk, place: int) -> Drawing:
    marks = [ink.made.centre, *ink.made.moving.points]
    return Drawing(ink.made.view, "", tuple(body(ink.rolled(place), "rolling", marks)))


TURNING = Turning(told=quantities, plan=CENTRODES)
FIGURES = MovingFigures(moving)
