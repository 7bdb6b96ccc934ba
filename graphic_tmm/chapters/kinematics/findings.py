"""Where a mechanism cannot be drawn, and which keys of links are left out whose defaults matter."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.chapters.kinematics.views import warned
from graphic_tmm.drawn import Drawn, Findings
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.findings import Warned
from graphic_tmm.scene.meshes import APART


def assumed(drawn: Drawn) -> Iterator[str]:
    """Yield, for people, that links with a mass have no J, where they turn unevenly."""
    plans = KINEMATICS_PLAN.on(drawn)
    drive, velocities = plans.mechanism.drive, plans.velocities
    if velocities is None:
        return
    # a crank that turns evenly has no inertia couple, and an energy that does not change
    even = {drive.link} if drive.acceleration == 0.0 else set()
    bare = [
        str(link.number)
        for link in plans.mechanism.links
        if link.mass and link.inertia is None and link.number in velocities.rates.keys() - even
    ]
    if bare:
        yield said(
            "link {links}: J is left out, with a mass given: no inertia couple and no energy of "
            "turning is taken; write J, or J = 0",
            links=", ".join(bare),
        )


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    """Return the positions in which a mark of the plan of positions is not there."""
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks(POSITIONS):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))


FINDINGS = Findings(undrawn=_undrawn)


def _warned(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield what the views warn of, and wheels in two meshes whose pitch radii are two."""
    yield from warned(drawn, language)
    known: dict[tuple[int, str, float], float] = {}
    for rolling in KINEMATICS_PLAN.on(drawn).structure.wheels:
        mesh, radii = rolling.mesh, {rolling.link: rolling.reach, rolling.on: rolling.away}
        for link, centre, size in zip(mesh.links, mesh.centres, mesh.sizes, strict=True):
            radius = abs(radii[link])
            other = known.setdefault((link, centre, size), radius)
            if abs(radius - other) > APART * other:
                yield speaking(language)(
                    _TWO_RADII,
                    link=link,
                    centre=centre,
                    first=1000.0 * other,
                    second=1000.0 * radius,
                    module=2000.0 * other / size,
                    own=2000.0 * radius / size,
                )


_TWO_RADII = said(
    "the wheel of link {link} about {centre} is in two meshes, with the pitch radii {first:.4g} and "
    "{second:.4g} mm: one wheel has one (the module 2r/z: {module:.4g} ≠ {own:.4g} mm); move a centre or "
    "change teeth"
)


WARNINGS = Warned(_warned)
