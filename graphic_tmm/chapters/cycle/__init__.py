"""A cycle of moments: the flywheel of a machine of which nothing is known but its moment over the turns.

A four-stroke engine repeats after two turns, a press or a pump may after three: the base of the graphs stands
for the whole cycle, 2π rad for each turn. The moments are given as they are read off a diagram, over the angle
of the shaft; they add up, and the other side is constant over the cycle. Integration, the segment cd and J =
cd·μ_T/(δ·ω²), or δ of a given J, are those of the chapter of the flywheel. There are no links and hence no
masses: ΔT is the energy of the flywheel alone.

Between positions the moment runs as the curve through its ordinates does; at a jump the ordinate is the mean
of both sides, so that the area is kept where jumps stand at positions.

Draws: place ``cycle`` (moment, works, energy, sketch, tables), on a board of its own. Uses the graphs, the rim
and the tables of the flywheel.

Sources: Артоболевский И. И., Теория механизмов и машин (неравномерность движения).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.board import roles
from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.cycle.names import CYCLE
from graphic_tmm.chapters.cycle.task import ASKED, SECTIONS
from graphic_tmm.chapters.flywheel.names import FLYWHEEL, VIEWS
from graphic_tmm.fitting.scales import GRAPH, GRAPHS
from graphic_tmm.language.said import said
from graphic_tmm.late import late
from graphic_tmm.readers.given import given_place

if TYPE_CHECKING:
    from graphic_tmm.chapter import Holder

with late(__name__):
    from graphic_tmm.chapters.cycle.accuracy import ACCURACY
    from graphic_tmm.chapters.cycle.asks import asks, listed
    from graphic_tmm.chapters.cycle.note import concludes, note
    from graphic_tmm.chapters.cycle.plan import record, record_beside
    from graphic_tmm.chapters.cycle.views import cycle_columns, cycle_results, cycle_views, given
    from graphic_tmm.chapters.flywheel.captions import graph_title
    from graphic_tmm.language.catalogue import speaking


_NAME = CYCLE.chapter
SCALE_KEYS = {
    VIEWS["moment"]: "mu_M_cycle",
    VIEWS["work"]: "mu_A_cycle",
    VIEWS["energy"]: "mu_T_cycle",
}
"""What the scale factors are called where machines read them."""


def _title(holder: Holder, view: str, language: str) -> str:
    order = CYCLE.on(holder).order.flywheel
    found = graph_title(view, order.constant, speaking(language), given=True)
    return found if view == VIEWS["moment"] else ""


CHAPTER = Chapter(
    name=_NAME,
    number=12,
    builds_on=(FLYWHEEL.chapter,),
    captions={
        "cycle": said("Flywheel for a cycle of moments"),
        "given cycle": said("Given for the cycle"),
        "table cycle": said("Flywheel, by positions"),
    },
    board=_NAME,
    places=(
        Place(
            _NAME,
            55,
            cycle_views,
            asks=asks,
            sizes=lambda scene, view: ("cycle sketch" if view == "flywheel" else GRAPHS,),
        ),
        given_place(_NAME),
    ),
    sizes=(GRAPH, Size("cycle sketch", small=0.6, cap=0.4, step=1.6, seen=False)),
    asked=lambda scene: ASKED.of(scene) is not None,
    given=given,
    listed=listed,
    sections=SECTIONS,
    record=record,
    aside=record_beside,
    charts=lambda made: made.flywheel.charts,
    result=lambda made: (made.flywheel.segment,),
    remedy=said("no work can be told of its moments; write them at more points"),
    scales=lambda fitting: fitting.shorter(
        GRAPHS,
        [
            ("cycle.base", VIEWS["moment"], roles.BASE),
            ("cycle.H", VIEWS["work"], roles.POLE_DISTANCE),
        ],
    ),
    scale_key=lambda view: SCALE_KEYS.get(view, ""),
    plans=(_NAME,),
    columns=cycle_columns,
    results=cycle_results,
    titles=_title,
    accuracy=ACCURACY,
    note=note,
    concludes=concludes,
    sources=("artobolevsky",),
)
