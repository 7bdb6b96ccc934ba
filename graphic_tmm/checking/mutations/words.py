"""What mutations say: a sentence each on the very step, with the letters put in later.

Names in braces: ``it`` the mark that the step leaves, ``was`` and ``now`` the marks taken, ``times`` a factor,
``formula`` as it was calculated.
"""

from __future__ import annotations

from graphic_tmm.board.operations.instruments import lay_off, measure, measure_along
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Length, Line, Number, Point
from graphic_tmm.checking.mutations.mutation import OPERAND, SCALE, START
from graphic_tmm.language.said import said

CALCULATED = said("{it} was calculated with {now} instead of {was}")
MEASURED = said("{it} was measured to {now} instead of {was}")
TAKEN = said("for {it} {now} was taken instead of {was}")
BEGUN = said("{it} was drawn from {now} instead of {was}")
DIRECTED = said("{it} was drawn by the direction of {now} instead of {was}")
LAID = said("for {it} {now} was laid off instead of {was}")
BEFORE = said("{was} of the position before was taken for {it}")
LETTERS = said(
    "{it} was found from the other end: {was} and {now} were exchanged in the similarity"
)
MIRRORED = said("the figure similar to the link was built mirrored for {it}")
SENSE = said("{it} has the opposite sense")
WRONG_END = said("the normal component {it} points away from the centre of rotation")
SQUARE = said("{it} was drawn square to {was} instead of parallel")
PARALLEL = said("{it} was drawn parallel to {was} instead of square")
TURNED = said("{it} was turned by {times}°")
LEFT_OUT = said("{it} was left out")
MEETING = said("of two meetings the other one was marked for {it}")
FORMULA = said("{it} was calculated as {formula}")
LAID_TIMES = said("{was} was laid off {times} times as long for {it}")
FACTOR = said("{it} was taken {times} times as large")
USED_TIMES = said("{it} was calculated with {was} taken {times} times as large")
ANOTHER_SCALE = said("{it} was calculated with the scale factor {now} instead of {was}")
OTHER_WAY = said("the crank was turned the other way")
COUNTED = said("the crank's angles were counted from {times}° further on")
DIVIDED = said("the circle was divided into {times} parts")
STANDS = said("the crank stands amiss by {times}°")
OPPOSITE_GIVEN = said("{was}, which is given, was taken with the opposite sense")
OTHER_END = said("{was} was counted from the other end of {now}")
GIVEN_TIMES = said("{was}, which is given, was taken {times} times as large")
EXCHANGED_WITH = said("{was} and {now} were exchanged")


def operand(step: Step, k: int, *, scale: bool) -> tuple[str, str]:
    """Return the family and the sentence of another mark taken for the one that a step uses."""
    kind = step.uses[k].kind
    if scale:
        return SCALE, ANOTHER_SCALE
    if step.op.formula:
        return OPERAND, CALCULATED
    if step.op.name in (measure.name, measure_along.name):
        return OPERAND, MEASURED
    if kind is Point and k == 0 and step.it.kind is Line:
        return START, BEGUN
    if kind is Line and step.it.kind is Line:
        return OPERAND, DIRECTED
    if kind in (Length, Number) and step.op is lay_off:
        return OPERAND, LAID
    if kind is Line and step.op is lay_off:
        return START, BEGUN
    return OPERAND, TAKEN
