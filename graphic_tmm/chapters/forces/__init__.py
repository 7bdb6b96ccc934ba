"""Kinetostatics: loads and inertia, groups in reverse order, the balancing force; Zhukovsky's lever.

By d'Alembert the moving mechanism is in equilibrium once inertia is added to the loads: −m·a_S at the mass
centre and the couple −J·ε. Groups are taken in the reverse of the order of attachment, for only the last
one carries nothing but its own loads: 3n = 2p₅ makes each statically determinate.

A dyad is two legs here too (`statics`). A leg that turns: the moments of its link about the closing point
give the part of the outer reaction square to the leg, R^t = ΣM/l; the rest of it lies along the leg. A leg
that slides: the reaction is square to the guide. So the polygon (known part of one reaction, loads of both
links, known part of the other) lacks two vectors of known directions, and closes where their lines meet.
The reaction in the inner pair runs from there to between the loads of the two links. Where the inner pair
slides it is square to that guide, and the line for it is drawn through the corner between the loads of both
links. The driving link is left with the reaction of the first group and the balancing force at the crank
pin, or a balancing moment.

Friction is taken from the reactions of the pass before: on guides the reaction leans by the angle of
friction, pins get the couple ρ·R (circle of friction); what further passes can change is a step of the log.

Zhukovsky: the powers of all forces, inertia included, sum to 0: Σ P·v·cos = 0. On the velocity plan turned
by 90° the arm of a force about the pole, when it is applied at the image of its point, is v·cos to the
scale; so the same sum is the sum of moments of the plan as a rigid lever about its pole. A couple on a link
becomes M·ab/l. It gives the balancing force once more by one equation without reactions: both must agree
(usually within 5 % by hand).

Draws: places ``forces`` (groups detached with their polygons and equations, the driving link), ``lever``,
``force table``, ``load diagram``. Builds on kinematics; on diagrams (loads by the travel of a slider); on
indicator (gas on a piston).

Sources: Артоболевский И. И., Теория механизмов и машин (кинетостатический анализ; теорема Жуковского о
жёстком рычаге); Попов С. А., Тимофеев Г. А., Курсовое проектирование; the course project of the windrower
(scene ``windrower``), and of the lever of a six-link mechanism.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.diagrams.names import DIAGRAMS
from graphic_tmm.chapters.forces.captions import CAPTIONS, SYMBOLS
from graphic_tmm.chapters.forces.names import FORCES, LOADS
from graphic_tmm.chapters.forces.sections import SECTIONS
from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.names import (
    ACCELERATIONS,
    KINEMATICS,
    POSITIONS,
    TURNS,
    VELOCITIES,
)
from graphic_tmm.fitting.scales import GRAPH, GRAPHS
from graphic_tmm.late import late

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from graphic_tmm.drawn import Drawn
    from graphic_tmm.project import Project
    from graphic_tmm.scene.records import Scene

with late(__name__):
    from graphic_tmm.chapters.forces import asks, views
    from graphic_tmm.chapters.forces.accuracy import ACCURACY
    from graphic_tmm.chapters.forces.any_angle import free, told
    from graphic_tmm.chapters.forces.captions import called
    from graphic_tmm.chapters.forces.choice import choose
    from graphic_tmm.chapters.forces.findings import balanced, compared, idle, ruled
    from graphic_tmm.chapters.forces.given import given, stated
    from graphic_tmm.chapters.forces.note import concludes, note
    from graphic_tmm.chapters.forces.plan import record
    from graphic_tmm.chapters.forces.scales import force_scales, named, reach, scale_key
    from graphic_tmm.chapters.forces.table import force_columns
    from graphic_tmm.chapters.forces.turning import between, moving
    from graphic_tmm.chapters.forces.views_loads import load_views
    from graphic_tmm.chapters.kinematics.assumed import assumed


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    found: dict[str, object] = {VELOCITIES: True}
    if order is not None and order.inertia:
        found[ACCELERATIONS] = True
    if order is not None and order.gas is not None:
        found[INDICATOR.chapter] = Wish(1, FORCES.chapter, order.gas)
        found[TURNS] = order.gas.turns
    return found


def _sizes(scene: Scene, view: str) -> tuple[str, ...]:
    if view.startswith("indicator"):
        return (GRAPHS,)
    return ("groups",) if view.startswith("group") else ("forces",)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    if FORCES.on(drawn).order.inertia:
        yield from assumed(drawn)


def _views(project: Project) -> Mapping[str, list[str]]:
    """Return the views that forces are drawn in, in the order of the log."""
    made = FORCES.on(project)
    there = dict.fromkeys(step.it.view for step in project.construction.steps)
    return {FORCES.chapter: [view for view in there if made.owns(view)]}


def _fixed(scene: Scene) -> str:
    order = ASKED.of(scene)
    return "forces.mu_F" if order is not None and order.mu is not None else ""


SIZES = (
    Size("forces", least=0.1, small=0.5, cap=0.42, fixed=_fixed),
    Size("groups", least=0.05, small=0.6, cap=0.42),
    Size("lever", least=0.05, small=0.6, cap=0.45),
)
"""Of polygons, of detached groups, of the lever: shares of the usual room."""

CHAPTER = Chapter(
    name=FORCES.chapter,
    number=6,
    captions=CAPTIONS,
    called=called,
    builds_on=(KINEMATICS.chapter, DIAGRAMS.chapter, INDICATOR.chapter),
    places=(
        Place(
            "forces",
            60,
            views.force_views,
            follows=(POSITIONS,),
            sizes=_sizes,
            asks=asks.polygons,
        ),
        Place(
            "lever",
            61,
            views.lever_views,
            follows=(POSITIONS, VELOCITIES),
            sizes=lambda scene, view: ("lever",),
            asks=asks.lever,
        ),
        Place("force table", 62, views.force_table, follows=(POSITIONS,), asks=asks.table),
        Place(LOADS, 0, load_views, follows=(POSITIONS,), attends=POSITIONS),
    ),
    sizes=(GRAPH, *SIZES),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=_needs,
    given=given,
    stated=stated,
    listed=asks.listed,
    acting=asks.acting,
    sections=SECTIONS,
    record=record,
    reach=reach,
    scales=force_scales,
    choice=choose,
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
    between=between,
    moving=moving,
    told=told,
    free=free,
    note=note,
    concludes=concludes,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
