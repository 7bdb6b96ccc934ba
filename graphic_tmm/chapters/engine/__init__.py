"""The forces of an engine's crank mechanism, position by position: from the gas to the turning moment.

The gas force and the inertia of what goes to and fro make P′, which closes with the rod's force Q and the pressure N
on the guide; Q at the crank pin splits into T, tangential, and K, along the crank. The inertia force stands beside its
first two harmonics, the projections of two rotating vectors.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 13; руководства по динамике двигателей.
"""

from __future__ import annotations

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.engine.accuracy import ACCURACY
from graphic_tmm.chapters.engine.captions import CAPTIONS
from graphic_tmm.chapters.engine.harmonics import VIEW as HARMONICS
from graphic_tmm.chapters.engine.plan import ENGINE, VIEW, record
from graphic_tmm.chapters.engine.scales import SCALE_KEYS, engine_scales, named
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.chapters.engine.task import ASKED, SECTIONS
from graphic_tmm.chapters.engine.views import engine_diagram_views, engine_views
from graphic_tmm.chapters.forces.plan import FORCES
from graphic_tmm.chapters.indicator.cylinder import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.plan import (
    ACCELERATIONS,
    KINEMATICS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    assert order is not None
    wish = Wish(2, ENGINE.chapter, order.indicator)
    return {VELOCITIES: True, ACCELERATIONS: True, INDICATOR.chapter: wish}


def _sizes(scene: Scene, view: str) -> tuple[str, ...]:
    return ("graphs",) if view.startswith("indicator") else ("engine", POSITIONS)


def _views(project: Project) -> dict[str, list[str]]:
    charts = [chart.view for chart in ENGINE.on(project).charts]
    return {ENGINE.chapter: [VIEW, HARMONICS, *charts]}


CHAPTER = Chapter(
    name=ENGINE.chapter,
    number=7,
    captions=CAPTIONS,
    builds_on=(KINEMATICS.chapter, INDICATOR.chapter, FORCES.chapter),
    places=(
        Place("engine", 70, engine_views, follows=(POSITIONS,), sizes=_sizes),
        Place(
            "engine diagrams",
            71,
            engine_diagram_views,
            follows=(POSITIONS,),
            sizes=lambda scene, view: ("graphs",),
        ),
    ),
    sizes=(Size("engine", least=0.5),),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=_needs,
    sections=SECTIONS,
    record=record,
    charts=lambda made: made.charts,
    scales=engine_scales,
    named=named,
    scale_key=lambda view: SCALE_KEYS.get(view, ""),
    plans=(ENGINE.chapter,),
    plans_rank=26,
    columns=engine_columns,
    results=engine_results,
    views=_views,
    accuracy=ACCURACY,
)
