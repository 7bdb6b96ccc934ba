"""Cells of plan and position that were left empty, merged or dittoed: what stands above is meant."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol, TypeVar

from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.checking.readings.names import plan_meant
from graphic_tmm.language.said import Said, said

_DITTO = frozenset(('"', "''", "〃", "//", "-//-", "—//—", '-"-', '—"—', "то же", "ditto", "so"))
_SCALES = ("μ", "µ", "mu", "мю", "масштаб", "scale")
"""How a row begins that states the scale factor of a plan: in one position only where it says so."""
_LISTED = 6


class _Row(Protocol):
    """A row as `filled` reads it."""

    @property
    def line(self) -> int: ...
    @property
    def plan(self) -> str: ...
    @property
    def position(self) -> str: ...
    @property
    def segment(self) -> str: ...
    def _replace(self: T, *, plan: str, position: str) -> T: ...


T = TypeVar("T", bound=_Row)


def filled(rows: Sequence[T]) -> tuple[list[T], tuple[Said, ...]]:
    """Return rows with the plan and the position of the row above where theirs were left out; a note on each.

    A position is filled down in rows that leave out their plan, too; a row that names its plan may have none
    (results, a pole), which its scene tells (`mending`).
    """
    plan = position = ""
    lines: dict[str, list[int]] = {"plan": [], "position": []}
    found = []
    for row in rows:
        same = not row.plan or row.plan in _DITTO
        named = plan if same else row.plan
        at = row.position
        everywhere = row.segment.casefold().startswith(_SCALES) or _of_results(named)
        if at in _DITTO or (not at and same and not everywhere):
            at = position
        if named != row.plan:
            lines["plan"].append(row.line)
        if at != row.position:
            lines["position"].append(row.line)
        found.append(row._replace(plan=named, position=at))
        plan, position = named, at
    return found, tuple(_note(name, at) for name, at in lines.items() if at)


def _of_results(plan: str) -> bool:
    return bool(plan_meant(plan, (RESULTS,)).names)


def _note(column: str, lines: Sequence[int]) -> Said:
    of = said("plan", context="column") if column == "plan" else said("position", context="column")
    return said(
        'empty cells of the column "{column}" were read as the one above them (line {lines})',
        column=of,
        lines=listed(lines),
    )


def listed(lines: Iterable[int]) -> str:
    """Return lines as a note lists them: the first ones.

    >>> listed([4, 3, 3]), listed(range(1, 9))
    ('3, 4', '1, 2, 3, 4, 5, 6, ...')
    """
    at = sorted(set(lines))
    return ", ".join(map(str, at[:_LISTED])) + (", ..." if len(at) > _LISTED else "")
