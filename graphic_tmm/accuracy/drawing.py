"""The log of a setting, with μ as on the scene's sheets; the true value of a quantity, by an exact hand.

The exact hand, without a ruler, draws on the same log where that is independent. Where it is not, the quantity
names another drawing as reference: a row so fine that it has converged, or another method.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from graphic_tmm.accuracy.quantities import (
    Accuracy,
    Quantity,
    Reference,
    Trial,
    quantities,
    with_affected,
)
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import common
from graphic_tmm.board.values import Length, Point, Reals
from graphic_tmm.drawn import DrawnScene, doubted
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.scales import chosen, reach_of
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.project import Project, own_boards, record
from graphic_tmm.readers.position_count import at_count
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import draws_mechanism

PER_MM = "/mm"
Pinned = Mapping[tuple[str, str, str], object]
"""Scale factors as given on a board, by board, view and letter."""


def pinned(made: DrawnScene) -> dict[tuple[str, str, str], object]:
    """Return the scale factors of a scene as drawn, and what else of it stays as it was drawn.

    Of a scale factor that positions have of their own that of the others: they are drawn at more positions.
    """
    found: dict[tuple[str, str, str], object] = {}
    for one in made.boards:
        scales = [mark for mark in one.construction.given if mark.unit.endswith(PER_MM)]
        kept = [m for each in one.project.chapters for m in Accuracy.of(each).kept(one.project)]
        for mark in (*scales, *kept, *one.sheet_lengths):
            if mark in one.given:
                value = one.given[mark]
                found[one.board, *mark.key] = common(value) if mark in scales else value
    return found


def draw(
    scene: Scene, scales: Pinned, enlarged: float = 1.0, pole: float = 1.0
) -> tuple[Project, ...]:
    """Record what a scene calls for, with the scales that are pinned, ``enlarged`` times as large.

    All that is given is in each `Project`. ``pole``: how many times farther the poles of graphs stand.

    Raises
    ------
    TmmError
        If the scene cannot be drawn so.
    """
    boards = own_boards(scene)
    if draws_mechanism(scene, boards):
        boards = (MECHANISM, *boards)
    found = (on_board(scene, board, scales) for board in boards)
    moved = (_farther(one, pole) if pole != 1.0 else one for one in found)
    return tuple(_enlarged(one, enlarged) if enlarged != 1.0 else one for one in moved)


def on_board(
    scene: Scene, board: str, scales: Pinned, wanted: frozenset[str] | None = None
) -> Project:
    """Record what a scene calls for on one board, or of that what is ``wanted``; see `draw`."""
    project = record(scene, board, wanted)
    given = _pin(project, scales)
    if missing := [mark for mark in project.construction.given if mark not in given]:
        reach = reach_of(project, doubted(project) if board == MECHANISM else Doubts((), {}))
        free = chosen(project, usual(scene), reach)[0]
        given |= {mark: free.get(mark, 1.0) for mark in missing}
    return replace(project, given=given)


def tried(project: Project) -> dict[Mark, Trial]:
    """Return what the refinements of a project try, by the mark that each leaves."""
    found: dict[Mark, Trial] = {}
    for chapter in project.chapters:
        found |= Accuracy.of(chapter).tried(project)
    return found


def _pin(project: Project, scales: Pinned) -> dict[Mark, object]:
    """Return what is given with the pinned scales; what is drawn pass after pass has those of the last one."""
    last = {view.name: view.last for view in project.construction.views}
    given = dict(project.given)
    for mark in project.construction.given:
        view, letter = mark.key
        for name in (last.get(view, view), view):
            if (project.board, name, letter) in scales:
                given[mark] = scales[project.board, name, letter]
    return given


def _farther(project: Project, times: float) -> Project:
    """Return the same with pole distances multiplied by a factor."""
    given = dict(project.given)
    for chapter in project.chapters:
        given |= Accuracy.of(chapter).farther(project, times)
    return replace(project, given=given)


def _enlarged(project: Project, times: float) -> Project:
    """Return the same larger: every length and point given in mm, and every μ by so much finer."""

    def sized(mark: Mark, value: object) -> object:
        if mark.kind in (Length, Point):
            return np.asarray(value) * times
        return np.asarray(value) / times if mark.unit.endswith(PER_MM) else value

    return replace(project, given={mark: sized(mark, v) for mark, v in project.given.items()})


TURN = 192
"""Positions among which the largest value of a turn is looked for."""


class References:
    """The true values of a scene's quantities, each computed once."""

    def __init__(self, scene: Scene, scales: Pinned) -> None:
        self.scene, self.scales = scene, scales
        self._known: dict[tuple[str, int], Reals | None] = {}
        self._largest: dict[tuple[str, str], float] = {}
        self._turn: dict[str, Project] | None = None

    def of(self, quantity: Quantity, drawing: Project) -> Reals | None:
        """Return the true quantity, (1, value); None without an independent reference."""
        if quantity.due:
            reading = execute(drawing.construction, drawing.given, quantity.due_marks)
            return quantity.read(reading, 1, due=True)
        key = quantity.name, quantity.row
        if key not in self._known:
            told = quantity.reference
            found = self._find(quantity, told, drawing.board) if told is not None else None
            self._known[key] = found
        return self._known[key]

    def largest(self, quantity: Quantity, drawing: Project) -> float:
        """Return the largest value of the quantity over the turn; NaN if unknown."""
        key = drawing.board, quantity.name
        if key not in self._largest:
            fine = self._row(quantity, drawing) if quantity.row else None
            due = self.of(quantity, drawing) if fine is None else fine
            size = np.abs(due) if due is not None else np.array([np.nan])
            self._largest[key] = float(np.max(size, initial=0.0, where=np.isfinite(size)))
        return self._largest[key]

    def _row(self, quantity: Quantity, drawing: Project) -> Reals | None:
        """Return what a quantity should be at the positions of a fine row."""
        if self._turn is None:
            scene = at_count(self.scene, TURN)
            turn = draw(scene, self.scales) if scene is not None else ()
            self._turn = {one.board: one for one in turn}
        one = self._turn.get(drawing.board)
        same = (q for q in with_affected(one) if q.name == quantity.name) if one is not None else ()
        return next((self.of(found, one) for found in same if one is not None), None)

    def _find(self, quantity: Quantity, told: Reference, board: str) -> Reals | None:
        row = at_count(self.scene, told.count or quantity.row or self.scene.row.count)
        scene = told.scene(row) if row is not None else None
        if scene is None:
            return None
        try:
            drawn = on_board(scene, board, self.scales, told.places)
        except TmmError:
            return None
        name = told.name or quantity.name
        found = next((one for one in quantities(drawn) if one.name == name), None)
        if found is None:
            return None
        reading = execute(drawn.construction, drawn.given, found.marks)
        return found.read(reading, 1) * told.by
