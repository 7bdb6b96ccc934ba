"""What a student's drawing is made of: steps, hands, pages, machines."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from support.students.drawing import Student

P, V, A, F, D, CAM = (
    "positions", "velocities", "accelerations", "forces", "diagrams", "cam",
)  # fmt: skip
POLES = {P: "O", V: "p", A: "π"}
Way = tuple[str, str]
"""A direction: ("along" or "square", a segment of the plan of positions or a guide "x", "y")."""
Operands = dict[str, Any]


class Step(NamedTuple):
    """A step as it was told: its plan and name, what kind of step, what it takes, in which position."""

    plan: str
    name: str
    kind: str
    takes: Operands
    position: int


class Hand(NamedTuple):
    """How a student's hand is: ``tails``: degrees of freedom of its slips, None for a normal one."""

    swing: float = 0.6
    slip: float = 0.8
    pointing: float = 0.5
    ruler: float = 0.5
    tails: int | None = None
    copy: float = 1.0
    compass: float = 1.0
    pole: complex = 0j


EXACT = Hand(0.0, 0.0, 0.0, 0.0)
Mind = Callable[[Step], Operands]


def honest(step: Step) -> Operands:
    """Take what is due."""
    return step.takes


class Page(NamedTuple):
    """What one position gives: lengths (mm), rates and other quantities, points; units of quantities."""

    lengths: dict[tuple[str, str], float]
    rates: dict[tuple[str, str], float]
    points: dict[tuple[str, str], complex]
    units: dict[tuple[str, str], str]

    def write(self, plan: str, name: str, mm: float) -> float:
        """Write a length down and return it."""
        self.lengths[plan, name] = float(mm)
        return float(mm)


class Machine(NamedTuple):
    """A mechanism: μ of its plans (SI per mm), givens in mm on the sheet and SI, how a position is drawn.

    ``calculated``: segments of which the mm are calculated; ``links``: lengths that stand in calculations.
    """

    mu: dict[str, float]
    given: dict[str, Any]
    accelerated: tuple[int, ...]
    script: Callable[[Student], None]
    calculated: frozenset[str]
    links: tuple[str, ...]
    positions: int = 8
    whole: Callable[[Student], None] | None = None
