"""What one hand-in comes to: verdicts counted, plans, causes, and its figures to be compared."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from graphic_tmm.checking.cells import RESULTS, cells, half_of, points
from graphic_tmm.checking.check import Checked
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.records import DOUBTFUL, FINE, UNSEEN, WRONG, Judged, Report, Taken
from graphic_tmm.checking.report.findings import explained, finding, headline, sure
from graphic_tmm.checking.report.findings import summary as counted
from graphic_tmm.checking.template import short
from graphic_tmm.classroom.marks.rule import Faults, Rule
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError

Key = tuple[str, str, str]
"""Plan, segment and position."""
MM, VALUE, SPOT = "mm", "value", "spot"
"""Kinds of figures: a length on paper, a quantity, a point (mm from its pole)."""


class Cause(NamedTuple):
    """What a report names: its sentence, its kind (as in `Likely`), whether that is sure, what it explains."""

    says: str
    kind: str
    sure: bool
    explains: int


class Plan(NamedTuple):
    """A plan of the scene: how many readings the short template asks of it, how many of these were given.

    ``there``: whether there is any reading of it; ``pointed``: whether points of it were given.
    """

    plan: str
    asked: int
    given: int
    there: bool
    pointed: bool


class Figure(NamedTuple):
    """A reading as a figure: of what, of which kind; as found and as due (a point: x and y), its limit.

    ``off``: how far it is off, in usual errors of the hand. ``grain``: to how many mm it was read; ``slip``:
    the usual slip of reading it, mm; both 0 where it was not measured.
    """

    key: Key
    kind: str
    found: tuple[float, ...]
    due: tuple[float, ...]
    limit: float
    off: float
    grain: float
    slip: float


class Row(NamedTuple):
    """A hand-in judged; ``skipped``: why it is not ("" where it is).

    ``wrong``: of every wrong reading its plan and segment, and which of the ``causes`` explains it (-1: none).
    ``doubts``: how near to wrong the doubtful ones are, together; ``whole``: whether the drawing is off as a
    whole. ``feedback``: what its student is told. ``dues``: what is due of the scene's figures, by key and
    kind.
    """

    skipped: str = ""
    fine: int = 0
    doubtful: int = 0
    plans: tuple[Plan, ...] = ()
    causes: tuple[Cause, ...] = ()
    wrong: tuple[tuple[tuple[str, str], int], ...] = ()
    feedback: str = ""
    figures: tuple[Figure, ...] = ()
    dues: Mapping[tuple[Key, str], tuple[float, ...]] = {}
    doubts: float = 0.0
    whole: bool = False

    @property
    def readings(self) -> int:
        """How many readings there are."""
        return self.fine + self.doubtful + len(self.wrong)


def plans_due(rule: Rule, row: Row) -> tuple[Plan, ...]:
    """Return the plans of a row that are asked for: by the rule, or else by the short template."""
    if not rule.plans:
        return tuple(one for one in row.plans if one.asked)
    plans = {one.plan: one for one in row.plans}
    return tuple(plans.get(name, Plan(name, 0, 0, False, False)) for name in rule.plans)


def faults(rule: Rule, row: Row) -> Faults:
    """Return what counts in a row."""
    plans = plans_due(rule, row)
    missing = tuple(one.plan for one in plans if not one.there)
    unread = sum(one.asked - one.given for one in plans if one.there and not one.pointed)
    doubts = Fraction(str(row.doubts))
    return Faults(row.wrong, doubts, missing, unread, whole=row.whole)


def text(row: Row) -> str:
    """Return a row as JSON text."""
    told = row._asdict()
    told["plans"] = [one._asdict() for one in row.plans]
    told["causes"] = [one._asdict() for one in row.causes]
    told["figures"] = [list(one) for one in row.figures]
    told["dues"] = [[*key, kind, *due] for (key, kind), due in row.dues.items()]
    lines = (f'"{name}": {json.dumps(value, ensure_ascii=True)}' for name, value in told.items())
    return "{" + ",\n ".join(lines) + "}\n"


def known(data: bytes | str) -> Row:
    """Return the row that a text tells."""
    told: dict[str, Any] = json.loads(data)
    figures = tuple(
        Figure(tuple(key), kind, tuple(found), tuple(due), *rest)
        for key, kind, found, due, *rest in told["figures"]
    )
    return Row(
        told["skipped"],
        told["fine"],
        told["doubtful"],
        tuple(Plan(**one) for one in told["plans"]),
        tuple(Cause(**one) for one in told["causes"]),
        tuple(((plan, segment), cause) for (plan, segment), cause in told["wrong"]),
        told["feedback"],
        figures,
        {((a, b, c), kind): tuple(due) for a, b, c, kind, *due in told["dues"]},
        told["doubts"],
        told["whole"],
    )


RULERS = (1.0, 0.5, 0.2, 0.1)
"""Rulers by which people read, mm: the coarsest of which all figures are multiples was used."""


def row_of(made: DrawnScene, checked: Checked) -> Row:
    """Return the row of a hand-in whose report is known."""
    report = checked.report
    causes = [one for one in report.mistakes if one.kind != UNSEEN]
    lines = [set(one.lines) for one in causes]
    wrong = tuple(
        (
            (one.taken.plan, one.taken.segment),
            next((k for k, its in enumerate(lines) if one.taken.line in its), -1),
        )
        for one in report.readings
        if one.verdict == WRONG
    )
    return Row(
        fine=sum(one.verdict == FINE for one in report.readings),
        doubtful=sum(one.verdict == DOUBTFUL for one in report.readings),
        plans=tuple(_plans(made, [one.taken for one in report.readings])),
        causes=tuple(
            Cause(finding(one, report.language), one.kind, sure(one), explained(report, one))
            for one in causes
        ),
        wrong=wrong,
        feedback=feedback(report),
        figures=tuple(_figures(checked)),
        dues=dues(made),
        doubts=round(sum(one.doubt for one in report.readings if one.verdict == DOUBTFUL), 2),
        whole=report.whole is not None,
    )


def feedback(report: Report) -> str:
    """Return what the student is told: what matters, and how many readings are fine."""
    return " ".join(filter(None, (headline(report), counted(report))))


def dues(made: DrawnScene) -> Mapping[tuple[Key, str], tuple[float, ...]]:
    """Return what is due of a scene's figures, by key and kind."""
    found: dict[tuple[Key, str], tuple[float, ...]] = {}
    for key, cell in cells(made).items():
        if cell.mm is not None:
            found[key, MM] = (float(cell.mm),)
        if cell.value is not None:
            found[key, VALUE] = (float(cell.value),)
    for key, spot in points(made).items():
        found[key, SPOT] = (spot.real, spot.imag)
    return found


