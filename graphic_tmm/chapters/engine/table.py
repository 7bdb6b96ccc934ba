"""The columns of an engine's forces, in the unit of the task and in SI beside it, and its results."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.engine.plan import ENGINE, Engine
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Column, row_of

PLAN = ENGINE.chapter


def engine_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return the columns of the engine at the positions of the row."""
    made = ENGINE.on(drawn)
    unit = made.order.unit
    found = [
        _column(drawn, "a_B", made.acceleration, "m/s²"),
        _column(drawn, "a_B_series", made.harmonics.acceleration, "m/s²"),
    ]
    rows = {"P": made.values["P"], "P_in": made.values["P_in"]}
    rows |= {
        "P_in_series": made.harmonics.force,
        "P_in1": made.harmonics.first,
        "P_in2": made.harmonics.second,
    }
    rows |= {name: mark for name, mark in made.values.items() if name not in rows}
    for name, mark in rows.items():
        of = f"{unit}·m" if name in ("M", "NOB") else unit
        mm = _read(made, name)
        found.append(_column(drawn, name, mark, of, mm))
        if unit == "kgf":
            column = found[-1]
            si = tuple(None if x is None else x * KGF for x in column.value)
            nothing = (None,) * len(si)
            found.append(
                Column(PLAN, f"{name}_SI", f"engine {name}", of.replace("kgf", "N"), nothing, si)
            )
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
    if mm is None:
        return Column(PLAN, name, f"engine {name}", unit, (None,) * count, row)
    lengths = row_of(reading.figure(mm), range(count), count)
    return Column(PLAN, name, f"engine {name}", unit, lengths, row)


def engine_results(drawn: Drawn) -> dict[str, tuple[float, str]]:
    """Return what lumping the rod's mass gives and costs: by name value and unit."""
    lumped, reading = ENGINE.on(drawn).lumped, drawn.reading
    marks = {
        "m_to_and_fro": (lumped.mass, "kg"),
        "m_rod_at_crank": (lumped.at_crank, "kg"),
        "m_rod_at_slider": (lumped.at_slider, "kg"),
        "J_rod_lumped": (lumped.inertia, "kg·m²"),
        "J_rod_excess": (lumped.lost, "kg·m²"),
    }
    return {
        name: (float(reading.figure(mark)[0, 0]), unit)
        for name, (mark, unit) in marks.items()
        if mark is not None
    }
