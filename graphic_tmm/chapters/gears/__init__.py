"""A pair of involute gears: dimensions, the line of action, teeth rolled off a rack, contact ratio, sliding.

The dimensions follow from numbers of teeth, module and shifts; a tooth's flank is the involute that the line of action
leaves on the wheel as it rolls on the base circle, its fillet the path of the rack's corner.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 22 (эвольвентное зацепление); ГОСТ 13755, 16532.
"""

from __future__ import annotations

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.gears.accuracy import ACCURACY
from graphic_tmm.chapters.gears.captions import CAPTIONS
from graphic_tmm.chapters.gears.plan import GEARS, gear_scales, record
from graphic_tmm.chapters.gears.results import gear_results
from graphic_tmm.chapters.gears.task import ASKED, SECTIONS
from graphic_tmm.chapters.gears.views import gear_views
from graphic_tmm.drawn import view_scales
from graphic_tmm.readers.measured import measured_columns
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "gears.mu_l" if "gears.mu_l" in scene.told else ""


CHAPTER = Chapter(
    name=GEARS.chapter,
    number=9,
    captions=CAPTIONS,
    board=GEARS.chapter,
    places=(Place("gears", 110, gear_views, sizes=lambda scene, view: (GEARS.chapter,)),),
    sizes=(Size(GEARS.chapter, fixed=_fixed),),
    asked=lambda scene: ASKED.of(scene) is not None,
    sections=SECTIONS,
    record=record,
    scales=gear_scales,
    named=lambda project, reading, given: view_scales(project, reading),
    scale_key=lambda view: {"gear": "mu_l_gears", "sliding": "mu_theta"}.get(view, ""),
    plans=(GEARS.chapter,),
    columns=measured_columns,
    results=gear_results,
    accuracy=ACCURACY,
)
