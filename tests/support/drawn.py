"""Bring a mechanism to the board and read everything off it in SI: what tests compare with the oracle."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.positions import (
    Positions,
    draw_frame,
    draw_positions,
)
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.chapters.kinematics.wheels import Wound
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure, dissect


class Board(NamedTuple):
    """Three plans of a mechanism over a free crank angle."""

    mechanism: Mechanism
    structure: Structure
    log: Construction
    given: dict[Mark, Any]
    positions: Positions
    velocities: Motion
    accelerations: Motion
    turned: bool
    mu: tuple[float, float, float]

    def read(self, angles: Any, hand: Hand = EXACT, **options: Any) -> dict[str, dict[Any, Any]]:
        """Points, velocities, accelerations by (letter, link), ω and ε by link; arrays over positions."""
        given = self.given | {self.positions.row[0]: np.atleast_2d(np.asarray(angles, float))}
        given |= standing(self, angles)
        reading = execute(self.log, given, hand=hand, **options)
        mu_l, mu_v, mu_a = self.mu
        turn = 1j * np.sign(self.mechanism.drive.speed) if self.turned else 1.0
        out: dict[str, dict[Any, Any]] = {"r": {}, "v": {}, "a": {}, "omega": {}, "epsilon": {}}
        origin = self.mechanism.frame.points[self.structure.origin]
        for number, body in self.positions.bodies.items():
            for letter in body.link.points:
                out["r"][letter, number] = origin + reading[body.marks[letter]][0] * mu_l
                image = self.velocities.images.by_letter[number][letter]
                out["v"][letter, number] = reading[image][0] * mu_v * turn
                image = self.accelerations.images.by_letter[number][letter]
                out["a"][letter, number] = reading[image][0] * mu_a
        for name, plan in (("omega", self.velocities), ("epsilon", self.accelerations)):
            for number, mark in plan.rates.items():
                out[name][number] = reading[mark][0]
        return out


def board(
    mechanism: Mechanism,
    *,
    turned: bool = False,
    mu: tuple[float, float, float] = (1.0, 1.0, 1.0),
    wound: Wound | None = None,
) -> Board:
    structure = dissect(mechanism)
    draft = Draft()
    frame = draw_frame(draft, mechanism, structure)
    phi = draft.board.take(Angle, "φ", "°")
    positions = draw_positions(draft, mechanism, structure, frame, [phi], wound)
    velocities = draw_velocities(draft, mechanism, structure, positions, turned=turned)
    accelerations = draw_accelerations(draft, mechanism, structure, positions, velocities)
    assert draft.mu_l is not None
    given: dict[Mark, Any] = dict(draft.given)
    given |= {draft.mu_l: mu[0], velocities.mu: mu[1], accelerations.mu: mu[2]}
    log = draft.board.construction()
    return Board(mechanism, structure, log, given, positions, velocities, accelerations, turned, mu)
