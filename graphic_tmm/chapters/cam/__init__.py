"""Cams: laws of motion, the region of centres by the pressure angle, the profile by reversed motion.

Over every position S is laid off the follower's line, dS/dφ square to it to the side of the rise; the tangent to that
curve, inclined by the largest pressure angle allowed, bounds the places where the cam's centre may be: every line from
such a centre to the curve stands steeper. The profile follows by turning the whole back against the cam; the roller's
circles envelop the working one. Under a flat face it is the radius of curvature that bounds r0 instead.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 26 (кулачковые механизмы).
"""

from __future__ import annotations

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.cam.accuracy import ACCURACY
from graphic_tmm.chapters.cam.captions import CAPTIONS
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.plan import CAM, GRAPHS, record
from graphic_tmm.chapters.cam.table import cam_columns, cam_marks
from graphic_tmm.chapters.cam.task import ASKED, SECTIONS
from graphic_tmm.chapters.cam.views import cam_views
from graphic_tmm.drawn import Drawn, results_of, view_scales
from graphic_tmm.scene.records import Scene

FIGURES = ("cam profile", "cam centre", "profile", "centre")
"""What is drawn of a cam besides graphs."""


def _sizes(scene: Scene, view: str) -> tuple[str, ...]:
    return (CAM.chapter,) if view.startswith(FIGURES) else (GRAPHS,)


def _limits(drawn: Drawn, language: str) -> tuple[str, ...]:
    """Return, as sentences, the limits that a cam passes."""
    found = cam_findings(drawn.reading, CAM.on(drawn))
    return tuple(one.says(language) for one in found)


def _told(key: str) -> Size:
    name = {"cam.mu_l": CAM.chapter, "cam.base": GRAPHS}[key]
    return Size(name, fixed=lambda scene: key if key in scene.told else "")


CHAPTER = Chapter(
    name=CAM.chapter,
    number=8,
    captions=CAPTIONS,
    board=CAM.chapter,
    places=(Place("cam", 100, cam_views, sizes=_sizes),),
    sizes=(_told("cam.mu_l"), _told("cam.base")),
    asked=lambda scene: ASKED.of(scene) is not None,
    sections=SECTIONS,
    record=record,
    charts=lambda made: made.charts,
    named=lambda project, reading, given: view_scales(project, reading),
    warnings=_limits,
    plans=(CAM.chapter,),
    columns=cam_columns,
    results=lambda drawn: results_of(drawn, cam_marks(CAM.on(drawn))),
    accuracy=ACCURACY,
)
