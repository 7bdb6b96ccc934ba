"""The ways in which a scene may be drawn: what each costs at the board, how far it is expected to be off.

What may vary: the number of parts of each board (positions that the scene names keep their places), the method
where the scene leaves it free, the ruler, the hand where a better one draws, the size of the drawing. A log is
recorded and tried once for each division and method; what any hand does with it follows (`response`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from math import log2

import numpy as np

from graphic_tmm.accuracy.drawing import References, on_board
from graphic_tmm.accuracy.measure import work_of
from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, quantities
from graphic_tmm.accuracy.response import Drawing, Response, responses
from graphic_tmm.accuracy.settings import GRID, POSITIONS, dividing, own_parts
from graphic_tmm.accuracy.words import WORDS, counted
from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import hand_of
from graphic_tmm.errors import TmmError
from graphic_tmm.language.numbers import number
from graphic_tmm.project import own_boards
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.drawing import DIVISIONS
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import draws_mechanism

COUNTS = (4, 6, 8, 10, 12, 16, 18, 24, 36, 48)
"""Numbers of positions that are tried."""
FEW = 4
"""So many values are tried of an axis of a board of its own: the least of them."""
SIZES = (1.0, 1.25, 1.6, 2.0, 2.5)
"""How many times as large a drawing is tried."""
RULERS = (0.5, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Divisions of rulers that are tried, mm; what is read off a ruler of whole mm is read to halves."""
PACE = {"exact": 1.0, "student": 1.0, "careful": 1.5, "cad": 2.0}
"""Minutes of a hand for those of a practised draughtsman. Estimates: a careful one places each edge twice, in
CAD every line takes a command, two snaps and a number."""
HALF = 1.1
"""Minutes where the ruler's division is half as large: tenths are read by the eye. An estimate."""
Changes = tuple[tuple[str, str], ...]
"""Axes, each with the value that it is put to."""


@dataclass(frozen=True)
class BoardWay:
    """One way to divide and draw a board: minutes at the board, how its quantities answer to slips."""

    changes: Changes
    minutes: float
    answers: Mapping[str, Response]


@dataclass(frozen=True)
class Way:
    """A way in which a scene may be drawn: ``minutes`` at the board, ``errors`` expected, % by quantity.

    ``boards``: what the axes of each board are put to, also where that is as in the scene; ``ruler``: its
    division, mm; ``times``: how many times as large as the scene is drawn.
    """

    boards: tuple[Changes, ...]
    hand: str
    ruler: float | None
    times: float
    minutes: float
    errors: Mapping[str, float]

    @property
    def changes(self) -> Changes:
        """What all axes are put to."""
        return tuple(one for changes in self.boards for one in changes)

    @property
    def worst(self) -> float:
        """The largest error, %."""
        return worst(self.errors)

    def of(self, scene: Scene) -> Scene:
        """Return the scene drawn so, but for its size."""
        return replace(changed(scene, self.changes), hand=self.hand, ruler=self.ruler)

    def sentence(self, own: Way, language: str) -> str:
        """Return the way in words: numbers of parts, and what else is not as in the ``own`` one."""
        words, divided = WORDS[language], dividing()
        parts = [counted(int(v), axis, language) for axis, v in self.changes if axis in divided]
        parts += [words[v] for axis, v in self.changes if axis not in divided]
        if self.hand != own.hand:
            parts.append(words[f"by {self.hand}"])
        usual = own.ruler if self.hand == own.hand else DIVISIONS[self.hand]
        if self.ruler is not None and self.ruler != usual:
            parts.append(words["by ruler"].format(ruler=number(self.ruler, language)))
        if self.times != 1.0:
            parts.append(words["budget size"].format(times=number(self.times, language)))
        return ", ".join(parts)


def worst(errors: Mapping[str, float]) -> float:
    """Return the largest error; without end if one of them is not known, or there is none."""
    return max((float("inf") if np.isnan(e) else e for e in errors.values()), default=float("inf"))


def changed(scene: Scene, changes: Changes) -> Scene:
    """Return the scene with its axes put to values."""
    for name, value in changes:
        scene = dict(_axis(name).scenes(scene))[value]
    return scene


