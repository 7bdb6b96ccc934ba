"""How large centrodes may be drawn; their μ_l, by the window that shows them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN, Centrodes
from graphic_tmm.chapters.centrodes.task import ASKED, CENTRODES
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.paper.window import Window, about
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

ROOM = 210.0
"""Room for the window the longer way, mm."""
FAR = 0.8
"""How far from the mechanism a centre is still shown, of the mechanism's own reach."""
EDGE = 0.04
"""White about what is shown, of its reach."""


def _fixed(scene: Scene) -> str:
    return "centrodes.mu_l" if "centrodes.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(CENTRODES, low=0.6, high=1.5, least=0.3, fixed=_fixed),),
    depends={CENTRODES: lambda scene, role: (CENTRODES,)},
)


def window_of(made: Centrodes, reading: Reading) -> Window:
    """Return the window of a link's centrodes: in mm of the sheet, or in m where nothing is to scale.

    It shows the mechanism as both touch, and centres that are not too far.
    """
    own = _flat(reading[mark][0] for mark in _still(made))
    far = _flat(reading[side.curve].knots[0] for side in made.sides)
    near = about(own).grown(FAR * about(own).reach)
    x = np.clip(far.real, near.low.real, near.high.real)
    y = np.clip(far.imag, near.low.imag, near.high.imag)
    whole = about(np.concatenate([own, x + 1j * y]))
    return whole.grown(EDGE * whole.reach)


def _flat(spots: Iterable[Complexes]) -> Complexes:
    found = np.concatenate([np.ravel(one) for one in spots])
    return np.asarray(found[np.isfinite(found)])


def _still(made: Centrodes) -> list[Mark]:
    return [*made.pivots, *(mark for side in made.sides for mark in side.stood)]


def _reach(project: Project, doubts: Doubts) -> Mapping[str, float]:
    found = {}
    for made in CENTRODES_PLAN.on(project):
        marks = [*_still(made), *(side.curve for side in made.sides)]
        found[made.view] = window_of(made, unscaled(project, doubts, marks)).reach
    return found


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    room, order = ROOM * sized.sizes[CENTRODES], ASKED.of(sized.project.scene)
    fixed = order.mu_l if order is not None else None
    for made in CENTRODES_PLAN.on(sized):
        reach = sized.reach[CENTRODES][made.view]
        yield ScaleFactor(made.mu, "l_{max}", reach, room, fixed=fixed, lengths=True)


SCALES = ScaleFactors(
    reach=_reach,
    factors=_factors,
    keys=lambda project: {
        made.view: f"mu_l_{CENTRODES}_{made.moving.link}" for made in CENTRODES_PLAN.on(project)
    },
)
