"""The columns and results of a cam: motion, pressure angle by positions of the cam; radii and limits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.cam.centre import Centre
from graphic_tmm.chapters.cam.plan import CAM_PLAN, Cam
from graphic_tmm.chapters.cam.record import BESIDE
from graphic_tmm.chapters.cam.task import CAM
from graphic_tmm.chapters.cam.turn import TurnDiagram
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of

PLAN = CAM


def cam_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return S, dS/dφ, d²S/dφ² and the pressure angle by positions; mm on the diagrams and quantities."""
    made, reading = CAM_PLAN.on(drawn), drawn.reading
    rocks = made.order.rocks
    count = made.diagrams.turn.positions
    found = []
    for segment, diagram in (
        ("S", made.diagrams.S),
        ("dS", made.diagrams.V),
        ("ddS", made.diagrams.A),
    ):
        mm, value = (reading.figure(diagram.reading, by) for by in (None, diagram.chart.mu))
        called = f"rocker cam {segment}" if rocks else ""
        found.append(_column(segment, diagram.chart.unit, value, count, mm, called))
    found += _moving(drawn, rocks, count)
    if isinstance(made.centre, Centre):
        found.append(_column("pressure", "°", reading.figure(made.centre.pressure), count))
    if made.spring is not None:
        for segment, one in zip("PNM", made.spring.diagrams, strict=True):
            found.append(_of_stretches(segment, one, reading, count))
    at = tuple(zip(drawn.names, drawn.project.coordinates, strict=True))
    return tuple(replace(column, at=at) for column in found)


def _moving(drawn: Drawn, rocks: bool, count: int) -> list[Column]:
    """Return velocity and acceleration of the follower, of a cam that turns at a speed."""
    beside = BESIDE.of(drawn)
    if beside is None or beside.velocity is None or beside.acceleration is None:
        return []
    marks = (
        {"omega": beside.velocity, "eps": beside.acceleration}
        if rocks
        else {"v": beside.velocity, "a": beside.acceleration}
    )
    return [_column(k, m.unit, drawn.reading.figure(m), count) for k, m in marks.items()]


def _of_stretches(segment: str, diagram: TurnDiagram, reading: Reading, count: int) -> Column:
    """Return the ordinates of a diagram; where two stretches meet, the earlier one's."""
    sizes = []
    for by in (None, diagram.chart.mu):
        size, *others = (reading.figure(mark, by) for mark in diagram.chart.ordinates)
        for other in others:
            size = np.where(np.isnan(size), other, size)
        sizes.append(size)
    mm, value = sizes
    return _column(segment, diagram.chart.unit, value, count, mm)


def _column(
    segment: str, unit: str, value: Reals, count: int, mm: Reals | None = None, called: str = ""
) -> Column:
    def row(values: Reals) -> Reals:
        return row_of(values[:, :count], range(count), count)

    lengths = row(mm) if mm is not None else empty(count)
    return Column(PLAN, segment, f"symbol {called or f'cam {segment}'}", unit, lengths, row(value))


def results(drawn: Drawn) -> Results:
    """Return the results of a cam, what is left up to its limits, and the peaks of its laws."""
    beside = BESIDE.on(drawn)
    return results_of(drawn, {**cam_marks(CAM_PLAN.on(drawn)), **beside.left, **beside.peaks})


def cam_marks(made: Cam) -> Mapping[str, Mark]:
    """Return the marks of a cam's results by name."""
    radius = "drum_radius" if made.order.developed else "r0"
    radius = "length" if made.order.slides else radius
    marks = {f"{radius}_min": made.least, radius: made.r0}
    if made.roller is not None:
        if made.roller.by_r0 is not None:
            marks[f"roller_by_{radius}"] = made.roller.by_r0
        marks |= {
            "roller_by_curvature": made.roller.by_curvature,
            "roller": made.roller.radius,
        }
    if made.pressure is not None:
        rows = zip(made.diagrams.turn.ways, made.pressure.extremes, strict=True)
        marks |= {f"pressure_{phase.name}": extreme.value for phase, extreme in rows}
    if made.contact is not None and made.face is not None:
        farthest, nearest = made.contact.extremes
        marks |= {"face_to": farthest.value, "face_from": nearest.value, "face_length": made.face}
    if made.spring is not None:
        spring = made.spring
        marks |= {"spring_preload": spring.preload, "spring_rate": spring.rate}
        for name, diagram in (("contact", spring.contact), ("moment", spring.moment)):
            most, least = diagram.extremes
            marks |= {f"{name}_most": most.value, f"{name}_least": least.value}
    marks["least_curvature"] = made.curvature.extremes[0].value
    return marks


TABLE = Tabled(columns=cam_columns, results=results)
