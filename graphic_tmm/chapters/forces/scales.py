"""How large figures of forces may be; μ_F of polygons, μ_l of what is detached, the lever's size, and why."""

from __future__ import annotations

import math
from collections.abc import Container, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import (
    ENLARGED,
    LENGTHS,
    Scale,
    next_ratio,
    standard_length,
    times_larger,
)
from graphic_tmm.board.values import Length, Point
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.levers import Balanced
from graphic_tmm.chapters.forces.load_diagrams import ACROSS, UP, pictured
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.spring_diagrams import laws
from graphic_tmm.chapters.forces.task import ASKED, FORCES
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger, usual_room, value_of
from graphic_tmm.fitting.scales import (
    Fitting,
    ScaleFactor,
    ScaleFactors,
    Sized,
    extent,
    scale_of,
    unscaled,
)
from graphic_tmm.fitting.sizes import Size, Sizing, graph_size
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import GRAPH as GRAPH_VIEW
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    order = ASKED.of(scene)
    return "forces.mu_F" if order is not None and order.mu is not None else ""


def _polygons(scene: Scene, role: str) -> tuple[str, ...]:
    return {GRAPH_VIEW: (GRAPHS.name,), roles.DETACHED: ("groups",)}.get(role, ("forces",))


GRAPHS = graph_size(FORCES)
POLYGON, GROUP, LEVER = 150.0, 145.0, 180.0
"""The most that a polygon takes on an A1, mm, the links of a detached group, the lever."""
SIZES = Sizing(
    graphs=GRAPHS.name,
    sizes=(
        GRAPHS,
        Size("forces", POLYGON, in_mm=True, least=0.1, first=True, fixed=_fixed),
        Size("groups", GROUP, in_mm=True, least=0.05),
        Size("lever", LEVER, in_mm=True, least=0.05),
    ),
    depends={"forces": _polygons, "lever": lambda scene, role: ("lever",)},
)


LARGER = 1.3
"""A lever as large as the plan of velocities may take so many times its room: the next scale halves it."""
LONGER = 3.5
"""So many times its room a group may take so as to be no smaller than the plan."""
LINK_1, SHORT = 0.5, 20.0
"""What link 1 alone takes of the room for a group; how long it is drawn on an A1 where that is less, mm."""
_GROUP = said(
    "A group takes {room}, and is no smaller than on the plan of positions: the arms of forces are measured "
    "on it.",
    room=usual_room(GROUP),
)
_ALONE = said(
    "Of link 1 one arm is measured: it is drawn no larger than the group that it turns, but no shorter than "
    "{short:g} mm of an A1.",
    short=SHORT,
)
_POLYGON = said(
    "A polygon of forces takes {room}: the forces that close it are measured.",
    room=usual_room(POLYGON),
)
ALIKE, READABLE = 4.0, 30.0
"""A polygon has a μ_F of its own where the largest would be so many times as large, or leave it less than so
many mm."""
ROUNDED = 1e-9
"""Points no farther apart than this share of how far out they lie are one: a nanometre on the largest sheet."""


def polygon_scales(project: Project) -> list[Mark]:
    """Return the marks of μ of every polygon of forces."""
    views = project.construction.views
    return [
        view.scale for view in views if view.scale is not None and view.role == roles.FORCE_POLYGON
    ]


class Reaches(NamedTuple):
    """How far polygons reach, by view and position (N); what is detached, m, plans of levers, m/s, by view.

    Polygons of no forces are not there.
    """

    polygons: Mapping[str, Mapping[int, float]]
    detached: Mapping[str, float]
    levers: Mapping[str, float]


def reach(project: Project, doubts: Doubts) -> Reaches:
    """Return what the scales of forces go by: positions whose forces are asked for, with all scales 1."""
    made, scales = FORCES_PLAN.on(project), polygon_scales(project)
    views = {mu.view for mu in scales}
    log = project.construction
    marks = [step.it for step in log.steps if step.it.view in views and step.it.kind is Point]
    plans = {
        one.view: list(dict.fromkeys(mark for own in one.lever.images.values() for mark in own))
        for one in made.balanced
    }
    images = [mark for own in plans.values() for mark in own]
    points = [mark for figure in made.figures for mark in figure.points.values()]
    reading = unscaled(project, doubts, [*marks, *points, *images])
    found = dict[str, Mapping[int, float]]()
    for mu in scales:
        spots = [_at(_place(reading, m, doubts), made.places) for m in marks if m.view == mu.view]
        rows = np.array([np.broadcast_to(row, len(made.places)) for row in spots])
        reaches = {
            k: extent([np.array([0j, *row])]) for k, row in zip(made.places, rows.T, strict=True)
        }
        found[mu.view] = {k: reach for k, reach in reaches.items() if reach > 0.0}
    far = {
        view: extent([np.concatenate([[0j], *(_at(reading[m], made.places) for m in own)])])
        for view, own in plans.items()
    }
    apart = {figure.view: _apart(figure, reading, made.places) for figure in made.figures}
    return Reaches(found, apart, far)


