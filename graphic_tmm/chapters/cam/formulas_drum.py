"""Formulas of drums and of grooves: the developed circumference, curvature of its centre line, both flanks."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.chapters.cam.words_drum import TURNING
from graphic_tmm.language.said import said


@formula(
    why=said("Developed, the drum's mean circumference is laid off: R times the angle, in radians.")
)
def developed(radius: Length, angle: Angle) -> Length:
    """{radius}·π·{angle}/180°"""


@formula(why=said("The developed drum is as long as its mean circumference."))
def circumference(radius: Length) -> Length:
    """2·π·{radius}"""


@formula(why=TURNING)
def turning_of_tangent(a: Length, radius: Length, pace: Length) -> Number:
    """−{a}·{radius}/{pace}²"""


@formula(
    holds="{pace} > −{roller}·{turning}",
    fails="the roller is larger than the radius of curvature of a hollow of its path",
    why=said(
        "The outer flank lies at the roller's radius on the other side of the path: where the path is hollow "
        "it is shorter by the radius times the turning of the normal."
    ),
)
def outer_pace(pace: Length, roller: Length, turning: Number) -> Length:
    """{pace} + {roller}·{turning}"""


@formula(
    holds="{height} ≠ 0",
    fails="the path of the roller is straight",
    why=said("Both flanks of a groove touch the roller: the sharpest bend to either side decides."),
)
def sharpest_bend(height: Length, mu: Number) -> Number:
    """1/(|{height}|·{mu})"""
