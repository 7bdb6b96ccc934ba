"""What a scene gives of its cam: the stroke, the phases, the laws, the follower, the limits."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.cam.task import (
    ASKED,
    CamTask,
    FlatFollower,
    RockerFollower,
    RollerFollower,
)
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.given import given_speed
from graphic_tmm.readers.task_sheet import SIZE, Given
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its cam, lengths in mm; phases by their numbers, as the profile has them."""
    order = ASKED.of(scene)
    if order is None:
        return
    rocks = isinstance(order.follower, RockerFollower)
    yield (Given("β", math.degrees(order.stroke), "°") if rocks else Given("h", order.stroke, SIZE))
    phases = (order.rise, order.upper_dwell, order.fall, order.lower_dwell)
    for number, angle in enumerate(phases, 1):
        if angle:
            yield Given(f"φ_{number}", angle, "°")
    if order.speed is not None:
        yield given_speed("1", order.speed)
    yield from _laws(order)
    yield from _follower(order)
    if not isinstance(order.follower, FlatFollower):
        yield Given("[α]", order.pressure, "°")
        if order.pressure_return is not None and order.pressure_return != order.pressure:
            yield Given("[α_f]", order.pressure_return, "°")


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell the kind of follower."""
    order = ASKED.of(scene)
    if order is None:
        return
    follower = order.follower
    if isinstance(follower, RollerFollower):
        kind = _OFFSET if follower.offset else _CENTRAL
    else:
        kind = _ROCKER if isinstance(follower, RockerFollower) else _FLAT
    yield speaking(language)(kind)


_CENTRAL = said("The follower is central, with a roller.")
_OFFSET = said("The follower is offset, with a roller.")
_ROCKER = said("The follower is a lever with a roller.")
_FLAT = said("The follower has a flat face.")


def _laws(order: CamTask) -> Iterator[Given]:
    laws = (order.rise_law.name, order.return_law.name)
    if laws[0] == laws[1]:
        yield Given("given law", f"law {laws[0]}")
    else:
        yield Given("given law of the rise", f"law {laws[0]}")
        yield Given("given law of the return", f"law {laws[1]}")


def _follower(order: CamTask) -> Iterator[Given]:
    """The sizes of the follower that the task fixes."""
    follower = order.follower
    if isinstance(follower, RockerFollower):
        yield Given("l", follower.lever, SIZE)
        yield Given("a_w", follower.centres, SIZE)
    elif isinstance(follower, RollerFollower) and follower.offset:
        yield Given("e", follower.offset, SIZE)
    elif isinstance(follower, FlatFollower) and follower.least:
        yield Given("[ρ]", follower.least, SIZE)
