"""What is recorded of a mechanism: its plans; where it can be drawn."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, record
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, ASKED, VELOCITIES
from graphic_tmm.language.said import joined, said
from graphic_tmm.project import Plan, Project
from graphic_tmm.scene.records import Scene

SHARES = (0.25, 0.5, 0.75)
"""Where in a range of crank angles a position is proposed."""


def _needs(scene: Scene) -> dict[str, object]:
    """Return the plans that further rows are read off."""
    rows = ASKED.of(scene)
    if rows is None:
        return {}
    gained = bool(rows.relative or rows.paths)
    return dict.fromkeys(
        [*[VELOCITIES] * bool(rows.pins or gained), *[ACCELERATIONS] * gained], True
    )


def _ranges(project: Project) -> tuple[str, str]:
    """Return, as the end of a sentence, where the mechanism assembles; and how to draw it there."""
    assembly = KINEMATICS_PLAN.on(project).assembly
    if not assembly.said:
        return "", ""
    inside = (
        f'"{(a + (b - a) * share) % 360:.4g} deg"' for a, b in assembly.ranges for share in SHARES
    )
    remedy = said("write positions that lie there: extra = [{listed}]", listed=", ".join(inside))
    return joined("", (": ", assembly.said)), remedy


PLAN = Plan(needs=_needs, record=record, ranges=_ranges)
