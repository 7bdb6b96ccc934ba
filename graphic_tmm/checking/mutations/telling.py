"""What is told of a diagnosis: names, sentences, where a mistake shows first."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.findings import step_number
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Construction, Mark, Step, segment_name
from graphic_tmm.checking.cells import segment_text, taken_figure
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import Diagnosis
from graphic_tmm.checking.mutations.evidence import Readings
from graphic_tmm.checking.mutations.execution import executed
from graphic_tmm.checking.mutations.explaining import explained
from graphic_tmm.checking.mutations.hypotheses import SURE, UNSURE, Hypothesis
from graphic_tmm.checking.mutations.mistakes import NONE
from graphic_tmm.checking.mutations.mutation import (
    CRANK,
    FACTOR,
    GIVEN,
    LEFT_OUT,
    SENSE,
    WRONG_END,
    Mutation,
    measured_last,
)
from graphic_tmm.checking.mutations.slip_of_reading import (
    AT_POSITION_OF,
    TENFOLD,
    slip_of,
    written_amiss,
)
from graphic_tmm.checking.mutations.tables import EMPTY, EVERYTHING, TIMES, WHERE_AT, Variation
from graphic_tmm.checking.mutations.words import BY_FAMILY, INSTRUMENT, TURNED, name_of
from graphic_tmm.checking.mutations.words import LEFT_OUT as LEFT_OUT_SAYS
from graphic_tmm.checking.mutations.words import LETTERS as LETTERS_SAYS
from graphic_tmm.checking.mutations.words import SENSE as SENSE_SAYS
from graphic_tmm.checking.mutations.words import WRONG_END as WRONG_END_SAYS
from graphic_tmm.checking.records import INSTRUMENT as OFF
from graphic_tmm.checking.records import MISTAKE, UNKNOWN, Judged, Likely, Taken
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import spoken
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.readers.sentences import letters_of
from graphic_tmm.scene.captions import view_name


def shown_at(one: Hypothesis, diagnosis: Diagnosis, drawing: Comparison) -> tuple[str, str]:
    """Return plan and segment of the first reading that shows a mistake, a wrong one if there is one.

    Of what was not read at all, and of nothing that was: the plan and the letter of its step.
    """
    what, readings = one.what, diagnosis.readings
    assert isinstance(what, Mutation)
    if what.family == CRANK:
        return "", ""  # the whole drawing stands otherwise
    wrong = {(each.taken.plan, each.taken.segment) for each in diagnosis.doubtful}
    board = drawing.made.boards[one.board]
    marks: list[tuple[str, str]] = []
    if readings is not None and drawing.made.mechanism is board:
        marks = _marks(board.construction, what, readings)
    found = [at for at in marks if at in wrong]
    if not found and readings is not None:
        found = [at for at in _columns(one, what, readings, drawing) if at in wrong]
    if found or marks:
        return (found or marks)[0]
    mark = what.at.it if what.at is not None else what.was
    return (mark.view, segment_name(mark.letter)) if mark is not None else ("", "")


def _marks(log: Construction, what: Mutation, readings: Readings) -> list[tuple[str, str]]:
    """Return the readings of marks that a mutation moves, nothing read being between; in the log's order."""
    read: dict[Mark, tuple[str, str]] = {
        mark: (taken.plan, taken.segment) for (mark, _), taken in readings.by_mark.items()
    }
    moved = {slot for slot in what.slots if slot not in {step.it.slot for step in log.steps}}
    found: list[tuple[str, str]] = []
    for step in log.steps:
        if step.it.slot in what.slots or any(mark.slot in moved for mark in step.uses):
            if step.it in read:
                found.append(read[step.it])
            else:
                moved.add(step.it.slot)
    return found


def _columns(
    one: Hypothesis, what: Mutation, readings: Readings, drawing: Comparison
) -> list[tuple[str, str]]:
    """Return the figures of tables that a mutation moves, in the order of the tables."""
    board = drawing.made.boards[one.board]
    log = measured_last(board.construction)
    beside = executed(log, board.given, (NONE, what), [step.it for step in log.steps])
    figures = readings.figures(board, beside, np.arange(2))
    found = []
    for each in readings.columns:
        row = figures.get(each.at)
        if row is not None and abs(abs(row[1]) - abs(row[0])) > 0.5 * max(each.scatter, 1e-9):
            found.append((each.taken.plan, each.taken.segment))
    order = {key[:2]: k for k, key in enumerate(drawing.due)}
    return sorted(dict.fromkeys(found), key=lambda at: order.get(at, 0))


