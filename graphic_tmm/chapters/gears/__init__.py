"""A pair of involute gears, spur, helical, in a ring or on a rack: dimensions, line of action, teeth, sliding.

Dimensions follow from tooth numbers, module and shifts: inv α_w = inv α + 2·(x₁ + x₂)·tan α/(z₁ + z₂) (no
play between flanks of shifted wheels), a_w = a·cos α/cos α_w, and the equalising shift Δy that keeps the
clearance at the tips.

Line of action: the tangent N₁N₂ common to both base circles. A string unwound from one base circle onto the
other turns both wheels in the fixed ratio r_b1 : r_b2, and each of its points draws an involute on either
wheel; these two touch on the string, with it as their common normal. So flanks that are involutes mesh
along this line only, and the ratio stays constant (Willis: the normal passes through the fixed pitch point
P). A flank is drawn so: arcs of the base circle are laid off on their tangents (`teeth`). Where the
involute ends below, the fillet begins: the path of the rounded corner of the rack's tooth, which cuts away
part of the involute if the wheel has too few teeth (`rack`).

Contact lasts while the touching point is on the part ab of N₁N₂ between the tip circles; where a tip reaches
beyond N₁ or N₂ there is no involute to touch, and ab ends in that limit, as it ends where a pointed tooth does
(`line`). The contact ratio is the arc of engagement over the pitch, drawn and by formula; above 1 a second pair
is there before the first one leaves (`contact`). Flanks slide on one another but at P:
ϑ₁ = 1 − (r₁/r₂)·(ρ₂/ρ₁) over the distance x from N₁, where ρ₁ = x and ρ₂ = N₁N₂ − x are the radii of curvature
(`sliding`).

A helical pair is drawn in the section across its axes (`helical`). In a ring N₁ and N₂ lie on one side of P;
`ring` asks whether wheel and ring miss one another. A rack is a wheel of infinite radius: its flanks are
straight, N₂ is infinitely far (`driven_rack`). The distance of the axes or the sum of the shifts gives the
shift that is missing (`shifts`). What does not work is told by checks. Where the speed of wheel 1 is given the
velocities of sliding are calculated (`record`).

Beside the drawing are calculated the ratio, the arc of engagement, and how long each dimension is on the
sheet (`beside`); a given length of a_w there makes the scale of the mesh.

Draws: place ``gears``: the mesh with three teeth a wheel, the rolling of a flank in a view of its own, the
diagram of sliding, tables; on a board of its own whose positions are the steps of the rolling. Builds on no
chapter.

Sources: Артоболевский И. И., Теория механизмов и машин (эвольвентное зацепление); ГОСТ 13755, 16532; Попов
С. А., Тимофеев Г. А., Курсовое проектирование; the course project of the windrower (scene ``windrower``).
"""

from __future__ import annotations

from graphic_tmm.chapters.gears.task import GEARS, SECTIONS
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_ASKS = (
    said("The dimensions of the gear pair are calculated."),
    said(
        "The meshing is drawn: the line of action with its working part, the construction of the "
        "flanks, three teeth of each wheel, the active flanks."
    ),
    said("The contact ratio is found from the drawing and by the formula."),
    said("The diagram of specific sliding is drawn."),
)

CHAPTER = Chapter(
    name=GEARS,
    number=9,
    board=GEARS,
    places=(Place("gears", 110, asks=_ASKS), Place("gears given", attends="gears")),
    sections=SECTIONS,
)
