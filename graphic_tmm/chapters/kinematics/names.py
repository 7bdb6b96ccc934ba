"""What others call what there is of the plans: views, places, what was made."""

from __future__ import annotations

from graphic_tmm.language.said import said

KINEMATICS = "kinematics"
POSITIONS, VELOCITIES, ACCELERATIONS = "positions", "velocities", "accelerations"
"""The plans: places of sheets, views of the board, and what other chapters need."""
PLANS = (POSITIONS, VELOCITIES, ACCELERATIONS)
TURNS = "turns"
"""What else may be needed of the plans: that their row goes over so many turns of the crank."""
EXTREMES = "extremes"
GIVEN = "given"
"""The place of the table of what is given."""
FULL_TURN = said(
    "a curve goes through all positions of a turn, and the mechanism does not assemble in each of them; "
    "change its lengths so that the crank turns fully"
)
"""Why there is no curve along the positions, and what to do."""
