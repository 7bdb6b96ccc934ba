"""A graph as users see it: its view, what its ordinates mean, how its scale is found."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import (
    pole_distance,
    scale_of_derivative,
    scale_of_integral,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length


@dataclass(frozen=True)
class ScaleOrder:
    """How one diagram of a chain is scaled: its μ (SI per mm), or the pole distance H (mm) that gives it.

    Neither: a standard μ is chosen. The first diagram of a chain has no pole.
    """

    mu: float | None = None
    pole: float | None = None


STANDARD = ScaleOrder()
"""Nothing is fixed: a standard μ is chosen."""


class Follower(NamedTuple):
    """Points on a curve that follow those through which it was drawn, ``behind`` so many positions."""

    curve: Mark
    points: Mark
    behind: int


class Chart(NamedTuple):
    """A graph: its view, the symbol and unit of its ordinates, its scale, the ordinates read off (Length).

    ``end``: the ordinate at the end of the base where it was integrated to (Length). ``chosen``: its scale is
    a given mark; ``wanted`` its value if the task fixes it, else a standard one is found at which the highest
    of the ordinates takes ``room`` mm at most. ``room`` None: the whole figure, from its lowest to its highest
    point, takes at most what the format has for a graph; ``figure``: its points, if not the ordinates.
    ``followers``: further points on its curves.
    """

    view: str
    symbol: str
    unit: str
    mu: Mark
    ordinates: tuple[Mark, ...]
    chosen: bool
    wanted: float | None
    room: float | None
    end: Mark | None = None
    figure: tuple[Mark, ...] = ()
    followers: tuple[Follower, ...] = ()

    @property
    def scale_name(self) -> str:
        """What its scale is called."""
        return f"μ_{self.symbol}" if len(self.symbol) == 1 else f"μ_{{{self.symbol}}}"


class Scaled(NamedTuple):
    """A scale, whether it is a given mark, and the distance of the pole that belongs to it (Length)."""

    mu: Mark
    chosen: bool
    distance: Mark


def derived_scale(
    draft: Draft, symbol: str, unit: str, of: Mark, along: Mark, drawn: ScaleOrder
) -> Scaled:
    """Find the scale of a derivative from the pole distance, or the pole distance from the scale."""
    return _scaled(
        draft, symbol, unit, drawn, scale_of_derivative, lambda mu: (of, mu), (of, along)
    )


def integrated_scale(
    draft: Draft, symbol: str, unit: str, of: Mark, along: Mark, drawn: ScaleOrder, pole: str = ""
) -> Scaled:
    """Find the scale of an integral from the pole distance, or the pole distance from the scale.

    ``pole``: the letter of that distance, if it is not that of the quantity.
    """
    known = (of, along)
    return _scaled(draft, symbol, unit, drawn, scale_of_integral, lambda mu: (mu, of), known, pole)


def _scaled(
    draft: Draft,
    symbol: str,
    unit: str,
    drawn: ScaleOrder,
    scale: Operation,
    in_order: Callable[[Mark], tuple[Mark, Mark]],
    known: tuple[Mark, Mark],
    pole: str = "",
) -> Scaled:
    """``in_order``: the scale sought and the known one, that of the integral before that of the derivative."""
    letter = pole or f"H_{symbol}"
    if drawn.pole is not None:
        distance = draft.take(Length, letter, drawn.pole, "mm", roles.POLE_DISTANCE)
        mu = draft.draw(scale, f"μ_{symbol}", *known, distance, unit=unit)
        return Scaled(mu, False, distance)
    mu = draft.scale(f"μ_{symbol}", unit)
    distance = draft.draw(pole_distance, letter, *in_order(mu), known[1], role=roles.POLE_DISTANCE)
    return Scaled(mu, True, distance)


def distances(given: Iterable[Mark], view: str) -> list[Mark]:
    """Return the distances of poles that are given in a view."""
    return [mark for mark in given if mark.role == roles.POLE_DISTANCE and mark.view == view]
