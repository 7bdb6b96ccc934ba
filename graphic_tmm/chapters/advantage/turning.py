"""What balances the drive by instantaneous centres at any angle of the crank."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.advantage.plan import ADVANTAGE_PLAN
from graphic_tmm.chapters.advantage.table import stem
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield what balances the drive, where both centres and forces are asked for."""
    made = ADVANTAGE_PLAN.on(project)
    if made.balance is not None:
        yield TurnQuantity(FORCES, "balance", f"{stem(made)}_centres", made.balance)


TURNING = Turning(told=quantities)
