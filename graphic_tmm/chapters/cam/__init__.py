"""Cams: laws of motion, the region of centres by the pressure angle, the profile by reversed motion.

A law is drawn as three diagrams on one base: S, dS/dφ, d²S/dφ². Sine and cosine come from semicircles,
constant acceleration from two parabolas, constant velocity from a straight line between two more, the
polynomial 3-4-5 from calculated ordinates, derivatives of a table of S from its chords; a law given by its
acceleration diagram is integrated twice against a pole, and its scale found from the stroke (`laws`,
`law_formulas`, `integral`). With several lifts in a turn each phase is drawn on the level of its lower place
(`task_motion`). Of a diagram read off paper a jump is put where a position stands and areas are made equal by
one factor, as far as a ruler does not tell the difference (`read_off`).

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

On a lever that swings the face turns too: the arms a_w·(2τ − 1)/τ² square to it and a_w·d²ψ/dφ²/τ³ along
it, τ = 1 ± dψ/dφ, lead from the pivot to E, and the projection of O1E on the line of the centres is the
radius of curvature with the distance of the face (`flat_rocker`).

Reversed motion: give everything the angular velocity −ω. The cam stands, the guide goes round it, the
roller's centre draws the theoretical profile; the working profile is its equidistant at the roller's
radius, which should stay below a share of r0 and of the theoretical profile's least radius of curvature. A
knife edge draws the working profile itself.

On a drum (`form = "drum"`) the rod goes along the axis: the mean circumference is unrolled, the roller's
path stands at R·φ and S, its tangent gives tan α = (dS/dφ)/R, so the least R follows from the largest dS/dφ
(`drum`). A groove, of a drum or of a disc (`groove = true`), has a second flank on the other side of the
roller; the sharpest bend of the path to either side bounds the roller then.

A cam that slides (`form = "translating"`) is what such a development is: diagrams stand over its travel s,
tan α = dS/ds, so rays from a pole at its length L to L·dS/ds give the least length (`drum`).

Where the follower has a mass, inertia P over the turn and a line of the spring over the displacement follow:
the steepest ray to the wanted force from the pole, as far before the lowest place as the spring is compressed
there, gives its rate and its preload; force of contact and moment on the shaft are drawn over the turn
(`spring`).

Draws: place ``cam``: diagrams, region of centres, profiles, pressure angle and curvature over the turn,
results; place ``cam scheme``: the mechanism in one position with its pressure angle; on a board of its own
whose positions are angles of the cam. Builds on no chapter.

Sources: Артоболевский И. И., Теория механизмов и машин (синтез кулачковых механизмов); Попов С. А.,
Тимофеев Г. А., Курсовое проектирование (проектирование кулачковых механизмов); the course project of the
windrower (scene ``windrower``).
"""

from __future__ import annotations

from graphic_tmm.chapters.cam.task import CAM, SECTIONS
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_SCHEME = said("The scheme of the cam mechanism is drawn.")

CHAPTER = Chapter(
    name=CAM,
    number=8,
    board=CAM,
    places=(
        Place("cam", 100),
        Place("cam scheme", asks=(_SCHEME,)),
        Place("cam given", attends="cam"),
    ),
    sections=SECTIONS,
)
