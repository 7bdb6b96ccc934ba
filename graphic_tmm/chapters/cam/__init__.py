"""Cams: laws of motion, the region of centres by the pressure angle, the profile by reversed motion.

A law is drawn as three diagrams on one base: S, dS/dφ, d²S/dφ². Sine and cosine come from semicircles,
constant acceleration from two parabolas, the polynomial 3-4-5 from calculated ordinates; a law given by its
acceleration diagram is integrated twice against a pole, and its scale found from the stroke (`laws`,
`law_formulas`, `integral`). Of a diagram read off paper a jump is put where a position stands and areas are
made equal by one factor, as far as a ruler does not tell the difference (`read_off`).

How the region of centres arises: take the cam's centre O anywhere below the roller's centre B, and in some
position lay off dS/dφ from B square to the path, to the side to which the velocity comes when it is turned
by 90° as the cam turns; its end is Q. The contact normal passes through the instantaneous centre of cam and
follower, which stands at dS/dφ from O on the line square to the path: so OQ is parallel to the normal, and
the angle of OQ with the path *is* the pressure angle, wherever O may stand. Every O from which no ray to
the curve of Q is inclined more than is allowed will do: tangents to the curve of the rise and to that of
the return, inclined by the allowed pressure angle to the path, bound the region, and its highest point on
the line of the centres gives the least r0 (`centre`). For a rocker whose distance of centres is given,
dS/dφ is laid off along the lever, and a line through Q inclined by the allowed angle to the path cuts the
circle of the centres where the region begins (`rocker`). Under a flat face the pressure angle does not
depend on r0; there the profile must be convex: r0 + S + d²S/dφ² ≥ ρ_min, and a line falling at 45° in the
diagram of S over d²S/dφ² gives r0 (`flat`).

Reversed motion: give everything the angular velocity −ω. The cam stands, the guide goes round it, the
roller's centre draws the theoretical profile; the working profile is its equidistant at the roller's
radius, which should stay below a share of r0 and of the theoretical profile's least radius of curvature.

Draws: place ``cam``: diagrams, region of centres, profiles, pressure angle and curvature over the turn,
results; place ``cam scheme``: the mechanism in one position with its pressure angle; on a board of its own
whose positions are angles of the cam. Builds on no chapter.

Sources: Артоболевский И. И., Теория механизмов и машин (синтез кулачковых механизмов); Попов С. А.,
Тимофеев Г. А., Курсовое проектирование (проектирование кулачковых механизмов); the course project of the
windrower (scene ``windrower``).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.cam.captions import CAPTIONS, SYMBOLS
from graphic_tmm.chapters.cam.names import CAM, GRAPHS
from graphic_tmm.chapters.cam.task import ASKED, SECTIONS
from graphic_tmm.language.said import said
from graphic_tmm.late import late
from graphic_tmm.readers.given import given_place

if TYPE_CHECKING:
    from graphic_tmm.drawn import Drawn
    from graphic_tmm.scene.records import Scene

with late(__name__):
    from graphic_tmm.chapters.cam import asks
    from graphic_tmm.chapters.cam.accuracy import ACCURACY
    from graphic_tmm.chapters.cam.beside import record_beside
    from graphic_tmm.chapters.cam.choice import choose
    from graphic_tmm.chapters.cam.findings import cam_findings, changes
    from graphic_tmm.chapters.cam.given import given, stated
    from graphic_tmm.chapters.cam.note import note
    from graphic_tmm.chapters.cam.note_conclusions import concludes
    from graphic_tmm.chapters.cam.plan import record
    from graphic_tmm.chapters.cam.scheme import scheme
    from graphic_tmm.chapters.cam.table import cam_columns, results
    from graphic_tmm.chapters.cam.verdict import verdict as judged
    from graphic_tmm.chapters.cam.views import cam_views, scheme_views
    from graphic_tmm.drawn import view_scales


FIGURES = ("cam profile", "cam scheme", "cam centre", "profile", "centre")
"""What is drawn of a cam besides graphs."""


def _sizes(scene: Scene, view: str) -> tuple[str, ...]:
    return (CAM.chapter,) if view.startswith(FIGURES) else (GRAPHS,)


def _limits(drawn: Drawn, language: str) -> tuple[str, ...]:
    """Return, as sentences, what was changed of diagrams read off paper, and the limits that a cam passes."""
    made = CAM.on(drawn)
    found = cam_findings(drawn.reading, made)
    return (*changes(made, language), *(one.says(language) for one in found))


def _told(key: str) -> Size:
    name = {"cam.mu_l": CAM.chapter, "cam.base": GRAPHS}[key]
    return Size(
        name,
        small=0.75,
        cap=CAPS[key],
        step=1.25,
        fixed=lambda scene: key if key in scene.told else "",
    )


CAPS = {"cam.mu_l": 0.6, "cam.base": 0.94}
"""What share of a sheet's height what a key sizes may take."""

CHAPTER = Chapter(
    name=CAM.chapter,
    number=8,
    captions=CAPTIONS,
    board=CAM.chapter,
    places=(
        Place("cam", 100, cam_views, sizes=_sizes, asks=asks.asks),
        Place("cam scheme", 0, scheme_views, sizes=_sizes, asks=asks.scheme),
        given_place("cam"),
    ),
    sizes=(_told("cam.mu_l"), _told("cam.base")),
    asked=lambda scene: ASKED.of(scene) is not None,
    given=given,
    stated=stated,
    listed=asks.listed,
    scheme=scheme,
    sections=SECTIONS,
    record=record,
    aside=record_beside,
    choice=choose,
    charts=lambda made: made.charts,
    result=lambda made: (made.least,),
    remedy=said(
        "no centre of the cam keeps the pressure angle within its limit; allow a larger one "
        "(pressure, or a smaller transmission), or a smaller stroke or longer phases"
    ),
    named=lambda project, reading, given: view_scales(project, reading),
    warnings=_limits,
    plans=(CAM.chapter,),
    columns=cam_columns,
    results=results,
    accuracy=ACCURACY,
    concludes=lambda drawn, language: (*concludes(drawn, language), *judged(drawn, language)),
    note=note,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
