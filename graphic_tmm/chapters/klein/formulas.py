"""What lengths of Klein's figure stand for: the crank on it is as long as the vectors of its pin."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said


@formula(
    why=said(
        "The triangle over the crank is the plan of velocities, turned by 90°: the crank stands for {omega}·l, "
        "so every length of it for as many times {omega}."
    )
)
def velocity_on_figure(omega: Number, segment: Length, mu: Number) -> Number:
    """{omega}·{segment}·{mu}"""


@formula(
    why=said(
        "The quadrilateral over the crank is the plan of accelerations, turned by 180°: the crank stands for "
        "{omega}²·l, so every length of it for as many times {omega}²."
    )
)
def acceleration_on_figure(omega: Number, segment: Length, mu: Number) -> Number:
    """{omega}²·{segment}·{mu}"""
