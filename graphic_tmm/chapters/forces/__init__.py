"""Kinetostatics: loads and inertia, groups in reverse order of attachment, the balancing force; Zhukovsky's lever.

A dyad is two legs here too: each leg knows the loads of its link and the tangential part of its reaction, which its
moment equation gives; the unknown part lies along the leg, and the polygon closes where the two lines meet. The turned
velocity plan as a rigid lever, loaded with the outer forces at the images of their points, gives the balancing force
a second time by one moment equation.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 13 (кинетостатика), гл. 15 (рычаг Жуковского).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.chapter import Chapter, Place
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS
from graphic_tmm.chapters.forces import views
from graphic_tmm.chapters.forces.accuracy import ACCURACY
from graphic_tmm.chapters.forces.captions import CAPTIONS, called
from graphic_tmm.chapters.forces.findings import balanced, compared, idle, ruled
from graphic_tmm.chapters.forces.plan import FORCES, record
from graphic_tmm.chapters.forces.scales import SIZES, force_scales, named, scale_key
from graphic_tmm.chapters.forces.sections import SECTIONS
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.chapters.indicator.cylinder import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.assumed import assumed
from graphic_tmm.chapters.kinematics.plan import (
    ACCELERATIONS,
    KINEMATICS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    found: dict[str, object] = {VELOCITIES: True}
    if order is not None and order.inertia:
        found[ACCELERATIONS] = True
    if order is not None and order.gas is not None:
        found[INDICATOR.chapter] = Wish(1, FORCES.chapter, order.gas)
    return found


def _sizes(scene: Scene, view: str) -> tuple[str, ...]:
    if view.startswith("indicator"):
        return ("graphs",)
    return ("groups", POSITIONS) if view.startswith("group") else ("forces",)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    if FORCES.on(drawn).order.inertia:
        yield from assumed(drawn)


def _views(project: Project) -> Mapping[str, list[str]]:
    """Return the views that forces are drawn in, in the order of the log."""
    made = FORCES.on(project)
    there = dict.fromkeys(step.it.view for step in project.construction.steps)
    return {FORCES.chapter: [view for view in there if made.owns(view)]}


CHAPTER = Chapter(
    name=FORCES.chapter,
    number=6,
    captions=CAPTIONS,
    called=called,
    builds_on=(KINEMATICS.chapter, DIAGRAMS.chapter, INDICATOR.chapter),
    places=(
        Place("forces", 60, views.force_views, follows=(POSITIONS,), sizes=_sizes),
        Place(
            "lever",
            61,
            views.lever_views,
            follows=(POSITIONS, VELOCITIES),
            sizes=lambda scene, view: ("lever",),
        ),
        Place("force table", 62, views.force_table, follows=(POSITIONS,)),
    ),
    sizes=SIZES,
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=_needs,
    sections=SECTIONS,
    record=record,
    scales=force_scales,
    named=named,
    scale_key=scale_key,
    nothing=balanced,
    coarse=ruled,
    compared=compared,
    findings=idle,
    warnings=_warnings,
    plans=(FORCES.chapter,),
    plans_rank=23,
    columns=force_columns,
    views=_views,
    equations=views.polygon_equation,
    accuracy=ACCURACY,
)