ON_STEP = said("{plan}, step {step}: {told}")
AT_POSITION = said("{told}, at position {position} only")
EVERY = said("{told}, in every such step")
UNKNOWN_NAME = said("no known mistake")
UNKNOWN_SAYS = said("no known mistake explains what is wrong: look at {plan}, step {step}: {it}")
BEGIN_SAYS = said("no known mistake explains what is wrong: begin with {segment} ({plan})")
ABOUT = said("the readings of {where} are about {times} times as large as they should be")
HALF_A_TURN = 180.0
ROUGHLY = 0.1
"""By so large a share a factor that readings are told to have may be off; else their own is told."""
NOTHING = 0.05
"""What is taken so many times as large, or less, and read as 0, was left out."""
MOST = 3
"""So many mistakes at the most are told of those that no reading tells apart."""
MANY = 10
"""One of so many wrong readings of a segment may be a slip beside what explains the others."""
MUCH = 0.3
"""A mistake that explains one reading alone must be so likely, or it is a slip: many mistakes explain one."""


def likely_mistakes(diagnosis: Diagnosis, drawing: Comparison, language: str) -> tuple[Likely, ...]:
    """Return what is told of a diagnosis, the surest first."""
    speech = speaking(language)
    roots = list(diagnosis.left) or [one for one in diagnosis.wrong if one.follows is None]
    alone = len({one.taken.key for one in roots}) == 1
    sure = [row for row in diagnosis.named if row[1] >= SURE]
    likely = max((row[1] for row in diagnosis.named), default=0.0) >= MUCH
    only = alone and not likely and roots[0].taken.key not in diagnosis.followed
    ten = alone and written_amiss(roots[0]) is TENFOLD
    if alone and not sure and (only or ten):
        slip = slip_of(roots, diagnosis, drawing, speech)
        most = UNSURE if diagnosis.named and not ten else 1.0  # or a mistake, perhaps
        return (slip._replace(chance=min(slip.chance, most)),)
    found = [_named(group, chance, diagnosis, drawing, speech) for group, chance in diagnosis.named]
    if any(_contradicted(one, diagnosis) for one in found):
        lower = [one._replace(chance=min(one.chance, UNSURE)) for one in found]
        return (*lower, *_unknown(diagnosis, drawing, speech))
    whole = found and not diagnosis.left and (diagnosis.unknown is None or not sure)
    if whole or not diagnosis.wrong:
        return tuple(found)
    unknown = _unknown(diagnosis, drawing, speech)
    by_itself = alone and not (unknown and roots[0].taken.key in diagnosis.followed)
    told = (slip_of(roots, diagnosis, drawing, speech),) if by_itself else unknown
    return (*found, *told)


def _contradicted(one: Likely, diagnosis: Diagnosis) -> bool:
    """Whether a sure name leaves what it should explain: wrong readings of the segment that shows it."""

    def count(some: Sequence[Judged]) -> int:
        its = [(each.taken.plan, each.taken.segment) for each in some]
        return its.count((one.plan, one.segment))

    if one.kind != MISTAKE or one.position or one.chance < SURE:
        return False
    return MANY * count(diagnosis.left) > count(diagnosis.wrong)


def _named(
    group: Sequence[Hypothesis],
    sure: float,
    diagnosis: Diagnosis,
    drawing: Comparison,
    speech: Speech,
) -> Likely:
    wrong, lines = diagnosis.wrong, explained(group[0], diagnosis, drawing)
    zero = [one.found == 0.0 for one in wrong if one.taken.line in lines]
    if zero and all(zero):
        group = [one._replace(what=_left_out(one.what)) for one in group]
        group = [one for one in group if one.what.says == LEFT_OUT_SAYS] or group
    group = _once_each(group, drawing)
    says = list(dict.fromkeys(_says(one, drawing, speech) for one in group))
    first = group[0]
    what = first.what
    found = Likely("", says[0], lines, len(wrong), 0.0, tuple(says[1:MOST]), chance=sure)
    if isinstance(what, Variation):
        return found._replace(
            name=speech(INSTRUMENT if what.kind == OFF else BY_FAMILY[what.family]),
            kind=what.kind,
            family=what.family,
            plan=what.plan,
            segment=what.segment,
            position=what.position,
        )
    mark = what.at.it if what.at is not None else what.was
    plan, segment = shown_at(first, diagnosis, drawing)
    return found._replace(
        name=speech(name_of(what)),
        family=what.family,
        plan=plan,
        segment=segment,
        position=drawing.names[first.place] if first.place is not None else "",
        step=mark.letter if mark is not None and plan else "",
        view=mark.view if mark is not None and plan else "",
    )


