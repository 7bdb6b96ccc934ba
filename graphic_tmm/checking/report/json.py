"""A report for machines: one JSON object, a reading a line, nothing lost but the noise of the last bits."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from typing import Any

from graphic_tmm.checking.records import DOUBTFUL, Judged, Lesson, Likely, OwnScale, Report, Sight
from graphic_tmm.checking.report.findings import explained, unexplained
from graphic_tmm.checking.report.rows import counts


def json_report(report: Report) -> str:
    r"""Return the report as JSON text.

    ``readings``: {plan, position, segment, mm, due_mm, deviation_mm, percent_of_plan, verdict, step, quantile};
    doubt of a doubtful one, 0 as a hand to 1 as good as wrong;
    where it was given as a quantity the mm are null and value, due_value, deviation_value and unit follow; x
    and y (mm) where a point was read; own_error_mm where a step is blamed with its own error; follows_from, the
    segment of the earlier reading (follows_from_line) whose deviation it has; line of the file.
    ``whole``, where the drawing is farther off than a hand's as a whole, else null: {rare, doubtful, due, of}.
    ``mistakes``: {name, says, like, kind, family, plan, segment, position, step, chance, lines, explains,
    wrong, rest}. ``unexplained``: how many of the wrong readings no mistake explains. ``lessons``, of the steps
    that are blamed: {plan, step, letter, says, why, drawn, position, calculation,
    own_numbers}. ``scales``, in which plans were drawn that are not the task's: {plan, view, symbol, mu, due,
    unit, by ("stated", "rows", "rates", "round", "lengths"), agree, among, positions, lengths_say, rates_say};
    ``head``: sentences on how it was judged. Figures have 12
    significant digits; one that is not finite is null.
    Text is whole, what is not printable in it as \\u escapes.
    """
    head = {"scene": report.scene, "title": report.title, "hand": report.hand}
    lines = [f" {_key(key)}: {_dumped(text)}," for key, text in head.items()]
    lines.append(f' "counts": {_dumped(counts(report))},')
    if report.sight is not None:
        lines.append(f' "seen": {_dumped(_sight(report.sight))},')
    whole = None if report.whole is None else report.whole._asdict()
    lines.append(f' "whole": {_dumped(whole)},')
    lines += _rows("readings", [_reading(one) for one in report.readings])
    lines += _rows("mistakes", [_mistake(report, one) for one in report.mistakes])
    lines += _rows("lessons", [_lesson(one) for one in report.lessons])
    lines += _rows("scales", [_scale(one) for one in report.scales])
    lines.append(f' "head": {_dumped(list(report.head))},')
    lines.append(f' "unexplained": {len(unexplained(report))},')
    lines.append(f' "notes": {_dumped(list(report.notes))}')
    return "\n".join(["{", *lines, "}"]) + "\n"


def tidy(value: float | None) -> float | None:
    """Return a figure with 12 significant digits and no -0; None if there is none or it is not finite."""
    if value is None or not math.isfinite(value):
        return None
    return float(f"{value:.12g}") + 0.0


def _sight(sight: Sight) -> dict[str, Any]:
    plans = [
        {
            "plan": one.plan,
            "asked": one.asked,
            "unseen": list(one.unseen),
            "partly": list(one.partly),
        }
        for one in sight.plans
    ]
    return {"points": sight.points, "of": sight.of, "plans": plans}


def _reading(one: Judged) -> dict[str, Any]:
    taken, drawn = one.taken, one.unit == "mm"
    figures = [tidy(value) for value in (one.found, one.due, one.deviation)]
    mm = figures if drawn else [None] * 3
    told: dict[str, Any] = {
        "plan": taken.plan,
        "position": taken.position,
        "segment": taken.segment,
    }
    told |= dict(zip(("mm", "due_mm", "deviation_mm"), mm, strict=True))
    told |= {"percent_of_plan": tidy(one.percent), "verdict": one.verdict, "step": one.step}
    told |= {"quantile": tidy(one.quantile)}
    told |= {"doubt": tidy(one.doubt)} if one.verdict == DOUBTFUL else {}
    if not drawn:
        told |= dict(zip(("value", "due_value", "deviation_value"), figures, strict=True))
        told |= {"unit": one.unit}
    if taken.x is not None or taken.y is not None:
        told |= {"x": tidy(taken.x), "y": tidy(taken.y)}
    told |= {"own_error_mm": tidy(one.own)} if one.own is not None else {}
    if one.follows is not None:
        told |= {"follows_from": one.follows.segment, "follows_from_line": one.follows.line}
    return told | ({"line": taken.line} if taken.line else {})


def _mistake(report: Report, one: Likely) -> dict[str, Any]:
    return {
        "name": one.name,
        "says": one.says,
        "like": list(one.like),
        "kind": one.kind,
        "family": one.family,
        "plan": one.plan,
        "segment": one.segment,
        "position": one.position,
        "step": one.step,
        "chance": tidy(one.chance),
        "lines": list(one.lines),
        "explains": explained(report, one),
        "wrong": one.wrong,
        "rest": tidy(one.rest),
    }


def _lesson(one: Lesson) -> dict[str, Any]:
    return {
        "plan": one.plan,
        "step": one.step,
        "letter": one.letter,
        "says": one.says,
        "why": one.why,
        "drawn": list(one.drawn),
        "position": one.position,
        "calculation": one.calculation,
        "own_numbers": one.own,
    }


def _scale(one: OwnScale) -> dict[str, Any]:
    return {
        "plan": one.plan,
        "view": one.view,
        "symbol": one.symbol,
        "mu": tidy(one.mu),
        "due": tidy(one.due),
        "unit": one.unit,
        "by": one.by,
        "agree": one.agree,
        "among": one.among,
        "positions": {place: tidy(mu) for place, mu in one.places},
        "lengths_say": tidy(one.against[0]),
        "rates_say": tidy(one.against[1]),
    }


def _rows(key: str, rows: Sequence[dict[str, Any]]) -> list[str]:
    if not rows:
        return [f" {_key(key)}: [],"]
    told = [f"  {_dumped(row)}" for row in rows]
    return [f" {_key(key)}: [", *(f"{line}," for line in told[:-1]), told[-1], " ],"]


def _key(key: str) -> str:
    return f'"{key}"'


def _dumped(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False, allow_nan=False)
    return text if text.isprintable() else "".join(map(_visible, text))


def _visible(sign: str) -> str:
    return sign if sign.isprintable() else json.dumps(sign)[1:-1]