def _apart(figure: Detached, reading: Reading, places: tuple[int, ...]) -> float:
    """Return how far the points of a figure reach, in each position by itself; 0 where they are one point."""
    spots = [_at(reading[mark], places) for mark in figure.points.values()]
    rows = np.array([np.broadcast_to(row, len(places)) for row in spots])
    far = max((extent([column]) for column in rows.T), default=0.0)
    return far if far > ROUNDED * np.nanmax(np.abs(rows), initial=0.0) else 0.0


def factors(sized: Sized) -> Iterator[ScaleFactor]:
    """Yield μ_l of what is detached and μ_F of every polygon of forces.

    The links of a group take their room in all positions, and are no smaller than on the plan of positions;
    link 1 is no larger than the groups. A polygon takes its room in any position whose forces are asked for;
    one whose forces are all nothing has no μ but the scene's. Positions of much smaller forces have their own.
    """
    made, known, project = FORCES_PLAN.on(sized), sized.reach[FORCES], sized.project
    room, plan = sized.sizes["groups"], _plan_scale(sized)
    groups = [one for one in made.figures if len(one.of.links) > 1 and known.detached[one.view]]
    turned = _group(known.detached[groups[-1].view], room, plan) if groups else plan
    for figure in made.figures:
        if not (far := known.detached[figure.view]):
            continue
        why = _GROUP if figure in groups else _ALONE
        if figure in groups:
            wide = far / _group(far, room, plan)
        else:
            # link 1 is no larger than the group that it turns, but where it would be too short to measure
            wide = max(
                min(LINK_1 * room, max(far / turned, SHORT * min(room / GROUP, 1.0))), far / plan
            )
        yield ScaleFactor(figure.mu, "l_{max}", far, wide * (1 + ROUNDED), lengths=True, why=why)
    high, mu_F = sized.sizes["forces"], made.order.mu
    for mu in polygon_scales(project):
        if not (far := known.polygons[mu.view]):
            if mu_F:
                yield ScaleFactor(mu, "F_{max}", 0.0, high, mu_F, why=_POLYGON)
            continue
        most, *others = _alike(far, max(min(ALIKE, high / READABLE), 1.0))
        apart = {k: max(far[k] for k in some) for some in others for k in some}
        largest = max(far[k] for k in most)
        yield ScaleFactor(mu, "F_{max}", largest, high, mu_F, why=_POLYGON, apart=apart)


def _alike(far: Mapping[int, float], times: float) -> list[list[int]]:
    """Return positions that have one μ_F together, those of the most (of as many the largest) first.

    No polygon is so many ``times`` as large as another of them.
    """
    found: list[list[int]] = []
    for k in sorted(far, key=lambda k: -far[k]):
        if not found or far[k] * times < far[found[-1][0]]:
            found.append([])
        found[-1].append(k)
    return sorted((sorted(some) for some in found), key=lambda some: -len(some))


def _group(far: float, room: float, plan: float) -> float:
    """Return μ_l of a group that reaches so far (m): by its room (mm), no smaller than the plan if it may."""
    larger = max((mu for mu in LENGTHS if mu <= plan * (1 + ROUNDED)), default=plan)
    return max(min(standard_length(far, room), larger), standard_length(far, LONGER * room))


def _plan_scale(sized: Sized) -> float:
    """Return μ_l of the plan of positions."""
    return float(np.ravel(np.asarray(sized.given[sized.project.scale(POSITIONS)]))[0])


def force_scales(fitting: Fitting) -> dict[Mark, object]:
    """Return how many times larger levers are drawn; μ_l of what is detached in one point.

    That has no length to go by: it is drawn to the scale of the plan of positions.
    """
    project, made = fitting.project, FORCES_PLAN.on(fitting)
    known: Reaches = fitting.reach[FORCES]
    times = dict[Mark, object]()
    for one in made.balanced:
        plan, far = (
            np.ravel(np.asarray(fitting.given[_plan_of(project, one)]))[0],
            known.levers[one.view],
        )
        room = fitting.sizes["lever"] * float(plan)
        times[one.lever.times] = next(
            (k for k in ENLARGED if k * far <= (LARGER if k == 1.0 else 1.0) * room), ENLARGED[-1]
        )
    mu_l = fitting.given[project.scale(POSITIONS)]
    points = {figure.mu: mu_l for figure in made.figures if not known.detached[figure.view]}
    return {**times, **points}