def _once_each(group: Sequence[Hypothesis], drawing: Comparison) -> list[Hypothesis]:
    """Return hypotheses that no reading tells apart without those that tell the very same once more.

    Who draws a vector back reverses its length, the line that it is laid off on, the point at its end. A crank
    that stands amiss in one position was counted there in whatever way; who exchanges a and b, A and B.
    """
    kept: list[Hypothesis] = []
    seen: list[Step] = []
    meanings = set[object]()
    for one in group:
        if (meaning := _meaning(one)) in meanings:
            continue
        meanings.add(meaning)
        step = _reversed_at(one)
        steps = drawing.made.boards[one.board].construction.steps if step is not None else ()
        if step is not None and any(_together(step, other, steps) for other in seen):
            continue
        kept.append(one)
        seen += [] if step is None else [step]
    return kept


def _meaning(one: Hypothesis) -> object:
    """Return what is the same of hypotheses that mean the same."""
    what = one.what
    if isinstance(what, Variation):
        return id(what)
    if what.family == CRANK and one.place is not None:
        return CRANK, one.place
    at = what.at.it if what.at is not None else None
    if what.says == LETTERS_SAYS:
        return LETTERS_SAYS, at, one.place
    return what.says, at, what.was, what.now, what.times, what.formula, one.place


def _reversed_at(one: Hypothesis) -> Step | None:
    """Return the step whose result is reversed; None where none is."""
    what = one.what
    if isinstance(what, Variation) or what.at is None:
        return None
    back = what.family in (SENSE, WRONG_END) or (what.says == TURNED and what.times == HALF_A_TURN)
    return what.at if back else None


def _together(one: Step, other: Step, steps: Sequence[Step]) -> bool:
    """Whether two steps are of one vector: of its length, its line, its end."""
    laid = (step for step in steps if step.op is lay_off)
    return any({one.it, other.it} <= {step.it, *step.uses} for step in laid)


def _left_out(what: Mutation | Variation) -> Mutation | Variation:
    """Return what makes next to nothing of a quantity as that which leaves it out."""
    if isinstance(what, Variation):
        times = what.told.get("times")
        some = isinstance(times, float) and abs(times) <= NOTHING
        return what._replace(says=EMPTY) if some else what
    if what.family not in (FACTOR, GIVEN) or abs(what.times) > NOTHING:
        return what
    return what._replace(family=LEFT_OUT, says=LEFT_OUT_SAYS)


def _says(one: Hypothesis, drawing: Comparison, speech: Speech) -> str:
    """Return the sentence of a hypothesis."""
    what, language = one.what, speech.language
    if isinstance(what, Variation):
        words = {k: _word(v, speech) for k, v in what.told.items()}
        plan = view_name(what.plan, language) if what.plan else speech(EVERYTHING)
        where = f"{plan}: {what.segment}" if what.segment else plan
        if "position" in words:
            where = speech(WHERE_AT, where=where, position=words["position"])
        says, words["where"] = what.says, where
        if says == TIMES and (times := _times(what, drawing)):
            says, words["times"] = ABOUT, number(times, language, 2)
        return speech(says, **words)
    log = drawing.made.boards[one.board].construction
    sentence = _sentence(what, language, speech)
    if what.at is not None:
        sentence = speech(
            ON_STEP,
            plan=title_of(drawing.made.boards[one.board].project, what.at.it.view, language),
            step=_number(log, what.at),
            told=sentence,
        )
    if what.wide:
        sentence = speech(EVERY, told=sentence)
    if one.place is not None and drawing.made.mechanism is not None:
        position = drawing.made.mechanism.names[one.place]
        sentence = speech(AT_POSITION, told=sentence, position=position)
    return sentence


