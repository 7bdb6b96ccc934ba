"""The protocol of a scene's plans in one position: what a student does, sentence by sentence, with numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.captions import CAPTIONS
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.words import flywheel_title, plain, view_name
from graphic_tmm.mechanism.synthesis import Found, rocker
from graphic_tmm.parts import Part
from graphic_tmm.readers.narration import Line
from graphic_tmm.readers.narration import protocol as narrate
from graphic_tmm.scene.records import Scene
from graphic_tmm.work import Work

MOST = 0.8
"""Positions with so large a share of the values that the best one has are as good."""
GATHERED = ("diagrams", "flywheel", "engine", "forces")
"""Plans that are drawn in several views."""


def steps_of(
    work: Work | None,
    parts: Sequence[Part],
    scene: Scene,
    plans: Sequence[str],
    position: str | None,
    language: str,
    known: Sequence[str],
) -> list[str]:
    """Return the lines of the protocol of plans in one position, of the mechanism and of the parts.

    ``known``: all plans that may be asked for.

    Raises
    ------
    SceneError
        If the scene has none of the plans (those it has are told), or `protocol` has no such position.
    """

    def lines(wanted: Sequence[str], place: str | None) -> list[str]:
        own = list(protocol(work, wanted, place, language)) if work is not None else []
        of_parts = place if work is None else None
        return [*own, *part_protocol(parts, wanted, language, of_parts)]

    found = lines(plans, position)
    if not found:
        there = ", ".join(plan for plan in known if lines((plan, ""), None))
        says = said(
            "the scene has no plan {listed}; it has {there}", listed=", ".join(plans), there=there
        )
        raise SceneError(scene.source, (Fault("--plan", 0, says),))
    return found


def protocol(
    work: Work, plans: Sequence[str], position: str | None, language: str
) -> Iterator[str]:
    """Yield the lines of the protocol of plans in one position.

    Raises
    ------
    SceneError
        If there is no such position, or it has no plan of accelerations.
    """
    project = work.project
    place = _position(work, position, needs="accelerations" if len(plans) == 1 else "")
    for plan in plans:
        for view in _views_of(work, plan):
            yield from _plan_lines(work, view, place, language)
        if plan == "accelerations" and len(plans) == 1 and place not in project.accelerated:
            raise _refused(work, plan, project.names[place])


def part_protocol(
    parts: Sequence[Part], plans: Sequence[str], language: str, position: str | None = None
) -> Iterator[str]:
    """Yield the lines of the protocol of parts, view by view, in one position.

    The rise of a cam has no value where it returns: what is not there in that position is told in another.
    Where none is asked for, it is that in which most of the steps have a value.

    Raises
    ------
    SceneError
        If a part has no such position.
    """
    for part in parts:
        if part.kind not in plans:
            continue
        log, names = part.construction, part.names
        if position is not None and position not in names:
            raise _no_position(part.scene, position, names)
        first = [names.index(position)] if position is not None else []
        places = _covering(part.reading, [step.it for step in log.steps], first)
        others = [(k, names[k]) for k in places]
        at = f", {CAPTIONS[language]['position']} {names[places[0]]}" if len(names) > 1 else ""
        for view in dict.fromkeys(step.it.view for step in log.steps):
            yield f"{view_name(view, language)}{at}"
            for line in narrate(log, view, part.reading, places[0], language, elsewhere=others):
                yield from _printed(line)
            yield ""


def _covering(reading: Reading, marks: Sequence[Mark], first: Sequence[int]) -> list[int]:
    """Return positions (indices) so that each mark has a value in one of them: ``first``, then few more.

    A position is taken in the middle of the longest stretch on which the same has a value, and most of it.
    """
    rows = [undefined(reading[mark])[0] for mark in marks if mark.kind is not Curve]
    there = np.array([~row for row in rows if row.size == reading.positions])
    places, left = list(first), np.ones(len(there), dtype=bool)
    while True:
        for place in places:
            left &= ~there[:, place] if there.size else left
        counts = there[left].sum(axis=0) if there.size else np.zeros(1)
        if not counts.any():
            return places or [0]
        changes = np.flatnonzero((there[left][:, 1:] != there[left][:, :-1]).any(axis=0)) + 1
        stretches = np.split(np.arange(counts.size), changes)
        whole = [s for s in stretches if counts[s[0]] >= MOST * counts.max()]
        longest = max(whole, key=len)
        places.append(int(longest[longest.size // 2]))


def _no_position(scene: Scene, name: str, names: Sequence[str]) -> SceneError:
    told = f"there is no {name}; there are {', '.join(names)}"
    return SceneError(scene.source, (Fault("--position", 0, told),))


def _printed(line: Line) -> Iterator[str]:
    yield f"{line.label:>4}. {line.text}" if line.number else f"      [{line.text}]"
    if line.calculation:
        yield f"      {line.calculation}"


def _views_of(work: Work, plan: str) -> list[str]:
    """Return the views of the board that a plan is drawn in, in the order of the log."""
    project = work.project
    found: set[str] = set()
    if plan == "diagrams" and project.kinematic is not None:
        found = {chart.view for chart in project.kinematic.charts.values()}
    elif plan == "flywheel" and project.flywheel is not None:
        found = {chart.view for chart in project.flywheel.charts}
    elif plan == "engine" and project.engine is not None:
        found = {"engine", "harmonics", *(chart.view for chart in project.engine.charts)}
    elif plan == "forces" and project.forces is not None:
        owns = project.forces.owns
        found = {s.it.view for s in project.construction.steps if owns(s.it.view)}
    elif plan not in GATHERED:
        return [plan]
    views = dict.fromkeys(step.it.view for step in project.construction.steps)
    return [view for view in views if view in found]


def _plan_lines(work: Work, plan: str, place: int, language: str) -> Iterator[str]:
    project, log, reading, index = work.project, work.project.construction, work.reading, place
    if plan == "synthesis":
        found = synthesis(work.scene)
        if found is None:
            return
        log, reading, index = found.construction, execute(found.construction, found.given), 0
    if plan == "accelerations":
        if work.accelerated is None or place not in project.accelerated:
            return
        reading, index = work.accelerated, project.accelerated.index(place)
    turned = work.scene.turned and plan == "velocities"
    lines = list(narrate(log, plan, reading, index, language, turned=turned))
    if not lines:
        return
    words = CAPTIONS[language]
    at = f", {words['position']} {project.names[place]}" if plan != "synthesis" else ""
    kinematic = work.project.kinematic
    point = kinematic.order.point if kinematic is not None else ""
    flywheel = project.flywheel
    constant = flywheel.order.constant if flywheel is not None else ""
    title = view_name(plan, language, point)
    title = flywheel_title(plan, constant, language) if plan == "moment" else title
    yield f"{title}{at}"
    yield from _polygon(work, plan, language)
    for line in lines:
        yield from _printed(line)
    yield ""


def _position(work: Work, name: str | None, needs: str) -> int:
    project = work.project
    if name is None:
        row = range(len(project.names))
        wanted: list[int] = [*project.accelerated, *row[1:2], *row]
        return next((k for k in wanted if k not in work.undrawn), wanted[0])
    if name not in project.names:
        raise _no_position(work.scene, name, project.names)
    return project.names.index(name)


def _refused(work: Work, plan: str, name: str) -> SceneError:
    drawn = ", ".join(work.project.names[k] for k in work.project.accelerated) or "none"
    text = (
        f"position {name} has no plan of accelerations (those that have one: {drawn}); add it there"
    )
    return SceneError(work.scene.source, (Fault("drive.accelerations", 0, text),))


def synthesis(scene: Scene) -> Found | None:
    """Return the recorded synthesis of a scene that states a task."""
    return rocker(**scene.task.given) if scene.task is not None else None


def _polygon(work: Work, view: str, language: str) -> Iterator[str]:
    """Yield the vector equation of a polygon of forces."""
    made = work.project.forces
    for polygon in made.polygons if made is not None else ():
        if polygon.view == view:
            letters = [plain(symbol(letter, language)) for letter, _, _ in polygon.sides]
            yield f"      [{' + '.join(letters)} = 0]"
