"""What forces tell at any angle of the crank: the reactions, what balances the crank by both methods."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphic_tmm.any_angles.turn import Told
from graphic_tmm.board.naming import segment_name
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.table import balance_segments
from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.values import OTHER_EXTREME


def free(scene: Scene) -> Scene:
    """Return the scene with both ends of the travel, by which a load is given, among its positions.

    Raises
    ------
    StructureError
        If the row does not begin at an extreme position of the point that travels: its stroke would be that of
        the positions drawn, and it would turn round at one of them.
    """
    order = ASKED.of(scene)
    points = [load.travel.of for load in order.loads if load.travel] if order else []
    if not points:
        return scene
    zero = scene.row.zero
    if not isinstance(zero, Extreme) or {zero.point} != set(points):
        says = said(
            "a load by the travel of {point} is known at any angle where the row begins at an extreme position "
            'of that point: zero = {{ point = "{point}", at = "left" }}',
            point=points[0],
        )
        raise scene.located(StructureError(says, "drive.zero", head="load"))
    extra = scene.row.extra
    row = replace(scene.row, extra=extra if OTHER_EXTREME in extra else (*extra, OTHER_EXTREME))
    return replace(scene, row=row)


def told(project: Project) -> Iterator[Told]:
    """Yield the reactions as vectors, N, then the balancing force or moment by groups and by the lever."""
    made = FORCES_PLAN.on(project)
    # passes of friction that do not settle leave no force known
    known = made.balance if made.open is not None else None
    for one in made.reactions:
        key, mu = segment_name(one.letter), project.scale(one.tail.view)
        yield Told("forces", "forces", key, one.head, mu, one.tail, known=known)
    for name, mark in balance_segments(made).items():
        yield Told("forces", "balance", name, mark, known=known)
