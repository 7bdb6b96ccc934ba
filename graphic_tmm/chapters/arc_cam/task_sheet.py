"""What a task gives of a cam of arcs, and what it asks, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.arc_cam.scheme import scheme
from graphic_tmm.chapters.arc_cam.task import ASKED, FLAT, FLAT_ROCKER, ROCKER, ArcTask, Flank
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet, given_speed
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its cam, lengths in mm."""
    order = ASKED.of(scene)
    if order is None:
        return
    if order.eccentric:
        yield Given("R", order.nose, SIZE)
        yield Given("e_C", order.distance, SIZE)
        yield from _follower(order)
        return
    yield Given("r_1", order.base, SIZE)
    yield Given("r_2", order.nose, SIZE)
    yield Given("d", order.distance, SIZE)
    if order.rise == order.fall:
        yield _flank("given flank", "r_3", order.rise)
    else:
        yield _flank("given flank of the rise", "r_3", order.rise)
        yield _flank("given flank of the return", "r_4", order.fall)
    if order.rise.hollow:
        yield Given("given flank", "given hollow")
    yield from _follower(order)


def _flank(name: str, letter: str, flank: Flank) -> Given:
    if flank.radius is None:
        return Given(name, "given straight")
    return Given(letter, flank.radius, SIZE)


def _follower(order: ArcTask) -> Iterator[Given]:
    yield from _what_follows(order)
    if order.speed is not None:
        yield given_speed("1", order.speed)


def _what_follows(order: ArcTask) -> Iterator[Given]:
    if order.follower == FLAT:
        yield Given("given follower", "given face")
        return
    if order.follower == FLAT_ROCKER:
        assert order.centres is not None
        yield Given("given follower", "given flat rocker")
        yield Given("a", order.centres, SIZE)
        if order.roller:
            yield Given("l_f", order.roller, SIZE)
        return
    if order.roller:
        yield Given("r", order.roller, SIZE)
    else:
        yield Given("given follower", "given edge")
    if order.follower == ROCKER:
        assert order.lever is not None
        assert order.centres is not None
        yield Given("l", order.lever, SIZE)
        yield Given("a", order.centres, SIZE)
    elif order.offset:
        yield Given("e", order.offset, SIZE)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the contour, the displacements of the follower, their diagrams."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    if not order.eccentric:
        yield _(_CONTOUR)
    yield _(_FOLLOWER, n=order.parts)
    yield _(_DIAGRAMS)
    if order.accelerations == ("all",):
        yield _(_EVERY_PLAN)
    elif order.accelerations:
        yield _(_PLANS, positions=", ".join(order.accelerations))


_CONTOUR = said(
    "The contour of the cam is drawn of its arcs, the points where they meet are found."
)
_FOLLOWER = said(
    "The displacements of the follower are found by turning it about the cam; the angle over "
    "which it moves is divided into {n} part.",
    "The displacements of the follower are found by turning it about the cam; the angle over "
    "which it moves is divided into {n} parts.",
)
_DIAGRAMS = said(
    "The diagram of displacements is drawn, and those of velocities and accelerations of the "
    "follower by graphical differentiation."
)


_PLANS = said(
    "The cam is replaced by a linkage whose plans of velocities and accelerations are drawn in the "
    "positions {positions}."
)
_EVERY_PLAN = said(
    "The cam is replaced by a linkage whose plans of velocities and accelerations are drawn in all positions."
)


TASK_SHEET = TaskSheet(
    given=given,
    scheme=scheme,
    wanted={"arc_cam": asks},
)
