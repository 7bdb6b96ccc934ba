"""The protocol of a scene's plans in one position: what a student does, sentence by sentence; titles."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.fitting.choice import SCALES, Choices, choices
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.synthesis import SynthesisLog, synthesis_log
from graphic_tmm.project import Project, own_boards
from graphic_tmm.readers.narration import ProtocolLine
from graphic_tmm.readers.narration import protocol as narrate
from graphic_tmm.scene.captions import Named, captions, plans_named, view_name
from graphic_tmm.scene.chapter import MECHANISM, Answer, Holder, chapters
from graphic_tmm.scene.records import Scene


@dataclass(frozen=True)
class Protocols(Answer):
    """A chapter's part in protocols.

    ``views``: the views of the board in which each of its plans is drawn. ``equations``: a view -> lines before
    its protocol. ``titles``: a view -> its title in the protocol where the record says more than the caption.
    """

    stands: ClassVar[str] = "table.PROTOCOL"
    views: Callable[[Project], Mapping[str, Iterable[str]]] = lambda project: {}
    equations: Callable[[Drawn, str, str], Iterable[str]] = lambda drawn, view, language: ()
    titles: Callable[[Holder, str, str], str] = lambda holder, view, language: ""


def title_of(project: Project, view: str, language: str) -> str:
    """Return the title of a view, plain text; a chapter may add what its record says."""
    titles = (Protocols.of(one).titles(project, view, language) for one in project.chapters)
    return next((title for title in titles if title), "") or view_name(view, language)


MOST = 0.8
"""Positions with so large a share of the values that the best one has are as good. Chosen by eye."""


def covering(reading: Reading, marks: Sequence[Mark], first: Sequence[int]) -> list[int]:
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


SYNTHESIS = "synthesis"
"""The plan that finds the lengths of a mechanism from a task."""
BESIDE = (SYNTHESIS, SCALES)
"""The plans that are calculated, not drawn."""


class PlanProtocol(NamedTuple):
    """A plan's protocol in one position: what it is headed by, its lines."""

    title: str
    lines: tuple[ProtocolLine, ...]


def plans() -> tuple[str, ...]:
    """Return the plans that have a protocol, in their order."""
    in_turn = sorted(chapters(), key=lambda one: Named.of(one).rank or 10 * one.number)
    found = dict.fromkeys(plan for one in in_turn for plan in Named.of(one).plans)
    return tuple(dict.fromkeys((*BESIDE, *found)))


def steps_of(
    made: DrawnScene,
    wanted: Sequence[str],
    position: str | None,
    language: str,
    *,
    why: bool = False,
) -> list[str]:
    """Return the lines of the protocol of plans in one position as text; ``why``: with the steps' reasons.

    Raises
    ------
    SceneError
        As `told`.
    """
    return [
        line
        for one in plan_protocols(made, wanted, position, language)
        for line in text_of(one, language, why)
    ]


def plan_protocols(
    made: DrawnScene, wanted: Sequence[str], position: str | None, language: str
) -> list[PlanProtocol]:
    """Return the protocols of plans in one position, of the mechanism and of the parts.

    Raises
    ------
    SceneError
        If the scene has none of the plans (the message lists its plans), or no such position.
    """

    def protocols_of(some: Sequence[str], place: str | None) -> list[PlanProtocol]:
        every: list[PlanProtocol] = []
        for drawn in made.boards:
            own = drawn.board == MECHANISM or made.mechanism is None
            every += _of_board(drawn, some, place if own else None, language)
        return every

    every = protocols_of(wanted, position)
    if not every:
        there = [plan for plan in plans() if protocols_of((plan, ""), None)]
        says = said(
            "the scene has no plan {listed}; it has {there}",
            listed=plans_named(wanted, language),
            there=plans_named(there, language),
        )
        raise SceneError(made.scene.source, (Fault("--plan", 0, says),))
    return every


def protocol(
    drawn: Drawn,
    wanted: Sequence[str],
    position: str | None,
    language: str,
    *,
    why: bool = False,
) -> Iterator[str]:
    """Yield the lines of the protocol of plans of a board in one position; ``why``: with the reasons of steps.

    Raises
    ------
    SceneError
        If there is no such position, or the only wanted plan of a mechanism is not drawn in it.
    """
    for one in _of_board(drawn, wanted, position, language):
        yield from text_of(one, language, why)


def text_of(one: PlanProtocol, language: str, why: bool) -> Iterator[str]:
    """Yield a protocol as lines of text; ``why``: with the reasons of its steps, in a language."""
    yield one.title
    yield from _printed(one.lines, language if why else "")
    yield ""


def _of_board(
    drawn: Drawn, wanted: Sequence[str], position: str | None, language: str
) -> Iterator[PlanProtocol]:
    """Yield the protocols of the plans of a board: of a mechanism plan by plan, of a part view by view."""
    tell = _of_mechanism if drawn.board == MECHANISM else _of_part
    return tell(drawn, wanted, position, language)


