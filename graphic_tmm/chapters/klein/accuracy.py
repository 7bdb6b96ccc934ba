"""What the constructions cost the hand, and how true they are, beside the plans: a_B in a position."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.cost import count, varying
from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import EXACT, HANDS
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.chapters.klein.record import KLEIN_PLAN
from graphic_tmm.chapters.klein.task import KLEIN, RITTERHAUS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project

TRIALS = 400
"""How often a student draws all of it: the scatter is known to 2 % then."""


class Price(NamedTuple):
    """What a way of finding a_B takes: elementary operations in one position; its scatter, % of the largest."""

    operations: float
    scatter: float


def sought(project: Project) -> dict[str, tuple[Mark, Mark | None]]:
    """Return by way of drawing the mark that a_B is read off by, and its scale factor if it is a length."""
    made, plans = KLEIN_PLAN.on(project), KINEMATICS_PLAN.on(project)
    wanted = f"a_{made.of.slider}"
    found: dict[str, tuple[Mark, Mark | None]] = {
        view: (next(one.value for one in figure.quantities if one.vector == wanted), None)
        for view, figure in made.figures.items()
    }
    motion = plans.accelerations
    if motion is not None and plans.accelerated:
        image = motion.images.by_letter[made.of.rod.link][made.of.slider]
        step = next(
            one for one in project.construction.steps
            if one.op.reads and one.it.view == ACCELERATIONS and one.uses[:2] == (motion.images.pole, image)
        )  # fmt: skip
        found[ACCELERATIONS] = step.it, motion.mu
    return found


def prices(drawn: Drawn) -> dict[str, Price]:
    """Return what each way takes, and how a student's a_B scatters; computed once for a drawing."""
    known: dict[str, Price] | None = drawn.cache.get(KLEIN)
    if known is None:
        known = drawn.cache[KLEIN] = _prices(drawn)
    return known


def _prices(drawn: Drawn) -> dict[str, Price]:
    log, ways = drawn.construction, sought(drawn.project)
    marks = [mark for way in ways.values() for mark in way if mark is not None]
    exact, tried = (
        execute(log, drawn.given, marks, hand=hand)
        for hand in (EXACT, HANDS["student"]._replace(trials=TRIALS))
    )
    places, found = list(KLEIN_PLAN.on(drawn).places), dict[str, Price]()
    varies = varying(drawn.given)
    whole = (1, len(drawn.names))
    due = {
        way: np.broadcast_to(np.abs(exact[mark]) * (exact[mu] if mu else 1.0), whole)[:, places]
        for way, (mark, mu) in ways.items()
    }
    there = np.isfinite([row[0] for row in due.values()]).all(axis=0)
    for way, (mark, mu) in ways.items():
        work = count(log, varies, [mark]).simplicity
        if not there.any():
            found[way] = Price(float(work), np.nan)
            continue
        own = np.abs(tried[mark]) * (tried[mu] if mu else 1.0)
        own = np.broadcast_to(own, (TRIALS, len(drawn.names)))[:, places]
        off = np.abs(own - due[way])[:, there] / np.max(due[way][:, there])
        off = off[np.isfinite(off)]
        scatter = 100.0 * float(np.sqrt(np.mean(off**2))) if off.size else np.nan
        found[way] = Price(float(work), scatter)
    return found


def _quantities(project: Project) -> Iterator[Quantity]:
    """Yield v_B and a_B by each construction, position by position."""
    made, count_ = KLEIN_PLAN.on(project), KINEMATICS_PLAN.on(project).count
    for view, figure in made.figures.items():
        for one in figure.quantities:
            if one.vector in (f"v_{made.of.slider}", f"a_{made.of.slider}"):
                value = Value(one.value)
                name = f"{one.vector[0]}_{view}"
                yield Quantity(
                    name, one.value.unit, (value,), count_, due=(value,), places=(KLEIN,)
                )


WORDS = {
    f"v_{KLEIN}": said("v by Klein"),
    f"a_{KLEIN}": said("a by Klein"),
    f"v_{RITTERHAUS}": said("v by Ritterhaus"),
    f"a_{RITTERHAUS}": said("a by Ritterhaus"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(quantities=_quantities, places=(KLEIN,), words=WORDS)
