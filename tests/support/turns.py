"""Cases by turns: some of them each day, all within a few days, and all at once with ``--measured``."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterable
from datetime import UTC, datetime
from typing import Any, TypeVar

Case = TypeVar("Case")
TURN = int(os.environ.setdefault("GRAPHIC_TMM_TURN", str(datetime.now(UTC).date().toordinal())))
"""Whose turn it is: the day's. The environment hands it on to workers, and repeats another day's."""


class Wanted:
    """Whether all cases are wanted at once: with ``--measured``."""

    all = False


def in_turn(cases: Iterable[Case], count: int, turn: int = TURN) -> list[Case]:
    """Return so many cases, spread over all; each has had its turn within ``len(cases)`` turns."""
    cases = list(cases)
    several = len(cases) if Wanted.all else min(count, len(cases))
    return [cases[(turn + k * len(cases) // several) % len(cases)] for k in range(several)]


def waiting(items: Iterable[Any]) -> set[Any]:
    """Return the tests whose turn it is not, of those marked so: ``turns(count)`` of each run.

    Tests of a file that are cases of one thing are marked with its name, ``turns(count, name)``, and take turns
    together. Everyday tests and slow ones take turns apart.
    """
    cases = defaultdict(list)
    for item in items:
        if mark := item.get_closest_marker("turns"):
            slow = item.get_closest_marker("slow") is not None
            count, name = (*mark.args, item.originalname)[:2]
            cases[item.path, name, slow, count].append(item)
    found: set[Any] = set()
    for (*_, count), all_ in cases.items():
        found |= {*all_} - {*in_turn(all_, count)}
    return found
