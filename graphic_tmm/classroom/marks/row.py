"""What one hand-in comes to: its verdicts counted, its plans, its mistakes; and its figures, to be compared."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, NamedTuple

from graphic_tmm.classroom.marks.rule import Faults, Rule

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
    ``feedback``: what its student is told. ``dues``: what is due of the scene's figures, by key and kind.
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

    @property
    def readings(self) -> int:
        """How many readings there are."""
        return self.fine + self.doubtful + len(self.wrong)


def asked(rule: Rule, row: Row) -> tuple[Plan, ...]:
    """Return the plans of a row that are asked for: by the rule, or else by the short template."""
    if not rule.plans:
        return tuple(one for one in row.plans if one.asked)
    plans = {one.plan: one for one in row.plans}
    return tuple(plans.get(name, Plan(name, 0, 0, False, False)) for name in rule.plans)


def faults(rule: Rule, row: Row) -> Faults:
    """Return what counts in a row."""
    plans = asked(rule, row)
    missing = tuple(one.plan for one in plans if not one.there)
    unread = sum(one.asked - one.given for one in plans if one.there and not one.pointed)
    return Faults(row.wrong, row.doubtful, missing, unread)


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
    )
