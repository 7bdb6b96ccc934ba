"""What can be changed on a page: each given quantity, by its letter; where a mechanism breaks, and why."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.findings import Finding, step_number
from graphic_tmm.board.record import Mark
from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.board.values import Curve, Number
from graphic_tmm.language.symbols import spoken
from graphic_tmm.language.units import unit
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.live.joints import joints
from graphic_tmm.page.live.keys import Letter, Meaning, keys, opposite_of
from graphic_tmm.page.live.log import LiveLog, turned_figure
from graphic_tmm.page.live.scales import free_scales, marks_of, scales_data
from graphic_tmm.page.sentences import marked_up
from graphic_tmm.readers.findings import reason
from graphic_tmm.readers.protocol import title_of

IN_MM = 1000.0
"""Lengths are told in mm."""


def live_log(
    found: Dense,
    slots: Collection[int],
    charted: Collection[int],
    script: RowScript,
    language: str,
) -> tuple[dict[str, Any], Mapping[str, str]]:
    """Return what the page needs to run the log with other givens, and the steps of the log written down.

    ``slots``: the marks that ink and what is told of figures are of; ``charted``: those of diagrams.
    """
    body = _Body(LiveLog(found, RowScript()))
    over = {mark.slot for mark in body.marks}
    scales = free_scales(found)
    log = LiveLog(found, script, {*slots, *over, *marks_of(scales)}, over, charted)
    # the pin of the crank is what turns it
    crank = [mark.slot for mark in body.crank]
    data = {
        **log.data(),
        "sliders": list(_sliders(log, language)),
        "breaks": list(_breaks(log, body, language)),
        "pin": crank,
        "joints": [
            [*one, *(crank[:1] if one[0] in crank else ())] for one in joints(log, body.views)
        ],
        "paths": list(_paths(log, body)),
        **_output(log, body, language),
        "scales": scales_data(log, scales),
    }
    return data, log.functions


class _Body:
    """The figures that move, and in the mechanism itself the pivot and the pin of what is turned."""

    def __init__(self, log: LiveLog) -> None:
        figure = turned_figure(log.found)
        self.crank = () if figure is None or figure.crank is None else figure.crank
        self.output = None if figure is None else figure.output
        self.views = {mark.view for mark in self.crank}
        steps = (*log.still, *log.turn)
        self.marks = [step.it for step in steps if step.it.view in self.views]


def _output(log: LiveLog, body: _Body, language: str) -> dict[str, Any]:
    """Return what is moved to and fro where a crank turns, with how many steps are a turn; else nothing.

    A link that turns has its number for a letter.
    """
    found, output = log.found, body.output
    view = None if output is None else found.log.view(output.point.view)
    if output is None or view is None or view.scale is None or found.ends:
        return {}
    data = {
        "slot": output.point.slot,
        "scale": view.scale.slot,
        "turn": round(360 / abs(found.per)),
    }
    if output.pivot is None:
        return {"out": {**data, "l": marked_up(output.point, language)}}
    return {"out": {**data, "l": str(output.link), "pivot": output.pivot.slot}}


def _sliders(log: LiveLog, language: str) -> Iterator[dict[str, Any]]:
    """Yield what can be changed: one quantity for one letter, in however many views it stands."""
    project = log.found.sheet.project
    scales: dict[Mark | None, str] = {}
    for view in log.found.log.views:
        scales.setdefault(view.scale, view.name)
    same: dict[tuple[str, str, float, str], list[Mark]] = {}
    for mark in log.own:
        value = log.own[mark]
        if (
            mark.kind is Number
            and mark.unit
            and np.size(np.asarray(value)) == 1
            and mark in log.used
        ):
            key = (mark.name, mark.unit, float(np.ravel(value)[0]), scales.get(mark, ""))
            same.setdefault(key, []).append(mark)
    known = keys(project.scene, project)
    minus = {
        own: same.pop(key)
        for key in list(same)
        if (own := (opposite_of(key[0]), key[1], -key[2], key[3])) in same
    }
    # scales last: whoever opens the page looks for lengths
    for key, marks in sorted(same.items(), key=lambda one: one[0][3] != ""):
        _, of, value, plan = key
        yield {
            "l": marked_up(marks[0], language),
            "n": spoken(marks[0], language),
            "u": unit("mm" if of == "m" else of, language),
            "by": IN_MM if of == "m" else 1.0,
            "v": value,
            "slots": [mark.slot for mark in marks],
            **({"minus": [mark.slot for mark in minus[key]]} if key in minus else {}),
            **({"plan": title_of(project, plan, language)} if plan else {}),
            **_key(marks, known),
        }


def _key(marks: list[Mark], known: dict[Letter, Meaning]) -> dict[str, Any]:
    """Return the number of the scene that a quantity is; nothing of one that is none."""
    found = {known.get(mark.key) for mark in marks}
    only = found.pop() if len(found) == 1 else None
    return {} if only is None else {"key": only.data()}


def _breaks(log: LiveLog, body: _Body, language: str) -> Iterator[list[Any]]:
    """Yield the steps that the mechanism itself needs: the slot, and why it may have no answer."""
    found, project = log.found, log.found.sheet.project
    there = {step.it for step in (*log.still, *log.turn)}
    for step in needed(found.log, body.marks):
        if step.it in there:
            fault = Finding("undrawn", step, step_number(project.construction, step), (), 0.0)
            yield [step.it.slot, reason(fault, project, language)]


def _paths(log: LiveLog, body: _Body) -> Iterator[int]:
    """Yield the points (slots) whose paths the view of the mechanism has."""
    there = set(body.marks)
    for step in log.found.sheet.construction.steps:
        if step.op.across and step.it.kind is Curve and step.it.view in body.views:
            yield from (mark.slot for mark in step.uses if mark in there)
