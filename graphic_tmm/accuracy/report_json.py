"""A study for machines: one JSON object; without seconds it is the same bytes for the same scene."""

from __future__ import annotations

import json
import math
from typing import Any

from graphic_tmm.accuracy.advice import advice, best_numbers, most, slopes, step_name
from graphic_tmm.accuracy.cost import BoardWork
from graphic_tmm.accuracy.lessons import Fitted, Optimum, divisions
from graphic_tmm.accuracy.measure import Measurement
from graphic_tmm.accuracy.study import Study
from graphic_tmm.accuracy.timing import Seconds
from graphic_tmm.scene.packaged import scene_name

TOP = 10
"""Greatest number of steps listed for each quantity."""


def json_report(study: Study) -> str:
    """Return the study as JSON text: runs, slopes, best numbers, shares of steps, advice."""
    told: dict[str, Any] = {
        "scene": scene_name(study.scene.source),
        "hand": study.hand,
        "trials": study.trials,
        "quantities": {name: {"unit": unit} for name, unit in study.quantities.items()},
        "runs": [_run(study, run) for run in study.runs],
        "slopes": [_slope(study, one) for one in study.fitted],
        "optima": [_optimum(one) for one in study.optima],
        "steps": {
            steps.quantity: [
                {
                    "step": step_name(study, steps, share),
                    "view": share.step.it.view,
                    "letter": share.step.it.letter,
                    "share": figure(share.share),
                    "deviation_percent": figure(share.deviation),
                }
                for share in steps.shares[:TOP]
            ]
            for steps in study.steps
        },
        "choice": _work(study.choice),
        "sentences": [*slopes(study), *best_numbers(study)],
        "advice": [*advice(study), *most(study)],
        "left_out": list(study.left_out),
        **_machine(study),
    }
    return json.dumps(told, ensure_ascii=False, indent=1) + "\n"


def _run(study: Study, run: Measurement) -> dict[str, Any]:
    found: dict[str, Any] = {
        "quantity": run.quantity,
        "axis": run.axis,
        "value": run.value,
        "positions": run.positions,
        "hand": run.hand,
        "enlarged": run.enlarged,
        "trials": run.trials,
        "error_percent": figure(run.errors.error),
        "error_median_percent": figure(run.errors.median),
        "error_standard_error": figure(run.errors.spread),
        "failed_percent": figure(run.errors.failed),
        **_work(run.work),
        "pareto": run in study.fronts,
    }
    if run.seconds is not None:
        found |= {
            **_seconds(run.seconds),
            "pareto_seconds": run in study.fast,
        }
    return found


def _seconds(seconds: Seconds) -> dict[str, Any]:
    return {
        "seconds": figure(seconds.least),
        "seconds_quartiles": [figure(seconds.low), figure(seconds.high)],
        "seconds_doubtful": seconds.doubtful,
    }


def _machine(study: Study) -> dict[str, Any]:
    """Return what was timed, and how busy the machine was; nothing if nothing was."""
    if study.load is None:
        return {}
    load = study.load
    return {
        "machine": [
            {"what": one.what, "positions": one.positions, **_seconds(one.seconds)}
            for one in study.machine
        ],
        "load": {
            "busy": load.busy,
            "elsewhere": figure(load.elsewhere),
            "scattered": load.scattered,
            "timed": load.calls,
        },
    }


def _work(work: BoardWork) -> dict[str, Any]:
    return {
        "simplicity": work.simplicity,
        "exactitude": work.exactitude,
        "minutes": figure(work.minutes),
        "symbol": work.symbol,
        "operations": dict(sorted(work.operations.items())),
    }


def _slope(study: Study, one: Fitted) -> dict[str, Any]:
    found = {
        "quantity": one.quantity,
        "error": figure(one.error.slope),
        "error_half_width": figure(one.error.half_width()),
        "minutes": figure(one.minutes.slope),
    }
    if not study.timed:
        return found
    width = figure(one.seconds.half_width())
    return found | {"seconds": figure(one.seconds.slope), "seconds_half_width": width}


def _optimum(one: Optimum) -> dict[str, Any]:
    return {
        "quantity": one.quantity,
        "hand": one.hand,
        one.axis: divisions(one.best),
        "error_percent": figure(one.best.error),
        "as_good": list(one.sure),
        "inside": one.inside,
        "flat": one.flat,
    }


def figure(value: float) -> float | None:
    """Return a figure without the noise of the last bits; None where there is none."""
    return float(f"{value:.9g}") if math.isfinite(value) else None