def _of_mechanism(
    drawn: Drawn, wanted: Sequence[str], position: str | None, language: str
) -> Iterator[PlanProtocol]:
    place = position_of(drawn, position)
    for plan in wanted:
        for view in _views_of(drawn, plan):
            own = [place] if position is not None else [place, *drawn.row(view)]
            at = next((k for k in own if k in drawn.row(view) and k not in drawn.undrawn), place)
            yield from _plan_told(drawn, view, at, language)
        if position is not None and len(wanted) == 1 and place not in drawn.row(plan):
            raise _refused(drawn, plan, drawn.names[place])


def _of_part(
    drawn: Drawn, wanted: Sequence[str], position: str | None, language: str
) -> Iterator[PlanProtocol]:
    """Yield the protocols of the views of a part.

    The rise of a cam has no value where it returns: what is not there in that position is told in another.
    Where none is asked for, it is that in which most of the steps have a value.
    """
    if SCALES in wanted:
        yield from _calculated_plan(drawn, SCALES, language)
    if not set(wanted) & {plan for one in drawn.project.chapters for plan in Named.of(one).plans}:
        return
    log, names = drawn.construction, drawn.names
    if position is not None and position not in names:
        raise _no_position(drawn.scene, position, names)
    first = [names.index(position)] if position is not None else []
    places = covering(drawn.reading, [step.it for step in log.steps], first)
    others = [(k, names[k]) for k in places]
    at = f", {captions(language)['position']} {names[places[0]]}" if len(names) > 1 else ""
    for view in dict.fromkeys(step.it.view for step in log.steps):
        lines = narrate(log, view, drawn.reading, places[0], language, elsewhere=others)
        yield PlanProtocol(f"{view_name(view, language)}{at}", tuple(lines))


def _no_position(scene: Scene, name: str, names: Sequence[str]) -> SceneError:
    told = said("there is no {name}; there are {known}", name=name, known=", ".join(names))
    return SceneError(scene.source, (Fault("--position", 0, told),))


def _printed(lines: Iterable[ProtocolLine], reasons: str) -> Iterator[str]:
    """Yield lines as text; ``reasons``: the language of the reasons, each printed once."""
    before = ""
    for line in lines:
        yield f"{line.label:>4}. {line.text}" if line.number else f"      [{line.text}]"
        if reasons and line.why and line.why != before:
            yield f"      {captions(reasons)['why']}: {line.why}"
        before = line.why or before
        if line.calculation:
            yield f"      {line.calculation}"


def _views_of(drawn: Drawn, plan: str) -> list[str]:
    """Return the views of the board that a plan is drawn in, in the order of the log.

    What another board draws is told there.
    """
    if plan in BESIDE:
        there = (one for board in own_boards(drawn.scene) for one in chapters(board))
        return [] if any(plan in Named.of(one).plans for one in there) else [plan]
    project = drawn.project
    found = {v for one in project.chapters for v in Protocols.of(one).views(project).get(plan, ())}
    views = dict.fromkeys(step.it.view for step in project.construction.steps)
    return [view for view in views if view in found]


def _plan_told(drawn: Drawn, view: str, place: int, language: str) -> Iterator[PlanProtocol]:
    if view in BESIDE:
        yield from _calculated_plan(drawn, view, language)
        return
    at, row = drawn.of(view), drawn.row(view)
    if at is None or place not in row:
        return
    index = row.index(place) if view in drawn.project.rows else place
    turned = drawn.scene.turned
    lines = list(narrate(drawn.construction, view, at, index, language, turned=turned))
    if not lines:
        return
    title = title_of(drawn.project, view, language)
    equations = [
        ProtocolLine(0, text)
        for one in drawn.project.chapters
        for text in Protocols.of(one).equations(drawn, view, language)
    ]
    heading = f"{title}, {captions(language)['position']} {drawn.names[place]}"
    yield PlanProtocol(heading, (*equations, *lines))


def _calculated_plan(drawn: Drawn, plan: str, language: str) -> Iterator[PlanProtocol]:
    """Yield a plan that is calculated, not drawn, if it has any steps."""
    found: SynthesisLog | Choices | None
    found = synthesis(drawn.scene) if plan == SYNTHESIS else choices(drawn)
    if found is None or not found.construction.steps:
        return
    log = found.construction
    reading = execute(log, found.given).doubted(Doubts(log.steps, found.given))
    yield PlanProtocol(view_name(plan, language), tuple(narrate(log, plan, reading, 0, language)))


def position_of(drawn: Drawn, name: str | None) -> int:
    """Return a position (index) by its name; None: the main one.

    Raises
    ------
    SceneError
        If there is no such position.
    """
    if name is None:
        return drawn.main
    if name not in drawn.names:
        raise _no_position(drawn.scene, name, drawn.names)
    return drawn.names.index(name)


def _refused(drawn: Drawn, plan: str, name: str) -> SceneError:
    text = said(
        "position {name} has no plan of {plan} (those that have one: {known}); add it there",
        name=name,
        plan=plan,
        known=", ".join(drawn.names[k] for k in drawn.row(plan)) or said("none"),
    )
    return SceneError(drawn.scene.source, (Fault(f"drive.{plan}", 0, text),))


def synthesis(scene: Scene) -> SynthesisLog | None:
    """Return the recorded synthesis of a scene that states a task."""
    task = scene.task
    return synthesis_log(task.kind, task.given) if task is not None else None
