"""The forces of an engine's crank mechanism, position by position: from the gas to the turning moment.

The rod's mass is shared between its two pins by the lever rule (or a given share), so that the rod carries
force along itself only: what is at the crosshead goes to and fro, what is at the crank pin turns with it
and has no moment about O. Its moment of inertia is not kept by that; how much is missed is told.

At B: the gas P = p_k·F_k − p_v·F_v and the inertia P_in = −m·a_B make P′ = P + P_in. The crosshead is in
equilibrium under P′, the force Q along the rod and the pressure N of the guide, so P′ resolves into N =
P′·tan β and Q = P′/cos β: a right triangle. Q, carried along the rod to A, resolves again, along the
tangent of the crank circle and along the crank: T = Q·sin(φ + β), K = Q·cos(φ + β). M = T·R turns the
crank; N on the arm OB is the couple that tips the frame, opposite to M. Forces are positive towards the
crank.

The two-term series: a = ω²·R·(cos φ + λ·cos 2φ) with λ = R/l. Its terms are the projections of a vector
m·ω²·R that turns with the crank and of m·ω²·R·λ that turns twice as fast (first and second order); the
exact acceleration off the plan has more terms, and both stand side by side. A task in kgf is drawn and
tabulated in kgf, with SI beside it.

Draws: places ``engine`` (indicator diagram, force triangles, rotating vectors) and ``engine diagrams`` (P,
N, Q, T, K, M over the turn). Builds on kinematics and indicator; on forces for how vectors of force are
inked and what is told of a moment's accuracy.

Sources: the book chapter on the forces in the crank mechanism of a steam engine, formulas (338)–(344) and
(349)–(352), with the locomobile P-25 (scene ``locomobile``); Артоболевский И. И., Теория механизмов и машин
(кинетостатика).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.engine.captions import CAPTIONS, SYMBOLS
from graphic_tmm.chapters.engine.names import (
    CALCULATED,
    ENGINE,
    HARMONICS,
    MASSES,
    TRANSFER,
    TRANSFER_PLACE,
    VIEW,
    WORKS_VIEW,
)
from graphic_tmm.chapters.engine.task import ASKED, SECTIONS
from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.chapters.indicator.names import CALCULATED as STROKE
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.names import (
    ACCELERATIONS,
    FULL_TURN,
    KINEMATICS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.fitting.scales import GRAPH, GRAPHS
from graphic_tmm.late import late

if TYPE_CHECKING:
    from graphic_tmm.project import Project
    from graphic_tmm.scene.records import Scene

with late(__name__):
    from graphic_tmm.chapters.engine import asks
    from graphic_tmm.chapters.engine.accuracy import ACCURACY
    from graphic_tmm.chapters.engine.beside import record_beside
    from graphic_tmm.chapters.engine.choice import choose
    from graphic_tmm.chapters.engine.conclusions import concludes
    from graphic_tmm.chapters.engine.given import given
    from graphic_tmm.chapters.engine.note import note
    from graphic_tmm.chapters.engine.plan import record
    from graphic_tmm.chapters.engine.scales import SCALE_KEYS, engine_scales, named, reach
    from graphic_tmm.chapters.engine.table import engine_columns, engine_results
    from graphic_tmm.chapters.engine.turning import moving
    from graphic_tmm.chapters.engine.views import engine_diagram_views, engine_views, transfer_views


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    assert order is not None
    wish = Wish(2, ENGINE.chapter, order.indicator)
    return {VELOCITIES: True, ACCELERATIONS: True, INDICATOR.chapter: wish}


def _sizes(scene: Scene, view: str) -> tuple[str, ...]:
    return (GRAPHS,) if view.startswith("indicator") else ("engine", POSITIONS)


def _views(project: Project) -> dict[str, list[str]]:
    charts = [chart.view for chart in ENGINE.on(project).charts]
    cylinder = INDICATOR.on(project)
    own = [cylinder.indicator.chart.view, STROKE] if cylinder.shown_by == ENGINE.chapter else []
    return {
        ENGINE.chapter: [*own, VIEW, TRANSFER, HARMONICS, *charts, CALCULATED, MASSES, WORKS_VIEW]
    }


CHAPTER = Chapter(
    name=ENGINE.chapter,
    number=7,
    captions=CAPTIONS,
    builds_on=(KINEMATICS.chapter, INDICATOR.chapter, FORCES.chapter),
    places=(
        Place("engine", 70, engine_views, follows=(POSITIONS,), sizes=_sizes, asks=asks.plan),
        Place(
            TRANSFER_PLACE,
            0,
            transfer_views,
            asks=asks.transfer,
            follows=(POSITIONS,),
            sizes=lambda scene, view: (TRANSFER, POSITIONS),
        ),
        Place(
            "engine diagrams",
            71,
            engine_diagram_views,
            asks=asks.diagrams,
            follows=(POSITIONS,),
            sizes=lambda scene, view: (GRAPHS,),
        ),
    ),
    sizes=(
        GRAPH,
        Size("engine", least=0.5, small=0.7, cap=0.4),
        Size(TRANSFER, least=0.5, small=0.7),
    ),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=_needs,
    given=given,
    listed=asks.listed,
    acting=asks.acting,
    sections=SECTIONS,
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.values["M"],),
    remedy=FULL_TURN,
    moving=moving,
    reach=reach,
    scales=engine_scales,
    choice=choose,
    named=named,
    scale_key=lambda view: SCALE_KEYS.get(view, ""),
    plans=(ENGINE.chapter,),
    plans_rank=26,
    columns=engine_columns,
    results=engine_results,
    views=_views,
    accuracy=ACCURACY,
    note=note,
    noted=(TRANSFER_PLACE,),
    concludes=concludes,
    sources=("artobolevsky",),
    symbols=SYMBOLS,
)
