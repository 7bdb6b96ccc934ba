"""Plans of a student's own sheet, wherever he put them: read as drawn about a pole that was clicked."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.values import Complexes
from graphic_tmm.checking.own_sheet.alternatives import Alternatives, agreement, moved, shapeless
from graphic_tmm.checking.own_sheet.clicked import (
    ClickedPlan,
    ClickedScale,
    first_letter,
    own_scales,
    scene_in,
)
from graphic_tmm.checking.own_sheet.open_ends import with_open_ends
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, Spot
from graphic_tmm.checking.pencil.reading import (
    THERE,
    PhotoPoints,
    Point,
    followed,
    placed,
    points_of,
    seen,
)
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.drawing import Drawing

CLICKED = 1.5
"""A pole is clicked so near, mm."""
COMMON, LIKELIER = 3, 3.0
"""So many mistakes of other plans are tried, and taken if the pencil agrees with them nearly as well, mm."""
MORE = 6.0
"""A mistake is read if the pencil agrees with so much more of it than of what is due, mm."""
DRAWN = 0.93
"""If so much of the lines of a plan as it is due is pencil, nothing else was drawn."""


class OwnPlan(NamedTuple):
    """A plan as it was read: its view, where its places stand, the share of its lines on pencil.

    ``worth``: how the pencil agrees with it, mm; ``row``: which mutation it shows, -1 for none.
    """

    view: View
    spots: tuple[Spot, ...]
    shift: complex
    covered: float
    worth: float
    row: int = -1

    @property
    def points(self) -> tuple[Point, ...]:
        """Its points, from its pole as the student turned the plan."""
        turn = self.view.turn
        return tuple(
            one._replace(spot=one.spot / turn)
            for one in points_of(self.view, self.spots, self.shift)
        )


class OwnPlans(NamedTuple):
    """Clicked plans as they were read: the scene in the student's scale factors, these with their one turn.

    ``plans``: as they are due, where they stand.
    """

    made: DrawnScene
    found: PhotoPoints
    scales: tuple[ClickedScale, ...]
    plans: tuple[Drawing, ...]


def read_clicked(
    made: DrawnScene, flat: Flat, clicked: Sequence[ClickedPlan], hand: Hand
) -> OwnPlans:
    """Return what a sheet shows of plans that somebody clicked, mm on the sheet."""
    scales = own_scales(made, clicked)
    drawing = _Drawing(made, scales, hand)
    read = drawing.read(flat, clicked)
    # all plans together tell a scale factor better than the clicks of one
    seen = [_as_seen(one, read[one], first_letter(made, one.plan)) for one in clicked]
    better = own_scales(made, seen)
    if any(abs(better[plan].mu / scales[plan].mu - 1) > FINER for plan in scales):
        scales = {plan: one._replace(turns=scales[plan].turns) for plan, one in better.items()}
        drawing = _Drawing(made, scales, hand)
        read = drawing.read(flat, clicked)
    turned = {one.plan: read[one].view.turn for one in clicked}
    told = tuple(one._replace(turns=(turned[plan],)) for plan, one in scales.items())
    there = [one for one in clicked if read[one].covered >= THERE]
    points = tuple(point for one in there for point in read[one].points)
    missing = tuple((one.plan, one.position) for one in clicked if one not in there)
    shown = tuple(
        drawing.others.drawing(one.plan, one.position).moved(one.pole)
        for one in clicked
        if turned[one.plan] == 1.0
    )
    return OwnPlans(drawing.made, PhotoPoints(points, missing), told, shown)


FINER = 0.002
"""What another scale factor changes a plan by, as a share, for it to be read again."""


def _as_seen(clicked: ClickedPlan, read: OwnPlan, letter: str) -> ClickedPlan:
    """Return a clicked plan with the end of its first vector where that was seen; else as it was clicked."""
    for one in read.points:
        if one.name[1] == letter and one.how == SEEN:
            return clicked._replace(pole=0j, first=one.spot * read.view.turn)
    return clicked


class _Drawing:
    """A scene as a student's scale factors draw it, and its plans as they may have been drawn."""

    def __init__(self, made: DrawnScene, scales: Mapping[str, ClickedScale], hand: Hand) -> None:
        self.made = scene_in(made, scales)
        assert self.made.mechanism is not None
        self.others, self._scales = Alternatives(self.made.mechanism, hand), scales

    def read(self, flat: Flat, clicked: Sequence[ClickedPlan]) -> dict[ClickedPlan, OwnPlan]:
        """Return the plans that were clicked as they were drawn; all of a kind are turned alike."""
        found: dict[ClickedPlan, OwnPlan] = {}
        for plan, scale in self._scales.items():
            some = [one for one in clicked if one.plan == plan]
            ways = [
                [read_own(flat, self.others, one, turn) for one in some] for turn in scale.turns
            ]
            best = max(ways, key=lambda way: sum(one.worth for one in way))
            found |= dict(zip(some, self._alike(flat, some, best), strict=True))
        return found

    def _alike(
        self, flat: Flat, clicked: Sequence[ClickedPlan], read: Sequence[OwnPlan]
    ) -> Iterator[OwnPlan]:
        """Yield plans as they were read: who makes a mistake in one makes it in the others, too."""
        rows = Counter(one.row for one in read if one.row >= 0 and one.covered >= DRAWN)
        for where, first in zip(clicked, read, strict=True):
            best = first
            if first.row < 0 and first.covered >= DRAWN:
                yield first
                continue
            for row, count in rows.most_common(COMMON):
                view = self.others.view(row, where.plan, where.position, first.view.turn)
                if row != first.row and count >= rows[first.row] and view is not None:
                    one = _read(flat, view, where.pole)._replace(row=row)
                    if one.worth > best.worth - LIKELIER:
                        best = one
            yield best


def read_own(flat: Flat, others: Alternatives, clicked: ClickedPlan, turn: complex) -> OwnPlan:
    """Return a plan about a clicked pole (mm on the sheet) as it was drawn, right or wrong."""
    plan, position, pole, _ = clicked
    due = others.due(plan, position).turned(turn)
    best = _read(flat, due, pole)
    whole = best.covered >= DRAWN and all(spot.how != UNSEEN for spot in best.spots)
    if whole or shapeless(due):
        return best
    least = best.worth + MORE
    for row, view in others.near(flat, due, plan, position, pole):
        one = _read(flat, view, pole)._replace(row=row)
        if one.worth > least:
            best, least = one, one.worth
    return best


def _read(flat: Flat, view: View, pole: complex) -> OwnPlan:
    shift, _ = placed(flat, view, pole, CLICKED)
    spots = seen(flat, view, shift, followed(flat, view, shift))
    spots = with_open_ends(flat, view, spots, pole)
    starts, ends = moved(view, _standing(view, spots, shift)[None])
    return OwnPlan(view, spots, shift, *agreement(flat, starts[0], ends[0]))


def _standing(view: View, spots: Sequence[Spot], shift: complex) -> Complexes:
    """Return where the places of a view stand, as far as they are seen; else where they should."""
    due = view.at + shift
    return np.array([z if one.how == UNSEEN else one.at for one, z in zip(spots, due, strict=True)])
