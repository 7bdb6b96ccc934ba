"""Cases by turns: some of them with each version, all within a few, and all at once with ``--measured``.

What was green for a version stays green: neither a clock nor a commit has a say in which cases run.
"""

from __future__ import annotations

import os
import tomllib
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Any, TypeVar
from zlib import crc32

Case = TypeVar("Case")


def _version() -> str:
    """Return the version in pyproject.toml."""
    text = (Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8")
    version: str = tomllib.loads(text)["project"]["version"]
    return version


TURN = int(os.environ.get("GRAPHIC_TMM_TURN") or crc32(_version().encode()))
"""Whose turn it is: the version's. The environment hands it to workers, or names another one."""
os.environ["GRAPHIC_TMM_TURN"] = str(TURN)


class Wanted:
    """Whether all cases are wanted at once: with ``--measured``."""

    all = False


def in_turn(cases: Iterable[Case], count: int, turn: int = TURN) -> list[Case]:
    """Return so many cases, spread over all; each has had its turn within ``len(cases)`` turns."""
    cases = list(cases)
    several = len(cases) if Wanted.all else min(count, len(cases))
    return [cases[(turn + k * len(cases) // several) % len(cases)] for k in range(several)]


SLOW = 3
"""So many cases of a slow test run where no mark says how many; all of one that is marked ``every``."""


def waiting(items: Iterable[Any]) -> set[Any]:
    """Return the tests whose turn it is not: ``turns(count)`` of each run, of slow ones without a mark `SLOW`.

    Tests of a file that are cases of one thing are marked with its name, ``turns(count, name)``, and take turns
    together. Everyday tests and slow ones take turns apart.
    """
    cases = defaultdict(list)
    for item in items:
        slow, mark = item.get_closest_marker("slow") is not None, item.get_closest_marker("turns")
        every = item.get_closest_marker("every") is not None
        if mark or (slow and not every and hasattr(item, "callspec")):
            count, name = (*(mark.args if mark else [SLOW]), item.originalname)[:2]
            cases[item.path, name, slow, count].append(item)
    found: set[Any] = set()
    for (*_, count), all_ in cases.items():
        found |= {*all_} - {*in_turn(all_, count)}
    return found
