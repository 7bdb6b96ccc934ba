"""Assur's special points of other legs of a plate: a student may take one of them; its images on the plans."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Construction, Mark, segment_name
from graphic_tmm.board.values import Complexes, Length, Line
from graphic_tmm.chapters.kinematics.closings import ClosingLeg, PinLeg, PlateClosing, on_three_legs
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, SPECIAL_POINTS
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Choice


def special_choices(drawn: Drawn) -> Iterator[Choice]:
    """Yield the image of each special point on each plan, with where those of other legs have theirs."""
    made = KINEMATICS_PLAN.of(drawn.project)
    if made is None:
        return
    for closing in on_three_legs(made.positions.closings, SPECIAL_POINTS):
        for plan in (made.velocities, made.accelerations):
            if plan is not None and drawn.row(plan.images.pole.view):
                yield from _on_plan(drawn, closing, plan)


def _on_plan(drawn: Drawn, closing: PlateClosing, plan: Motion) -> Iterator[Choice]:
    number, view = closing.group.plate, plan.images.pole.view
    hanging = plan.images.hanging.get(number)
    reading, row = drawn.of(view), drawn.row(view)
    if hanging is None or reading is None or hanging.image not in reading:
        return
    images = [reading[plan.images.by_letter[number][pin]][:1] for pin in closing.pins]
    spots = [_row(drawn.reading[pin], drawn, row) for pin in closing.points]
    with np.errstate(all="ignore"):
        others = [
            images[0] + (point - spots[0]) * (images[1] - images[0]) / (spots[1] - spots[0])
            for point in _crossings(drawn, closing, row)
        ]
    places = np.full((len(others), len(drawn.names)), complex(np.nan, np.nan))
    places[:, list(row)] = np.concatenate(others)
    names = {
        segment_name(mark.letter) if mark.kind is Length else mark.key[1]
        for mark in _hanging(drawn, hanging.image)
    }
    yield Choice(view, hanging.image.key[1], places, frozenset(names))


def _hanging(drawn: Drawn, image: Mark) -> Iterator[Mark]:
    """Yield the image of a special point, what is laid off towards it and from it, what is measured from it."""
    log = drawn.construction
    hung = {image}
    if image.view == ACCELERATIONS:
        for line in _uses(log, image):
            start = _uses(log, line)[0]
            hung |= {start, _uses(log, start)[1]}
    for step in log.steps:
        if step.it.view != image.view:
            continue
        if step.op is lay_off and not hung.isdisjoint(_uses(log, step.uses[0])[:1]):
            hung |= {step.it, step.uses[1]}
        elif step.it.kind is Length and step.op.reads and not hung.isdisjoint(step.uses):
            hung.add(step.it)
    yield from hung


def _uses(log: Construction, mark: Mark) -> tuple[Mark, ...]:
    step = log.step(mark)
    return () if step is None else step.uses


def _crossings(drawn: Drawn, closing: PlateClosing, row: tuple[int, ...]) -> Iterator[Complexes]:
    """Yield where the lines of the other pairs of legs cross."""
    for first, second in combinations(range(3), 2):
        if {first, second} != {*closing.branch.crossing}:
            p, q = (_line(drawn, closing, closing.legs[k], row) for k in (first, second))
            share = wedge(q.at - p.at, q.along) / wedge(p.along, q.along)
            yield p.at + share * p.along


def _line(drawn: Drawn, closing: PlateClosing, leg: ClosingLeg, row: tuple[int, ...]) -> Line:
    """Return the line of a leg at the positions of a plan, of one that slides square to its guide."""
    pin, line = _row(drawn.reading[closing.pin(leg)], drawn, row), drawn.reading[leg.line]
    way = _row(line.along, drawn, row)
    return Line(pin, way if isinstance(leg, PinLeg) else 1j * way)


def _row(values: Complexes, drawn: Drawn, row: tuple[int, ...]) -> Complexes:
    """Return values, (1, position), at the positions of a plan."""
    wide = np.broadcast_to(values[:1], (1, len(drawn.names)))
    return np.asarray(wide[:, list(row)])
