"""What the effects of a scene cost, and what they change: the scene drawn with each and without it.

An effect is something that a scene could leave out: weights, inertia, friction, a load. What it costs is what
the log, the board and the machine have less without it. What it changes is told by the exact hand, and held
against the error of the drawing itself, by the hand that draws: a change below that error is not to be seen.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.drawing import Pinned, References, draw, pinned
from graphic_tmm.accuracy.effects.effect_costs import Cost, cost_of, seconds_apart, seconds_of
from graphic_tmm.accuracy.measure import NOISE, off
from graphic_tmm.accuracy.quantities import Accuracy, Effect, Quantity, with_affected
from graphic_tmm.accuracy.settings import hand_named, own_setting
from graphic_tmm.accuracy.timing import Load, Stopwatch
from graphic_tmm.board.execute import execute, prepare
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import segment_name
from graphic_tmm.board.values import Reals
from graphic_tmm.errors import TmmError
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

PENCIL = "student"
"""The hand whose error is told, too, where the scene's own does not slip."""
LEVEL = 1.0 - 1e-9
"""Changes in this ratio are the same: the first of them is told, whatever the last bits say."""
DRAWINGS = 100
"""Default number of drawings by a hand that slips."""


class Change(NamedTuple):
    """How a result changes without an effect: at most by ``percent`` of its largest value in the turn.

    ``segment``: which of several values of the quantity does; ``position``: where; both "" where there is one
    only. ``error``: of the drawing, % of the same largest value, by the hand that draws; ``pencil``: by a
    student, None where that is the same. NaN where it is not known.
    """

    quantity: str
    segment: str
    position: str
    percent: float
    error: float
    pencil: float | None

    @property
    def seen(self) -> bool:
        """Whether it stands out of the drawing's own error."""
        return not self.percent <= self.error

    @property
    def seen_by_pencil(self) -> bool:
        """Whether it stands out of a student's error."""
        return not self.percent <= (self.error if self.pencil is None else self.pencil)


@dataclass(frozen=True)
class Weighed:
    """An effect: what it costs and changes; ``refused``: why the scene cannot do without it, "" if it can.

    ``unsure``: seconds below this are not told from nothing.
    """

    name: str
    called: bool
    cost: Cost
    changes: tuple[Change, ...] = ()
    refused: str = ""
    unsure: float = 0.0

    @property
    def percent(self) -> float:
        """The largest change; 0 if nothing changes."""
        return max((one.percent for one in self.changes), default=0.0)

    @property
    def worth(self) -> bool:
        """Whether it changes anything above the drawing's own error."""
        return any(one.seen for one in self.changes)

    @property
    def worth_pencil(self) -> bool:
        """Whether it changes anything above a student's error."""
        return any(one.seen_by_pencil for one in self.changes)


class Hidden(NamedTuple):
    """Effects that can be left out together without being seen, by name; whether they are ``all`` of the small.

    ``weighed``: what they cost and change together; its time is not measured.
    """

    names: tuple[str, ...]
    weighed: Weighed
    all: bool


@dataclass(frozen=True)
class EffectStudy:
    """All effects of a scene; ``whole``: the cost of the scene with all of them.

    ``hand``: that draws; ``pencil``: whether the student's error is told besides; ``names``: of the quantities;
    ``effects``: that of the largest change first, those not called for last. ``hidden``: what the drawing's own
    error hides, and what a student's does; None where that are not several effects.
    ``load``: what else the machine did; None if nothing was timed.
    """

    scene: Scene
    hand: str
    pencil: bool
    trials: int
    whole: Cost
    names: tuple[str, ...]
    effects: tuple[Weighed, ...]
    hidden: Hidden | None = None
    hidden_by_pencil: Hidden | None = None
    load: Load | None = None


class _Result(NamedTuple):
    """A quantity as it is with everything: its values by letter (value, position), its errors in %."""

    quantity: Quantity
    drawing: Project
    values: Mapping[str, Reals]
    largest: float
    error: float
    pencil: float | None


def study_effects(
    scene: Scene,
    *,
    hand: str | None = None,
    trials: int = DRAWINGS,
    minutes: Mapping[str, float] | None = None,
    clock: bool = True,
    tell: Callable[[int, int, str], None] = lambda done, of, name: None,
) -> EffectStudy:
    """Draw a scene with each of its effects and without it.

    ``hand``, ``trials``: whose error, of how many drawings; ``minutes``: of elementary operations; ``clock``:
    whether runs are timed; ``tell``: is called with the number of effects done, their total, and the next.
    """
    own = own_setting(scene, hand, trials)
    pencil = None if own.who.slips else hand_named(PENCIL, scene, trials)
    scales = pinned(make(scene, exact=True))
    drawings = draw(scene, scales)
    found = effects(scene, drawings)
    tell(0, len(found) + 1, "")
    references = References(at_all_positions(scene), scales)
    results = [
        result for drawing in drawings for result in _results(drawing, references, own.who, pencil)
    ]
    watch = Stopwatch() if clock else None
    weigh = partial(_weighed, scene, drawings, results, scales, minutes, watch)
    weighed = []
    for k, effect in enumerate(found):
        tell(k + 1, len(found) + 1, effect.name)
        weighed.append(weigh(effect))
    there = [
        one for one in zip(found, weighed, strict=True) if one[1].called and not one[1].refused
    ]
    untimed = partial(_weighed, scene, drawings, results, scales, minutes, None)
    small = [(effect, one) for effect, one in there if not one.worth]
    faint = [(effect, one) for effect, one in there if not one.worth_pencil]
    whole = cost_of(drawings, minutes)._replace(
        seconds=None if watch is None else seconds_of(drawings, watch)
    )
    names = tuple(result.quantity.name for result in results)
    ranked = tuple(sorted(weighed, key=lambda one: (not one.called, -one.percent)))
    return EffectStudy(
        scene,
        own.hand,
        pencil is not None,
        trials,
        whole,
        names,
        ranked,
        _unseen(small, untimed, lambda one: one.worth),
        _unseen(faint, untimed, lambda one: one.worth_pencil),
        None if watch is None else watch.load,
    )


