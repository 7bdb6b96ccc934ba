"""What mistakes are called: usual ones by the names that teachers have for them, the others by their family.

A mutation is known by its family and by its operation, by the role of what it leaves, or by what is taken.
"""

from __future__ import annotations

from graphic_tmm.checking.mutations.mutation import (
    CRANK,
    DIRECTION,
    EXCHANGED,
    FACTOR,
    GIVEN,
    LEFT_OUT,
    MEETING,
    MIRRORED,
    OPERAND,
    POWER,
    PREVIOUS,
    SCALE,
    SENSE,
    START,
    TABLE,
    WRONG_END,
    Mutation,
)
from graphic_tmm.language.said import Said, said

BY_OPERATION: dict[tuple[str, str], Said] = {
    (LEFT_OUT, "coriolis"): said("Coriolis left out"),
    (FACTOR, "coriolis"): said("Coriolis by another factor"),
    (SENSE, "coriolis"): said("Coriolis turned"),
    (OPERAND, "normal"): said("normal of another link or velocity"),
    (POWER, "normal"): said("v/l for v²/l"),
    (LEFT_OUT, "normal"): said("normal left out"),
    (POWER, "product"): said("ω/r for ω·r"),
    (POWER, "rate"): said("v/l inverted"),
    (POWER, "rate_turned"): said("v/l inverted"),
    (POWER, "product_of_squares"): said("ω²·r by another power"),
    (LEFT_OUT, "weight"): said("a weight left out"),
    (LEFT_OUT, "inertia_force"): said("inertia left out"),
    (LEFT_OUT, "inertia_couple"): said("inertia left out"),
    (OPERAND, "measure"): said("another segment"),
    (OPERAND, "measure_along"): said("another segment"),
    (OPERAND, "similar"): said("another letter in the similarity"),
    (OPERAND, "arm"): said("another arm"),
    (SENSE, "moment"): said("sense of a moment reversed"),
}
INERTIA = said("inertia not reversed")
BY_FAMILY: dict[str, Said] = {
    OPERAND: said("another quantity taken"),
    PREVIOUS: said("taken from the position before"),
    FACTOR: said("a factor lost or doubled"),
    POWER: said("another formula"),
    LEFT_OUT: said("something left out"),
    DIRECTION: said("parallel for square"),
    SENSE: said("sense reversed"),
    WRONG_END: said("normal from the wrong end"),
    MEETING: said("other assembly"),
    MIRRORED: said("mirrored similarity"),
    START: said("drawn from another point"),
    SCALE: said("another scale factor"),
    EXCHANGED: said("links exchanged"),
    CRANK: said("crank turned or counted otherwise"),
    GIVEN: said("a given misread"),
    TABLE: said("table written down otherwise"),
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
        if one.family == SENSE and one.at.it.role == "inertia":
            return INERTIA
        if (found := BY_OPERATION.get((one.family, one.at.op.name))) and not _ten(one.times):
            return found
    if one.family == FACTOR:
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
    return BY_FAMILY[FACTOR]
