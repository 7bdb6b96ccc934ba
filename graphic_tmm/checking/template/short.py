"""A short file to be filled in: the main segments of one position, or what a teacher marks; and what it means.

Main is what is measured on the paper: what is calculated first and laid off then is told, not asked for.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.checking.cells import RESULTS, Cell, Key, cells, pointed, points
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.readings.mending import Names, names_of
from graphic_tmm.checking.readings.names import (
    Meant,
    plan_meant,
    position_meant,
    segment_meant,
)
from graphic_tmm.checking.records import Taken
from graphic_tmm.checking.template.told import explained
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError, printable
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import Said, joined, said

SEEN = 2.0
"""A shorter segment is no good task for a ruler of half millimetres, mm: its reading is a quarter off."""


class Short(NamedTuple):
    """What a short template asks for: its rows, what explains them, the position of each of its plans."""

    rows: tuple[Taken, ...]
    told: tuple[str, ...]
    places: Mapping[str, str]


def short(made: DrawnScene, only: Sequence[str] = (), position: str = "") -> Short:
    """Return a short template of a scene.

    Parameters
    ----------
    only : sequence of str
        What is asked for, each "plan" or "plan:segment,segment", as people spell it; points by their letters.
        Empty: what is measured on the plans of the mechanism, or else whatever is drawn.
    position : str
        Of what; "": that at which the most plans are drawn, and the most segments that can be seen.

    Raises
    ------
    SheetError
        If the scene does not have what is asked for.
    """
    due, spots = cells(made), points(made)
    names = names_of(made, due, spots)
    place = _position(position, due, names)
    wanted = [_marked(one, names) for one in only] or _main(made, due)
    rows: dict[Key, Taken] = {}
    for plan, segments in wanted:
        for segment in segments:
            for key in _there(plan, segment, place, due, spots, bool(position)):
                rows.setdefault(key, _row(key, due))
    if not rows:
        says = said("nothing that is asked for is drawn at position {position}", position=place)
        raise SheetError(says)
    places = {row.plan: row.position for row in rows.values()}
    speech = speaking(made.scene.language)
    told = tuple(map(speech, explained(made, list(rows.values()), due)))
    return Short(tuple(rows.values()), told, places)


def _position(typed: str, due: Mapping[Key, Cell], names: Names) -> str:
    """Return the position that is meant, or at which most plans, and most segments of them, are drawn."""
    there: dict[str, set[str]] = {}
    long: Counter[str] = Counter()
    for (plan, _, name), cell in due.items():
        there.setdefault(name, set()).add(plan)
        long[name] += abs(cell.mm or 0.0) > SEEN
    there.pop("", None)
    if typed:
        found = position_meant(typed, tuple(there))
        if not found.one:
            raise SheetError(_unknown("--position", typed, found, there))
        return found.one
    plans = set(pointed()) & names.segments.keys()
    return max(there, key=lambda name: (len(there[name] & plans), long[name]), default="")


def _marked(typed: str, names: Names) -> tuple[str, tuple[str, ...]]:
    """Return the plan and the segments, or points, that somebody has marked."""
    plan_typed, sign, rest = typed.partition(":")
    plan = plan_meant(plan_typed.strip(), names.plans)
    if not plan.one:
        raise SheetError(_unknown("--only", plan_typed, plan, names.plans))
    known = {**names.points.get(plan.one, {}), **names.segments.get(plan.one, {})}
    if not sign:
        return plan.one, tuple(names.segments.get(plan.one, {})) or tuple(known)
    found = []
    for one in filter(None, (part.strip() for part in rest.split(","))):
        segment = segment_meant(one, plan.one, known)
        if not segment.one:
            raise SheetError(_unknown("--only", one, segment, known))
        found.append(segment.one)
    return plan.one, tuple(found)


def _unknown(option: str, typed: str, found: Meant, known: Iterable[str]) -> Said:
    listed = joined(", ", found.names or tuple(known))
    typed = printable(typed)[:30]
    return said(
        '{option}: what is "{typed}"? There are {known}', option=option, typed=typed, known=listed
    )


def _main(made: DrawnScene, due: Mapping[Key, Cell]) -> list[tuple[str, tuple[str, ...]]]:
    """Return what is measured on the plans of the mechanism; of a scene without, all that is drawn."""
    steps = steps_of(made.mechanism)
    measured: dict[str, dict[str, None]] = {}
    drawn: dict[str, dict[str, None]] = {}
    for (plan, segment, _), cell in due.items():
        if cell.mm is None:
            continue
        drawn.setdefault(plan, {})[segment] = None
        step = steps.get((plan, segment))
        if plan in pointed() and step is not None and step.op.reads:
            measured.setdefault(plan, {})[segment] = None
    found = measured or drawn
    return [(plan, tuple(segments)) for plan, segments in found.items()]


def _there(
    plan: str,
    segment: str,
    place: str,
    due: Mapping[Key, Cell],
    spots: Mapping[Key, complex],
    strict: bool,
) -> Iterator[Key]:
    """Yield the figure of a segment, or the point, at a position; of a plan with others at its first."""
    own = [name for p, s, name in (*due, *spots) if (p, s) == (plan, segment)]
    if place in own:
        yield plan, segment, place
    elif own and (plan == RESULTS or not strict) and plan not in pointed():
        yield plan, segment, own[0]


def _row(key: Key, due: Mapping[Key, Cell]) -> Taken:
    plan, segment, position = key
    cell = due.get(key)
    calculated = cell is not None and cell.mm is None
    return Taken(plan, position, segment, unit=(cell.unit or "1") if cell and calculated else "")