def _axis(name: str) -> Axis:
    every = (axis for one in chapters() for axis in Accuracy.of(one).axes)
    return next(axis for axis in (POSITIONS, *every) if axis.name == name)


def wanted(scene: Scene, quantity: Quantity) -> bool:
    """Whether the sheets of a scene show a quantity."""
    return not quantity.places or bool(scene.called & set(quantity.places))


class Ways:
    """All ways of one scene, from the cheapest on; ``own``: as the scene says.

    ``references``: the true values, to the scales of the scene as it is drawn. ``minutes``: a user's own table.
    """

    def __init__(
        self, scene: Scene, references: References, minutes: Mapping[str, float] | None = None
    ) -> None:
        self.scene, self.references, self._minutes = scene, references, minutes
        boards = [MECHANISM] if draws_mechanism(scene, own_boards(scene)) else []
        self.parts = [row for b in (*boards, *own_boards(scene)) if (row := self._parts(b))]
        self.every = tuple(sorted(self._ways(), key=_order)) if self.parts else ()

    def _parts(self, board: str) -> list[BoardWay]:
        """Return the parts of a board; the scene's own first; none if nothing there can be told."""
        own = self._part(board, self._own_changes(board))
        if own is None:
            return []
        by = (hand_of(self.scene), EXACT)
        free = dict.fromkeys((self._own_free(board), *(self._best(board, own, who) for who in by)))
        rows = [own]
        divided = [_values(self.scene, board, name) for name, _ in self._own_divided(board)]
        for divisions in product(*divided):
            for methods in free:
                if (changes := (*divisions, *methods)) != own.changes:
                    part = self._part(board, changes)
                    rows += [part] if part is not None else []
        return rows

    def _own_divided(self, board: str) -> Changes:
        return tuple(
            (name, str(own_parts(self.scene, name)))
            for name, axis in dividing().items()
            if _board(name) == board and any(True for _ in axis.scenes(self.scene))
        )

    def _own_free(self, board: str) -> Changes:
        """Return what the axes that may be chosen freely are put to in the scene."""
        found = []
        for axis in _free(board):
            values = [value for value, scene in axis.scenes(self.scene) if scene == self.scene]
            found += [(axis.name, value) for value in values[:1]]
        return tuple(found)

    def _own_changes(self, board: str) -> Changes:
        return (*self._own_divided(board), *self._own_free(board))

    def _best(self, board: str, own: BoardWay, who: Hand) -> Changes:
        """Return each free axis at the value with the least error of what it bears on, others as they are."""
        found, divided, drawn = [], self._own_divided(board), [Drawing(who)]
        methods = dict(self._own_free(board))
        for axis in _free(board):
            if axis.name not in methods:
                continue
            bears = axis.bears(self.scene)
            best, least = methods[axis.name], _error(own, bears, drawn)
            for value, _ in axis.scenes(self.scene):
                other = (*divided, *{**methods, axis.name: value}.items())
                part = self._part(board, other) if other != own.changes else own
                if part is not None and _error(part, bears, drawn) < least:
                    best, least = value, _error(part, bears, drawn)
            found.append((axis.name, best))
        return tuple(found)

    def _part(self, board: str, changes: Changes) -> BoardWay | None:
        """Record a board with its axes so; None if it cannot be drawn, or nothing of it can be told."""
        try:
            scene = changed(self.scene, changes)
            drawing = on_board(at_all_positions(scene), board, self.references.scales)
            sheet = on_board(scene, board, self.references.scales)
        except (KeyError, TmmError):
            return None
        there = [q for q in quantities(drawing) if wanted(scene, q)]
        answers = responses(drawing, there, self.references)
        if not answers:
            return None
        marks = [mark for q in quantities(sheet) if wanted(scene, q) for mark in q.marks]
        return BoardWay(changes, work_of(sheet, marks, self._minutes).minutes, answers)

    def by_count(self, who: Hand) -> dict[int, float]:
        """Return the error that is expected of a hand, %, by the number of parts of the first board divided."""
        divided = dividing()
        rows = (row for row in self.parts if any(name in divided for name, _ in row[0].changes))
        found, row = {}, next(rows, [])
        for part in row:
            counts = [int(value) for name, value in part.changes if name in divided]
            fixed = [one for one in part.changes if one[0] not in divided]
            if all(one in row[0].changes for one in fixed):
                errors = _errors(part, [Drawing(who)])
                found[counts[0]] = worst({name: float(each[0]) for name, each in errors.items()})
        return found

    def _ways(self) -> Iterator[Way]:
        drawn = list(_drawings(self.scene))
        by = [Drawing(who, times) for _, who, times in drawn]
        errors = [[_errors(part, by) for part in row] for row in self.parts]
        paces = [pace(name, who.ruler) for name, who, _ in drawn]
        for places in product(*(range(len(row)) for row in self.parts)):
            parts = [row[k] for row, k in zip(self.parts, places, strict=True)]
            changes = tuple(part.changes for part in parts)
            finer = any(_finer(part, row[0]) for part, row in zip(parts, self.parts, strict=True))
            minutes = sum(part.minutes for part in parts)
            each: dict[str, Reals] = {}
            for row, k in zip(errors, places, strict=True):
                each |= row[k]
            for k, (name, who, times) in enumerate(drawn):
                if finer and times > 1.0:
                    continue  # more positions need the room that the sheets have
                mine = {quantity: float(of[k]) for quantity, of in each.items()}
                yield Way(changes, name, who.ruler, times, minutes * paces[k], mine)

    @cached_property
    def own(self) -> Way:
        """The scene as it is."""
        key = tuple(row[0].changes for row in self.parts), self.scene.hand, self.scene.ruler, 1.0
        return next(w for w in self.every if (w.boards, w.hand, w.ruler, w.times) == key)


