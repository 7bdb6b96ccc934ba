"""What is asked of a motor (SI)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, key
from graphic_tmm.scene.misfits import fault_in_list, stands

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

MOTOR, RUN, STEP = "motor", "motion-calculation", "motion-step"
"""The section and the view of its characteristic; the views of a run-up and of one crossing."""


def _points(value: object, names: Names) -> tuple[tuple[float, float], ...]:
    remedy = said('write speeds and moments, [["0 rpm", "30 N*m"], ["1000 rpm", "0 N*m"]]')
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(stands(value, remedy))
    found = []
    for item in value:
        if not isinstance(item, list) or len(item) != 2:
            raise ValueError(fault_in_list(item, remedy))
        found.append(
            (quantities.parse(item[0], "angular speed"), quantities.parse(item[1], "moment"))
        )
    if found[0][0] < 0.0 or not all(b[0] > a[0] for a, b in pairwise(found)):
        raise ValueError(said("the speeds begin at 0 or above and grow from point to point"))
    return tuple(found)


@dataclass(frozen=True, order=True)  # of several wishes for it the greatest counts
class MotorTask:
    """A motor (its own speeds and moments): asynchronous by its catalogue, straight, or by a table.

    ``ratio``: how many times faster than the crank it turns. ``J``: of its rotor. ``step``: how many intervals
    are before that whose crossing is drawn.
    """

    power: float | None = key(v.quantity("power", POSITIVE), "nominal power", "4 kW", None)
    nominal: float | None = key(v.SPEED, "nominal speed", "1430 rpm", None)
    synchronous: float | None = key(
        v.SPEED, "synchronous speed of an asynchronous motor", "1500 rpm", None
    )
    overload: float = key(
        v.number(Bound(1, 10, above=True)),
        "greatest moment over the nominal one, of an asynchronous motor",
        2.2,
        2.2,
    )
    no_load: float | None = key(
        v.SPEED, "speed without load of a straight characteristic", "1500 rpm", None
    )
    starting: float | None = key(
        v.quantity("moment", POSITIVE),
        "moment at rest of a straight characteristic; left out: by power and nominal",
        "80 N*m",
        None,
    )
    points: tuple[tuple[float, float], ...] | None = key(
        Kind(_points, v.PAIRS),
        "speeds and moments of a table, straight between them",
        [["0 rpm", "30 N*m"], ["900 rpm", "24 N*m"], ["1000 rpm", "0 N*m"]],
        None,
    )
    ratio: float = key(
        v.number(Bound(1e-3, 1e4)),
        "how many times faster than the crank the motor turns",
        15.9,
        1.0,
    )
    J: float = key(v.INERTIA, "moment of inertia of the rotor", "0.02 kg*m^2", 0.0)
    step: int = key(
        v.number(Bound(0, 10**4, whole=True)),
        "the interval whose crossing is drawn, by how many are before it",
        1,
        1,
    )


def _check_motor(motor: Said, parts: Parts) -> Iterator[Flaw]:
    """A motor of which there is too little, or that is two."""
    count = parts.drive.count if parts.drive is not None else None
    law = parts.said.get("motion_law")
    if count is not None and law and motor.step >= (count := count * law.turns):
        says = said("there are {count} intervals; write a smaller number", count=count)
        yield Flaw((MOTOR, "step"), says)
    kinds = [one for one in ("synchronous", "no_load", "points") if getattr(motor, one) is not None]
    if len(kinds) > 1:
        says = said(
            "a motor is asynchronous, has a straight characteristic or a table: leave {first} out, or {other}",
            first=kinds[0],
            other=kinds[1],
        )
        yield Flaw((MOTOR, kinds[1]), says)
    elif motor.points is not None:
        return
    elif motor.synchronous is None and motor.no_load is None:
        says = said(
            "nothing says what motor it is; write synchronous, nominal and power of an asynchronous one, "
            "no_load and starting, or points"
        )
        yield Flaw((MOTOR,), says)
    elif motor.starting is None or motor.synchronous is not None:
        for name in ("power", "nominal"):
            if getattr(motor, name) is None:
                yield Flaw((MOTOR, name), said("it is missing; write it as the catalogue gives it"))
        idle = motor.synchronous if motor.no_load is None else motor.no_load
        if motor.nominal is not None and not motor.nominal < idle:
            says = said(
                "under load a motor turns more slowly than {idle:g} rad/s: make it smaller",
                idle=idle,
            )
            yield Flaw((MOTOR, "nominal"), says)


def _idle_motor(motor: object, parts: Parts) -> Iterator[str]:
    if "motion_law" not in parts.doc:
        yield said("motor: nothing asks for it; add [motion_law], or take [motor] out")


SECTIONS = (
    Section(
        MOTOR, MotorTask, "the motor that drives the crank", gives=True,
        check=_check_motor, idle=_idle_motor,
    ),
)  # fmt: skip
