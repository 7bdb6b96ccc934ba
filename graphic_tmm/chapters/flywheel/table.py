"""The columns of kinematic diagrams and of the flywheel, and the flywheel's results."""

from __future__ import annotations

import math

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.flywheel.rim import wanted_outer
from graphic_tmm.language.captions import CAPTIONS
from graphic_tmm.language.words import number
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Row, row_of, segment_name


def flywheel_columns(project: Project, reading: Reading) -> tuple[Column, ...]:
    """Return the columns of the flywheel: pressures, reduced moment, works and energies by positions."""
    if project.flywheel is None:
        return ()
    count, made, indicator = len(project.names), [], project.flywheel.indicator
    sides = indicator.sides if indicator is not None else ()
    pressures = {side.ordinate: side.pressure for side in sides}
    for chart in project.flywheel.charts:
        for mark in chart.ordinates:
            letter = pressures.get(mark, mark).name
            if chart.view == "work":
                continue  # ΔT is laid off, and read, once more among the energies
            rows = _rows(reading, mark, chart.mu, count)
            made.append(Column("flywheel", segment_name(letter), letter, chart.unit, *rows))
    return tuple(made)


def _rows(reading: Reading, mark: Mark, mu: Mark, count: int) -> tuple[Row, Row]:
    """Return an ordinate along the positions: mm, and what it stands for."""
    mm, value = (row_of(reading.figure(mark, by), range(count), count) for by in (None, mu))
    return mm, value


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
    for side in found.indicator.sides if found.indicator is not None else ():
        marks[f"p_mean_{side.name}"] = (side.mean, "Pa")
    values = {
        name: (float(reading.figure(mark)[0, 0]), unit) for name, (mark, unit) in marks.items()
    }
    return {name: found for name, found in values.items() if math.isfinite(found[0])}


def rim_too_wide(project: Project, reading: Reading, language: str) -> str:
    """Return, as lettered on a sheet, that the rim is too wide and what to do; empty where it is not."""
    results = flywheel_results(project, reading)
    if not {"D_max", "D_e", "rim_width"} <= set(results):
        return ""
    most, outer, width = (results[name][0] for name in ("D_max", "D_e", "rim_width"))
    least = wanted_outer(outer, width)
    if least is None:
        return ""
    key = "rim too wide" if least <= most else "rim too wide, speed"
    sizes = {"outer": outer, "width": width, "least": least, "most": most}
    told = {name: number(size, language, 3) for name, size in sizes.items()}
    return CAPTIONS[language][key].format(**told)