def _times(what: Variation, drawing: Comparison) -> float:
    """Return how many times as large the readings of a place are, if it is not what is told; else 0."""
    ratios = [
        abs(figure / due)
        for one, factor in zip(drawing.rows, what.factor, strict=True)
        if factor != 1.0
        for figure, due in _figures(one, drawing)
        if due
    ]
    median, told = float(np.median(ratios)) if ratios else 0.0, what.told.get("times")
    right = isinstance(told, float) and abs(median / told - 1.0) < ROUGHLY
    return 0.0 if right else median


def _figures(one: Taken, drawing: Comparison) -> Iterator[tuple[float, float]]:
    """Yield a reading and what is due, in mm or its unit; nothing of a point or of what is not due."""
    cell = drawing.due.get(one.key)
    due = cell and (cell.mm if one.mm is not None else cell.value)
    if cell is not None and due is not None and not one.pointed:
        yield taken_figure(one, cell), due


def _number(log: Construction, step: Step) -> int:
    """Return the number of a step by the mark that it makes: what it does may be told otherwise here."""
    return step_number(log, next(own for own in log.steps if own.it == step.it))


def _word(value: object, speech: Speech) -> str:
    if isinstance(value, (int, float)):
        return number(float(value), speech.language)
    return speech(str(value)) if isinstance(value, str) else str(value)


def _sentence(what: Mutation, language: str, speech: Speech) -> str:
    words = {"times": number(what.times, language), "was": "", "now": "", "it": "", "formula": ""}
    for name, mark in (("was", what.was), ("now", what.now), ("it", what.was)):
        if mark is not None:
            words[name] = _called(mark, language)
    if what.at is not None:
        words["it"] = _called(what.at.it, language)
        if what.formula:
            letters = letters_of(what.at, lambda mark: _called(mark, language))
            words["formula"] = what.formula.format(**letters)
    normal = what.says == SENSE_SAYS and what.at is not None and what.at.op.name == "normal"
    return speech(WRONG_END_SAYS if normal else what.says, **words)


def _called(mark: Mark, language: str) -> str:
    return spoken(mark, language) or view_name(mark.view, language)


def _unknown(diagnosis: Diagnosis, drawing: Comparison, speech: Speech) -> tuple[Likely, ...]:
    """Return where to look first: the first step that is wrong; of figures of tables the first one."""
    step, language = _first_wrong(diagnosis, drawing), speech.language
    name, count = speech(UNKNOWN_NAME), len(diagnosis.wrong)
    if step is None or drawing.made.mechanism is None:
        own = [one for one in diagnosis.wrong if one.follows is None]
        first = (diagnosis.left or own or diagnosis.wrong)[0]
        plan, segment, at = first.taken.key
        of = segment_text(segment, language)
        of = speech(AT_POSITION_OF, segment=of, position=at) if at else of
        says = speech(BEGIN_SAYS, segment=of, plan=view_name(plan, language))
        found = Likely(name, says, (), count, 1.0, kind=UNKNOWN, plan=plan)
        return (found._replace(segment=segment, step=first.step),)
    says = speech(
        UNKNOWN_SAYS,
        plan=title_of(drawing.made.mechanism.project, step.it.view, language),
        step=_number(drawing.made.mechanism.construction, step),
        it=_called(step.it, language),
    )
    found = Likely(name, says, (), count, 1.0, kind=UNKNOWN, plan=step.it.view, step=step.it.letter)
    return (found._replace(segment=segment_name(step.it.letter)),)


def _first_wrong(diagnosis: Diagnosis, drawing: Comparison) -> Step | None:
    """Return the step of the first wrong reading, as the log draws them: later ones may follow from it."""
    if diagnosis.unknown is None or drawing.made.mechanism is None:
        return diagnosis.unknown
    own = diagnosis.left or [one for one in diagnosis.wrong if one.follows is None]
    slots = {step.it.slot for one in own if (step := drawing.step(one.taken)) is not None}
    log = drawing.made.mechanism.construction
    return next((step for step in log.steps if step.it.slot in slots), diagnosis.unknown)
