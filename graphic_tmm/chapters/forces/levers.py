"""Each drive by a lever of its own: the plan of velocities as it alone causes them, the others held.

What holds the others does no work there, so that the lever must agree with what the groups leave at that drive.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.board.operations.statics import apart_percent
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.driving import Driven
from graphic_tmm.chapters.forces.lever import Lever, draw_lever
from graphic_tmm.chapters.forces.loads import Couple, Force, Ground
from graphic_tmm.chapters.forces.operations import left_percent
from graphic_tmm.chapters.forces.task import ForcesTask
from graphic_tmm.chapters.kinematics.by_drive import ByDrive
from graphic_tmm.chapters.kinematics.motion import image_letter


class Balanced(NamedTuple):
    """A drive balanced by both methods: P_b (N) or M_b (N·m) by groups, its lever, their difference (%).

    ``open``: by how much further passes of friction can change what the groups have; None without friction.
    """

    driven: Driven
    balance: Mark
    lever: Lever
    difference: Mark
    open: Mark | None = None

    @property
    def view(self) -> str:
        """The view of its lever."""
        return self.lever.pole.view


def draw_levers(
    ground: Ground, order: ForcesTask, forces: Sequence[Force], couples: Sequence[Couple]
) -> tuple[Lever, ...]:
    """Draw the lever of each drive; ``forces`` and ``couples``: all that do work on the plan of all drives."""
    return tuple(
        draw_lever(
            ground.draft,
            ground.positions,
            by,
            ([_on(by, ground, force) for force in forces], list(couples)),
            turned=bool(ground.quarters),
            couples=order.couples,
            moment=order.balance == "moment",
        )
        for by in ground.by_drive
    )


def _on(by: ByDrive, ground: Ground, force: Force) -> Force:
    """Return a force with the image of its point on the plan of one drive."""
    if by.motion is ground.velocities:
        return force
    plan, whole, body = by.motion, ground.velocities, ground.positions.bodies[force.link]
    for group, image in whole.closed.items():
        if image == force.image != whole.images.pole:
            return force._replace(image=plan.closed[group])
    known = whole.images.by_letter[force.link]
    letter = (
        body.letter_of(force.point)
        if force.point in body.marks.values()
        else next(letter for letter, image in known.items() if image == force.image)
    )
    ground.draft.open(plan.images.pole.view)
    shown = image_letter(letter, force.link)
    return force._replace(image=plan.images.of(force.link, force.point, letter, shown))


def compared(
    ground: Ground,
    driven: Driven,
    balance: Mark,
    lever: Lever,
    open_: Mark | None,
    *,
    left: bool,
) -> Balanced:
    """Compare what balances a drive by both methods; ``left``: nothing is due, and what is left is compared."""
    ground.draft.open(lever.pole.view)
    op, both = (apart_percent, (lever.balance, balance))
    if left:
        op, both = left_percent, (balance, lever.balance)
    difference = ground.draft.draw(op, "Δ", *both, unit="%")
    return Balanced(driven, balance, lever, difference, open_)
