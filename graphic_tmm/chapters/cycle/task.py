"""What is asked of a machine known by its moment alone: a flywheel for a cycle of turns (SI, degrees)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import INTERVALS, Bound
from graphic_tmm.chapters.flywheel.task import FlywheelTask, aims
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import (
    Flaw,
    Kind,
    Names,
    Said,
    Section,
    build,
    combined_key,
    key,
    keys_of,
)
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


CYCLE = "cycle"


EXAMPLE = [[0, "0 N*m"], [90, "400 N*m"], [360, "0 N*m"]]
NEEDLESS = ("tangents", "turns")
"""Keys of a flywheel that ask for the energies of links, or are its own here."""


def _points(value: object, names: Names) -> tuple[tuple[float, float], ...]:
    remedy = said('write points of the cycle, [[0, "0 N*m"], [90, "400 N*m"], [360, "0 N*m"]]')
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(stands(value, remedy))
    found = []
    for item in value:
        if not isinstance(item, list) or len(item) != 2:
            raise ValueError(fault_in_list(item, remedy))
        found.append((quantities.parse(item[0], "angle"), quantities.parse(item[1], "moment")))
    v.follow([angle for angle, _ in found])
    return tuple(found)


@dataclass(frozen=True)
class Moment:
    """A moment on the shaft over the cycle: ``points``, angle (degrees) and moment (N·m), straight between.

    Two points at one angle are a jump.
    """

    points: tuple[tuple[float, float], ...] = key(
        Kind(_points, v.PAIRS), "angles of the shaft and moments, straight between them", EXAMPLE
    )

    def at(self, angle: float) -> float:
        """Return the moment at an angle (degrees); at a jump, or where the cycle closes, the mean of both."""
        points = self.points
        if angle == points[0][0] or angle == points[-1][0]:
            return (points[0][1] + points[-1][1]) / 2
        there = [moment for at, moment in points if at == angle]
        if there:
            return sum(there) / len(there)
        (a, p), (b, q) = next(two for two in pairwise(points) if two[0][0] < angle < two[1][0])
        return p + (q - p) * (angle - a) / (b - a)


def _order(told: Said) -> FlywheelTask:
    found: FlywheelTask = build(FlywheelTask, told, indicator=None, tangents=None, turns=None)
    return found


@dataclass(frozen=True)
class CycleTask:
    """A flywheel on a shaft whose moments are given over a cycle of ``turns`` turns.

    ``speed`` (1/s) is the mean one; the cycle is divided into ``positions``. ``moments`` add up: driving ones
    where the resisting moment is constant, resisting ones where the driving is. ``flywheel``: the rest.
    """

    speed: float = key(v.SPEED, "mean angular velocity of the shaft", "300 rpm")
    flywheel: FlywheelTask = combined_key(
        _order,
        **{
            name: key(one.kind, one.says, one.example, one.default, fixes=one.fixes)
            for name, one in keys_of(FlywheelTask).items()
            if name not in NEEDLESS
        },
    )
    turns: int = key(
        v.number(Bound(1, 12, whole=True)),
        "turns of the shaft in a cycle: 2 of a four-stroke engine",
        2,
        1,
    )
    positions: int = key(
        v.number(Bound(INTERVALS.least, 360, whole=True)),
        "into how many parts the cycle is divided",
        24,
        24,
    )
    moments: tuple[Moment, ...] = ()


ASKED: SectionKey[CycleTask] = SectionKey("cycle")


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    yield from aims(asked, "cycle")
    if "moment" not in parts.doc:
        says = said("no moment is given over the cycle; write [[moment]] with its points")
        yield Flaw(("cycle",), says)


def _check_moments(all_of_them: list[tuple[tuple[str, int], Said]], parts: Parts) -> Iterator[Flaw]:
    asked = parts.said.get("cycle")
    if asked is None:
        return
    whole = 360.0 * asked.turns
    for path, one in all_of_them:
        if (one.points[0][0], one.points[-1][0]) != (0.0, whole):
            says = said("the points go from 0 to {whole:g}°, over the whole cycle", whole=whole)
            yield Flaw((*path, "points"), says)


def _idle(asked: object, parts: Parts) -> Iterator[str]:
    if "cycle" not in parts.doc:
        yield said("moment: nothing asks for it; add [cycle], or take [[moment]] out")


SECTIONS = (
    Section(
        "cycle", CycleTask, "a flywheel for moments given over a cycle, without a mechanism",
        alone=True, begin='speed = "300 rpm"\ndelta = 0.04', check=_check,
        joined=lambda others: {"moments": others["moment"] or ()},
    ),
    Section(
        "moment", Moment, "moments on the shaft over the cycle", several=True,
        alone=True, gives=True, check=_check_moments, idle=_idle,
    ),
)  # fmt: skip
