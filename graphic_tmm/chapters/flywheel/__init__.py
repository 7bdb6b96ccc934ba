"""The flywheel: the moment of inertia that keeps a machine's speed within a coefficient of irregularity δ.

The reduced moment of the driving (or resisting) forces is integrated to their works; the other side is constant over
the cycle. ΔT, the works' difference, less the energy T_зв of the links is the energy of the flywheel: T_м = ΔT − T_зв.
The segment cd between its extremes gives J = cd·μ_T/(δ·ω²). Wittenbauer's diagram of energy over reduced inertia gives
it a second time, by its two tangents.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 19 (маховые массы), диаграмма Виттенбауэра.
"""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board import roles
from graphic_tmm.chapter import Chapter, Holder, Place, Size
from graphic_tmm.chapters.flywheel.accuracy import ACCURACY
from graphic_tmm.chapters.flywheel.captions import CAPTIONS, graph_title
from graphic_tmm.chapters.flywheel.energy_mass import VIEW as ENERGY_MASS
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL, VIEWS, record
from graphic_tmm.chapters.flywheel.table import flywheel_columns, flywheel_results, rim_too_wide
from graphic_tmm.chapters.flywheel.task import ASKED, SECTIONS
from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.chapters.forces.plan import FORCES
from graphic_tmm.chapters.indicator.cylinder import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.assumed import assumed
from graphic_tmm.chapters.kinematics.plan import KINEMATICS, POSITIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.names import plain
from graphic_tmm.scene.records import Scene

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
    return {VELOCITIES: True, INDICATOR.chapter: Wish(3, FLYWHEEL.chapter, gas)}


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
            follows=(POSITIONS,),
            sizes=lambda scene, view: (
                "sketch" if view.partition("-")[0] == FLYWHEEL.chapter else "graphs",
            ),
        ),
    ),
    sizes=(Size("sketch"),),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=_needs,
    sections=SECTIONS,
    record=record,
    charts=lambda made: made.charts,
    scales=lambda fitting: fitting.shorter(
        "graphs",
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
    views=lambda project: {FLYWHEEL.chapter: [chart.view for chart in FLYWHEEL.on(project).charts]},
    titles=_title,
    accuracy=ACCURACY,
)
