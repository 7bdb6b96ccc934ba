"""A dwell drawn: a coupler's path over the turn, the arc through three of its points, the second dyad."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.instruments import cross, join, measure, place, ray, strike
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.linkage_synthesis import words as why
from graphic_tmm.chapters.linkage_synthesis.figure import (
    Circle,
    Dyad,
    Position,
    SynthesisBoard,
    SynthesisFigure,
)
from graphic_tmm.mechanism.synthesis_dwell import take_dwell
from graphic_tmm.mechanism.synthesis_kinds import PLACES
from graphic_tmm.scene.length_task import Task

ROW = 24
"""Positions of the crank over a turn by which the path is drawn."""
SHOWN = 25.0
"""So far, degrees, the arc is drawn beyond its three points."""


def draw_dwell(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw the path of M, its arc's centre D where two bisectors meet, and the dyad MDE."""
    draft = board.draft
    given = take_dwell(draft, task.given)
    crank, rod, rocker, frame, across, up = (
        board.length(name, mark)
        for name, mark in zip(("OA", "AB", "BC", "OC", "x_M", "y_M"), given.sizes, strict=True)
    )
    origin = board.origin("O")
    axis = board.axis(origin, "(x)")
    pivot = board.off("C", axis, frame)
    side = board.side(1)

    def coupler(name: str, phi: Mark) -> tuple[Mark, Mark, Mark]:
        """Draw the coupler at an angle of the crank: A, B and M."""
        line = draft.draw(ray, f"(OA{name})", origin, phi, why=why.CRANK_AT)
        pin = board.off(f"A{name}", line, crank, why.CRANK_AT)
        first = draft.draw(strike, f"(l{name})", pin, rod)
        second = draft.draw(strike, f"(b{name})", pivot, rocker)
        end = draft.draw(cross, f"B{name}", first, second, side)
        link = draft.draw(join, f"(A{name}B{name})", pin, end)
        return pin, end, draft.draw(place, f"M{name}", link, across, up, why=why.OF_COUPLER)

    row = draft.take(Angle, "φ", 360.0 / ROW * np.arange(ROW)[None, :], "°")
    *_, course = coupler("", row)
    draft.draw(french_curve, "(M)", course, row=ROW)
    places = [coupler(f"_{k}", phi) for k, phi in zip(PLACES, given.turns, strict=True)]
    points = [point for *_, point in places]
    centre = board.centre("D", points, ("F_1", "F_2"), why.ARC)
    arm = draft.draw(measure, "MD", points[1], centre)
    far = draft.draw(
        place, "E", axis,
        *(board.length(name, mark) for name, mark in zip(("x_E", "y_E"), given.pivot, strict=True)),
    )  # fmt: skip
    lever = draft.draw(measure, "DE", centre, far)
    middle, *others = (places[k] for k in (1, 0, 2))
    chain = [Position((origin, pin, end, pivot)) for pin, end, _ in (middle, *others)]
    return SynthesisFigure(
        task, board.mu, {"MD": board.real("MD", arm), "DE": board.real("DE", lever)},
        tuple(chain), (origin, pivot, far),
        (*(mark for one in places for mark in one), centre),
        circles=(
            Circle("thin", centre, tuple(points), SHOWN),
            Circle("centre", origin, tuple(pin for pin, *_ in places)),
        ),
        worst=tuple(Position((pin, point, end)) for pin, end, point in others),
        dyad=Dyad(course, (arm, lever), (
            Position((middle[0], middle[2], middle[1])), Position((middle[2], centre, far)),
        )),
    )  # fmt: skip
