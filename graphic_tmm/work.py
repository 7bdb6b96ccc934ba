"""A scene that has been drawn: its log, its numbers, its scale factors, what went wrong."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute, needed
from graphic_tmm.board.findings import Finding, examine, step_number
from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.chapters.engine.task import PLACES as ENGINE_PLACES
from graphic_tmm.chapters.forces.task import PLACES as FORCE_PLACES
from graphic_tmm.chapters.kinematics.reaches import Reach, reach_of
from graphic_tmm.errors import Fault, SceneError, StructureError
from graphic_tmm.project import Project, draw_project
from graphic_tmm.scaling import (
    Extents,
    Sizes,
    base_lengths,
    chart_scale_values,
    chart_scales,
    choose_scales,
    engine_scales,
    extents,
    force_scales,
    polygon_scales,
)
from graphic_tmm.scene.places import with_plans
from graphic_tmm.scene.records import Scene

NARROW = {"A4": 140.0}
"""Room for the plan of positions on a format that has less than the usual one, mm."""


@dataclass(frozen=True)
class Work:
    """A scene that has been drawn: its log, its numbers, its scale factors, what went wrong."""

    scene: Scene
    project: Project
    given: Mapping[Mark, object]
    scales: Mapping[str, Scale]
    reading: Reading
    accelerated: Reading | None
    hand: Hand
    undrawn: tuple[int, ...]
    doubts: Doubts
    sizes: Sizes

    @cached_property
    def extents(self) -> Extents:
        """What there is to draw, in SI."""
        return extents(self.project, self.doubts)

    @cached_property
    def reaches(self) -> dict[Figure, Reach]:
        """How far every guide is used over the turn, mm on the sheet."""
        project, mu = self.project, self.scales["positions"].value
        crank = project.mechanism.by_number[project.structure.driver].points
        circle = 2.0 * abs(crank[project.structure.pin] - crank[project.structure.pivot]) / mu
        found = {}
        for guide, whole in project.reaches.items():
            drawn = reach_of(project.construction, self.reading, guide, whole.anchor)
            found[guide] = whole.times(1.0 / mu).near(drawn, circle)
        return found

    def drawn_by(self, hand: Hand) -> Work:
        """Return the same drawing, to the same scales, by another hand."""
        reading, accelerated = _read(self.project, self.given, hand, self.doubts)
        return replace(self, reading=reading, accelerated=accelerated, hand=hand)

    def trial(self, k: int) -> Work:
        """Return one of the drawings of a hand that drew several times."""
        accelerated = self.accelerated.trial(k) if self.accelerated is not None else None
        return replace(self, reading=self.reading.trial(k), accelerated=accelerated)

    def findings(self) -> tuple[Finding, ...]:
        """Return what could not be drawn, or was drawn at the edge of its possibility, or is left out."""
        log, project = self.project.construction, self.project
        marks = [step.it for step in log.steps if not step.op.across]
        found = examine(log, self.given, marks, hand=self.hand, doubts=self.reading.doubts)
        return (*_asked_for(found, project, self.doubts), *_idle(project, self.scales))


def assumed(drawn: Work) -> Iterator[str]:
    """Yield, for people, which keys are left out whose defaults matter."""
    project = drawn.project
    drive = project.mechanism.drive
    inertial = project.forces is not None and project.forces.order.inertia
    velocities = project.velocities
    if velocities is None or not (inertial or project.flywheel is not None):
        return
    # a crank that turns evenly has no inertia couple, and an energy that does not change
    even = {drive.link} if drive.acceleration == 0.0 else set()
    bare = [
        str(link.number)
        for link in project.mechanism.links
        if link.mass and link.inertia is None and link.number in velocities.rates.keys() - even
    ]
    if bare:
        yield (
            f"link {', '.join(bare)}: J is left out, with a mass given: no inertia couple and no energy of "
            "turning is taken; write J, or J = 0"
        )


def work(scene: Scene, *, exact: bool = False) -> Work:
    """Draw a scene in the usual size: record its plans, choose the scale factors, execute.

    ``exact`` switches the rounding of the ruler off.
    """
    project = record(scene)
    doubts = doubted(project)
    reach = extents(project, doubts)
    return executed(scene, project, usual(scene), reach, doubts, exact=exact)


def usual(scene: Scene) -> Sizes:
    """Return the sizes that the formats of a scene's sheets suggest."""
    orders = [order for order in scene.sheets if "positions" in order.place] or scene.sheets
    most = Sizes().positions
    return Sizes(positions=min(NARROW.get(order.format, most) for order in orders))


