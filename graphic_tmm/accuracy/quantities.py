"""The quantities whose error is told: of plans, diagrams, forces, a flywheel, a cam, gears."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.drawing import Drawing
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Reals
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.project import Project

CONVERGED = frozenset({"J_fly", "J_fly_energy_mass", "r0_min"})
"""Quantities that are known only when the row is fine."""


class Value(NamedTuple):
    """A mark, and what it is multiplied by to be the quantity: a scale factor's mark, or a number."""

    mark: Mark
    by: Mark | float = 1.0

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks to be read."""
        return (self.mark, self.by) if isinstance(self.by, Mark) else (self.mark,)


class Quantity(NamedTuple):
    """What is drawn, and what is due where the same log gives it.

    ``values``: read position by position, ``row`` of them from the first; a single number if it is 0.
    ``due``: what the values should be, drawn by an exact hand; empty where another drawing has to tell.
    """

    name: str
    unit: str
    values: tuple[Value, ...]
    row: int = 0
    due: tuple[Value, ...] = ()

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks to be read of a drawing."""
        return tuple(mark for value in self.values for mark in value.marks)

    def read(self, reading: Reading, trials: int, *, due: bool = False) -> Reals:
        """Return the quantity, (trial, value); ``due``: what it should be."""
        found = []
        for mark, by in self.due if due else self.values:
            value = reading[mark] * (reading[by] if isinstance(by, Mark) else by)
            wide = self.row or 1
            value = value[:, :wide] if value.shape[1] > 1 else value
            found.append(np.broadcast_to(value, (trials, wide)))
        return np.concatenate(found, axis=1)


def quantities(drawing: Drawing) -> tuple[Quantity, ...]:
    """Return the quantities that a drawing has, in the order in which they are found at the board."""
    made = drawing.made
    if isinstance(made, Project):
        return (*_plans(made), *_diagrams(made), *_machine(made))
    if isinstance(made, Cam):
        return (Quantity("r0_min", "m", (Value(made.least),)),)
    return _gears(made) if isinstance(made, Gear) else ()


def _plans(made: Project) -> list[Quantity]:
    found = []
    for name, unit, plan, motion in (
        ("v", "m/s", "velocities", made.velocities),
        ("a", "m/s²", "accelerations", made.accelerations),
    ):
        if motion is None:
            continue
        steps = made.construction.steps
        read = [s.it for s in steps if s.it.view == plan and s.op.reads and s.it.kind is Length]
        values = tuple(Value(mark, motion.mu) for mark in read)
        if values:
            found.append(Quantity(name, unit, values, made.count, values))
    return found


def _diagrams(made: Project) -> list[Quantity]:
    kinematic = made.kinematic
    if kinematic is None:
        return []
    found = []
    for symbol, motion in (("V", made.velocities), ("a", made.accelerations)):
        if motion is None or symbol not in kinematic.planned:
            continue
        chart = kinematic.charts[symbol]
        own = Value(chart.ordinates[0], chart.mu)
        due = Value(kinematic.planned[symbol], motion.mu)
        found.append(Quantity(f"{symbol}_diagram", chart.unit, (own,), made.count, (due,)))
    return found


def _machine(made: Project) -> list[Quantity]:
    found = []
    if made.forces is not None:
        moment = made.forces.order.balance == "moment"
        name, unit = ("M_bal", "N·m") if moment else ("P_bal", "N")
        # of the last pass of friction, whether passes have settled or not: a hand that slips scatters more
        value = (Value(made.forces.driven.balance),)
        due = () if made.forces.order.friction is not None else value
        found.append(Quantity(name, unit, value, made.count, due))
    if made.engine is not None:
        by = KGF if made.engine.order.unit == "kgf" else 1.0
        turning = Value(made.engine.values["M"], by)
        found.append(Quantity("M_engine", "N·m", (turning,), made.count))
    if made.flywheel is not None:
        found.append(Quantity("J_fly", "kg·m²", (Value(made.flywheel.inertia),)))
        if made.flywheel.energy_mass is not None:
            inertia = Value(made.flywheel.energy_mass.inertia)
            found.append(Quantity("J_fly_energy_mass", "kg·m²", (inertia,)))
    return found


def _gears(made: Gear) -> tuple[Quantity, ...]:
    """Return the contact ratio: as drawn on the line of action, and by the arc that a tooth goes through."""
    due = (Value(made.sizes.contact_ratio),)
    wheel, size = made.contact.wheels[0], made.sizes.wheels[0]
    pitch = 2.0 * pi / made.order.z1
    ratio = Quantity("contact_ratio", "", (Value(made.contact.drawn),), 0, due)
    # the arc is as long as the contact ratio times the pitch on the working circle
    arc = Quantity("contact_arc", "m", (Value(wheel.real, 1.0 / pitch),), 0)
    return (ratio, arc._replace(due=(Value(made.sizes.contact_ratio, size.r_w),)))
