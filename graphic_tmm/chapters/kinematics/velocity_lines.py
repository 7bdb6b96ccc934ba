"""Lines of a plan of velocities, direct or turned by 90°, drawn from lines of the plan of positions."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics import words as why


class VelocityLines(NamedTuple):
    """How lines of a plan are drawn; ``sense``: of the drive, by which a turned plan is turned."""

    draft: Draft
    turned: bool
    sense: int

    def across(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of a velocity square to a link (in the turned plan: along it).

        ``fixed``: the link turns about a pivot that stands still.
        """
        if self.turned:
            because = why.ABOUT_FIXED_TURNED if fixed else why.ABOUT_MOVING_TURNED
            return self.draft.draw(parallel, name, through, to, sense=self.sense, why=because)
        because = why.ABOUT_FIXED if fixed else why.ABOUT_MOVING
        return self.draft.draw(square, name, through, to, sense=1, why=because)

    def with_cylinder(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of what is left of a rod's velocity: square to it (in the turned plan: along it)."""
        if self.turned:
            sense, because = self.sense, why.ROD_TURNS_TURNED
            return self.draft.draw(parallel, name, through, to, sense=sense, why=because)
        return self.draft.draw(square, name, through, to, sense=1, why=why.ROD_TURNS)

    def out(self, name: str, through: Mark, to: Mark) -> Mark:
        """Draw the line of the velocity of a rod seen from its cylinder (in the turned plan: square to it)."""
        if self.turned:
            return self.draft.draw(
                square, name, through, to, sense=-self.sense, why=why.ROD_OUT_TURNED
            )
        return self.draft.draw(parallel, name, through, to, sense=1, why=why.ROD_OUT)

    def along(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of a velocity along a guide (in the turned plan: square to it).

        ``fixed``: the guide stands still.
        """
        if self.turned:
            because = why.ON_FIXED_GUIDE_TURNED if fixed else why.ON_MOVING_GUIDE_TURNED
            return self.draft.draw(square, name, through, to, sense=-self.sense, why=because)
        because = why.ON_FIXED_GUIDE if fixed else why.ON_MOVING_GUIDE
        return self.draft.draw(parallel, name, through, to, sense=1, why=because)