def _unseen(
    small: Sequence[tuple[Effect, Weighed]],
    weigh: Callable[[Effect], Weighed],
    worth: Callable[[Weighed], bool],
) -> Hidden | None:
    """Return effects that are not seen each by itself, as many as can be left out together unseen.

    From the least on each is left out beside those before it, unless that would be seen or cannot be drawn.
    """
    if len(small) < 2:
        return None
    least = sorted(small, key=lambda one: one[1].percent)
    kept, found = [least[0][0]], least[0][1]
    for effect, _ in least[1:]:
        beside = weigh(_together([*kept, effect]))
        if not beside.refused and not worth(beside):
            kept, found = [*kept, effect], beside
    return Hidden(tuple(effect.name for effect in kept), found, len(kept) == len(small))


def effects(scene: Scene, drawings: Sequence[Project]) -> tuple[Effect, ...]:
    """Return the effects of the chapters that are drawn; one of several chapters is left out of all of them."""
    drawn = {name for drawing in drawings for name in drawing.recorded}
    named: dict[str, list[Effect]] = {}
    for chapter in chapters():
        if chapter.name in drawn:
            for effect in Accuracy.of(chapter).effects(scene):
                named.setdefault(effect.name, []).append(effect)
    return tuple(_together(same) for same in named.values())


def _together(same: Sequence[Effect]) -> Effect:
    def without(scene: Scene) -> Scene:
        for effect in same:
            scene = effect.without(scene)
        return scene

    return Effect(same[0].name, without, any(effect.called for effect in same))


def _weighed(
    scene: Scene,
    drawings: Sequence[Project],
    results: Sequence[_Result],
    scales: Pinned,
    minutes: Mapping[str, float] | None,
    watch: Stopwatch | None,
    effect: Effect,
) -> Weighed:
    try:
        rest = draw(effect.without(scene), scales)
    except TmmError as error:
        return Weighed(
            effect.name,
            effect.called,
            Cost(0, 0.0, None),
            refused=(error.__cause__ or error).args[0],
        )
    more = cost_of(drawings, minutes).less(cost_of(rest, minutes))
    unsure = 0.0
    if watch is not None:
        seconds, unsure = seconds_apart(drawings, rest, watch)
        more = more._replace(seconds=seconds)
    changes = (_change(result, rest) for result in results)
    kept = tuple(one for one in changes if one is not None)
    return Weighed(effect.name, effect.called, more, kept, unsure=unsure)


def _results(
    drawing: Project, references: References, who: Hand, pencil: Hand | None
) -> Iterator[_Result]:
    """Yield every quantity of a drawing as it is, and the drawing's own errors of it."""
    asked = with_affected(drawing)
    marks = [mark for quantity in asked for mark in quantity.marks]
    program = prepare(drawing.construction, marks)
    hands = [one for one in (who, pencil) if one is not None]
    drawn = [(program.run(drawing.given, hand=one), one.trials) for one in hands]
    for quantity in asked:
        due, largest = references.of(quantity, drawing), _largest(quantity, drawing, references)
        errors = [math.nan] * len(drawn)
        if due is not None:
            errors = [off(quantity.read(one, n), due, largest).error for one, n in drawn]
        values = _values(quantity, drawing)
        yield _Result(quantity, drawing, values, largest, errors[0], (*errors[1:], None)[0])


def _largest(quantity: Quantity, drawing: Project, references: References) -> float:
    """Return the largest value of the turn; of the positions drawn, where a finer row cannot be drawn."""
    try:
        found = references.largest(quantity, drawing)
    except TmmError:
        found = math.nan
    if math.isfinite(found):
        return found
    value = quantity.read(execute(drawing.construction, drawing.given, quantity.marks), 1)
    return float(np.max(np.abs(value), initial=0.0, where=np.isfinite(value)))


def _values(quantity: Quantity, drawing: Project) -> dict[str, Reals]:
    """Return the values of a quantity by the exact hand, by letter; a single one has none."""
    reading = execute(drawing.construction, drawing.given, quantity.marks)
    names = [value.mark.letter for value in quantity.values] if len(quantity.values) > 1 else [""]
    each = (quantity._replace(values=(value,)) for value in quantity.values)
    return dict(zip(names, (one.read(reading, 1)[0] for one in each), strict=True))


def _change(result: _Result, rest: Sequence[Project]) -> Change | None:
    """Return what becomes of a result in the drawings without an effect; None if it stays, or is gone."""
    same = (drawing for drawing in rest if drawing.board == result.drawing.board)
    there = ((one, drawing) for drawing in same for one in with_affected(drawing))
    found = next(((q, d) for q, d in there if q.name == result.quantity.name), None)
    if found is None or not result.largest > 0.0:
        return None
    values, best = _values(*found), (0.0, "", 0)
    for letter in (one for one in result.values if one in values):
        apart = np.abs(result.values[letter] - values[letter])
        apart = np.where(np.isfinite(apart), apart, 0.0)
        if apart.max() * LEVEL > best[0]:
            best = float(apart.max()), letter, int(np.argmax(apart >= apart.max() * LEVEL))
    apart_most, letter, place = best
    percent = 100.0 * apart_most / result.largest
    if not percent > NOISE:
        return None
    at = result.quantity.position(place)
    position = result.drawing.names[at] if result.quantity.row else ""
    told = segment_name(letter), position, percent, result.error, result.pencil
    return Change(result.quantity.name, *told)
