"""What is done and calculated for curvature: points carried over, radii, points of the inflection circle."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.statics import STANDS
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said


@formula(
    holds="{normal} ≠ 0",
    fails="the normal acceleration reads 0: the path is straight there",
    why=said(
        "The centre of curvature lies on the side to which the normal acceleration {normal} points."
    ),
)
def radius_towards(radius: Number, mu_l: Number, normal: Length) -> Length:
    """{radius}/{mu_l}·sgn({normal})"""


@formula(
    holds=f"{{radius}} > {STANDS:.9f}·{{ray}}",
    fails="the centre of curvature is at the point itself, or too near to be seen on so small a drawing",
    why=said(
        "By Euler and Savary the square of the distance {ray} from the instantaneous centre is the distance "
        "from the centre of curvature, {radius}, times that from the inflection circle, both laid off from "
        "the point the same way."
    ),
)
def to_inflection(ray: Length, radius: Length) -> Length:
    """{ray}²/{radius}"""
