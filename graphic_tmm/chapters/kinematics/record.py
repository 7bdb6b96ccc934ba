"""What is recorded of a mechanism: its plans; where it can be drawn."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.assembly import Assembly
from graphic_tmm.chapters.kinematics.plan import INSIDE, KINEMATICS_PLAN, record
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, ASKED, VELOCITIES
from graphic_tmm.language.said import Said, joined, said
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
    if KINEMATICS_PLAN.on(project).ends is not None:
        return joined("", (": ", assembly.said)), _between(assembly)
    inside = (
        f'"{(a + (b - a) * share) % 360:.4g} deg"' for a, b in assembly.ranges for share in SHARES
    )
    extra = said("write positions that lie there: extra = [{listed}]", listed=", ".join(inside))
    remedy = joined(said(", or "), (extra, _between(assembly)))
    return joined("", (": ", assembly.said)), remedy


def _between(assembly: Assembly) -> Said:
    """Return the ends of a row that can be drawn, a little inside the longest range."""
    low, high = max(assembly.ranges, key=lambda one: one[1] - one[0])
    off = INSIDE * (high - low)
    ends = (low + off, high - off)
    first, last = (
        f"{one:.4g} deg" if assembly.sweep.turns else f"{1000.0 * one:.4g} mm" for one in ends
    )
    return said(
        'write a row that lies there: from = "{first}", to = "{last}"', first=first, last=last
    )


PLAN = Plan(needs=_needs, record=record, ranges=_ranges)
