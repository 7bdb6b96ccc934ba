"""How large the views of a cam may be, and how scale factors that are no diagram's were chosen."""

from __future__ import annotations

import math

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import accepted
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.task import ASKED, CAM, GRAPHS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger, value_of
from graphic_tmm.fitting.scales import ScaleFactor
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import GRAPH, TABLE
from graphic_tmm.scene.records import Scene


def _depends(scene: Scene, role: str) -> tuple[str, ...]:
    return (GRAPHS,) if role in (GRAPH, TABLE) else (CAM,)


def _size(name: str, key: str) -> Size:
    return Size(name, low=0.75, fixed=lambda scene: key if key in scene.told else "")


SIZES = Sizing(
    sizes=(_size(CAM, "cam.mu_l"), _size(GRAPHS, "cam.base")),
    depends={"cam": _depends, "cam scheme": _depends},
)


_AS_DIAGRAMS = said(
    "The least radius is measured on the diagram whose lengths are those of the stroke: it is carried over "
    "as it is."
)
_HANDY = said("A millimetre for a degree: the angle is read off the ruler as it is.")


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how the scale factors of dS/dφ, of the centre with the profile, of the pressure angle came."""
    cam, order = CAM_PLAN.on(drawn), ASKED.of(drawn.scene)
    for chart in cam.charts:
        if chart.unit == "°" and chart.wanted:
            ledger.of(chart.view)
            ledger.given(chart.mu, chart.wanted, why=_HANDY)
    if order is not None and order.mu_V:
        ledger.of(cam.diagrams.V.chart.view)
        ledger.given(cam.diagrams.V.chart.mu, order.mu_V)
    mu = cam.profile.mu
    if mu not in drawn.given:
        _as_diagrams(drawn, ledger, mu, cam.profile.view)
    if mu not in drawn.given or order is None:
        return
    ledger.of(cam.profile.view)
    r0 = value_of(drawn, cam.r0)
    far, letter = r0 + value_of(drawn, cam.diagrams.stroke), "r_{max}"
    if order.developed:
        far, letter = (r0, "L") if order.slides else (math.tau * r0, "2πR")
    ledger.ruled(drawn, ScaleFactor(mu, letter, far, fixed=order.mu_l, lengths=True))


def _as_diagrams(drawn: Drawn, ledger: Ledger, mu: Mark, view: str) -> None:
    """Record that the profile is drawn to the scale factor of the strokes."""
    steps = {step.it: step for step in drawn.construction.steps}
    ledger.of(mu.view)
    same = ledger.copied(drawn, steps, mu)
    ledger.of(view)
    ledger.draft.draw(accepted, "μ_l", same, unit=mu.unit, why=_AS_DIAGRAMS)


CHOICE = Choice(choose=choose)
