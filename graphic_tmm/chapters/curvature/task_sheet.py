"""What a task asks of the curvature of paths."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.curvature.task import ASKED, CURVATURE
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the centres of curvature of points or of a link's points; for what else the scene asks."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    points = ", ".join(order.points)
    yield _(_POINTS, points=points) if points else _(_LINK, link=order.link)
    if order.circles or order.ball:
        yield _("The circles of Bresse and the pole of accelerations are drawn.")
    if order.ball:
        yield _("Ball's point is found.")


_POINTS = said(
    "Centres of curvature of the paths of {points} are found from the plans and by Bobillier's construction."
)
_LINK = said(
    "Centres of curvature of paths of link {link} are found from the plans and by Bobillier's construction."
)

TASK_SHEET = TaskSheet(wanted={CURVATURE: asks})