def _plan_of(project: Project, one: Balanced) -> Mark:
    """Return μ_v of the plan of velocities that is taken for a lever."""
    return KINEMATICS_PLAN.on(project).plan_of(one.driven.pair.link).mu


def _place(reading: Reading, mark: Mark, doubts: Doubts) -> np.ndarray:
    """Return where a point is, with all scales 1; what is nothing but rounding is at the beginning."""
    return np.asarray(doubts.figure(mark, reading[mark]))


def _at(values: np.ndarray, places: tuple[int, ...]) -> np.ndarray:
    return np.asarray(values[0, list(places)] if values.shape[1] > 1 else values[0])


def named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return the scales of levers, and of the polygons and detached groups that have one ``given``."""
    made = FORCES_PLAN.on(project)
    others = [polygon.mu for polygon in made.polygons] + [figure.mu for figure in made.figures]
    chosen = [*(one.lever.mu for one in made.balanced), *(mu for mu in others if mu in given)]
    return {mu.view: scale_of(mu, reading) for mu in chosen}


def scale_keys(project: Project) -> dict[str, str]:
    """Return what machines call the scale factors, by view: forces 4-5 -> mu_F_4_5, group 1 -> mu_l_1."""
    made = FORCES_PLAN.on(project)
    keys = {figure.view: figure.of.key("l") for figure in made.figures}
    keys |= {polygon.view: polygon.of.key("F") for polygon in made.polygons}
    return {**keys, **{one.view: f"mu_{one.view.replace(' ', '_')}" for one in made.balanced}}


SCALES = ScaleFactors(reach, factors=factors, scales=force_scales, named=named, keys=scale_keys)


GRAIN = 10.0
"""What is meant for the lever is told in multiples of this, mm."""
_POINT = said(
    "All points of what is detached lie in one: no length tells how large to draw it, so it keeps the scale of "
    "the plan of positions."
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how the scale factors of the forces were chosen."""
    known: Reaches = drawn.reach[FORCES]
    for figure in FORCES_PLAN.on(drawn).figures:
        if not known.detached[figure.view]:
            ledger.of(figure.view)
            ledger.same(figure.mu, drawn.project.scale(POSITIONS), figure.mu.name, why=_POINT)
    for drive in FORCES_PLAN.on(drawn).balanced:
        _lever(drawn, ledger, drive, known.levers[drive.view])
    for law in laws(drawn):
        ledger.of(law.view)
        largest = ledger.quantity(f"{law.letter[:-1]}max}}", law.largest, "N")
        ledger.pictured("μ_F", "N/mm", largest, UP)
    for one in pictured(drawn):
        ledger.of(one.view)
        along, up = one.scales
        if along:
            base = ledger.quantity(f"{along[2:]}_{{max}}", one.reach, one.base.removesuffix("/mm"))
            ledger.pictured(along, one.base, base, ACROSS)
        of = one.unit.removesuffix("/mm")
        largest = ledger.quantity(f"{one.letter[:-1]}max}}", one.largest, of)
        ledger.pictured(up, one.unit, largest, UP)


def _lever(drawn: Drawn, ledger: Ledger, one: Balanced, longest: float) -> None:
    """Record how many times larger than the plan of velocities a lever is drawn."""
    lever, of_plan = one.lever, _plan_of(drawn.project, one)
    plan = ledger.chosen[of_plan.slot]
    ledger.of(one.view)
    times = value_of(drawn, lever.times)
    if not longest > 0.0:
        ledger.quantity(lever.times.name, times, "")
        return
    mu_v = value_of(drawn, of_plan)
    most = ledger.quantity("v_{max}", longest, "m/s")
    room = GRAIN * math.ceil(times * longest / mu_v / GRAIN)
    wanted = ledger.draft.take(Length, f"[{most.name}]", room)
    exact = ledger.draft.draw(times_larger, f"{lever.times.name}′", wanted, plan, most)
    ledger.enter(lever.times, ledger.draft.draw(next_ratio, lever.times.name, exact))


CHOICE = Choice(choose=choose)
