"""Formulas of instantaneous centres: ratios of distances, velocities by them; how points come to the scheme."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said

_TOGETHER = "both centres fall together"


@formula(
    fails=_TOGETHER,
    why=said(
        "In the common centre both links have one velocity, so their rates of turning are inversely as its "
        "distances from their centres on the frame; on one side of it both turn in one sense."
    ),
)
def rates_by_centres(to_driver: Length, to_link: Length) -> Number:
    """{to_driver}/{to_link}"""


@formula(why=said("The driving link turns counter-clockwise: the sign is the sense."))
def rate_by_ratio(ratio: Number, omega: Number) -> Number:
    """{ratio}·{omega}"""


@formula(why=said("The driving link turns clockwise; a link that turns in its sense does so, too."))
def rate_by_ratio_clockwise(ratio: Number, omega: Number) -> Number:
    """−{ratio}·{omega}"""


@formula(fails=_TOGETHER, why=said("In the common centre the link goes as the slider does."))
def rate_by_slider(speed: Number, distance: Length, mu: Number) -> Number:
    """{speed}/({distance}·{mu})"""


@formula(
    fails=_TOGETHER,
    why=said(
        "About its centre the link turns: the velocity of a point is ω times its distance; the side on which "
        "the centre lies of the velocity tells the sense."
    ),
)
def rate_by_point(segment: Length, mu_v: Number, distance: Length, mu: Number) -> Number:
    """|{segment}|·{mu_v}/({distance}·{mu})"""


@formula(why=said("At this moment the link turns about its centre: velocities are as distances."))
def speed_about(omega: Number, distance: Length, mu: Number) -> Number:
    """|{omega}·{distance}|·{mu}"""


@formula(
    fails="both links turn alike: their centre lies at infinity",
    why=said("The common centre divides the line of both centres inversely as ω, by the plan."),
)
def divided(length: Length, first: Number, second: Number) -> Length:
    """{length}·{second}/({second} − {first})"""
