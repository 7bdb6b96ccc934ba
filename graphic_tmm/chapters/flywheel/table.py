"""The columns and the results of a flywheel."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.plan import FLYWHEEL, VIEWS
from graphic_tmm.chapters.flywheel.rim import wanted_outer
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.readers.columns import Column, ordinates, segment_name

PLAN = FLYWHEEL.chapter
_TOO_WIDE = said(
    "the rim of D_{{e}} = {outer} m is {width} m wide: choose D_{{e}} = {least} m or more"
)
_TOO_WIDE_AND_SLOW = said(
    "the rim of D_{{e}} = {outer} m is {width} m wide, and D_{{e}} is {most} m at most: "
    "put the flywheel on a faster shaft, or allow a larger δ"
)


def flywheel_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of the flywheel: pressures, reduced moment, works and energies by positions."""
    made = FLYWHEEL.on(drawn)
    sides = made.indicator.sides if made.indicator is not None else ()
    pressures = {side.ordinate: side.pressure for side in sides}
    for chart in made.charts:
        for mark in chart.ordinates:
            letter = pressures.get(mark, mark).name
            if chart.view == VIEWS["work"]:
                continue  # ΔT is laid off, and read, once more among the energies
            rows = ordinates(drawn.reading, mark, chart.mu, len(drawn.names))
            yield Column(PLAN, segment_name(letter), letter, chart.unit, *rows)


def flywheel_results(drawn: Drawn) -> dict[str, tuple[float, str]]:
    """Return the results of the flywheel by name: value and unit."""
    found, reading = FLYWHEEL.on(drawn), drawn.reading
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


def rim_too_wide(drawn: Drawn, language: str) -> str:
    """Return, as lettered on a sheet, that the rim is too wide and what to do; empty where it is not."""
    results = flywheel_results(drawn)
    if not {"D_max", "D_e", "rim_width"} <= set(results):
        return ""
    most, outer, width = (results[name][0] for name in ("D_max", "D_e", "rim_width"))
    least = wanted_outer(outer, width)
    if least is None:
        return ""
    text = _TOO_WIDE if least <= most else _TOO_WIDE_AND_SLOW
    sizes = {"outer": outer, "width": width, "least": least, "most": most}
    told = {name: number(size, language, 3) for name, size in sizes.items()}
    return speaking(language)(text, **told)
