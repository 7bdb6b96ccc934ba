"""Which of the coaxial members of a planetary train stand, drive and are driven."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask
from graphic_tmm.language.said import said


class Closing(NamedTuple):
    """Two members that wheels outside the train join: the ``other`` turns ``ratio`` times as fast as ``joint``.

    ``joint``: the one that drives or, where neither does, is driven.
    """

    joint: str
    other: str
    ratio: Fraction


class Motion(NamedTuple):
    """Which of the three coaxial members of a train move, and how.

    ``driving``: angular velocities that are given, 1/s, by the member; ``fixed``: the member that stands, "" in
    a differential, where two are given; ``driven``: the one that is left, "2" where none is: the satellite;
    ``last``: the last central wheel. ``closing``: of a differential of which one drives.
    """

    driving: Mapping[str, float]
    fixed: str
    driven: str
    last: str
    closing: Closing | None = None

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
    scheme, two = SCHEMES[order.scheme], isinstance(order.speed, tuple)
    members, (drives, stands) = scheme.members, scheme.usual
    speeds = order.speed if isinstance(order.speed, tuple) else (order.speed,)
    drivers = (order.driving,) if isinstance(order.driving, str) else order.driving
    driving = tuple(sorted(scheme.usual)) if two and drivers == (drives,) else drivers
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
    others = [name for name in members if name not in driving]
    if order.closed:
        return _closed(order, dict(zip(driving, speeds, strict=True)))
    usual = stands if stands in others else others[0] if len(others) == 1 else ""
    fixed = "" if two else order.fixed or usual
    if not two and (not fixed or fixed in driving):
        other = ", ".join(f'"{name}"' for name in others)
        raise refused(
            "fixed",
            said(
                "{driving} drives: one of the others stands, {other}",
                driving=driving[0],
                other=other,
            ),
        )
    for row in order.before:
        speeds = tuple(speed * (-1.0) ** (len(row) - 1) * row[0] / row[-1] for speed in speeds)
    driven = next((name for name in others if name != fixed), scheme.rims[0])
    return Motion(dict(zip(driving, speeds, strict=True)), fixed, driven, scheme.meshes[-1].wheel)


def _closed(order: PlanetaryTask, driving: Mapping[str, float]) -> Motion:
    """Return the motion of a differential of which wheels join two members."""
    scheme = SCHEMES[order.scheme]
    if len(driving) > 1:
        says = said("wheels close the differential: one shaft drives, give one speed")
        raise refused("speed", says)
    if order.fixed:
        raise refused("fixed", said("no member of a closed differential stands: leave fixed out"))
    if len(scheme.members) < 3 or "H" not in scheme.members or scheme.bevel:
        says = said(
            'scheme "{name}" is drawn with no wheels that close it: leave closed out',
            name=scheme.name,
        )
        raise refused("closed", says)
    (joint, one), (other, two) = sorted(order.closed, key=lambda row: row[0] not in driving)
    if not {joint, other} <= {*scheme.members}:
        listed = ", ".join(scheme.members)
        says = said("two members are closed: of {listed}", listed=listed)
        raise refused("closed", says)
    turns = (-1) ** (len(one) + len(two)) * Fraction(one[0] * two[-1], one[-1] * two[0])
    (left,) = {*scheme.members} - {joint, other}
    driven = left if joint in driving else joint
    last = scheme.meshes[-1].wheel
    return Motion(driving, "", driven, last, Closing(joint, other, turns))


def refused(key: str, message: str) -> TaskError:
    """Return what refuses a key of a train."""
    return TaskError("planetary", key, message)
