"""Forces at any angle of the crank: the loads there, reactions, what balances the crank; figures that move."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.scales import common
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.forces.detached import Polygon, Reaction
from graphic_tmm.chapters.forces.ink_groups import GroupFigure, draw_group
from graphic_tmm.chapters.forces.ink_lever import draw_lever_ink
from graphic_tmm.chapters.forces.ink_polygons import draw_polygon, whole
from graphic_tmm.chapters.forces.load_diagrams import travelled, varies
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.forces.scales import polygon_scales
from graphic_tmm.chapters.forces.table import balance_segments, force_columns
from graphic_tmm.chapters.forces.task import ASKED, TURN, Load
from graphic_tmm.chapters.forces.travel import parts_of_strokes, size_at_turn
from graphic_tmm.chapters.forces.views import decimals_told, driver_shown, group_shown, told_lengths
from graphic_tmm.chapters.forces.words import called
from graphic_tmm.chapters.kinematics.dead_centres import Slider, goes_out
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.page.strands import Moving, MovingFigures
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Between, Turn, Turning, TurnQuantity
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.values import OTHER_EXTREME


def free(scene: Scene) -> Scene:
    """Return the scene with both ends of a travel from the zero position among its positions."""
    order, zero, extra = ASKED.of(scene), scene.row.zero, scene.row.extra
    points = [load.travel.of for load in order.loads if load.travel] if order else []
    if not isinstance(zero, Extreme) or zero.point not in points or OTHER_EXTREME in extra:
        return scene
    return replace(scene, row=replace(scene.row, extra=(*extra, OTHER_EXTREME)))


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the reactions as vectors, N, then the balancing force or moment by groups and by the lever."""
    made = FORCES_PLAN.on(project)
    # passes of friction that do not settle leave no force known
    known = made.balance if made.open is not None else None
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
    in_turn = KINEMATICS_PLAN.on(drawn).in_turn
    at = turn.numbers % in_turn
    degrees = turn.numbers * (TURN / in_turn) if turn.row is None else turn.along
    for load, size in zip(made.order.loads, made.loads.given, strict=True):
        if not varies(load):
            continue
        if load.travel is not None:
            found |= _by_travel(drawn, turn, load, size)
        elif load.by_angle:
            found[size] = size_at_turn(load.by_angle, degrees)[None, :]
        elif isinstance(load.size, tuple):
            found[size] = np.interp(at, np.arange(in_turn), load.size, period=in_turn)[None, :]
    return found


def _by_travel(drawn: Drawn, turn: Turn, load: Load, size: Mark) -> dict[Mark, object]:
    """Return the part of its diagram on which a load stands at every angle.

    Raises
    ------
    StructureError
        If the travel is counted from a zero position that is no extreme position of its point: its stroke would
        be that of the positions drawn.
    """
    travel, scene = load.travel, drawn.scene
    assert travel is not None
    way, stroke = travelled(drawn, size)
    by_mark, plans = {s.it: s for s in drawn.construction.steps}, KINEMATICS_PLAN.on(drawn)
    start, last = by_mark[way].uses[0], by_mark[stroke].uses[1]
    zero = scene.row.zero
    if by_mark[start].op is at_zero and not (isinstance(zero, Extreme) and zero.point == travel.of):
        says = said(
            "a load by the travel of {point} is known at any angle where the row begins at an extreme position "
            'of that point: zero = {{ point = "{point}", at = "left" }}',
            point=travel.of,
        )
        raise scene.located(StructureError(says, "drive.zero", head="load"))
    given, phi = by_mark[size].uses[:4], plans.positions.row[0]
    reading = turn.read([way, stroke, phi])
    shares = reading[way][0] / reading[stroke][0, 0]
    out, back = parts_of_strokes(travel, shares)
    ends = (complex(drawn.numbers.drawn[mark][0, 0]) for mark in (start, last))
    leg = sliding_leg(plans.positions, travel.of, plans.mechanism.frame.number, "load", "of")
    begins, turns_back = ends
    slider = Slider(leg, travel.of, 1.0)
    going = goes_out(plans.tried, slider, reading[phi][0], turns_back - begins)
    from_, to, first, last_ = np.where(going, out, back)
    return dict(zip(given, (one[None, :] for one in (first, last_, from_, to)), strict=True))


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
    words, language = captions(drawn.scene.language), drawn.scene.language
    on, decimals = subject(drawn, "", "lever"), decimals_told(drawn)

    def lever(place: int) -> Drawing:
        return draw_lever_ink(on, made.lever, place, decimals, False, made.tool)

    yield Moving(
        "lever",
        words["lever"],
        mu_text(drawn.scales["lever"], language),
        lever,
        lambda name: f"lever-{name}",
        columns=lambda: columns,
    )


def _pair(
    drawn: Drawn,
    made: Forces,
    shown: GroupFigure,
    polygon: Polygon,
    reactions: tuple[Reaction, ...],
) -> Iterator[Moving]:
    language, on = drawn.scene.language, subject(drawn, "", "forces")
    _, name = speaking(language), "-".join(map(str, shown.links))
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
        return draw_polygon(on, polygon, reactions, place, scale.value, helping=False)

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


TURNING = Turning(between=between, told=quantities, free=free)
FIGURES = MovingFigures(moving)
