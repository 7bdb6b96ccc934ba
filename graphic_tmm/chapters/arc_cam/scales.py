"""How large a cam of arcs may be drawn, and how its μ_l was chosen."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.chapters.arc_cam.linkage import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, reach_of
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.task import ARC_CAM
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "arc_cam.mu_l" if "arc_cam.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(ARC_CAM, low=0.75, fixed=_fixed),),
    depends={"arc_cam": lambda scene, role: (ARC_CAM,)},
)


VECTOR = 80.0
"""Room for the longest vector of a plan, mm."""
LARGEST = ("(v/ω)_{max}", "(a/ω²)_{max}")
"""What the longest vectors are called."""
SCALE_KEYS = {VELOCITIES: "mu_v_arc_cam", ACCELERATIONS: "mu_a_arc_cam"}
"""What the scale factors of the plans are called where machines read them."""


def reach(project: Project, doubts: Doubts) -> tuple[float, float]:
    """Return the longest vectors from the poles of both plans, m, in the positions that are drawn."""
    plans = BESIDE.on(project).plans
    at = list(plans.asked or range(len(plans.names)))
    pairs = [(one.velocities, one.accelerations) for one in plans.linkages.values()]
    most = []
    for which in (0, 1):
        ends = [mark for pair in pairs for mark in pair[which][:4] if mark is not None]
        reading = unscaled(project, doubts, ends)
        sizes = [np.abs(np.atleast_2d(reading[mark])) for mark in ends]
        rows = [np.broadcast_to(one, (1, len(project.names)))[0, at] for one in sizes]
        most.append(float(np.nanmax(np.concatenate([*rows, [0.0]]))))
    return most[0], most[1]


def planned(sized: Sized) -> Iterator[ScaleFactor]:
    """Yield the scale factors of both plans: by the longest vector of what is drawn."""
    scales, share = BESIDE.on(sized).plans.scales, sized.sizes[ARC_CAM]
    for mu, letter, most in zip(scales, LARGEST, sized.reach[ARC_CAM], strict=True):
        yield ScaleFactor(mu, letter, most, VECTOR * share)


SCALES = ScaleFactors(reach=reach, factors=planned, keys=lambda project: SCALE_KEYS)


def factors(drawn: Drawn) -> Iterator[ScaleFactor]:
    """Yield μ_l: by how far the contour with its follower reaches."""
    made = ARC_CAM_PLAN.on(drawn)
    far, mu_l = reach_of(made.order), made.order.mu_l
    yield ScaleFactor(made.contour.mu, "r_{max}", far, fixed=mu_l, lengths=True)


CHOICE = Choice(factors)