def _finer(part: BoardWay, own: BoardWay) -> bool:
    """Whether a part is divided finer than that of the scene."""
    divided, there = dividing(), dict(own.changes)
    return any(int(v) > int(there[axis]) for axis, v in part.changes if axis in divided)


def _order(way: Way) -> tuple[float, float, float]:
    return way.minutes, way.times, way.worst


def _errors(part: BoardWay, drawn: Sequence[Drawing]) -> dict[str, Reals]:
    return {name: answer.errors(drawn) for name, answer in part.answers.items()}


def _error(part: BoardWay, names: Sequence[str], drawn: Sequence[Drawing]) -> float:
    return worst({k: float(e[0]) for k, e in _errors(part, drawn).items() if k in names})


def pace(hand: str, ruler: float | None) -> float:
    """Return minutes of a hand with a ruler, for one of a practised draughtsman."""
    usual = DIVISIONS[hand]
    return float(PACE[hand] * HALF ** (log2(usual / ruler) if ruler is not None else 0.0))


def _drawings(scene: Scene) -> Iterator[tuple[str, Hand, float]]:
    """Yield who may draw, and how large: the scene's hand with any ruler, a better one with its own.

    In CAD nobody chooses a ruler.
    """
    on_paper = scene.ruler is not None and scene.hand != "cad"
    rulers = dict.fromkeys((scene.ruler, *RULERS)) if on_paper else (scene.ruler,)
    hands = [(scene.hand, hand_of(scene)._replace(ruler=ruler)) for ruler in rulers]
    if HANDS[scene.hand].slips and scene.hand in GRID:
        better = GRID[1 : GRID.index(scene.hand)]
        hands += [(name, HANDS[name]._replace(seed=scene.seed)) for name in reversed(better)]
    for (name, who), times in product(hands, SIZES):
        yield name, who, times


def _board(axis: str) -> str:
    if axis == POSITIONS.name:
        return MECHANISM
    return next(c.board for c in chapters() for a in Accuracy.of(c).axes if a.name == axis)


def _free(board: str) -> list[Axis]:
    return [a for c in chapters(board) for a in Accuracy.of(c).axes if a.free]


def _values(scene: Scene, board: str, name: str) -> list[tuple[str, str]]:
    """Return the values of an axis that are tried, with those of the scene itself."""
    own, there = own_parts(scene, name), [v for v, _ in _axis(name).scenes(scene)]
    if name == POSITIONS.name:
        return [(name, v) for v in there if int(v) in (*COUNTS, own)]
    return [(name, v) for v in there if int(v) == own or there.index(v) < FEW]
