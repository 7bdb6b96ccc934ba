"""Formulas of springs and dampers."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said


@formula(
    why=said(
        "The spring pulls by its stiffness for every metre by which it is longer than its free length; a "
        "negative force pushes."
    )
)
def spring_force(rate: Number, length: Length, mu_l: Number, free: Number) -> Number:
    """{rate}·({length}·{mu_l} − {free})"""


@formula(
    why=said(
        "To the force with which the spring is set in comes its stiffness for every metre by which it is "
        "longer than its free length."
    )
)
def preloaded_force(
    rate: Number, length: Length, mu_l: Number, free: Number, preload: Number
) -> Number:
    """{rate}·({length}·{mu_l} − {free}) + {preload}"""


@formula(
    why=said(
        "The damper holds back by its damping for every metre per second at which its ends part; where they "
        "come together the force pushes."
    )
)
def damper_force(damping: Number, segment: Length, mu_v: Number) -> Number:
    """{damping}·{segment}·{mu_v}"""