def plans_of(made: DrawnScene) -> tuple[str, ...]:
    """Return the plans of a scene that something can be read off, in its order."""
    figures = (*cells(made), *points(made))
    return tuple(dict.fromkeys(plan for plan, _, _ in figures if plan != RESULTS))


def _plans(made: DrawnScene, taken: Sequence[Taken]) -> Iterator[Plan]:
    """Yield the plans of a scene in its order: how much of each is there."""
    try:
        wanted = {(one.plan, one.segment) for one in short(made).rows}
    except SheetError:
        wanted = set()
    given = {(one.plan, one.segment) for one in taken}
    for plan in plans_of(made):
        own = {one for one in wanted if one[0] == plan}
        there = any(one.plan == plan for one in taken)
        pointed = any(one.plan == plan and one.pointed for one in taken)
        yield Plan(plan, len(own), len(own & given), there, pointed)


def _figures(checked: Checked) -> Iterator[Figure]:
    """Yield the readings as figures."""
    compared, readings = checked.compared, checked.report.readings
    measured = [one for one in readings if _is_measured(compared, one.taken)]
    lengths = [length for one in measured for length in _lengths(compared, one)]
    ruler = next(
        (by for by in RULERS if lengths and all(_is_multiple(*one, by) for one in lengths)), 0.0
    )
    own = {id(one) for one in measured}
    for one in readings:
        grain, slip = _fineness(compared, one, ruler) if id(one) in own else (0.0, 0.0)
        yield _figure(compared, one, grain, slip)


def _is_measured(compared: Comparison, taken: Taken) -> bool:
    """Whether a figure was read off the paper itself, not calculated of others; and is not next to nothing.

    Of a length that should be none the slips to both sides are read alike.
    """
    if taken.pointed:
        return True
    step, cell = compared.step(taken), compared.due[taken.key]
    if step is None or not step.op.reads or cell.mm is None:
        return False
    return compared.scale(taken) > 0.0 and abs(cell.mm) > 4.0 * compared.by.reader.hand.reading


def _lengths(compared: Comparison, one: Judged) -> tuple[tuple[float, float], ...]:
    """Return the lengths of a reading, mm, of a point two; each with half a unit of its last digit."""
    taken = one.taken
    if taken.x is not None and taken.y is not None:
        return (abs(taken.x), taken.last.x), (abs(taken.y), taken.last.y)
    return (_mm(compared, one),)


def _mm(compared: Comparison, one: Judged) -> tuple[float, float]:
    """Return a length in mm, and half a unit of its last digit."""
    mu = 1.0 if one.taken.mm is not None else compared.scale(one.taken)
    return abs(one.found) / mu, half_of(one.taken, compared.due[one.taken.key]) / mu


def _is_multiple(mm: float, half: float, of: float) -> bool:
    return abs(mm - of * round(mm / of)) <= half + 1e-6


def _fineness(compared: Comparison, one: Judged, ruler: float) -> tuple[float, float]:
    """Return to how many mm a figure was read, and the usual slip of that."""
    reader, taken = compared.by.reader, one.taken
    if taken.pointed:
        return max(2.0 * max(taken.last.x, taken.last.y), ruler, 0.01), reader.pointing
    _, half = _mm(compared, one)
    return max(2.0 * half, ruler, 0.01), reader.hand.reading


def _figure(compared: Comparison, one: Judged, grain: float, slip: float) -> Figure:
    taken, spread = one.taken, compared.by.spread[one.taken.at]
    off = abs(one.deviation) / spread.rms if spread.rms > 0.0 else 0.0
    if taken.pointed:
        spot, due = taken.spot, compared.spots[taken.key]
        ends = (spot.real, spot.imag), (due.real, due.imag)
        return Figure(taken.key, SPOT, *ends, spread.doubtful, off, grain, slip)
    kind = MM if taken.mm is not None else VALUE
    return Figure(taken.key, kind, (one.found,), (one.due,), spread.doubtful, off, grain, slip)
