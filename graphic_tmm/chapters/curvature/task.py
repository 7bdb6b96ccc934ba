"""What is asked of the curvature of paths: a link, points of it, the positions that are drawn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, key
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

CURVATURE, BRESSE, BALL = "curvature", "bresse", "ball"
"""The place and the view of centres of curvature, the views of the circles and of Ball's point."""


@dataclass(frozen=True)
class CurvatureTask:
    """Centres of curvature of the paths of ``points`` of a ``link``, drawn in some ``positions``.

    ``link``: None: that of the points. ``points``: none: those of the link that no circle and no guide holds.
    """

    link: int | None = key(
        v.number(Bound(1, 99, whole=True)),
        "the link whose points are asked for; left out: that of the points",
        2,
        None,
    )
    points: tuple[str, ...] = key(
        v.LETTERS,
        "points of the link whose centres of curvature are found; left out: those that neither turn about a "
        "pivot of the frame nor slide on it",
        ["K"],
        (),
    )
    positions: tuple[str, ...] = key(v.POSITIONS, "the positions that are drawn", [2], ("all",))
    circles: bool = key(
        v.SWITCH,
        "the inflection circle, the pole of accelerations, the circles of Bresse",
        True,
        True,
    )
    ball: bool = key(
        v.SWITCH,
        "Ball's point, of a link two of whose points turn about pivots of the frame",
        True,
        False,
    )


ASKED: SectionKey[CurvatureTask] = SectionKey(CURVATURE)


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every letter that is no point, a section that names neither link nor points, a drive at rest."""
    for k, letter in enumerate(asked.points):
        yield from parts.moves((CURVATURE, "points", k), letter)
    if asked.link is None and not asked.points:
        says = said('nothing is asked for: write link = 2, or points = ["K"]')
        yield Flaw((CURVATURE,), says)


SECTIONS = (
    Section(
        CURVATURE, CurvatureTask, "centres of curvature of the paths of a link's points",
        begin="link = 2\npositions = [2]", check=_check,
    ),
)  # fmt: skip