def doubted(project: Project) -> Doubts:
    """Return how far rounding moves the marks of a project, with a scale factor of 1 for every plan.

    Where it leaves no digit of a mark does not depend on scale factors; they are chosen by the others.
    """
    log = project.construction
    return Doubts(log.steps, {**dict.fromkeys(log.given, 1.0), **project.given}, to_scale=False)


def record(scene: Scene, wanted: Set[str] | None = None) -> Project:
    """Record what the scene calls for, or of that only what is ``wanted`` (places of a sheet).

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If its mechanism cannot be drawn.
    """
    if scene.mechanism is None:
        says = (
            "this scene has no mechanism, only sheets to draw: write [frame], [[link]] and [drive]"
        )
        raise SceneError(scene.source, (Fault("", 0, says),))
    wanted = with_plans(scene.called if wanted is None else wanted)
    try:
        return draw_project(
            scene.mechanism,
            scene.row,
            turned=scene.turned,
            trajectories=scene.trajectories,
            plans=[p for p in ("positions", "velocities", "accelerations") if p in wanted],
            diagrams=scene.tasks.get("diagrams") if "diagrams" in wanted else None,
            flywheel=scene.tasks.get("flywheel") if "flywheel" in wanted else None,
            engine=scene.tasks.get("engine") if wanted & set(ENGINE_PLACES) else None,
            forces=scene.tasks.get("forces") if wanted & _needing_forces(scene) else None,
        )
    except StructureError as error:
        raise scene.located(error) from error


def _needing_forces(scene: Scene) -> set[str]:
    """Return the places of a sheet that show forces, or a flywheel that is found by loads."""
    by_loads = scene.tasks.get("flywheel") is not None and scene.tasks["flywheel"].indicator is None
    return {*FORCE_PLACES, "flywheel"} if by_loads else set(FORCE_PLACES)


def hand_of(scene: Scene, trials: int = 1) -> Hand:
    """Return the hand that a scene names, with its ruler and its seed."""
    return HANDS[scene.hand]._replace(ruler=scene.ruler, seed=scene.seed, trials=trials)


def executed(
    scene: Scene,
    project: Project,
    sizes: Sizes,
    reach: Extents,
    doubts: Doubts,
    *,
    exact: bool,
) -> Work:
    """Choose the scale factors of a recorded project and execute it; see `work`.

    ``reach``: its `extents`; ``doubts``: what is lost by them sets no scale factor, and is not there.
    """
    scales = choose_scales(project, scene.scales, sizes, reach)
    given = {**project.given, **base_lengths(project, sizes.graphs, scene.told)}
    for plan, scale in scales.items():
        given[project.scale(plan)] = scale.value
    sized = force_scales(project, given, doubts, sizes)
    given |= {**dict.fromkeys(polygon_scales(project), 1.0), **sized}
    given |= engine_scales(project, given, doubts, sizes)
    given |= chart_scales(project, given, doubts, sizes, _graphs_on(scene))
    hand = EXACT if exact else hand_of(scene)
    reading, accelerated = _read(project, given, hand, doubts)
    scales |= chart_scale_values(project, reading)
    if project.engine is not None:
        mu = project.engine.mu
        scales["engine"] = Scale("μ_F", float(reading[mu][0, 0]), mu.unit)
        mu = project.engine.harmonics.mu
        scales["harmonics"] = Scale("μ_F", float(reading[mu][0, 0]), mu.unit)
    if project.forces is not None:
        polygons = project.forces.polygons
        lever = project.forces.lever.mu
        scales["lever"] = Scale("μ_v", float(reading[lever][0, 0]), lever.unit)
        scales |= {p.view: Scale("μ_F", sized[p.mu], "N/mm") for p in polygons if p.mu in sized}
    undrawn = _undrawn(project, reading)
    if len(undrawn) == len(project.names):
        raise StructureError(
            f"{scene.source}: none of the positions can be drawn" + ranges(project)
        )
    return Work(scene, project, given, scales, reading, accelerated, hand, undrawn, doubts, sizes)


