"""Mistakes made when readings are written down: scales, rows, decimal points."""

from __future__ import annotations

from typing import Any

import numpy as np

from support.another_hand import Rows
from support.students.kinds import AtTable, Kind, Written
from support.students.records import A, P, V
from support.students.tools import Tools


def number_in(cells: list[str]) -> int | None:
    """Return which of a row's cells was written: mm, else a value; None for a point."""
    return 0 if cells[0] else 1 if cells[1] else None


def segments(rows: Rows, least: int = 3) -> list[tuple[str, str]]:
    """Return the segments that were read in so many positions, with figures that differ."""
    found: dict[tuple[str, str], set[str]] = {}
    for (plan, _, name), cells in rows.items():
        if number_in(cells) is not None:
            found.setdefault((plan, name), set()).add(cells[0] or cells[1])
    return [at for at, figures in found.items() if len(figures) >= least]


def row_of(rows: Rows, at: tuple[str, str]) -> list[tuple[str, str, str]]:
    return [key for key in rows if (key[0], key[2]) == at and number_in(rows[key]) is not None]


def picked(rng: np.random.Generator, of: list[Any]) -> Any:
    return of[rng.integers(len(of))]


def _by_mu(number: float) -> Any:
    """Return a change of the quantities of one plan: a factor of them."""

    def change(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
        plan = picked(rng, [plan for plan in (V, A) if any(key[0] == plan for key in rows)])
        others_ = [tools.mu[p] for p in (P, V, A) if p in tools.mu and p != plan]
        mu = tools.mu[plan]
        by = mu**-2 if number < 0 else picked(rng, others_) / mu
        keys = [key for key in rows if key[0] == plan and not key[2].startswith(("omega", "eps"))]
        return times(rows, keys, by, plan, "")

    return change


def times(
    rows: Rows, keys: list[tuple[str, str, str]], by: float, plan: str, position: str, cell: int = 1
) -> Written:
    """Return the readings with some of them multiplied."""
    changed = {key: list(cells) for key, cells in rows.items()}
    for key in keys:
        if changed[key][cell]:
            changed[key][cell] = f"{float(changed[key][cell]) * by:.4g}"
    return Written(changed, plan, frozenset(key[2] for key in keys), position)


def _shifted(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write a row of the table one column on."""
    plan, name = picked(rng, segments(rows))
    keys = row_of(rows, (plan, name))
    return moved(rows, keys, [*keys[-1:], *keys[:-1]], plan, frozenset({name}), "")


def moved(
    rows: Rows, to: list[Any], of: list[Any], plan: str, names: frozenset[str], position: str
) -> Written:
    """Return the readings with the cells of some rows written into others."""
    changed = dict(rows)
    for into, source in zip(to, of, strict=True):
        cells = list(rows[source])
        cells[2] = rows[into][2]
        changed[into] = cells
    return Written(changed, plan, names, position)


def _swapped(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Exchange two segments of a plan in the table."""
    found = segments(rows)
    pairs = [(a, b) for a in found for b in found
             if a < b and a[0] == b[0] and _alike(rows, a, b)]  # fmt: skip
    if not pairs:
        return None
    a, b = picked(rng, pairs)
    keys, other = row_of(rows, a), row_of(rows, b)
    return moved(rows, [*keys, *other], [*other, *keys], a[0], frozenset({a[1], b[1]}), "")


def _alike(rows: Rows, a: tuple[str, str], b: tuple[str, str]) -> bool:
    keys, other = row_of(rows, a), row_of(rows, b)
    units = {rows[key][2] for key in (*keys, *other)}
    return [key[1] for key in keys] == [key[1] for key in other] and len(units) == 1


def _tenfold(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    plan, name = picked(rng, segments(rows))
    keys, cell = row_of(rows, (plan, name)), 0
    cell = number_in(rows[keys[0]]) or 0
    return times(rows, keys, picked(rng, [10.0, 0.1]), plan, "", cell)


def _slip(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    plan, name = picked(rng, segments(rows))
    key = picked(rng, row_of(rows, (plan, name)))
    return times(rows, [key], picked(rng, [10.0, 0.1]), plan, key[1], number_in(rows[key]) or 0)


TABLES: tuple[Kind, ...] = (
    AtTable("μ inverted", ("scale",), _by_mu(-2), ("quantities", "both")),
    AtTable("μ of another plan", ("scale",), _by_mu(1), ("quantities", "both")),
    AtTable("row shifted", ("table",), _shifted),
    AtTable("rows exchanged", ("table", "exchanged"), _swapped),
    AtTable("row tenfold", ("table", "scale", "factor"), _tenfold),
    AtTable("one figure tenfold", ("slip", "table"), _slip),
)
