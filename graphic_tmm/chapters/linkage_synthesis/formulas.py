"""Formulas of a synthesis on the board: angles that are laid off, differences of lengths."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length
from graphic_tmm.language.said import said

_CENTRE_ANGLE = said(
    "At the centre of the circle the chord is seen under 2·θ, so both radii to its ends are at 90° − θ to it."
)
_HALF = said("The axis halves the angle.")
_TURNED = said("What is held turns the rest back by as much.")


@formula(why=_CENTRE_ANGLE)
def angle_at_chord(theta: Angle) -> Angle:
    """90° − {theta}"""


@formula(why=_CENTRE_ANGLE)
def back_at_chord(theta: Angle) -> Angle:
    """{theta} − 90°"""


@formula(why=_HALF)
def half_angle(angle: Angle) -> Angle:
    """{angle}/2"""


@formula(why=_HALF)
def half_angle_back(angle: Angle) -> Angle:
    """−{angle}/2"""


@formula(why=_TURNED)
def turned_by(start: Angle, end: Angle) -> Angle:
    """{end} − {start}"""


@formula(why=said("On the other side of the line angles are counted the other way."))
def counted_back(angle: Angle) -> Angle:
    """−{angle}"""


@formula(why=said("In a dead centre coupler and crank lie in one line, one behind the other."))
def stretched(rod: Length, crank: Length) -> Length:
    """{rod} + {crank}"""


@formula(why=said("In the other dead centre the crank lies over the coupler."))
def overlapping(rod: Length, crank: Length) -> Length:
    """{rod} − {crank}"""


@formula(why=said("Half of it lies on each side."))
def half_length(length: Length) -> Length:
    """{length}/2"""