def _graphs_on(scene: Scene) -> str:
    """Return the format of the sheet that shows the graphs of the flywheel; of several the smaller."""
    formats = {sheet.format for sheet in scene.sheets if "flywheel" in sheet.place}
    return "A4" if "A4" in formats else "A1"


def _balanced(project: Project, doubts: Doubts) -> dict[int, np.ndarray]:
    """Return, by the slot of their difference, where both methods find that nothing balances the crank.

    There is nothing to compare then.
    """
    made = project.forces
    if made is None:
        return {}
    none = doubts.nothing(made.balance) & doubts.nothing(made.lever.balance)
    return {made.difference.slot: np.broadcast_to(none, (1, len(project.names)))}


def _asked_for(found: tuple[Finding, ...], project: Project, doubts: Doubts) -> Iterator[Finding]:
    """Yield findings of plans of accelerations and of forces only at positions that have such a plan."""
    gained = set(project.accelerated)
    if project.forces is not None and project.forces.order.inertia:
        gained |= set(project.forced)
    for one in found:
        places = set(one.positions)
        if one.step.it.view == "accelerations":
            places &= gained
        elif project.forces is not None and project.forces.owns(one.step.it.view):
            places &= set(project.forced)
            one = _compared(one, places, project, doubts)
        if places and (one.letters or one.kind != "lost"):
            yield one._replace(positions=tuple(sorted(places)))


def _compared(one: Finding, places: set[int], project: Project, doubts: Doubts) -> Finding:
    """Return a finding without what it says of comparing nothing with nothing; its places are cut down."""
    assert project.forces is not None
    difference = project.forces.difference
    (balanced,) = _balanced(project, doubts).values()
    nothing = set(np.flatnonzero(balanced[0]).tolist())
    if one.kind == "undrawn" and one.step.it == difference:
        # of what is lost there is nothing to compare either: that it is lost is told
        lost = [doubts.lost[use.slot] for use in one.step.uses if use.slot in doubts.lost]
        places -= nothing.union(*(np.flatnonzero(mask[0]).tolist() for mask in lost))
    if one.kind == "lost" and places <= nothing:
        return one._replace(letters=tuple(k for k in one.letters if k != difference.letter))
    return one


def _idle(project: Project, scales: Mapping[str, Scale]) -> Iterator[Finding]:
    """Yield the polygons that have no scale, for all their forces are nothing."""
    made, log = project.forces, project.construction
    for polygon in made.polygons if made is not None else ():
        if polygon.view not in scales:
            step = next(step for step in log.steps if step.it.view == polygon.view)
            yield Finding("idle", step, step_number(log, step), project.forced, 0.0)


def _read(
    project: Project, given: Mapping[Mark, object], hand: Hand, doubts: Doubts
) -> tuple[Reading, Reading | None]:
    """Execute the log: everything but the plans of accelerations, and these at their positions.

    What is lost is not there.
    """
    log = project.construction
    exact = hand.ruler is None and not hand.slips and hand.digits is None
    own = (
        doubts
        if exact
        else Doubts(log.steps, given, doubts.lost, coarse=_ruled(project, given, hand))
    )
    still = {m for m in log.given if m.view != "accelerations"}
    still |= {m for s in log.steps if s.it.view != "accelerations" for m in (s.it, *s.uses)}
    reading = execute(log, given, still, hand=hand).doubted(own)
    reading = reading.without(doubts.lost).without(_balanced(project, doubts))
    if project.accelerations is None or not project.accelerated:
        return reading, None
    steps = [step for step in log.steps if step.it.view == "accelerations"]
    whole = {mark for step in steps for mark in (step.it, *step.uses)}
    places = project.accelerated
    planned = execute(log, given, whole, hand=hand, positions=places)
    return reading, planned.without(doubts.lost, places).doubted(own, places)


def _ruled(project: Project, given: Mapping[Mark, object], hand: Hand) -> dict[int, Doubts]:
    """Return what the ruler leaves of the difference of the two methods: its digits follow from readings."""
    if project.forces is None or hand.ruler is None:
        return {}
    difference = project.forces.difference
    steps = needed(project.construction, [difference])
    return {difference.slot: Doubts(steps, given, ruler=hand.ruler)}


def ranges(project: Project) -> str:
    """Return, as the end of a sentence, over which ranges of the crank the mechanism assembles."""
    said = project.assembly.said
    return f": {said}" if said else ""


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks("positions"):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))
