"""Formulas of a rotor: unbalances and their moments, counterweights, reactions of its bearings."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Number
from graphic_tmm.language.said import said

_COINCIDE = "both planes coincide"


@formula(
    why=said(
        "The force of inertia of a mass off the axis is m·r·ω². All turn with one ω, so the unbalance m·r "
        "stands for it."
    )
)
def unbalance(mass: Number, radius: Number) -> Number:
    """{mass}·{radius}"""


@formula(why=said("Distances are measured from the plane about which moments are taken."))
def from_plane(place: Number, plane: Number) -> Number:
    """{place} − {plane}"""


@formula(
    why=said(
        "The moment of a force of inertia about a point of the axis in the plane is force times distance; "
        "without ω² it is m·r·z. Left of the plane it is negative."
    )
)
def moment_of_unbalance(size: Number, distance: Number) -> Number:
    """{size}·{distance}"""


@formula(
    holds="{apart} ≠ 0",
    fails=_COINCIDE,
    why=said(
        "In the plane about which moments are taken no counterweight has a moment: the other one alone "
        "closes the polygon, at the distance of the planes."
    ),
)
def unbalance_of_moment(moment: Number, apart: Number) -> Number:
    """{moment}/{apart}"""


@formula(
    holds="{radius} ≠ 0",
    fails="the counterweight stands on the axis",
    why=said("The counterweight has to give m·r: at a given radius its mass follows."),
)
def mass_of_counterweight(size: Number, radius: Number) -> Number:
    """{size}/{radius}"""


@formula(
    holds="{mass} ≠ 0",
    fails="the counterweight has no mass",
    why=said("The counterweight has to give m·r: of a given mass its radius follows."),
)
def radius_of_counterweight(size: Number, mass: Number) -> Number:
    """{size}/{mass}"""


@formula(
    why=said(
        "What closes the polygon in the plane of a bearing would balance the rotor there: times ω² it is "
        "the force by which the bearing holds the shaft. It turns with the rotor."
    )
)
def reaction_of_bearing(size: Number, omega: Number) -> Number:
    """{size}·{omega}²"""
