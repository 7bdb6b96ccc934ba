"""Every figure that a table gives of a row of positions, beside what is so at 50 digits.

The rows are of random mechanisms: where they were drawn, and so many degrees before they lock. The judges are
the loops solved by Newton's method and the equations of Newton and Euler, both in digits.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any, NamedTuple

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np

from graphic_tmm.board.operations.instruments import measure, measure_along
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ForcesTask
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.records import Mechanism, Row
from graphic_tmm.readers.columns import (
    Column,
)
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.records import Scene, SheetOrder
from support import dynamics, oracle
from support.boards import drawn_of
from support.dynamics import Loaded
from support.hard_judge import DIGITS, exact_of
from support.loaded import order_of, places, weighed
from support.locks import locks, solved_at
from support.mechanisms import Sampled

SHOWN = ("positions", "velocities", "accelerations", "forces", "lever", "force table")
READ = (measure, measure_along)
"""How a vector from the pole is read: a slider's along its guide."""
OFFS = tuple(10.0**-k for k in range(1, 13))
"""How far from locking, degrees."""
NOUGHT = 1e-6
"""A zero may be told of what is smaller than this share of the largest of its kind at its position."""

Key = tuple[str, str]
"""Plan and segment."""


class Told(NamedTuple):
    """A figure: where it stands, what the table gives, what is due, the largest of its kind there."""

    key: Key
    place: int
    value: float | None
    due: Any
    size: Any

    @property
    def off(self) -> float:
        return float(abs(mp.mpf(self.value) - self.due))

    @property
    def unit(self) -> float:
        """The value of the last digit that is not a trailing nought, of twelve at most."""
        exponent = Decimal(f"{self.value:.12g}").normalize().as_tuple().exponent
        assert isinstance(exponent, int)
        return 10.0**exponent

    @property
    def right(self) -> bool:
        """Whether the figure is right to two in its last digit; a zero, to a millionth."""
        if self.value == 0.0:
            return self.off <= NOUGHT * float(self.size)
        assert self.value is not None
        return self.off <= 2.0 * self.unit


def scene_of(mechanism: Mechanism, order: ForcesTask, angles: Sequence[float]) -> Scene:
    """A scene of these positions: the first the row's only one, the others extras."""
    row = Row(1, 1, angles[0], tuple(angles[1:]), ("all",))
    sheets = (SheetOrder("A1", SHOWN),)
    return Scene("random", "random", "en", mechanism, row, sheets=sheets).asking(forces=order)


def drawn_at(one: Loaded, angles: Sequence[float]) -> tuple[Drawn, list[Column]]:
    order = order_of(one, gravity=True, inertia=True, balance="force")
    made = drawn_of(scene_of(one.mechanism, order, angles), exact=True)
    return made, columns_of(made)


def figures(one: Loaded, angles: Sequence[float]) -> tuple[Drawn, list[Told]]:
    """Draw a row; return its figures of which the truth is known."""
    made, columns = drawn_at(one, angles)
    found = []
    for place, angle in enumerate(angles):
        due = truth(made, one, angle)
        if due is None:
            continue
        for column in columns:
            key = column.plan, column.segment
            if key in due:
                found.append(Told(key, place, column.first_figures[1][place], *due[key]))
    return made, found


def truth(made: Drawn, one: Loaded, angle: float) -> dict[Key, tuple[Any, Any]] | None:
    """Return what is due at an angle, and the largest of its kind, by plan and segment."""
    found = solved_at(one.mechanism, angle)
    if found is None:
        return None
    with mp.workdps(DIGITS):
        return {**_motion(made, one.mechanism, found[1]), **_forces(made, one, angle, *found)}


def _motion(made: Drawn, mechanism: Mechanism, rates: Any) -> dict[Key, tuple[Any, Any]]:
    exact = exact_of(mechanism, rates)
    project, found = made.project, dict[Key, tuple[Any, Any]]()
    plans = (
        ("velocities", KINEMATICS_PLAN.on(project).velocities, 1, "omega", exact.omega),
        ("accelerations", KINEMATICS_PLAN.on(project).accelerations, 2, "epsilon", exact.epsilon),
    )
    fastest = max(abs(w) for w in exact.omega.values())
    for plan, motion, n, rate, turns in plans:
        assert motion is not None
        size = max(abs(z[n]) for z in exact.points.values())
        images = {
            mark: (letter, link)
            for link, by_letter in motion.images.by_letter.items()
            for letter, mark in by_letter.items()
            if (letter, link) in exact.points
        }
        for step in project.construction.steps:
            if step.it.view == plan and step.op in READ and step.uses[0] == motion.images.pole:
                name = images.get(step.uses[1])
                if name is not None:
                    segment = step.it.letter.translate({ord(c): None for c in "_{}"})
                    found[plan, segment] = abs(exact.points[name][n]), size
        largest = max([abs(t) for t in turns.values()] + [fastest**n])
        for link in motion.rates:
            found[plan, f"{rate}{link}"] = turns[link], largest
    return found


def _forces(
    made: Drawn, one: Loaded, angle: float, poses: Any, rates: Any
) -> dict[Key, tuple[Any, Any]]:
    assert FORCES_PLAN.of(made) is not None
    try:
        state = oracle.solve_fast(one.mechanism, angle, poses)
    except oracle.OracleError:
        # in floats it does not come to rest so near to a lock
        return {}
    judge = dynamics.statics(
        one.mechanism,
        replace(state, rates=rates),
        one.forces,
        one.moments,
        gravity=True,
        inertia=True,
        balance="force",
        at=places(KINEMATICS_PLAN.on(made).structure, KINEMATICS_PLAN.on(made).positions),
        digits=True,
    )
    sizes = {k: abs(v) for k, v in judge.reactions.items()}
    largest = max([*sizes.values(), abs(judge.balance)])
    found = {
        ("forces", f"R{i}{j}"): (sizes[i, j], largest)
        for reaction in FORCES_PLAN.on(made).reactions
        for i, j in [reaction.links]
    }
    for way in ("forces", "lever"):
        found["forces", f"P_bal_{way}"] = judge.balance, largest
    return found


def rows(drawn: Sequence[Sampled]) -> Iterator[tuple[Loaded, tuple[float, ...]]]:
    """Yield loaded mechanisms and their angles: as they were drawn, a little on, before they lock if they do.

    The distances from the lock take turns.
    """
    for k, one in enumerate(drawn):
        loaded = weighed(one, k)
        angles = [one.phi, one.phi + 7.0]
        end = locks(one.mechanism, one.phi)
        if end is not None:
            angles.append(end - OFFS[k % len(OFFS)])
        yield loaded, tuple(dict.fromkeys(angles))


def dead_centre(seed: int) -> tuple[Mechanism, float]:
    """A slider-crank, and an angle in line, or some power of ten of a degree beside it."""
    from support.hard_mechanisms import slider_crank

    source = np.random.default_rng(seed)
    r = float(source.uniform(0.05, 0.4))
    off = (0.0, *OFFS)[seed % (len(OFFS) + 1)]
    angle = (0.0 if seed % 2 else 180.0) + off * (1 if seed % 3 else -1)
    return slider_crank(r, r * float(source.uniform(1.3, 4.0))), angle % 360.0
