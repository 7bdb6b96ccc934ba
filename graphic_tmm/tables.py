"""Tables read off the log: segments in mm, times μ, in SI; the links' rates; the structure.

Segments are magnitudes; the sense of a link's ω and ε is the sign of its value.
"""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Length, Reals
from graphic_tmm.captions import CAPTIONS
from graphic_tmm.plans.project import Project
from graphic_tmm.words import fixed, number, plain, unit

UNITS = {"positions": "m", "velocities": "m/s", "accelerations": "m/s²"}
NOISE = 1e-12
"""A figure below this share of the largest of its plan is the rounding of the machine."""
RATES = {"ω": "omega", "ε": "epsilon"}


class Column(NamedTuple):
    """One row of figures along the positions: mm on the sheet (None where nothing is measured) and SI."""

    plan: str
    segment: str
    letter: str
    unit: str
    mm: tuple[float | None, ...]
    value: tuple[float | None, ...]

    def without(self, places: Sequence[int]) -> Column:
        """Return the column with nothing at the places (indices) of positions that cannot be drawn."""

        def blank(row: tuple[float | None, ...]) -> tuple[float | None, ...]:
            return tuple(None if k in places else x for k, x in enumerate(row))

        return self._replace(mm=blank(self.mm), value=blank(self.value)) if places else self


def segment_name(letter: str) -> str:
    """Return a letter of the log as machines read it: n_{ab} -> nab, ω_2 -> omega2."""
    if letter[0] in RATES:
        return RATES[letter[0]] + letter[1:].strip("_{}")
    return letter.translate({ord(sign): None for sign in "_{}"})


def columns(
    construction: Construction,
    reading: Reading,
    plan: str,
    places: Sequence[int],
    count: int,
    shared: dict[int, Mark] | None = None,
) -> tuple[Column, ...]:
    """Return the columns of one plan.

    Parameters
    ----------
    reading
        The numbers, at the positions ``places`` (indices) out of ``count``.
    shared
        The rate mark of every turning link of this plan; links that turn alike share a mark.
    """
    view = construction.view(plan)
    if view is None or view.scale is None:
        return ()
    mu = reading[view.scale]
    steps = [step for step in construction.steps if step.it.view == plan and _is_segment(step)]
    rates = dict(sorted((shared or {}).items()))
    lengths = _quiet([np.abs(reading[step.it]) for step in steps])
    turning = _quiet([reading[mark] for mark in rates.values()])
    made = []
    for step, mm in zip(steps, lengths, strict=True):
        letter = step.it.letter
        rows = _row(mm, places, count), _row(mm * mu, places, count)
        made.append(Column(plan, segment_name(letter), letter, UNITS[plan], *rows))
    empty = (None,) * count
    for (link, mark), value in zip(rates.items(), turning, strict=True):
        letter = f"{'ω' if plan == 'velocities' else 'ε'}_{link}"
        row = _row(value, places, count)
        made.append(Column(plan, segment_name(letter), letter, mark.unit, empty, row))
    return tuple(made)


def chart_columns(
    project: Project, reading: Reading, planned: Reading | None
) -> tuple[Column, ...]:
    """Return the columns of the diagrams: what they give, what the plans give, the difference in %.

    The difference is told in % of the largest that the plan gives.
    ``planned``: the numbers of the plan of accelerations, at its positions.
    """
    kinematic, count = project.kinematic, len(project.names)
    if kinematic is None:
        return ()
    everywhere, made = range(count), []
    for symbol, chart in kinematic.charts.items():
        mm, mu = reading[chart.ordinates[0]], reading[chart.mu]
        (mm,) = _quiet([mm])
        rows = _row(mm, everywhere, count), _row(mm * mu, everywhere, count)
        made.append(Column("diagrams", symbol, symbol, chart.unit, *rows))
        source, places = {"V": (reading, everywhere), "a": (planned, project.accelerated)}.get(
            symbol, (None, ())
        )
        if source is None or symbol not in kinematic.planned:
            continue
        view = project.construction.view(kinematic.planned[symbol].view)
        assert view is not None
        assert view.scale is not None
        (due,) = _quiet([source[kinematic.planned[symbol]] * source[view.scale]])
        plan = _row(due, places, count)
        made.append(
            Column(
                "diagrams", f"{symbol}_plan", f"{symbol}_plan", chart.unit, (None,) * count, plan
            )
        )
        made.append(_difference(f"{symbol}_difference", rows[1], plan))
    return tuple(made)


def flywheel_columns(project: Project, reading: Reading) -> tuple[Column, ...]:
    """Return the columns of the flywheel: pressures, reduced moment, works and energies by positions."""
    if project.flywheel is None:
        return ()
    count, made = len(project.names), []
    for chart in project.flywheel.charts:
        mu = reading[chart.mu]
        for mark in chart.ordinates:
            letter = mark.letter.replace("y_", "p_") if chart.symbol == "p" else mark.letter
            if chart.view == "work":
                continue  # ΔT is laid off, and read, once more among the energies
            (mm,) = _quiet([reading[mark]])
            rows = _row(mm, range(count), count), _row(mm * mu, range(count), count)
            made.append(Column("flywheel", segment_name(letter), letter, chart.unit, *rows))
    return tuple(made)


