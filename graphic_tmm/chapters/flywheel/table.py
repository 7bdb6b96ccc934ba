"""The columns and the results of a flywheel; what protocols call its graphs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.flywheel.record import BESIDE, Aside
from graphic_tmm.chapters.flywheel.rim import wanted_outer
from graphic_tmm.chapters.flywheel.task import CALCULATED, FLYWHEEL, VIEWS
from graphic_tmm.chapters.flywheel.words import graph_title
from graphic_tmm.chapters.indicator.task import CALCULATED as STROKE
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, ordinates
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import Holder

PLAN = FLYWHEEL
OFF_SHEET = ("M_mean", "power", "A_excess", "J_made", "delta_made")
"""Results for which the table on a sheet has no row: they would take room from the graphs they are read off."""
_TOO_WIDE = said(
    "the rim of D_{{e}} = {outer} m is {width} m wide: choose D_{{e}} = {least} m or more"
)
_TOO_WIDE_AND_SLOW = said(
    "the rim of D_{{e}} = {outer} m is {width} m wide, and D_{{e}} is {most} m at most: "
    "put the flywheel on a faster shaft, or allow a larger δ"
)


def flywheel_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of the flywheel: pressures, reduced moment, works and energies by positions."""
    yield from columns_of(drawn, FLYWHEEL_PLAN.on(drawn), PLAN)


def columns_of(drawn: Drawn, made: Flywheel, plan: str) -> Iterator[Column]:
    """Yield the columns of a flywheel as drawn, of a plan."""
    cylinders = made.cylinder.every if made.cylinder is not None else ()
    sides = [side for one in cylinders for side in one.indicator.sides]
    pressures = {side.ordinate: side.pressure for side in sides}
    for chart in made.charts:
        for mark in chart.ordinates:
            letter = pressures.get(mark, mark).name
            if chart.view == VIEWS["work"]:
                continue  # ΔT is laid off, and read, once more among the energies
            rows = ordinates(drawn.reading, mark, chart.mu, len(drawn.names))
            yield Column(plan, segment_name(letter), letter, chart.unit, *rows)


def flywheel_results(drawn: Drawn) -> Results:
    """Return the results of the flywheel; those that no drawing gives are left out."""
    return results_for(drawn, FLYWHEEL_PLAN.on(drawn), BESIDE.on(drawn))


def flywheel_marks(drawn: Drawn) -> dict[str, Mark]:
    """Return the marks of the results of the flywheel."""
    return _marks(FLYWHEEL_PLAN.on(drawn), BESIDE.on(drawn))


def results_for(drawn: Drawn, made: Flywheel, beside: Aside) -> Results:
    """Return the results of a flywheel as drawn, and of what was calculated beside it."""
    found = results_of(drawn, _marks(made, beside))
    return {name: result for name, result in found.items() if np.isfinite(result[0]).any()}


def _marks(made: Flywheel, beside: Aside) -> dict[str, Mark]:
    marks = {"cd": made.segment, "J_fly": made.inertia}
    if made.order.J is not None:
        marks["delta"] = made.delta
    if made.energy_mass is not None:
        marks["J_fly_energy_mass"] = made.energy_mass.inertia
    if made.rim is not None:
        rim = made.rim
        marks |= {"D_max": rim.limit, "D_e": rim.outer, "D_i": rim.inner, "D_mean": rim.mean}
        marks |= {"rim_mass": rim.mass, "rim_width": rim.width}
    for one in made.cylinder.every if made.cylinder is not None else ():
        for side in one.indicator.sides:
            if side.mean is not None:
                tag = one.tag if one.indicator.tag else ""
                marks["_".join(filter(None, ("p_mean", side.name, tag)))] = side.mean
    if beside.apart is not None:
        marks["J_apart"] = beside.apart
    marks |= {"M_mean": beside.moment, "power": beside.power, "A_excess": beside.excess}
    if beside.rim is not None:
        marks |= dict(zip(("J_made", "delta_made"), beside.rim[1:], strict=True))
    return marks


def rim_too_wide(results: Mapping[str, tuple[float, str]], language: str) -> str:
    """Return, of results, that the rim is too wide and what to do; empty where it is not."""
    if not {"D_max", "D_e", "rim_width"} <= set(results):
        return ""
    most, outer, width = (results[name][0] for name in ("D_max", "D_e", "rim_width"))
    least = wanted_outer(outer, width)
    if least is None:
        return ""
    text = _TOO_WIDE if least <= most else _TOO_WIDE_AND_SLOW
    sizes = {"outer": outer, "width": width, "least": least, "most": most}
    told = {name: number(size, language, 3) for name, size in sizes.items()}
    advice = plain(speaking(language)(text, **told))
    return f"{captions(language)['flywheel']}: {advice}"


TABLE = Tabled(columns=flywheel_columns, results=flywheel_results, marks=flywheel_marks)


def _views(project: Project) -> dict[str, list[str]]:
    charts = FLYWHEEL_PLAN.on(project).charts
    return {FLYWHEEL: [*(chart.view for chart in charts), STROKE, CALCULATED]}


def _title(holder: Holder, view: str, language: str) -> str:
    made = FLYWHEEL_PLAN.on(holder)
    varying = view == VIEWS["moment"]
    return graph_title(view, made.order.constant, speaking(language)) if varying else ""


PROTOCOL = Protocols(views=_views, titles=_title)
