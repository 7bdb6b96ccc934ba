"""What is told of a reading that was read or written down amiss, alone or beside a mistake."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.checking.cells import segment_text
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import Diagnosis
from graphic_tmm.checking.mutations.hypotheses import REPEATED, UNSURE
from graphic_tmm.checking.records import SLIP, Judged, Likely
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said

SLIP_NAME = said("slip of a reading")
SLIP_SAYS = said("only {segment} is off: this reading was read or written down amiss")
SLIP_TEN = said("only {segment} is off: its decimal point has perhaps slipped")
SLIP_BESIDE = said("by itself {segment} is off: this reading was read or written down amiss")
SLIP_OR_BEFORE = said("{segment} is off, or what it is found from: no other reading tells which")
SLIP_TEN_BESIDE = said("by itself {segment} is off: its decimal point has perhaps slipped")
AT_POSITION_OF = said("{segment} at position {position}")
TENFOLD = 0.05
"""So near (as a share) to ten or a hundred times too much a reading is perhaps a slipped decimal point."""


def slip_of(
    wrong: Sequence[Judged], diagnosis: Diagnosis, drawing: Comparison, speech: Speech
) -> Likely:
    """Return that a figure was read or written down amiss, or that it, or what it is found from, is off."""
    one = wrong[0]
    ten, key = tenfold(one), one.taken.key
    off = (*diagnosis.wrong, *diagnosis.doubtful)
    only = all(each.taken.key == key or each.follows is not None for each in off)
    alone, beside = (SLIP_TEN, SLIP_TEN_BESIDE) if ten else (SLIP_SAYS, SLIP_BESIDE)
    segment, at = segment_text(one.taken.segment, speech.language), one.taken.position
    where = segment if not at else speech(AT_POSITION_OF, segment=segment, position=at)
    certain = ten or _only_read_amiss(one, diagnosis, drawing)
    sentence = (alone if only else beside) if certain else SLIP_OR_BEFORE
    says = speech(sentence, segment=where)
    lines = tuple(dict.fromkeys(each.taken.line for each in wrong))
    return Likely(
        speech(SLIP_NAME),
        says,
        lines,
        len(wrong),
        0.0,
        kind=SLIP,
        family="table" if ten else "",
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


def tenfold(one: Judged) -> bool:
    """Whether a reading is ten or a hundred times too large or too small."""
    times = abs(one.found / one.due) if one.due else 1.0
    return any(abs(times / ten - 1.0) < TENFOLD for ten in (10.0, 0.1, 100.0, 0.01))
