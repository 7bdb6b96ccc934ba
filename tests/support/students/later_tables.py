"""Mistakes made when readings are written down that `later` adds: plans, columns, digits, coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np

from support.another_hand import Rows
from support.students.early_tables import moved, number_in, picked, row_of, segments, times
from support.students.kinds import AtTable, Kind, Written
from support.students.records import A, V
from support.students.tools import Tools

Key = tuple[str, str, str]


def _plan(rows: Rows, rng: np.random.Generator) -> str:
    return str(picked(rng, sorted({plan for plan, _ in segments(rows)})))


def _back(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write a row one column too early."""
    plan, name = picked(rng, segments(rows))
    keys = row_of(rows, (plan, name))
    return moved(rows, keys, [*keys[1:], *keys[:1]], plan, frozenset({name}), "")


def _plan_shifted(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write all rows of a plan one column on."""
    plan = _plan(rows, rng)
    into: list[Key] = []
    of: list[Key] = []
    for at in segments(rows):
        if at[0] == plan:
            keys = row_of(rows, at)
            into, of = [*into, *keys], [*of, *keys[-1:], *keys[:-1]]
    return moved(rows, into, of, plan, frozenset(key[2] for key in into), "")


def _pairs(rows: Rows) -> list[tuple[list[Key], list[Key]]]:
    """Return two rows of a plan that were read in the same positions and units."""
    found = []
    for a in segments(rows):
        for b in segments(rows):
            one, two = row_of(rows, a), row_of(rows, b)
            same = [key[1] for key in one] == [key[1] for key in two]
            if a != b and a[0] == b[0] and same and rows[one[0]][2] == rows[two[0]][2]:
                found.append((one, two))
    return found


def _row_copied(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Copy a row from the one above it."""
    pairs = _pairs(rows)
    if not pairs:
        return None
    one, two = picked(rng, pairs)
    return moved(rows, one, two, one[0][0], frozenset({one[0][2]}), "")


def _cells_exchanged(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Exchange two segments in one column."""
    pairs = _pairs(rows)
    if not pairs:
        return None
    one, two = picked(rng, pairs)
    k = int(rng.integers(len(one)))
    a, b = one[k], two[k]
    return moved(rows, [a, b], [b, a], a[0], frozenset({a[2], b[2]}), a[1])


def _one_cell(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write one figure of the column before."""
    plan, name = picked(rng, segments(rows))
    keys = row_of(rows, (plan, name))
    k = int(rng.integers(1, len(keys)))
    return moved(rows, [keys[k]], [keys[k - 1]], plan, frozenset({name}), keys[k][1])


def _plan_tenfold(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write the quantities of a plan ten times as large, or as small: a point in μ."""
    plan, by = _plan(rows, rng), picked(rng, [10.0, 0.1])
    keys = [key for key in rows if key[0] == plan and rows[key][1]]
    turning = ("omega", "eps", "pressure")
    keys = [key for key in keys if not key[2].startswith(turning)]
    return times(rows, keys, by, plan, "") if keys else None


def _without_mu(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write mm where quantities are asked for."""
    plan = picked(rng, [plan for plan in (V, A) if any(key[0] == plan for key in rows)] or [""])
    keys = [key for key in rows if key[0] == plan and not key[2].startswith(("omega", "eps"))]
    return times(rows, keys, 1 / tools.mu[plan], plan, "") if keys else None


def _digits(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Exchange the first two digits of one figure: 63.5 for 36.5."""
    found = []
    for at in segments(rows):
        for key in row_of(rows, at):
            cell = number_in(rows[key]) or 0
            shown = rows[key][cell].lstrip("-").replace(".", "").lstrip("0")
            if len(shown) > 1 and "e" not in shown and shown[0] != shown[1]:
                found.append((key, cell, shown))
    if not found:
        return None
    key, cell, shown = picked(rng, found)
    by = float(shown[1] + shown[0] + shown[2:]) / float(shown)
    return times(rows, [key], by, key[0], key[1], cell)


def _points(rows: Rows, rng: np.random.Generator) -> list[Key]:
    """Return the rows of one letter."""
    found = sorted({(key[0], key[2]) for key, cells in rows.items() if cells[3]})
    if not found:
        return []
    plan, letter = picked(rng, found)
    return [key for key in rows if (key[0], key[2]) == (plan, letter)]


def _coordinates(change: str) -> Any:
    """Return a change of the coordinates of one letter, everywhere."""

    def changes(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
        keys = _points(rows, rng)
        if not keys:
            return None
        changed = {key: list(cells) for key, cells in rows.items()}
        for key in keys:
            x, y = rows[key][3:]
            changed[key][3:] = [y, x] if change == "exchanged" else [x, f"{-float(y):g}"]
        return Written(changed, keys[0][0], frozenset({keys[0][2]}), "")

    return changes


def _letters(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Exchange the letters of two points of a plan."""
    one, two = _points(rows, rng), _points(rows, rng)
    same = [key[:2] for key in one] == [key[:2] for key in two]
    if not one or one == two or not same:
        return None
    names = frozenset({one[0][2], two[0][2]})
    return moved(rows, [*one, *two], [*two, *one], one[0][0], names, "")


def _point_before(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write the coordinates of the position before."""
    keys = _points(rows, rng)
    if len(keys) < 2:
        return None
    k = int(rng.integers(1, len(keys)))
    return moved(rows, [keys[k]], [keys[k - 1]], keys[k][0], frozenset({keys[k][2]}), keys[k][1])


QUANTITIES, POINTS = ("quantities", "both"), ("points",)
TABLES: tuple[Kind, ...] = (
    AtTable("row shifted back", ("table",), _back),
    AtTable("plan shifted", ("table", "previous"), _plan_shifted),
    AtTable("row copied from another", ("table", "exchanged", "operand"), _row_copied),
    AtTable("figures of a column exchanged", ("exchanged", "table"), _cells_exchanged),
    AtTable("figure of the column before", ("previous", "table", "slip"), _one_cell),
    AtTable("plan tenfold", ("scale", "table", "factor"), _plan_tenfold, QUANTITIES),
    AtTable("μ left out", ("scale", "table"), _without_mu, QUANTITIES),
    AtTable("digits exchanged", ("slip", "table"), _digits),
    AtTable("letters exchanged", ("exchanged", "table"), _letters, POINTS),
    AtTable("x and y exchanged", ("exchanged", "table"), _coordinates("exchanged"), POINTS),
    AtTable("y counted downwards", ("mirrored", "sense", "table"), _coordinates("down"), POINTS),
    AtTable("point of the position before", ("previous", "table", "slip"), _point_before, POINTS),
)
