"""Which of the coaxial members of a planetary train stand, drive and are driven."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.chapters.planetary.task import SCHEMES, PlanetaryTask
from graphic_tmm.language.said import said


class Motion(NamedTuple):
    """Which of the three coaxial members of a train move, and how.

    ``driving``: angular velocities that are given, 1/s, by the member; ``fixed``: the member that stands, "" in
    a differential, where two are given; ``driven``: the one that is left; ``last``: the second central wheel.
    """

    driving: Mapping[str, float]
    fixed: str
    driven: str
    last: str

    @property
    def first(self) -> str:
        """The member that drives, or the first of two."""
        return next(iter(self.driving))

    @property
    def ratio(self) -> str:
        """The letter of the ratio; driving over driven."""
        return f"U_{{{self.first}{self.driven}}}"


def motion_of(order: PlanetaryTask) -> Motion:
    """Return which members of a train move.

    Raises
    ------
    TaskError
        If one drives and stands, two have one speed, or it is not told which stands.
    """
    last = SCHEMES[order.scheme].wheels[-1]
    members, two = ("1", last, "H"), isinstance(order.speed, tuple)
    speeds = order.speed if isinstance(order.speed, tuple) else (order.speed,)
    usual = ("1", last) if two else ("1",)
    drivers = (order.driving,) if isinstance(order.driving, str) else order.driving
    driving = usual if drivers == ("1",) else drivers
    for asked, names in (("driving", driving), ("fixed", (order.fixed,))):
        for name in names:
            if name and name not in members:
                listed = ", ".join(members)
                says = said(
                    'the train has no "{name}": its members are {listed}', name=name, listed=listed
                )
                raise refused(asked, says)
    if len(driving) != len(speeds):
        says = said(
            "{n} drive, but the angular velocity of {m} is given", n=len(driving), m=len(speeds)
        )
        raise refused("speed", says)
    if two and order.fixed:
        raise refused("fixed", said("two shafts of a differential drive: leave fixed out"))
    fixed = "" if two else order.fixed or (last if last not in driving else "")
    if not two and (not fixed or fixed in driving):
        other = ", ".join(f'"{name}"' for name in members if name not in driving)
        raise refused(
            "fixed",
            said(
                "{driving} drives: one of the others stands, {other}",
                driving=driving[0],
                other=other,
            ),
        )
    (driven,) = (name for name in members if name not in driving and name != fixed)
    return Motion(dict(zip(driving, speeds, strict=True)), fixed, driven, last)


def refused(key: str, message: str) -> TaskError:
    """Return what refuses a key of a train."""
    return TaskError("planetary", key, message)
