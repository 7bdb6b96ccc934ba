"""The answer first: how far a drawing is off, what would halve that, what is not worth its cost.

``worst`` is the quantity that errs most, ``main`` the last one that the drawing is made for. All errors are
those that nine readings of ten keep within, in % of the largest value of the turn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import isfinite
from typing import NamedTuple

from graphic_tmm.accuracy.budget import Measured, Taken, Tell, cheapest, in_the_way, nearest_way
from graphic_tmm.accuracy.drawing import draw
from graphic_tmm.accuracy.machine_times import MachineTime, machine_times
from graphic_tmm.accuracy.quantities import Accuracy, quantities
from graphic_tmm.accuracy.sources import Sources, sources
from graphic_tmm.accuracy.timing import Load, Stopwatch
from graphic_tmm.accuracy.ways import Way, wanted, worst
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.drawn import hand_of
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.drawing import DIVISIONS
from graphic_tmm.scene.records import Scene

PARTS = 5
"""Parts of the work."""
ROWS = 12
"""Settings in the table at the most."""
BETTER = 0.97
"""A row of the front leaves no more than this share of the error of that before it."""
HALF = 0.5
"""The share of the error that is sought."""
DEARER, WASTED = 1.1, 0.9
"""A setting that costs by this factor more and leaves this share of the error or more is not worth it."""
STUDENT = "student"
"""The hand at the board of a scene whose own leaves nothing to chance: nobody draws so."""


class MeasuredWay(NamedTuple):
    """A way and its errors as measured, % by quantity."""

    way: Way
    errors: Mapping[str, float]

    @property
    def worst(self) -> float:
        """The largest error, %."""
        return worst(self.errors)


@dataclass(frozen=True)
class Origin:
    """Where the errors of a board's quantities come from, by a hand; with the log and its exact numbers.

    ``wanted``: the quantities that the sheets show, ``of`` those that have an error.
    """

    hand: str
    project: Project
    reading: Reading
    wanted: tuple[str, ...]
    of: Mapping[str, Sources]


@dataclass(frozen=True)
class Answer:
    """What accuracy costs in a scene, in short.

    ``scene``: by the hand at the board. ``own``: the scene as it is, by that hand, without what is ``lost``
    in too many drawings to have an error, and what has no true value here: ``unjudged``; ``printed``: its
    errors by the scene's own hand, None if that is the same. ``halved``: the cheapest way with half the
    error, None if there is none: ``nearest`` then. ``wasted``: a dearer way that brings next to nothing.
    ``ways``: all, with their expected errors. ``rows``: the front, the cheapest first, and the scene itself;
    ``knee``: the row where the front bends, farthest below the straight line between its ends. ``origins``:
    by the hand at the board, then by the scene's own. ``counts``: the error expected as printed and at the
    board, by the number of positions. ``machine``: seconds of what a user asks for, ``load``: what else the
    machine did then, None if nothing was timed.
    """

    scene: Scene
    own: MeasuredWay
    lost: tuple[str, ...]
    unjudged: tuple[str, ...]
    printed: Mapping[str, float] | None
    halved: Taken | None
    nearest: tuple[MeasuredWay, str] | None
    wasted: MeasuredWay | None
    ways: tuple[Way, ...]
    rows: tuple[MeasuredWay, ...]
    knee: MeasuredWay
    origins: tuple[Origin, ...]
    counts: Mapping[int, tuple[float, float]]
    machine: tuple[MachineTime, ...] = ()
    load: Load | None = None

    @property
    def worst(self) -> str:
        """The quantity that errs most."""
        return max(self.own.errors, key=lambda name: self.own.errors[name])

    @property
    def main(self) -> str:
        """The quantity that the drawing is made for: the last constructed, but for those that compare ways."""
        compared = {name for one in chapters() for name in Accuracy.of(one).compared}
        names = [*self.own.errors]
        return [name for name in names if name not in compared or {*names} <= compared][-1]

    def origin(self, name: str) -> Origin | None:
        """Return where the error of a quantity comes from: by the hand at the board."""
        return next((one for one in self.origins if name in one.of), None)


def answer(
    scene: Scene,
    minutes: Mapping[str, float] | None = None,
    watch: Stopwatch | None = None,
    tell: Tell | None = None,
    *,
    around: bool = True,
    literal: bool = False,
) -> Answer:
    """Weigh the ways of drawing a scene, by a student where its own hand leaves nothing to chance.

    ``minutes``: a user's own table of minutes. ``watch``: what times the machine, nothing if None; ``around``:
    not at the scene's number of positions only. ``tell`` is called with the number of parts done, of how many.
    ``literal``: by the scene's own hand whatever it is.

    Raises
    ------
    SceneError
        If the scene has no quantity whose error can be measured.
    """
    on_the_way = tell or (lambda done, of, name: None)
    on_the_way(0, PARTS, "")
    own_hand, own_ruler = scene.hand, scene.ruler
    if not (literal or HANDS[scene.hand].slips):
        scene = replace(scene, hand=STUDENT, ruler=DIVISIONS[STUDENT])
    measured = Measured(scene, minutes)
    on_the_way(1, PARTS, "")
    if not measured.ways.every:
        raise SceneError(scene.source, (Fault("", 0, nothing(scene)),))
    errors = measured.roughly(measured.ways.own).measured
    known = {name: error for name, error in errors.items() if isfinite(error)}
    own = MeasuredWay(measured.ways.own, known or errors)
    printed, own_who = None, hand_of(replace(scene, hand=own_hand, ruler=own_ruler))
    if scene.hand != own_hand:
        by = replace(measured.ways.own, hand=own_hand, ruler=own_ruler)
        printed = measured.roughly(by).measured
    halved = cheapest(measured, HALF * own.worst)
    near = None
    if halved is None:
        way, drawn, least = nearest_way(measured)
        near = MeasuredWay(way, least), in_the_way(measured, way, drawn, least)
    on_the_way(2, PARTS, "")
    rows = _front(measured, own)
    on_the_way(3, PARTS, "")
    knee = _knee(rows)
    origins = at_the_board = tuple(_origins(measured, scene.hand, hand_of(scene)))
    if printed is not None:
        origins += tuple(_origins(measured, own_hand, own_who))
    as_printed, at_board = (measured.ways.by_count(who) for who in (own_who, hand_of(scene)))
    on_the_way(4, PARTS, "")
    machine = (
        machine_times(scene, measured.measure, watch, around=around) if watch is not None else ()
    )
    return Answer(
        scene,
        own,
        tuple(name for name in errors if name not in own.errors),
        tuple(name for origin in at_the_board for name in origin.wanted if name not in errors),
        printed,
        halved,
        near,
        _wasted(measured, own),
        measured.ways.every,
        rows,
        knee,
        origins,
        {count: (as_printed[count], error) for count, error in at_board.items()},
        machine,
        watch.load if watch is not None else None,
    )


def _front(measured: Measured, own: MeasuredWay) -> tuple[MeasuredWay, ...]:
    """Return the ways none of which is both dearer and less exact than another, and the scene itself."""
    rows, least, expected = list[MeasuredWay](), float("inf"), float("inf")
    for way in measured.ways.every:
        # a ruler without a hand that slips may be lucky: what is expected has to be less, too
        if way.worst < expected and measured.has_room(way.times):
            row = MeasuredWay(way, measured.roughly(way).measured)
            if row.errors and row.worst < BETTER * least:
                rows.append(row)
                least, expected = row.worst, way.worst
    while len(rows) > ROWS - 1:  # what gains least on the one before it goes
        gains = [b.worst / a.worst for a, b in pairwise(rows[:-1])]
        rows.pop(1 + gains.index(max(gains)))
    if all(row.way is not own.way for row in rows):
        rows.append(own)
    return tuple(sorted(rows, key=lambda row: (row.way.minutes, -row.worst)))


def _knee(rows: Sequence[MeasuredWay]) -> MeasuredWay:
    """Return the row farthest below the straight line from the cheapest to the most exact."""
    first, last = rows[0], min(rows, key=lambda row: row.worst)
    x, y = last.way.minutes - first.way.minutes, last.worst - first.worst

    def above(row: MeasuredWay) -> float:
        return (row.worst - first.worst) * x - (row.way.minutes - first.way.minutes) * y

    return min(rows, key=above)


def _wasted(measured: Measured, own: MeasuredWay) -> MeasuredWay | None:
    """Return the dearest way that differs from the scene's in one thing, and is hardly more exact."""
    found: MeasuredWay | None = None
    for way in measured.ways.every:
        if _differences(way, own.way) != 1 or way.minutes < DEARER * own.way.minutes:
            continue
        if way.worst < WASTED * own.way.worst or way.minutes > 2.5 * own.way.minutes:
            continue
        errors = measured.roughly(way).measured
        row = MeasuredWay(way, {k: errors[k] for k in own.errors if k in errors})
        if row.errors and WASTED * own.worst <= row.worst < float("inf"):
            found = row
    return found


def _differences(way: Way, own: Way) -> int:
    changes = dict(own.changes)
    axes = sum(changes[name] != value for name, value in way.changes)
    hand = way.hand != own.hand or way.ruler != own.ruler
    return axes + hand + (way.times != own.times)


def _origins(measured: Measured, name: str, who: Hand) -> Iterator[Origin]:
    """Yield where the errors of the scene as it is come from, by a hand, board by board."""
    scene = measured.scene
    full = at_all_positions(scene)
    for drawing in draw(full, measured.ways.references.scales):
        there = [q for q in quantities(drawing) if wanted(scene, q)]
        if there:
            exact = execute(drawing.construction, drawing.given)
            of = sources(drawing, there, measured.ways.references, who)
            yield Origin(name, drawing, exact, tuple(q.name for q in there), of)


def nothing(scene: Scene) -> str:
    """Return that nothing of a scene has an error that can be measured, and what would have."""
    shown = ", ".join(sorted(scene.called))
    *first, last = (place for one in chapters() for place in Accuracy.of(one).places)
    return said(
        "it calls for {shown}: nothing whose error can be told; place {first} or {last} on a [[sheet]]",
        shown=shown,
        first=", ".join(first),
        last=last,
    )
