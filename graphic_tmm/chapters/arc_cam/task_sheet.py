"""What a task asks of a cam of arcs, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.arc_cam.given import given
from graphic_tmm.chapters.arc_cam.scheme import scheme
from graphic_tmm.chapters.arc_cam.task import ASKED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the contour, the displacements of the follower, their diagrams."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    yield _(_CONTOUR)
    yield _(_FOLLOWER, n=order.parts)
    yield _(_DIAGRAMS)


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


TASK_SHEET = TaskSheet(
    given=given,
    scheme=scheme,
    wanted={"arc_cam": asks},
)
