"""What mutations say, a sentence each on the very step; and what they are called.

In sentences letters are put in later, by names in braces: ``it`` the mark that the step leaves, ``was`` and
``now`` the marks taken, ``times`` a factor, ``formula`` as it was calculated. Usual mistakes are called as
teachers call them, by family and operation; the others by their family.
"""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.board.operations.instruments import lay_off, measure, measure_along
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Length, Line, Number, Point
from graphic_tmm.checking.mutations import mutation
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.language.said import Said, said

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
ON_PAPER = said("{it} was calculated with lengths as they are on the paper, without {was}")
ANOTHER_SCALE = said("{it} was calculated with the scale factor {now} instead of {was}")
ANOTHER_ZERO = said("{it} was counted from another zero: from where it is {times} positions later")
OF_SUM = {
    mutation.LEFT_OUT: said("{was} was left out of {it}"),
    mutation.SENSE: said("{was} was taken with the opposite sense in {it}"),
}
UPSIDE_DOWN = said("{it} was found by the ratio upside down")
AS_FAR = said("{it} was found {times} times as far off")
OPENED = said("{was} was taken {times} times as long for the opening of the arc {it}")
AS_LONG = said("{it} is {times} times as long as it should be")
OTHER_WAY = said("the crank was turned the other way")
COUNTED = said("the crank's angles were counted from {times}° further on")
DIVIDED = said("the circle was divided into {times} parts")
STANDS = said("the crank stands amiss by {times}°")
OPPOSITE_GIVEN = said("{was}, which is given, was taken with the opposite sense")
NO_GIVEN = said("{was}, which is given, was left out")
OTHER_END = said("{was} was counted from the other end of {now}")
GIVEN_TIMES = said("{was}, which is given, was taken {times} times as large")
EXCHANGED_WITH = said("{was} and {now} were exchanged")
ANOTHER_PLACE = said("{was} was laid in another of its places")
DIRECTIONS = said("the directions of {was} and {now} were exchanged")


def operand(step: Step, k: int, *, scale: bool) -> tuple[str, str]:
    """Return the family and the sentence of another mark taken for the one that a step uses."""
    kind = step.uses[k].kind
    if scale:
        return mutation.SCALE, ANOTHER_SCALE
    if step.op.formula:
        return mutation.OPERAND, CALCULATED
    if step.op.name in (measure.name, measure_along.name):
        return mutation.OPERAND, MEASURED
    if kind is Point and k == 0 and step.it.kind is Line:
        return mutation.START, BEGUN
    if kind is Line and step.it.kind is Line:
        return mutation.OPERAND, DIRECTED
    if kind in (Length, Number) and step.op is lay_off:
        return mutation.OPERAND, LAID
    if kind is Line and step.op is lay_off:
        return mutation.START, BEGUN
    return mutation.OPERAND, TAKEN


BY_OPERATION: dict[tuple[str, str], Said] = {
    (mutation.LEFT_OUT, "coriolis"): said("Coriolis left out"),
    (mutation.FACTOR, "coriolis"): said("Coriolis by another factor"),
    (mutation.SENSE, "coriolis"): said("Coriolis turned"),
    (mutation.OPERAND, "normal"): said("normal of another link or velocity"),
    (mutation.POWER, "normal"): said("v/l for v²/l"),
    (mutation.LEFT_OUT, "normal"): said("normal left out"),
    (mutation.POWER, "product"): said("ω/r for ω·r"),
    (mutation.POWER, "rate"): said("v/l inverted"),
    (mutation.POWER, "rate_turned"): said("v/l inverted"),
    (mutation.POWER, "product_of_squares"): said("ω²·r by another power"),
    (mutation.LEFT_OUT, "weight"): said("a weight left out"),
    (mutation.LEFT_OUT, "inertia_force"): said("inertia left out"),
    (mutation.LEFT_OUT, "inertia_couple"): said("inertia left out"),
    (mutation.OPERAND, "measure"): said("another segment"),
    (mutation.OPERAND, "measure_along"): said("another segment"),
    (mutation.OPERAND, "similar"): said("another letter in the similarity"),
    (mutation.OPERAND, "arm"): said("another arm"),
    (mutation.SENSE, "moment"): said("sense of a moment reversed"),
    (mutation.LEFT_OUT, "moment"): said("a moment left out"),
    (mutation.LEFT_OUT, "on_lever"): said("a moment left out"),
    (mutation.LEFT_OUT, "added"): said("something left out of a sum"),
    (mutation.FACTOR, "similar"): said("another ratio"),
    (mutation.DIRECTION, "carry"): said("the plan of the lever turned otherwise"),
}
INERTIA = said("inertia not reversed")
BY_FAMILY: dict[str, Said] = {
    mutation.OPERAND: said("another quantity taken"),
    mutation.PREVIOUS: said("taken from the position before"),
    mutation.FACTOR: said("a factor lost or doubled"),
    mutation.POWER: said("another formula"),
    mutation.LEFT_OUT: said("something left out"),
    mutation.DIRECTION: said("parallel for square"),
    mutation.SENSE: said("sense reversed"),
    mutation.WRONG_END: said("normal from the wrong end"),
    mutation.MEETING: said("other assembly"),
    mutation.MIRRORED: said("mirrored similarity"),
    mutation.START: said("drawn from another point"),
    mutation.SCALE: said("another scale factor"),
    mutation.EXCHANGED: said("links exchanged"),
    mutation.CRANK: said("crank turned or counted otherwise"),
    mutation.GIVEN: said("a given misread"),
    mutation.TABLE: said("table written down otherwise"),
}
INSTRUMENT = said("an instrument is off")
POWERS_OF_TEN = said("decimal point slipped")
TURNS = said("rpm for rad/s")
DEGREES = said("degrees for radians")


def usual(one: Mutation) -> bool:
    """Whether a mutation has a name of its own."""
    return one.at is not None and (one.family, one.at.op.name) in BY_OPERATION


def name_of(one: Mutation) -> Said:
    """Return what a mutation is called."""
    if one.at is not None:
        if one.family == mutation.SENSE and one.at.it.role == roles.INERTIA:
            return INERTIA
        if (found := BY_OPERATION.get((one.family, one.at.op.name))) and not _ten(one.times):
            return found
    if one.family == mutation.FACTOR:
        return _factor(one)
    return BY_FAMILY[one.family]


def _ten(times: float) -> bool:
    return times in (10.0, 0.1, 100.0, 0.01, 1000.0, 0.001)


def _factor(one: Mutation) -> Said:
    if _ten(one.times):
        return POWERS_OF_TEN
    unit = one.was.unit if one.was is not None else one.at.it.unit if one.at is not None else ""
    if unit == "1/s" and 9.0 < max(one.times, 1.0 / (one.times or 1.0)) < 10.0:
        return TURNS
    if 57.0 < max(one.times, 1.0 / (one.times or 1.0)) < 58.0:
        return DEGREES
    return BY_FAMILY[mutation.FACTOR]
