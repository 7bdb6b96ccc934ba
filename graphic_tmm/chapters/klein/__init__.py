"""Klein's construction and Ritterhaus's: velocities and accelerations of a slider-crank on its own figure.

The crank OA turns; the rod AB moves the slider B along a guide. The rod is produced to M on the
normal to the guide through O. The triangle OAM is the plan of velocities turned by 90°, with v_A drawn as
long as the crank: v_B = ω·OM·μ_l, v_BA = ω·AM·μ_l. So ω is the only number that is needed.

Klein: the circle about A with the radius AM and the circle on AB as diameter have a common chord, which is
square to AB and meets it in Q and the line through O along the guide in N. In the right-angled triangle
over AB AM² = AQ·AB, hence ω²·AQ·μ_l = v_BA²/l_AB is the normal acceleration, and the quadrilateral OAQN is
the plan of accelerations turned by 180°: a_A = ω²·OA·μ_l, a_BA^t = ω²·QN·μ_l, a_B = ω²·ON·μ_l. The guide
need not go through O: then N lies on the parallel to it. These drawings hold of a crank that turns evenly.

A crank that gains speed gives its pin ε·OA besides, square to the crank. To the scale ω²·μ_l it is AA′ =
OA·ε/ω², laid off at A against the sense of ε, for all is turned by 180°. Behind it AQ is laid off parallel to
the rod, to Q′; the square to the rod through Q′ meets the line through O along the guide in N. The pentagon
OAA′Q′N is the plan of accelerations: a_A = ω²·OA′·μ_l, a_BA^t = ω²·Q′N·μ_l, a_B = ω²·ON·μ_l. M and Q hang on
velocities alone and stay; points of the rod lie on A′N. Where ω and ε are listed by positions each position
has its own scale factors.

Ritterhaus finds the same Q without the compass: the parallel to BO (in line with O: to the guide) through M
meets the crank in R; the parallel to OM through R meets the rod in Q, for AR : AO = AM : AB and AQ : AM =
AR : AO. From there on both go alike.

Points of the rod lie on AM and on AN as they lie on AB.

Where crank and rod fall into one line, the lines of Ritterhaus do too and do not meet; Klein's circles do.
Where the crank is square to the guide, M falls on A, both constructions give Q there. Where the rod is
square to the guide the slider has no finite velocity, and neither has a point M. In a slider-crank that
does not turn fully AM may be longer than AB: then Klein's circles do not meet, and Ritterhaus's lines do.

Draws: places ``klein`` (the constructions by positions) and ``klein table``. Builds on the plan of
positions; where there are plans of velocities and accelerations, both are held against them.

Sources: Артоболевский И. И., Теория механизмов и машин (построение Клейна); Bevan T., The Theory of
Machines (Klein's construction, Ritterhaus's construction).
"""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, KINEMATICS, VELOCITIES
from graphic_tmm.chapters.klein.task import KLEIN, SECTIONS, TABLE
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=KLEIN,
    number=24,
    builds_on=(KINEMATICS,),
    places=(
        Place(KLEIN, 25, beside=(VELOCITIES, ACCELERATIONS)),
        Place(TABLE, shows=(KLEIN,), attends=KLEIN),
    ),
    sections=SECTIONS,
)
