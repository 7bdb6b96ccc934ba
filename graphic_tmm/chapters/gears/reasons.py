"""Why a pair of gears is drawn as it is: the arguments of the book."""

from __future__ import annotations

from graphic_tmm.language.said import said

CENTRES = said("The centres of both wheels stand on this line, the distance of the axes apart.")
POLE = said(
    "The rolling circles touch in the pitch point, which divides the centre line in the ratio of the "
    "teeth."
)
CIRCLE = said("Circles of a wheel stand about its centre.")
LIMIT = said(
    "The common normal of involutes touches their base circle, and by the law of gearing it goes through "
    "the pitch point: so the line of action is this tangent."
)
ACTION = said("Both involutes touch one another on this line only.")
ENTERS = said(
    "A pair of teeth begins to touch where the tip circle of the driven wheel cuts the line of action."
)
LEAVES = said(
    "A pair of teeth ceases to touch where the tip circle of the driving wheel cuts the line of action."
)
APEX = said("A pointed tooth ends where its flanks meet, below the tip circle.")
MESH_ANGLE = said(
    "The line of action leans by the angle of mesh; read off, it checks the calculated one."
)
SPAN = said(
    "Pieces of the line of action tell where the teeth touch; the contact ratio and the sliding follow "
    "from them."
)
UNROLLED = said(
    "The thread from the limit point to here is wound back on the base circle: there the involute begins."
)
TANGENT = said("The thread leaves the base circle along the tangent, square to the radius.")
INVOLUTE_POINT = said(
    "The end of the thread, as long as the arc it has left, is a point of the involute."
)
INVOLUTE = said("Through the ends of the thread goes the involute: the flank of the tooth.")
TOOTH_AXIS = said(
    "Half of the tooth's thickness from the flank, on the pitch circle, lies its axis."
)
FILLET_POINT = said(
    "The rounding of the tool's tip cuts here, where its normal goes through the point of rolling."
)
FILLET = said("The points that the rounding of the tool cuts make the fillet.")
NEXT_PAIR = said("The next pair of teeth touches one base pitch farther along the line of action.")
TURNED_FLANK = said(
    "Turned by this angle the flank goes through the end of the working line: so it stands at the "
    "beginning and the end of the contact."
)
STATION = said("The place of contact on the line of action.")
SLIDING_AT = said("The ordinate shows how much the flanks slide where they touch here.")
ROLLED = said("The wheel rolls by equal steps: so much of the thread has come off by then.")
