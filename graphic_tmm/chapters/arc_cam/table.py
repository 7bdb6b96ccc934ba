"""The columns and results of a cam given by arcs: motion and pressure angle by positions, the stroke."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, marks
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.task import ARC_CAM
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of

PLAN = ARC_CAM


def arc_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return S, its derivatives by chords and without differentiation, speeds, the pressure angle.

    By the replacing linkage d²S/dφ² is told twice: at a change of arcs before it, and behind it.
    """
    made, reading = ARC_CAM_PLAN.on(drawn), drawn.reading
    count, follower = len(made.angles), made.follower
    motion = "rad" if made.order.rocks else "m"
    charts = dict(zip(marks(made), made.charts.values(), strict=True))
    beside = BESIDE.on(drawn)
    plans, found = beside.plans, list[Column]()
    for segment, mark in marks(made).items():
        mm, value = (reading.figure(mark, by) for by in (None, charts[segment].mu))
        found.append(_column(segment, motion, value, count, mm))
        if segment == "dS":
            exact = {"dS_P": follower.rate, "dS_K": plans.first, "dS_off": beside.apart[0]}
            found += [
                _column(name, motion, reading.figure(one), count) for name, one in exact.items()
            ]
    exact = dict(zip(("ddS_K", "ddS_K_after"), plans.second, strict=True))
    exact["ddS_off"] = beside.apart[1]
    if beside.velocity is not None and beside.acceleration is not None:
        names = ("omega", "eps") if motion == "rad" else ("v", "a")
        exact |= {names[0]: beside.velocity}
        exact |= dict(zip((names[1], f"{names[1]}_after"), beside.acceleration, strict=True))
    found += [_column(name, mark.unit, reading.figure(mark), count) for name, mark in exact.items()]
    if follower.pressure is not None:
        found.append(_column("pressure", "°", reading.figure(follower.pressure), count))
    at = tuple(zip(drawn.names, drawn.project.coordinates, strict=True))
    return tuple(replace(column, at=at) for column in found)


def _column(segment: str, unit: str, value: Reals, count: int, mm: Reals | None = None) -> Column:
    def row(values: Reals) -> Reals:
        return row_of(values[:, :count], range(count), count)

    lengths = row(mm) if mm is not None else empty(count)
    return Column(PLAN, segment, f"symbol arc {segment}", unit, lengths, row(value))


def results(drawn: Drawn) -> Results:
    """Return the stroke; the greatest of what the linkage gives; how far the flanks' centres stand from others.

    Both sides of a change of arcs count: there accelerations are greatest.
    """
    made = ARC_CAM_PLAN.on(drawn)
    chart = made.charts["S"]
    value = drawn.reading.figure(chart.ordinates[0], chart.mu)
    with np.errstate(all="ignore"):
        stroke = np.fmax.reduce(value, axis=1, initial=-np.inf)
    found = {"arc_stroke": (stroke, chart.unit)}
    beside = BESIDE.on(drawn)
    rates, seconds, letters = beside.plans.first, beside.plans.second, ("rate", "second")
    if beside.velocity is not None and beside.acceleration is not None:
        rates, seconds = beside.velocity, beside.acceleration
        letters = ("omega", "eps") if rates.unit == "1/s" else ("v", "a")
    rows = [drawn.reading.figure(mark) for mark in (rates, *seconds)]
    with np.errstate(all="ignore"):
        most = np.fmax.reduce(np.abs(rows[0]), axis=1, initial=-np.inf)
        both = np.concatenate(rows[1:], axis=1)
        ends = (np.fmax.reduce(both, axis=1), np.fmin.reduce(both, axis=1))
    found[f"arc_{letters[0]}_max"] = (most, rates.unit)
    for name, figures in zip(("max", "min"), ends, strict=True):
        found[f"arc_{letters[1]}_{name}"] = (figures, seconds[0].unit)
    for number, pair in beside.centres.items():
        for name, mark in zip(("flank_centre", "flank_to_nose"), pair, strict=True):
            found[f"{name}{number}"] = (drawn.reading.figure(mark)[:, 0].copy(), mark.unit)
    return found


TABLE = Tabled(columns=arc_columns, results=results)
