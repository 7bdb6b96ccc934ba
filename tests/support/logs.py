"""Logs to count: a four-bar, the scenes that come with the package, and the sizes of their values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.instruments import cross, lay_off, measure, ray, strike
from graphic_tmm.board.record import Board, Construction, Mark
from graphic_tmm.board.values import Angle, Curve, Length, Point, Side, arrays
from support import gallery

Log = tuple[Construction, Mapping[Mark, object]]


@cache
def logs(name: str) -> tuple[Log, ...]:
    return tuple((one.construction, one.given) for one in gallery.usual(name).boards)


def sizes(log: Construction, given: Mapping[Mark, object]) -> Iterator[tuple[Mark, int]]:
    """Yield the marks of the steps that leave no curve with how many positions their values have."""
    reading = execute(log, given)
    for step in log.steps:
        if step.op.leaves is not Curve and not step.op.across:
            yield step.it, max(part.shape[1] for part in arrays(reading[step.it]))


class FourBar:
    """A four-bar on a board: crank, two arcs, their meeting point and one reading."""

    def __init__(self) -> None:
        board = Board()
        board.open("positions")
        o, c = board.take(Point, "O"), board.take(Point, "C")
        self.phi = board.take(Angle, "φ")
        lengths = [board.take(Length, name) for name in ("OA", "AB", "CB")]
        side = board.take(Side, "±")
        self.ray = board.draw(ray, "(OA)", o, self.phi)
        self.a = board.draw(lay_off, "A", self.ray, lengths[0])
        around_a = board.draw(strike, "(A)", self.a, lengths[1])
        self.around_c = board.draw(strike, "(C)", c, lengths[2])
        self.b = board.draw(cross, "B", around_a, self.around_c, side)
        self.length = board.draw(measure, "OB", o, self.b)
        self.log = board.construction()
