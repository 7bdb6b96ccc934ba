"""The columns of an engine's forces, in the unit of the task and in SI, its results; the views of its plans."""

from __future__ import annotations

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN, Engine
from graphic_tmm.chapters.engine.record import BESIDE, WORKS
from graphic_tmm.chapters.engine.task import (
    CALCULATED,
    ENGINE,
    HARMONICS,
    MASSES,
    TRANSFER,
    VIEW,
    WORKS_VIEW,
)
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.chapters.indicator.task import CALCULATED as STROKE
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, ordinates, row_of
from graphic_tmm.readers.protocol import Protocols

PLAN = ENGINE
PRESSURES = ("pk", "pv")
"""Columns for which the table on a sheet has no row: the indicator diagram beside it tells them."""


def engine_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return the columns of the engine at the positions of the row."""
    made = ENGINE_PLAN.on(drawn)
    unit = made.order.unit
    found = [
        _column(drawn, "beta", BESIDE.on(drawn).beta, "°"),
        _column(drawn, "a_B", made.acceleration, "m/s²"),
        _column(drawn, "a_B_series", made.harmonics.acceleration, "m/s²"),
    ]
    chart = INDICATOR_PLAN.on(drawn).indicator.chart
    for side in INDICATOR_PLAN.on(drawn).indicator.sides:
        letter = side.pressure.name
        both = ordinates(drawn.reading, side.ordinate, chart.mu, len(drawn.names))
        found.append(Column(PLAN, segment_name(letter), letter, "Pa", *both))
    rows = {"P": made.values["P"], "P_in": made.values["P_in"]}
    rows |= {
        "P_in_series": made.harmonics.force,
        "P_in1": made.harmonics.first,
        "P_in2": made.harmonics.second,
    }
    rows |= {name: mark for name, mark in made.values.items() if name not in rows}
    for name, mark in rows.items():
        of = f"{unit}·m" if name in ("M", "NOB") else unit
        column = _column(drawn, name, mark, of, _read(made, name))
        found.append(column)
        if unit == "kgf":
            si, newtons = column.value * KGF, of.replace("kgf", "N")
            nothing = empty(si.shape[1])
            found.append(Column(PLAN, f"{name}_SI", column.letter, newtons, nothing, si))
    return tuple(found)


def _read(made: Engine, name: str) -> Mark | None:
    """Return the ordinate that was read off a diagram for a quantity."""
    for view, letters in made.curves.items():
        if name in letters:
            chart = next(chart for chart in made.charts if chart.view == view)
            return chart.ordinates[letters.index(name)]
    return None


def _column(drawn: Drawn, name: str, mark: Mark, unit: str, mm: Mark | None = None) -> Column:
    count, reading = len(drawn.names), drawn.reading
    row = row_of(reading.figure(mark), range(count), count)
    lengths = empty(count) if mm is None else row_of(reading.figure(mm), range(count), count)
    return Column(PLAN, name, f"engine {name}", unit, lengths, row)


def engine_results(drawn: Drawn) -> Results:
    """Return what lumping the rod's mass gives and costs, and the works over a turn."""
    return results_of(drawn, engine_marks(drawn))


def engine_marks(drawn: Drawn) -> dict[str, Mark]:
    """Return the marks of the results of an engine."""
    lumped = ENGINE_PLAN.on(drawn).lumped
    marks = {
        "m_to_and_fro": lumped.mass,
        "m_rod_at_crank": lumped.at_crank,
        "m_rod_at_slider": lumped.at_slider,
        "J_rod_lumped": lumped.inertia,
        "J_rod_excess": lumped.lost,
    }
    found = {name: mark for name, mark in marks.items() if mark is not None}
    return found | dict(zip(WORKS, BESIDE.on(drawn).works, strict=True))


TABLE = Tabled(columns=engine_columns, results=engine_results, marks=engine_marks)


def _views(project: Project) -> dict[str, list[str]]:
    charts = [chart.view for chart in ENGINE_PLAN.on(project).charts]
    cylinder = INDICATOR_PLAN.on(project)
    own = [cylinder.indicator.chart.view, STROKE] if cylinder.shown_by == ENGINE else []
    return {ENGINE: [*own, VIEW, TRANSFER, HARMONICS, *charts, CALCULATED, MASSES, WORKS_VIEW]}


PROTOCOL = Protocols(views=_views)
