"""What is asked of the balance of a mechanism: the point of its moment, counterweights (SI, degrees)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import POSITIVE, Bound
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
MASSES, UNBALANCE = "replacing masses", "unbalance"
"""The views of what replaces the masses of links, and, with a link's number behind, of its static moments."""
OPPOSITE = 180.0
"""A counterweight stands opposite the pin."""


FULL, PARTIAL = "full", "partial"
HALF = 0.5
"""The share of sliding masses that a crank's counterweight is made to answer by custom."""
_METHOD = v.choice(FULL, PARTIAL, полное=FULL, частичное=PARTIAL)


@dataclass(frozen=True)
class Counterweight:
    """A counterweight on a link: its mass (kg), the radius (m) at which its mass centre stands from the pivot.

    ``angle``: from the line that goes from the pivot to the pin, degrees. Where a method finds it, one of mass
    and radius is None, and the angle found.
    """

    link: int = key(v.LINK_NUMBER, "the number of the link that bears it", 1)
    mass: float | None = key(
        v.quantity("mass", POSITIVE), "its mass; left out: found by the method", "4 kg", None
    )
    radius: float | None = key(
        v.POSITIVE_LENGTH,
        "how far its mass centre stands from the pivot of the link; left out: found by the method",
        "80 mm",
        None,
    )
    angle: float | None = key(
        v.ANGLE,
        "its angle from the line that goes from the pivot to the pin; left out: opposite the pin, or found by "
        "the method",
        "180 deg",
        None,
    )


@dataclass(frozen=True)
class BalanceTask:
    """The shaking force of a mechanism over the turn and its moment, without and with counterweights.

    ``about``: the letter of the frame's point about which the moment is taken; None: the crank's pivot.
    ``method``: by which the counterweights are found: "full", so that the centre of all masses stands still, or
    "partial", on the crank alone, with a ``share`` of the sliding masses; None: they are given. ``mu``: N/mm of
    the polar diagram.
    """

    about: str | None = key(
        v.LETTER,
        "the letter of the frame's point about which the moment is taken; left out: the crank's pivot",
        "O",
        None,
    )
    method: str | None = key(
        _METHOD,
        "how counterweights are found by replacing masses: full (crank, and rocker or rod: the centre of all "
        "masses stands still) or partial (on the crank alone); left out: they are given",
        FULL,
        None,
    )
    share: float | None = key(
        v.number(Bound(0.0, 1.0)),
        "of the partial method: the share of the sliding masses that the crank's counterweight answers; left "
        "out: 0.5",
        0.5,
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
    if asked.share is not None and asked.method != PARTIAL:
        says = said(
            'only the partial method takes a share; write method = "partial", or leave it out'
        )
        yield Flaw((BALANCE, "share"), says)


def _check_counterweights(all_of_them: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    seen = set[int]()
    for path, one in all_of_them:
        if one.link not in parts.names.bodies:
            yield from no_link((*path, "link"), one.link, parts.names)
        if one.link in seen:
            says = said(
                "link {link} has a counterweight already: write one for both", link=one.link
            )
            yield Flaw((*path, "link"), says)
        seen.add(one.link)
        balance = parts.said.get(BALANCE)
        if balance is not None:
            yield from _found_or_given(path, one, balance.method)


def _found_or_given(path: Path, one: Said, method: str | None) -> Iterator[Flaw]:
    """Say what of a counterweight is missing, or is told though the method finds it."""
    missing = [name for name in ("mass", "radius") if getattr(one, name) is None]
    if method is None and missing:
        says = said('nothing finds it: write it, or write method = "full" in [balance]')
        yield Flaw((*path, missing[0]), says)
    elif method is not None and not missing:
        says = said("the method finds mass or radius by the other: leave one of them out")
        yield Flaw((*path, "mass"), says)
    if method is not None and one.angle is not None:
        says = said("the method finds the angle: leave it out")
        yield Flaw((*path, "angle"), says)


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
