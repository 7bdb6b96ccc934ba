"""What is calculated of plates, and of wheels on links: their ratio, the angle to which a wheel has rolled."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.geometry import cis, degrees
from graphic_tmm.board.grammar import ANGLE, operation
from graphic_tmm.board.values import Angle, Length, Line, Number
from graphic_tmm.language.said import said


@formula(
    why=said(
        "Seen from the link that joins the centres both pitch circles turn by equally long arcs, so the angles "
        "are as the teeth (the radii) the other way round; wheels in external mesh turn in opposite senses."
    )
)
def external_ratio(other: Number, own: Number) -> Number:
    """−{other}/{own}"""


@formula(
    why=said(
        "Seen from the link that joins the centres both pitch circles turn by equally long arcs, so the angles "
        "are as the teeth (the radii) the other way round; wheels in internal mesh turn in one sense."
    )
)
def internal_ratio(other: Number, own: Number) -> Number:
    """{other}/{own}"""


@formula(
    why=said(
        "The link turns at {omega}, so each of its points has the normal acceleration ω²·l about another, on "
        "the plan divided by {mu_a}."
    )
)
def normal_at(omega: Number, apart: Length, mu_l: Number, mu_a: Number) -> Length:
    """{omega}²·{apart}·{mu_l}/{mu_a}"""


@formula(
    why=said(
        "As a point of either plate the special point has along a link that joins them what the link's pin "
        "there has, and the plate's own ω²·l; between both pins there is that of the link. So both differ by "
        "this, on the plan divided by {mu_a}."
    )
)
def apart_along(
    omega: Number,
    apart: Length,
    joining: Number,
    length: Length,
    other: Number,
    beyond: Length,
    mu_l: Number,
    mu_a: Number,
) -> Length:
    """({omega}²·{apart} − {joining}²·{length} − {other}²·{beyond})·{mu_l}/{mu_a}"""


_SHARES = said(
    "The pitch circles touch where the distance of the centres is divided as the teeth (the radii) are."
)


@formula(why=_SHARES)
def external_radius(length: Length, other: Number, own: Number) -> Length:
    """{length}·{own}/({other} + {own})"""


@formula(why=_SHARES)
def internal_radius(length: Length, other: Number, own: Number) -> Length:
    """{length}·{own}/|{other} − {own}|"""


@formula(why=said("A run of the belt falls by this from the one wheel to the other."))
def excess(own: Length, other: Length) -> Length:
    """{own} − {other}"""


@formula(
    why=said(
        "In the own axes of the links by which the wheel rolls the lines whose angles are read stand at {arm} "
        "and {on}."
    )
)
def start_by_axes(start: Angle, ratio: Number, arm: Angle, on: Angle) -> Angle:
    """{start} − (1 − {ratio})·{arm} − {ratio}·{on}"""


@formula(
    why=said(
        "The centres stand: while the other wheel turns by {turned}, this one turns by {ratio} times that from "
        "{start}."
    )
)
def rolled_by(start: Angle, ratio: Number, turned: Angle) -> Angle:
    """{start} + {ratio}·{turned}"""


@formula(
    why=said(
        "The other wheel stands. Seen from the arm it turns back by {arm}, and this one by {ratio} times that; "
        "with the arm it goes on by {arm}."
    )
)
def rolled_round(start: Angle, arm: Angle, ratio: Number) -> Angle:
    """{start} + {arm} − {ratio}·{arm}"""


@formula(
    why=said(
        "Seen from the link that joins the centres the other wheel has turned by {turned} − {arm}, this one by "
        "{ratio} times that; with that link it goes on by {arm}."
    )
)
def rolled_between(start: Angle, arm: Angle, ratio: Number, turned: Angle) -> Angle:
    """{start} + {arm} + {ratio}·({turned} − {arm})"""


@operation(
    symbol=ANGLE,
    fails="over more turns the angle by which a wheel rolls swings by more than a whole turn and back",
    why=said("So far from 0° it was tried that the angle stays within half a turn of this."),
)
def near_while_tried(near: Angle, row: Angle, most: Angle) -> Angle:
    """Take {near} while {row} is within {most}."""
    return Angle(np.where(np.abs(row) <= most, near, np.nan))


@operation(
    symbol=ANGLE,
    why=said(
        "How far a wheel rolls depends on whole turns, too: of the angles at which {line} is drawn the one "
        "counted on without a leap is taken."
    ),
)
def bearing_near(line: Line, near: Angle) -> Angle:
    """Find the angle of {line} from the x axis, that next to {near}."""
    return Angle(near + degrees(line.along * cis(-near)))
