"""Synthesis: the lengths of a mechanism found by ruler and compass from what it is to do, before its plan.

By dead centres: the angle θ = 180°·(K_v − 1)/(K_v + 1) lies between both of them, and in each crank and
coupler are in one line with O. So O stands on the circle from which both extreme places of the driven pin are
seen under θ: its centre is where two lines at 90° − θ to their chord meet. One condition more fixes O on it:
the offset e of a slider's guide, or of a rocker the distance of the pivots or the least angle of
transmission, measured where crank and frame are in line. OB is l + r and l − r there, so their difference is
twice the crank.

By positions: a pin that turns about a fixed centre keeps its distance from it, so the centre stands on the
bisectors of the chords between its places. Three places of a coupler give O and C by two pairs of bisectors;
three pairs of angles of crank and rocker give B likewise once the rocker is held and the frame turned back
about C (inversion); a function (x^p, ln x, sin x) is met at three places of Chebyshev's spacing, or a table
in its three points, by the angles that stand for them.

By a coupler's path: where it keeps near an arc, a second dyad as long as the arc's radius, its far pin at the
centre, stands while the crank turns. The arc is the one that the path leaves least, through the three points
in which it crosses it; their bisectors meet in its centre.

A rocker with its stone is found from two lines under θ that its crank is square to, a swinging cylinder from
two under its swing that the pin's circle touches. Where the rod is chosen by its ratio λ or by the greatest
pressure angle, the crank is half the stroke, or, with an offset, calculated, and the dead centres are drawn as
a check.

What is measured stands beside what is calculated, which the scene's lengths are. That a mechanism through
three places may reach them in another order, or only taken apart, is told of it.

Draws: place ``synthesis``: the construction, its results; on a board of its own.

Sources: Артоболевский И. И., Теория механизмов и машин (синтез механизмов); Попов С. А., Тимофеев Г. А.,
Курсовое проектирование; Norton R. L., Design of Machinery (graphical linkage synthesis).
"""

from __future__ import annotations

from graphic_tmm.chapters.linkage_synthesis.task import CHAPTER_NAME, SECTIONS, SYNTHESIS
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_ASKS = (
    said("The lengths of the mechanism are found graphically from what it is to do."),
    said("What is measured is compared with what is calculated."),
)

CHAPTER = Chapter(
    name=CHAPTER_NAME,
    number=0,
    board=SYNTHESIS,
    places=(
        Place(SYNTHESIS, 5, asks=_ASKS),
        Place(f"{SYNTHESIS} given", attends=SYNTHESIS),
    ),
    sections=SECTIONS,
)
