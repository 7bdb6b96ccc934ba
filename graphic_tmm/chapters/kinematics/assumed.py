"""Which keys of links are left out whose defaults matter where the energy or the inertia of links is taken."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said


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
