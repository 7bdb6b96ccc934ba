"""What is asked of the balance of a mechanism: the point of its moment, counterweights (SI, degrees)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import POSITIVE
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Path, Said, Section, key
from graphic_tmm.scene.references import no_link
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

BALANCE = "balance"
COUNTERWEIGHT = "counterweight"
INERTIA, COUNTERWEIGHTS, FORCE, MOMENT = (
    "inertia",
    "counterweights",
    "shaking force",
    "shaking moment",
)
"""The views: inertia forces with their arms, the counterweights, the polar diagram, the graph of the moment."""
OPPOSITE = 180.0
"""A counterweight stands opposite the pin."""


@dataclass(frozen=True)
class Counterweight:
    """A counterweight on a link: its mass (kg), the radius (m) at which its mass centre stands from the pivot.

    ``angle``: from the line that goes from the pivot to the pin, degrees.
    """

    link: int = key(v.LINK_NUMBER, "the number of the link that bears it", 1)
    mass: float = key(v.quantity("mass", POSITIVE), "its mass", "4 kg")
    radius: float = key(
        v.POSITIVE_LENGTH, "how far its mass centre stands from the pivot of the link", "80 mm"
    )
    angle: float = key(
        v.ANGLE,
        "its angle from the line that goes from the pivot to the pin; left out: opposite the pin",
        "180 deg",
        OPPOSITE,
    )


@dataclass(frozen=True)
class BalanceTask:
    """The shaking force of a mechanism over the turn and its moment, without and with counterweights.

    ``about``: the letter of the frame's point about which the moment is taken; None: the crank's pivot. ``mu``:
    N/mm of the polar diagram.
    """

    about: str | None = key(
        v.LETTER,
        "the letter of the frame's point about which the moment is taken; left out: the crank's pivot",
        "O",
        None,
    )
    mu: float | None = key(
        v.mu("scale of forces"), "N/mm of the polar diagram", "20 N/mm", None, written="mu_F",
        fixes="size",
    )  # fmt: skip
    counterweights: tuple[Counterweight, ...] = ()


ASKED: SectionKey[BalanceTask] = SectionKey(BALANCE)


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    standing = parts.names.bodies[parts.names.frame].letters
    if asked.about is not None and asked.about not in standing:
        says = said(
            'the moment is taken about a point of the frame; "{letter}" is none: write one of {listed}',
            letter=asked.about[:20],
            listed=", ".join(standing),
        )
        yield Flaw((BALANCE, "about"), says)


def _check_counterweights(all_of_them: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    for path, one in all_of_them:
        if one.link not in parts.names.bodies:
            yield from no_link((*path, "link"), one.link, parts.names)


def _idle(asked: object, parts: Parts) -> Iterator[str]:
    if BALANCE not in parts.doc:
        yield said(
            "counterweight: nothing asks for it; add [balance], or take [[counterweight]] out"
        )


SECTIONS = (
    Section(
        BALANCE, BalanceTask, "the shaking force of a mechanism, its moment, counterweights",
        begin='about = "O"', weighs=True, check=_check,
        joined=lambda others: {"counterweights": others[COUNTERWEIGHT] or ()},
    ),
    Section(
        COUNTERWEIGHT, Counterweight, "counterweights on links", several=True,
        gives=True, check=_check_counterweights, idle=_idle,
    ),
)  # fmt: skip