def flywheel_results(project: Project, reading: Reading) -> dict[str, tuple[float, str]]:
    """Return the results of the flywheel by name: value and unit."""
    found = project.flywheel
    if found is None:
        return {}
    marks = {"cd": (found.segment, "mm"), "J_fly": (found.inertia, "kg·m²")}
    if found.energy_mass is not None:
        marks["J_fly_energy_mass"] = (found.energy_mass.inertia, "kg·m²")
    if found.rim is not None:
        rim = found.rim
        named = ("D_max", "D_e", "D_i", "D_mean", "rim_mass", "rim_width")
        sizes = (rim.limit, rim.outer, rim.inner, rim.mean, rim.mass, rim.width)
        units = ("m", "m", "m", "m", "kg", "m")
        marks |= {n: (mark, unit) for n, mark, unit in zip(named, sizes, units, strict=True)}
    for side in found.indicator.sides:
        marks[f"p_mean_{side.name}"] = (side.mean, "Pa")
    values = {name: (float(reading[mark][0, 0]), unit) for name, (mark, unit) in marks.items()}
    return {name: found for name, found in values.items() if math.isfinite(found[0])}


def _difference(letter: str, found: Sequence[float | None], due: Sequence[float | None]) -> Column:
    """Return by how much figures differ from what is due, in % of the largest due."""
    largest = max((abs(x) for x in due if x is not None), default=0.0)
    row = tuple(
        100.0 * (x - y) / largest if x is not None and y is not None and largest else None
        for x, y in zip(found, due, strict=True)
    )
    return Column("diagrams", letter, letter, "%", (None,) * len(row), row)


def _quiet(rows: list[Reals]) -> list[Reals]:
    """Return figures with those that are nothing but rounding beside the largest of them set to zero."""
    finite = [np.abs(row[np.isfinite(row)]) for row in rows]
    largest = max((float(row.max()) for row in finite if row.size), default=0.0)
    return [np.where(np.abs(row) < NOISE * largest, 0.0, row) for row in rows]


def _is_segment(step: Step) -> bool:
    if step.it.kind is not Length:
        return False
    return step.op.reads or step.it.view != "positions"


def _row(values: Reals, places: Sequence[int], count: int) -> tuple[float | None, ...]:
    row: list[float | None] = [None] * count
    spread = np.broadcast_to(values[0], (len(places),))
    for place, value in zip(places, spread, strict=True):
        row[place] = float(value) if np.isfinite(value) else None
    return tuple(row)


def as_json(
    scene: str,
    scales: dict[str, dict[str, Any]],
    positions: Sequence[tuple[str, float]],
    table: Sequence[Column],
    results: dict[str, Any],
) -> str:
    """Return the tables as one JSON object (see the README); null where a position cannot be drawn."""
    document = {
        "scene": scene,
        "scales": scales,
        "positions": [{"number": name, "angle_deg": angle} for name, angle in positions],
        "columns": [
            {
                "plan": c.plan,
                "segment": c.segment,
                "unit": c.unit,
                "mm": _tidy(c.mm),
                "value": _tidy(c.value),
            }
            for c in table
        ],
        "results": results,
    }
    return json.dumps(document, ensure_ascii=False, indent=1, allow_nan=False) + "\n"


def as_csv(positions: Sequence[tuple[str, float]], table: Sequence[Column]) -> str:
    """Return the tables as CSV: a line for each segment and position."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["plan", "position", "angle_deg", "segment", "mm", "value", "unit"])
    for column in table:
        for (name, angle), mm, value in zip(
            positions, _tidy(column.mm), _tidy(column.value), strict=True
        ):
            if value is not None or mm is not None:
                cells = [column.plan, name, angle, column.segment, mm, value, column.unit]
                writer.writerow(["" if cell is None else cell for cell in cells])
    return out.getvalue()


def rich_tables(
    table: Sequence[Column], names: Sequence[str], language: str, title: str, decimals: int = 1
) -> list[Any]:
    """Return the tables for a terminal, one a plan; positions run across; mm with ``decimals``."""
    from rich.markup import escape
    from rich.table import Table
    from rich.text import Text

    words, made = CAPTIONS[language], []
    for plan in dict.fromkeys(column.plan for column in table):
        rows = [column for column in table if column.plan == plan]
        shown = [k for k in range(len(names)) if any(c.value[k] is not None for c in rows)]
        out = Table(title=escape(f"{title}. {words[plan]}"), title_justify="left")
        for head in (words["segment"], words["unit"], *(names[k] for k in shown)):
            out.add_column(Text(head), justify="right", no_wrap=True)
        for column in rows:
            if any(x is not None for x in column.mm):
                cells = [fixed(column.mm[k], decimals, language) for k in shown]
                out.add_row(Text(plain(column.letter)), unit("mm", language), *cells)
            cells = [_figure(column.value[k], language) for k in shown]
            out.add_row(Text(plain(column.letter)), unit(column.unit, language), *cells)
        made.append(out)
    return made


def _figure(value: float | None, language: str) -> str:
    return "—" if value is None else number(value, language)


def _tidy(row: Sequence[float | None]) -> list[float | None]:
    """Return figures without the noise of the last bits: 12 significant digits, no -0."""
    return [None if x is None else float(f"{x:.12g}") + 0.0 for x in row]
