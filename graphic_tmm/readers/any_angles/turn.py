"""Any coordinates of the drive, angles of a crank or lengths of what slides: what chapters know there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Literal, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Curve, Number, Reals
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import DECIMALS, Project
from graphic_tmm.scene.chapter import Answer
from graphic_tmm.scene.records import Scene

PLACE = Mark(-1, "i", Number, "")
"""Where in the row an angle is, in intervals of it, for who runs steps of `Turning.read_off` by himself."""
ENDS = 10.0**-DECIMALS
"""A place so near the end of a row is there, °: a position tells its angle rounded by half as much."""
Between = Mapping[Mark, object]
"""Values of marks at the angles of a turn."""


@dataclass(frozen=True)
class Turn:
    """Angles of the crank at which the log of a row of positions is run once more.

    ``turned``: how far it has turned from position zero, degrees, (angle,), with the sign in which it is drawn,
    the zero position first; ``whole``: how far it does over the row, degrees, with that sign, in ``count``
    intervals. ``read``: the numbers of marks at these angles, of what is known already. ``angles``: the
    direction of the crank itself where that is what is asked for, degrees, (1, angle): the state of a mechanism
    that was never turned from anywhere; None where it is turned from the zero position on. A chapter that hands
    this very array on does so at any angles: it is asked once. Of a board of its own they are angles of what
    drives, and ``read`` takes values of more marks. ``row``: of a row that does not close, how far
    each of its positions is from the zero position.
    """

    turned: Reals
    whole: float
    count: int
    read: Callable[..., Reading]
    angles: Reals | None = None
    row: Reals | None = None

    @property
    def along(self) -> Reals:
        """How far it has turned, in the sense in which it is drawn."""
        return self.turned if self.whole > 0.0 else -self.turned

    @cached_property
    def numbers(self) -> Reals:
        """Where each angle is in the row, in intervals of it."""
        if self.row is not None:
            return np.interp(self.along, self.row, np.arange(self.row.size))
        whole = abs(self.whole)
        return self.along % whole * self.count / whole


def open_row(scene: Scene, steps: Reals) -> Reals | None:
    """Return how far each position of a row is from the first; None of a row of whole turns.

    ``steps``: how far the drive comes from the first position to each, with its sign.
    """
    row, mechanism = scene.row, scene.mechanism
    slides = mechanism is not None and (mechanism.drive.slides or mechanism.drive.rack > 0.0)
    if row.ends is None and not row.places and not slides:
        return None
    return np.abs(steps[: row.count])


def in_row(turned: Reals, way: float) -> Reals:
    """Return how far a crank has turned from the first position of an open row that goes a ``way`` (°, signed).

    An angle outside the row is the same angle nearest to its middle: of a row from 350° to 375°, 15° is inside.
    """
    off = turned - way / 2.0
    inside = np.abs(off) <= abs(way / 2.0) + ENDS
    return np.where(inside, turned, (off + 180.0) % 360.0 - 180.0 + way / 2.0)


Plan = Literal["positions", "velocities", "accelerations", "forces"]
"""The plans that `motion` takes, by the place of a sheet that shows them."""
OwnPlan = Literal[
    "cam", "arc_cam", "planetary", "gears", "centres", "centrodes", "curvature", "hodograph"
]  # fmt: skip
"""Those of chapters by their own names; of boards of their own it takes one."""
Quantity = Literal[
    "places",
    "velocities",
    "accelerations",
    "omega",
    "epsilon",
    "forces",
    "balance",
    "columns",
    "profile",
    "centres",
    "analogues",
]
"""The quantities at any angle: of a mechanism, and of other chapters by their names."""
PLAN_OF: Mapping[Quantity, Plan | None] = {
    "places": "positions",
    "velocities": "velocities",
    "accelerations": "accelerations",
    "omega": "velocities",
    "epsilon": "accelerations",
    "forces": "forces",
    "balance": "forces",
    "columns": None,
    "profile": None,
    "centres": None,
    "analogues": None,
}
"""The plan of kinematics or forces that gives a quantity; None of those of other chapters."""
VECTORS: frozenset[Quantity] = frozenset(
    {"places", "velocities", "accelerations", "forces", "profile", "centres", "analogues"}
)
"""Those that are x + iy."""
Key = tuple[str, int] | int | str
"""The owner of a quantity: a letter and the number of its link; a link; the name of a column."""


class TurnQuantity(NamedTuple):
    """A quantity that can be had at any angle of the crank, in SI: where the log has it.

    ``mark``: its number, in SI; or, with a ``scale`` (SI a mm), a length, or a
    point of a plan, whose vector from ``start`` (None: from the pole, 0) times the scale it is, behind
    ``origin`` (SI). ``known``: a number without which nobody knows it. Of a board of its own the mark may be
    none of the log: then `Turning.between` gives its value.
    """

    plan: str
    quantity: Quantity
    key: Key
    mark: Mark
    scale: Mark | None = None
    start: Mark | None = None
    origin: complex = 0j
    known: Mark | None = None


class Passed(NamedTuple):
    """How a mechanism passes its motion on over a turn of its crank, or between the ``ends`` of its row.

    ``whole``: whether it assembles everywhere there; ``least``: the least transmission angle of all its groups,
    degrees, NaN where it assembles nowhere.
    """

    whole: bool
    least: float
    ends: bool = False


@dataclass(frozen=True)
class Turning(Answer):
    """What a chapter knows at any angle of the crank.

    ``between``: the values of its given marks of a drawn board at any angles of a turn. ``read_off``: of a
    drawn board and the mark that tells where in the row an angle is the steps by which marks are read off the
    drawing there instead of computed again. ``passed``: how well the mechanism transmits its motion over a
    turn. ``told``: its quantities at any angle; ``free``: the scene as it is recorded for them. ``plan``: what
    they are asked for by, of a board of its own.
    """

    stands: ClassVar[str] = "turning.TURNING"
    between: Callable[[Drawn, Turn], Between] = lambda drawn, turn: {}
    read_off: Callable[[Drawn, Mark], Iterable[Step]] = lambda drawn, number: ()
    passed: Callable[[Project], Passed | None] = lambda project: None
    told: Callable[[Project], Iterable[TurnQuantity]] = lambda project: ()
    free: Callable[[Scene], Scene] = lambda scene: scene
    plan: str = ""

    def values(self, drawn: Drawn, turn: Turn) -> Between:
        """Return the values of all that is known at any angles of a turn, or read off the drawing there."""
        found = dict(self.between(drawn, turn))
        for step in self.read_off(drawn, PLACE):
            uses = [
                turn.numbers[None, :]
                if mark is PLACE
                else drawn.numbers.drawn[mark]
                if mark.kind is Curve
                else turn.read([mark])[mark]
                for mark in step.uses
            ]
            found[step.it] = step.op.run(*uses, **step.choice)
        return found
