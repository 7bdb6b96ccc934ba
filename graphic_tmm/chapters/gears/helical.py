"""A helical pair: the section across the axes is drawn, m, α, h_a and the shifts are given across the teeth.

Heights are the same in both sections; whatever lies along a circle is longer by 1/cos β in the transverse one.
So all coefficients of a height become smaller by cos β while the module becomes larger; the rounding of the
rack's tip is taken for an arc in the drawn section too.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.gears.formulas import over_cosine, times_cosine
from graphic_tmm.language.said import said

WIDER = said("Across the axes a tooth that leans is broader by the cosine.")
LOWER = said("The height stays, the module is larger: so the coefficient is smaller by the cosine.")
NORMAL = said("Told in modules across the teeth, as the shifts are given.")
ACROSS = {
    "m": "m_{n}", "α": "α_{n}", "inv α": "inv α_{t}", "α_{w}": "α_{tw}", "inv α_{w}": "inv α_{tw}",
    "p": "p_{t}", "p_{b}": "p_{bt}", "x": "x_{n}", "s": "s_{t}", "s_{a}": "s_{at}",
    "x_{min}": "x_{n min}",
}  # fmt: skip
"""By its letter in a spur pair, that of a size in a helical one: n across the teeth, t across the axes."""


@formula(why=said("Across the axes the flank leans more: its height stays, its breadth grows."))
def transverse_angle(alpha: Angle, beta: Angle) -> Angle:
    """arctan(tan {alpha}/cos {beta})"""


@formula(why=said("A spur wheel of so many teeth has the tooth that stands across the helix."))
def equivalent_teeth(z: Number, beta: Angle) -> Number:
    """{z}/cos³ {beta}"""


@formula(
    why=said("Over the width the helix goes on by so many pitches: the teeth enter one by one.")
)
def overlap_ratio(b: Number, beta: Angle, m: Number) -> Number:
    """{b}·sin {beta}/(π·{m})"""


def _transverse(letter: str) -> str:
    return letter.replace("h_{a", "h_{at").replace("c^", "c_{t}^")


@dataclass(frozen=True)
class Helix:
    """The helix angle (Angle); in the drawn section m (m), α (Angle), h_a of both wheels, c (Number)."""

    beta: Mark
    m: Mark
    alpha: Mark
    ha: tuple[Mark, Mark]
    c: Mark


def draw_helix(
    draft: Draft, beta: float, m: Mark, alpha: Mark, ha: tuple[Mark, Mark], c: Mark
) -> Helix:
    """Calculate the basic rack in the transverse section."""
    angle = draft.take(Angle, "β", beta, "°")
    wide = draft.draw(over_cosine, "m_{t}", m, angle, unit="m", why=WIDER)
    steep = draft.draw(transverse_angle, "α_{t}", alpha, angle)
    by_mark = {
        mark: draft.draw(times_cosine, _transverse(mark.letter), mark, angle, why=LOWER)
        for mark in dict.fromkeys((*ha, c))
    }
    return Helix(angle, wide, steep, (by_mark[ha[0]], by_mark[ha[1]]), by_mark[c])
