"""Along what the diagrams of a cam stand: the angle of one that turns, the travel of one that slides.

The scale of their base tells them apart.
"""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Base
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.cam import formulas as f


def slides(base: Base) -> bool:
    """Whether places of the cam are lengths (Number, m), and no angles."""
    return base.mu.unit == "m/mm"


def take_place(draft: Draft, base: Base, of: str, value: object) -> Mark:
    """Take places of the cam, degrees or m; ``of``: what stands below their letter."""
    if slides(base):
        return draft.take(Number, f"s_{of or 'c'}", value, "m")
    return draft.take(Angle, f"φ_{of}" if of else "φ", value, "°")


def along_base(draft: Draft, base: Base, letter: str, place: Mark) -> Mark:
    """Return how far along the base a place of the cam is (Length)."""
    if slides(base):
        return draft.draw(to_board, letter, place, base.mu)
    return draft.draw(f.along_turn, letter, place, base.length)


def read_place(draft: Draft, base: Base, x: Mark) -> Mark:
    """Return the place of the cam that stands so far along the base (Length)."""
    if slides(base):
        return draft.draw(in_si, "s_k", x, base.mu, unit="m")
    return draft.draw(f.angle_of_turn, "φ_k", x, base.length, unit="°")
