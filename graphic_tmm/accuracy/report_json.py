"""A study for machines: JSON, or its runs as CSV; without seconds the same bytes for the same scene."""

from __future__ import annotations

import csv
import json
import math
from io import StringIO
from typing import Any

from graphic_tmm.accuracy.answer import Answer, MeasuredWay, Origin
from graphic_tmm.accuracy.answer_text import sentences, setting, step_name
from graphic_tmm.accuracy.cost import BoardWork
from graphic_tmm.accuracy.lessons import Fitted, Optimum, divisions
from graphic_tmm.accuracy.measure import Measurement
from graphic_tmm.accuracy.report_text import best_numbers, slopes
from graphic_tmm.accuracy.study import Study
from graphic_tmm.accuracy.timing import Seconds
from graphic_tmm.scene.packaged import scene_name

TOP = 10
"""Greatest number of steps listed for each quantity."""


def json_report(study: Study) -> str:
    """Return the study as JSON text: the answer, runs, slopes, best numbers."""
    told: dict[str, Any] = {
        "scene": scene_name(study.scene.source),
        "hand": study.hand,
        "trials": study.trials,
        "answer": _answer(study.answer),
        "quantities": {name: {"unit": unit} for name, unit in study.quantities.items()},
        "runs": [_run(study, run) for run in study.runs],
        "slopes": [_slope(study, one) for one in study.fitted],
        "optima": [_optimum(one) for one in study.optima],
        "choice": _work(study.choice),
        "sentences": [*slopes(study), *best_numbers(study)],
        "left_out": list(study.left_out),
        **_machine(study),
    }
    return json.dumps(told, ensure_ascii=False, indent=1) + "\n"


def csv_report(study: Study) -> str:
    """Return the runs of a study as CSV text, a line each; operations are left to JSON."""
    rows = []
    for run in study.runs:
        row = _run(study, run)
        del row["operations"]
        low, high = row.pop("seconds_quartiles", (None, None))
        rows.append({**row, "seconds_low": low, "seconds_high": high})
    out = StringIO()
    writer = csv.DictWriter(out, [*rows[0]], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()


def _answer(answer: Answer) -> dict[str, Any]:
    told: dict[str, Any] = {
        "sentences": [*sentences(answer)],
        "worst": answer.worst,
        "main": answer.main,
        "own": _row(answer, answer.own),
        "front": [_row(answer, row) for row in answer.rows],
        "knee": _row(answer, answer.knee),
        "sources": [_sources(origin, answer) for origin in answer.origins],
    }
    if answer.printed is not None:
        told["printed"] = {name: figure(error) for name, error in answer.printed.items()}
    if answer.halved is not None:
        told["halved"] = _row(answer, MeasuredWay(answer.halved.way, answer.halved.errors))
    if answer.nearest is not None:
        told["nearest"] = _row(answer, answer.nearest[0])
    if answer.wasted is not None:
        told["wasted"] = _row(answer, answer.wasted)
    return told


def _row(answer: Answer, row: MeasuredWay) -> dict[str, Any]:
    way = row.way
    return {
        "setting": setting(answer, way),
        **dict(way.changes),
        "hand": way.hand,
        "ruler": way.ruler,
        "enlarged": way.times,
        "minutes": figure(way.minutes),
        "errors_percent": {name: figure(error) for name, error in row.errors.items()},
    }


def _sources(origin: Origin, answer: Answer) -> dict[str, Any]:
    language = answer.scene.language
    return {
        "hand": origin.hand,
        "of": {
            name: {
                "mean_square_percent2": figure(of.square),
                "sources": {source: figure(share) for source, share in of.parts.items()},
                "together": figure(of.together),
                "in_mm": figure(of.in_mm),
                "steps": [
                    {
                        "step": step_name(origin, share, language),
                        "view": share.step.it.view,
                        "letter": share.step.it.letter,
                        "share": figure(share.share),
                    }
                    for share in of.steps[:TOP]
                ],
            }
            for name, of in origin.of.items()
        },
    }


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
    return found if run.seconds is None else found | _seconds(run.seconds)


def _seconds(seconds: Seconds) -> dict[str, Any]:
    return {
        "seconds": figure(seconds.least),
        "seconds_quartiles": [figure(seconds.low), figure(seconds.high)],
        "seconds_doubtful": seconds.doubtful,
    }


def _machine(study: Study) -> dict[str, Any]:
    """Return what was timed, and how busy the machine was; nothing if nothing was."""
    if study.answer.load is None:
        return {}
    load = study.answer.load
    return {
        "machine": [
            {"what": one.what, "positions": one.positions, **_seconds(one.seconds)}
            for one in study.answer.machine
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
