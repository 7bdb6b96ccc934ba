"""The flywheel: the moment of inertia that keeps a machine's speed within a coefficient of irregularity δ.

All forces are reduced to the crank by their powers: M·ω = P·v, so M = P·(v_B/v_A)·l_OA for the gas on a
piston, and for any loads their moment on Zhukovsky's lever. Graphical integration of M over φ (see the
chapter of diagrams) gives the work. In a steady cycle the work of the driving side equals that of the
resisting side at its end; where one moment is constant its work is the straight line from the beginning to
the end of the other.

Why T_м = ΔT − T_зв: the work that the driving forces have done more than the resisting ones, ΔT = A_дв −
A_с, is what the kinetic energy of the whole machine has gained. The links' part of it, T_зв = Σ(m·v²/2 +
J·ω²/2), is known from the plan of velocities; the rest went into the flywheel. It spins with the crank, so
its energy runs between J·ω_max²/2 and J·ω_min²/2, and their difference is J·ω²·δ (ω the mean speed, δ =
(ω_max − ω_min)/ω). The segment cd between the extremes of T_м, carried to the axis of ordinates, therefore
gives

    J = cd·μ_T/(δ·ω²).

T_зв is taken at the mean speed, an approximation for small δ (at δ = 0.23 it is some 12 % on the safe
side). Wittenbauer's diagram does without that: ΔT over the reduced inertia J_пр = 2·T_зв/ω² is a closed
curve; a ray to it from the (unknown) origin has the slope ω²/2. So the two tangents with the slopes tg ψ =
μ_J·ω²·(1 ± δ)/(2·μ_T) touch it where the speed is largest and smallest, and cut off ab on the axis of
energies: J = ab·μ_T/(δ·ω²), without an origin having to be on the sheet.

The rim: the largest diameter by the speed that its material stands; m = 4·J/D_m², its width from the
density.

Draws: place ``flywheel`` (moment, works, energies, energy–mass curve, sketch, tables). Builds on
kinematics, on indicator (the gas) or forces (loads on the lever).

Sources: Артоболевский И. И., Теория механизмов и машин (неравномерность движения, диаграмма Виттенбауэра);
Попов С. А., Тимофеев Г. А., Курсовое проектирование; the course project of the flywheel of a
single-cylinder engine (scene ``engine``).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.board import roles
from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.flywheel.captions import CAPTIONS, SYMBOLS
from graphic_tmm.chapters.flywheel.names import CALCULATED, ENERGY_MASS, FLYWHEEL, VIEWS
from graphic_tmm.chapters.flywheel.task import ASKED, SECTIONS
from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.chapters.indicator.names import CALCULATED as STROKE
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.names import (
    FULL_TURN,
    KINEMATICS,
    POSITIONS,
    TURNS,
    VELOCITIES,
)
from graphic_tmm.fitting.scales import GRAPH, GRAPHS
from graphic_tmm.late import late

if TYPE_CHECKING:
    from collections.abc import Iterator

    from graphic_tmm.chapter import Holder
    from graphic_tmm.drawn import Drawn
    from graphic_tmm.scene.records import Scene

with late(__name__):
    from graphic_tmm.chapters.flywheel.accuracy import ACCURACY
    from graphic_tmm.chapters.flywheel.asks import acting, asks, listed
    from graphic_tmm.chapters.flywheel.beside import record_beside
    from graphic_tmm.chapters.flywheel.captions import graph_title
    from graphic_tmm.chapters.flywheel.conclusions import concludes
    from graphic_tmm.chapters.flywheel.given import given
    from graphic_tmm.chapters.flywheel.note import note
    from graphic_tmm.chapters.flywheel.plan import record
    from graphic_tmm.chapters.flywheel.table import flywheel_columns, flywheel_results, rim_too_wide
    from graphic_tmm.chapters.flywheel.views import flywheel_views
    from graphic_tmm.chapters.kinematics.assumed import assumed
    from graphic_tmm.language.catalogue import speaking
    from graphic_tmm.language.names import plain


SCALE_KEYS = {
    VIEWS["moment"]: "mu_M",
    VIEWS["work"]: "mu_A",
    VIEWS["energy"]: "mu_T",
    ENERGY_MASS: "mu_J",
}
"""What the scale factors are called where machines read them."""


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    gas = order.indicator if order is not None else None
    if gas is None:
        return {VELOCITIES: True, FORCES.chapter: True}
    wish = Wish(3, FLYWHEEL.chapter, gas)
    return {VELOCITIES: True, INDICATOR.chapter: wish, TURNS: gas.turns}


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    if wide := rim_too_wide(drawn, language):
        yield f"flywheel: {plain(wide)}"
    yield from assumed(drawn)


def _title(holder: Holder, view: str, language: str) -> str:
    made = FLYWHEEL.on(holder)
    varying = view == VIEWS["moment"]
    return graph_title(view, made.order.constant, speaking(language)) if varying else ""


CHAPTER = Chapter(
    name=FLYWHEEL.chapter,
    number=5,
    captions=CAPTIONS,
    builds_on=(KINEMATICS.chapter, INDICATOR.chapter, FORCES.chapter),
    places=(
        Place(
            FLYWHEEL.chapter,
            50,
            flywheel_views,
            asks=asks,
            follows=(POSITIONS,),
            sizes=lambda scene, view: ("sketch" if view == FLYWHEEL.chapter else GRAPHS,),
        ),
    ),
    sizes=(GRAPH, Size("sketch", small=0.6, cap=0.4, step=1.6, seen=False)),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=_needs,
    given=given,
    listed=listed,
    acting=acting,
    sections=SECTIONS,
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.segment,),
    remedy=FULL_TURN,
    scales=lambda fitting: fitting.shorter(
        GRAPHS,
        [
            ("flywheel.base", VIEWS["moment"], roles.BASE),
            ("flywheel.H", VIEWS["work"], roles.POLE_DISTANCE),
        ],
    ),
    scale_key=lambda view: SCALE_KEYS.get(view, ""),
    warnings=_warnings,
    plans=(FLYWHEEL.chapter,),
    columns=flywheel_columns,
    results=flywheel_results,
    views=lambda project: {
        FLYWHEEL.chapter: [
            *(chart.view for chart in FLYWHEEL.on(project).charts),
            STROKE,
            CALCULATED,
        ]
    },
    titles=_title,
    accuracy=ACCURACY,
    note=note,
    concludes=concludes,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
