"""The columns and the results of a law of motion; its views in protocols."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN
from graphic_tmm.chapters.motion_law.task import MOTION_LAW
from graphic_tmm.chapters.motor.task import RUN, STEP
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, ordinates
from graphic_tmm.readers.protocol import Protocols


def law_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield what each graph shows, by positions; ε and 1/ω stand with the interval that begins there."""
    for chart in LAW_PLAN.on(drawn).charts:
        mark = chart.ordinates[0]
        rows = ordinates(drawn.reading, mark, chart.mu, len(drawn.names))
        yield Column(MOTION_LAW, chart.symbol, chart.symbol, chart.unit, *rows)


def law_marks(drawn: Drawn) -> dict[str, Mark]:
    """Return the marks of the results."""
    law = LAW_PLAN.on(drawn)
    marks = {
        "motion_start": law.inertia.start,
        "motion_energy": law.inertia.first,
        "motion_speed": law.omega.end,
        "motion_angle": law.angle,
        "motion_time": law.time,
        "motion_turns": law.run_up,
        "motion_step": law.step.omega if law.step is not None else None,
        "motion_delta": law.delta,
        "motion_flywheel": law.flywheel,
        "motion_error": law.error,
    }
    return {name: mark for name, mark in marks.items() if mark is not None}


def law_results(drawn: Drawn) -> Results:
    """Return the results: how far, how long, how fast at the end of the base."""
    found = results_of(drawn, law_marks(drawn))
    return {name: one for name, one in found.items() if np.isfinite(one[0]).any()}


TABLE = Tabled(columns=law_columns, results=law_results, marks=law_marks)


def _views(project: Project) -> dict[str, list[str]]:
    law = LAW_PLAN.on(project)
    motor = [RUN] if law.motor is None else [RUN, STEP]
    return {MOTION_LAW: [*(chart.view for chart in law.charts), *motor]}


PROTOCOL = Protocols(views=_views)
