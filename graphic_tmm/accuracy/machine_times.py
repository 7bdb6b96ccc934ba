"""Seconds on the machine of what a user asks for: one run of the log, the table, the sheets, many drawings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from math import log2
from typing import NamedTuple

from graphic_tmm.accuracy.measure import Measure
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.settings import Setting, hand_named, is_long, own_parts, rows
from graphic_tmm.accuracy.timing import Seconds, Stopwatch
from graphic_tmm.board.execute import Program, prepare
from graphic_tmm.board.hand import Hand
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.composition import Composition, composition_file, read_composition
from graphic_tmm.paper.compose.search import forget
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.readers.table import WIDTH, table
from graphic_tmm.readers.text import Framed
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, sheet_files

LOG, TABLE, SHEETS, DRAWINGS = "log", "table", "sheets", "drawings"
"""What is timed: the log of all quantities by the exact hand; what `table` prints; what `draw` writes as SVG,
without writing it; `SCALED` drawings of all quantities by a student."""
DRAWN, SCALED = 1000, 10_000
"""Drawings that are timed, and to which that is scaled, to 15 % (tests/benchmarks/times_under_load)."""
DEAR = 0.1
"""What takes longer, s, is called once only at other numbers of positions than the scene's, and marked."""


class MachineTime(NamedTuple):
    """Seconds of one thing that a user asks for, at a number of positions (or of whatever a drawing has)."""

    what: str
    positions: int
    seconds: Seconds


def machine_times(
    scene: Scene, measure: Measure, watch: Stopwatch, *, around: bool = True
) -> tuple[MachineTime, ...]:
    """Return the seconds at the scene's own number of positions.

    ``around``: at about half and twice of it, too. What cannot be drawn is left out.
    """
    given = read_composition(composition_file(scene.source))
    own, others = _counts(scene)
    found = watch.in_turns(dict(_calls(scene, own, measure, given)))
    dear = {what for (what, _), seconds in found.items() if seconds.least > DEAR}
    more = {
        key: call
        for count, changed in (others if around else ())
        for key, call in _calls(changed, count, measure, given)
    }
    found |= watch.in_turns({key: call for key, call in more.items() if key[0] not in dear})
    found |= watch.once({key: call for key, call in more.items() if key[0] in dear})
    return tuple(
        MachineTime(what, count, seconds.times(SCALED / DRAWN if what == DRAWINGS else 1.0))
        for (what, count), seconds in sorted(found.items(), key=lambda one: _order(*one[0]))
    )


def _order(what: str, count: int) -> tuple[int, int]:
    return (LOG, TABLE, SHEETS, DRAWINGS).index(what), count


def _counts(scene: Scene) -> tuple[int, tuple[tuple[int, Scene], ...]]:
    """Return a scene's own number of positions, and the scene with about half and about twice as many."""
    for axis, divided in rows(scene):
        own = own_parts(scene, axis)
        there = {int(value): one for value, one in divided if not is_long(axis, value)}
        near = (min(there, key=partial(_apart, times * own)) for times in (0.5, 2.0))
        return own, tuple((n, there[n]) for n in near if 2.0 * _apart(own, n) >= 1.0)
    return scene.row.count, ()


def _apart(one: float, other: float) -> float:
    """Return how many times two numbers differ by a factor of two."""
    return abs(log2(one / other))


def _calls(
    scene: Scene, count: int, measure: Measure, given: Composition | None
) -> Iterator[tuple[tuple[str, int], Callable[[], object]]]:
    """Yield what is timed of a scene; each call draws it anew, with nothing kept from the one before."""
    full = at_all_positions(scene)
    exact, student = hand_named("exact", full, 1), hand_named("student", full, DRAWN)
    with suppress(TmmError):
        logs = [(d, quantities(d)) for d in measure.drawings(Setting(full, "exact", exact))]
        slices = [
            (prepare(drawing.construction, [m for q in asked for m in q.marks]), drawing)
            for drawing, asked in logs
            if asked
        ]
        yield (LOG, count), partial(_run, slices, exact)
        yield (DRAWINGS, count), partial(_run, slices, student)
    yield (TABLE, count), lambda: _table(make(_anew(scene), given=given))
    yield (SHEETS, count), lambda: sheet_files(_anew(scene), given=given)


def _anew(scene: Scene) -> Scene:
    """Return a scene of which nothing has been kept."""
    forget()
    return replace(scene)


def _run(slices: Sequence[tuple[Program, Project]], hand: Hand) -> None:
    for program, drawing in slices:
        program.run(drawing.given, hand=hand)


def _table(made: DrawnScene) -> list[str | None]:
    """Return the tables of a scene as they are printed."""
    return [one.plain(WIDTH) for one in table(made, "text") if isinstance(one, Framed)]
