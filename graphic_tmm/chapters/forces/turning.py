"""Forces at any angle of the crank: the loads there, reactions, what balances the crank; figures that move."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.scales import common
from graphic_tmm.chapters.forces.detached import Polygon, Reaction
from graphic_tmm.chapters.forces.ink_groups import GroupFigure, draw_group
from graphic_tmm.chapters.forces.ink_lever import draw_lever_ink
from graphic_tmm.chapters.forces.ink_polygons import draw_polygon, whole
from graphic_tmm.chapters.forces.levers import Balanced
from graphic_tmm.chapters.forces.load_diagrams import varies
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.forces.scales import polygon_scales
from graphic_tmm.chapters.forces.table import balance_segments, force_columns
from graphic_tmm.chapters.forces.task import TURN
from graphic_tmm.chapters.forces.tool import Tool
from graphic_tmm.chapters.forces.travel import parts_at, size_at_turn, size_in_row
from graphic_tmm.chapters.forces.views import (
    decimals_told,
    driver_shown,
    group_shown,
    lever_called,
    told_lengths,
)
from graphic_tmm.chapters.forces.words import called
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.page.strands import Moving, MovingFigures
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Between, Turn, Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the reactions as vectors, N; what balances the drives, by groups and by their levers."""
    made = FORCES_PLAN.on(project)
    # passes of friction that do not settle leave no force known: all of them make what drives with it
    step = made.efficiency and project.construction.step(made.efficiency)
    known = step.uses[1] if step is not None else None
    for one in made.reactions:
        key, mu = segment_name(one.letter), project.scale(one.tail.view)
        yield TurnQuantity("forces", "forces", key, one.head, mu, one.tail, known=known)
    for name, mark in balance_segments(made).items():
        yield TurnQuantity("forces", "balance", name, mark, known=known)


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return the loads that vary, read off their diagrams: by travel, by the turn, by the position; μ_F."""
    made = FORCES_PLAN.on(drawn)
    # at other angles every polygon is drawn to what most positions of the sheet are
    scales = [
        mu for mu in polygon_scales(drawn.project) if isinstance(drawn.given.get(mu), np.ndarray)
    ]
    found: dict[Mark, object] = {mu: common(drawn.given[mu]) for mu in scales}
    plans = KINEMATICS_PLAN.on(drawn)
    in_turn = plans.in_turn
    at = turn.numbers % in_turn
    degrees = turn.numbers * (TURN / in_turn) if turn.row is None else turn.along
    for load, size in zip(made.order.loads, made.loads.given, strict=True):
        if not varies(load):
            continue
        if load.travel is not None:
            of = made.loads.travels[size]
            phi = plans.positions.row[0]
            reading = turn.read([of.way, of.stroke, phi])
            shares = reading[of.way][0] / reading[of.stroke][0, 0]
            from_, to, first, last = parts_at(load.travel, of, shares, reading[phi][0])
            step = drawn.construction.step(size)
            assert step is not None
            parts = (one[None, :] for one in (first, last, from_, to))
            found |= dict(zip(step.uses[:4], parts, strict=True))
        elif load.by_angle:
            found[size] = size_at_turn(load.by_angle, degrees)[None, :]
        elif load.by_time and (steps := plans.steps) is not None:
            way = float(steps[plans.count - 1])
            found[size] = size_in_row(load.by_time, plans.pairs[0], way, turn.along)[None, :]
        elif isinstance(load.size, tuple):
            found[size] = np.interp(at, np.arange(in_turn), load.size, period=in_turn)[None, :]
    return found


def moving(drawn: Drawn) -> Iterator[Moving]:
    """Yield every detached group with its polygon, the driving link with its own, the lever."""
    made = FORCES_PLAN.on(drawn)
    columns = force_columns(drawn, everywhere=True)
    for solved in made.groups:
        yield from _pair(
            drawn, made, group_shown(drawn, made, solved), solved.polygon, solved.reactions
        )
    for driven in made.driven:
        if (alone := driven.alone) is not None:
            shown = driver_shown(drawn, made, driven)
            yield from _pair(drawn, made, shown, alone.polygon, (alone.reaction,))
    on, decimals = subject(drawn, "", "lever"), decimals_told(drawn)
    for one in made.balanced:
        key = one.view.replace(" ", "-")
        yield Moving(
            one.view,
            lever_called(drawn, one),
            mu_text(drawn.scales[one.view], drawn.scene.language),
            partial(_lever, on, one, decimals, made.tool),
            f"{key}-{{}}".format,
            columns=lambda: columns,
        )


def _lever(on: Subject, one: Balanced, decimals: int, tool: Tool | None, place: int) -> Drawing:
    return draw_lever_ink(on, one.lever, place, decimals, False, tool)


def _pair(
    drawn: Drawn,
    made: Forces,
    shown: GroupFigure,
    polygon: Polygon,
    reactions: tuple[Reaction, ...],
) -> Iterator[Moving]:
    language, on = drawn.scene.language, subject(drawn, "", "forces")
    _, name = speaking(language), polygon.of.name
    scale = drawn.scales.get(polygon.view)
    yield Moving(
        f"group {name}",
        called(f"group {name}", _),
        mu_text(drawn.scales[shown.figure.view], language),
        _group(drawn, shown, polygon, reactions),
        lambda position: f"group-{name}-{position}",
    )
    if scale is None:
        return

    def sides(place: int) -> Drawing:
        if not whole(drawn.reading, polygon, reactions, place):
            return Drawing(polygon.view, "")
        rods = made.rods(polygon)
        return draw_polygon(on, polygon, reactions, place, scale.value, rods, helping=False)

    yield Moving(
        f"forces {name}",
        called(f"forces {name}", _),
        mu_text(scale, language),
        sides,
        lambda position: f"forces-{name}-{position}",
    )


def _group(
    drawn: Drawn, shown: GroupFigure, polygon: Polygon, reactions: tuple[Reaction, ...]
) -> Callable[[int], Drawing]:
    on, factors = subject(drawn, "", "forces"), told_lengths(drawn)

    def at(place: int) -> Drawing:
        if not whole(drawn.reading, polygon, reactions, place):
            return Drawing(shown.figure.view, "")
        return draw_group(on, reaches(drawn), shown, place, factors, helping=False)

    return at


TURNING = Turning(between=between, told=quantities)
FIGURES = MovingFigures(moving)
