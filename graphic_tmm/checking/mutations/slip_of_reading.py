"""What is told of a reading that was read or written down amiss, alone or beside a mistake."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.checking.cells import segment_text
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import Diagnosis
from graphic_tmm.checking.mutations.hypotheses import REPEATED, UNSURE
from graphic_tmm.checking.mutations.mistakes import digits_exchanged
from graphic_tmm.checking.records import SLIP, Judged, Likely
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import Said, said

SLIP_NAME = said("slip of a reading")
ONLY = said("only {segment} is off: {what}")
BY_ITSELF = said("by itself {segment} is off: {what}")
OR_BEFORE = said("{segment} is off, or what it is found from: no other reading tells which")
AMISS = said("this reading was read or written down amiss")
TENFOLD = said("its decimal point has perhaps slipped")
OPPOSITE = said("it bears the other sign")
DIGITS = said("two of its digits are perhaps exchanged")
AT_POSITION_OF = said("{segment} at position {position}")
NEAR = 0.05
"""So near (as a share) a reading is to what is due with its point, its sign or its digits otherwise."""


def slip_of(
    wrong: Sequence[Judged], diagnosis: Diagnosis, drawing: Comparison, speech: Speech
) -> Likely:
    """Return that a figure was read or written down amiss, or that it, or what it is found from, is off."""
    one = wrong[0]
    what, key = written_amiss(one), one.taken.key
    off = (*diagnosis.wrong, *diagnosis.doubtful)
    only = all(each.taken.key == key or each.follows is not None for each in off)
    segment, at = segment_text(one.taken.segment, speech.language), one.taken.position
    where = segment if not at else speech(AT_POSITION_OF, segment=segment, position=at)
    certain = what is TENFOLD or _only_read_amiss(one, diagnosis, drawing)
    sentence = (ONLY if only else BY_ITSELF) if certain else OR_BEFORE
    says = speech(sentence, segment=where, what=speech(what))
    lines = tuple(dict.fromkeys(each.taken.line for each in wrong))
    return Likely(
        speech(SLIP_NAME),
        says,
        lines,
        len(wrong),
        0.0,
        kind=SLIP,
        family="" if what is AMISS else "table",
        plan=one.taken.plan,
        segment=one.taken.segment,
        position=one.taken.position,
        step=one.step,
        chance=1.0 if certain else UNSURE,
    )


def _only_read_amiss(one: Judged, diagnosis: Diagnosis, drawing: Comparison) -> bool:
    """Whether fine readings, of other positions or found from it, say that a figure was only read amiss."""
    key, step = one.taken.key, drawing.step(one.taken)
    off = {each.taken.key for each in (*diagnosis.wrong, *diagnosis.doubtful)}
    fine = [taken for taken in drawing.rows if taken.key not in off]
    again = {taken.position for taken in fine if taken.key[:2] == key[:2]}
    if len(again) >= REPEATED:
        return True
    if step is None or drawing.made.mechanism is None:
        return False
    slots = {step.it.slot}
    for each in drawing.made.mechanism.construction.steps:
        if any(mark.slot in slots for mark in each.uses):
            slots.add(each.it.slot)
    here = [drawing.step(taken) for taken in fine if taken.position == one.taken.position]
    return any(each is not None and each.it.slot in slots for each in here)


def written_amiss(one: Judged) -> Said:
    """Return what is perhaps wrong with how a reading is written: its point, its sign, its digits."""
    if not one.due:
        return AMISS
    times = one.found / one.due
    if any(abs(abs(times) / ten - 1.0) < NEAR for ten in (10.0, 0.1, 100.0, 0.01)):
        return TENFOLD
    if one.taken.signed and abs(times + 1.0) < NEAR:
        return OPPOSITE
    swapped = any(abs(times * by - 1.0) < NEAR for by in digits_exchanged(one.found))
    return DIGITS if swapped else AMISS
