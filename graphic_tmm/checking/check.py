"""A check from readings to a report: what they name, a drawing judged by the hand, mistakes looked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import RESULTS, Cell, Key, cells, points, taken_figure
from graphic_tmm.checking.congruence.congruence import Agreed, Congruence
from graphic_tmm.checking.congruence.stated import (
    Stated,
    is_scale_row,
    stated_by,
    stated_in,
    turns_by,
)
from graphic_tmm.checking.congruence.supposed import MERE
from graphic_tmm.checking.congruence.words import head
from graphic_tmm.checking.judging.choices import chosen_otherwise
from graphic_tmm.checking.judging.comparison import Comparison, worse_of
from graphic_tmm.checking.judging.groups import groups
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.residuals import sharpened
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardstick, Yardsticks
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.mutations.diagnosis import Diagnosis, diagnosed
from graphic_tmm.checking.mutations.hypotheses import FITTED
from graphic_tmm.checking.mutations.mistaken_scene import mistaken_scenes
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.checking.mutations.rescaled import rescaled
from graphic_tmm.checking.mutations.scaling import Scaling
from graphic_tmm.checking.mutations.telling import likely_mistakes
from graphic_tmm.checking.mutations.unseen import Unseen, told_unseen
from graphic_tmm.checking.readings.letters import letter_near
from graphic_tmm.checking.readings.mending import mended
from graphic_tmm.checking.readings.read import TOLD, with_words_of
from graphic_tmm.checking.readings.signs import with_signs
from graphic_tmm.checking.records import (
    INSTRUMENT,
    MISTAKE,
    WRONG,
    Judged,
    Likely,
    Report,
    Taken,
    Whole,
)
from graphic_tmm.checking.report.findings import sure
from graphic_tmm.checking.report.rows import WORDS
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make


def known_readings(
    made: DrawnScene, readings: Sequence[Taken], source: str
) -> tuple[tuple[Taken, ...], tuple[str, ...]]:
    """Return the readings whose figures are known, by the names of the scene, and notes.

    Of names that were typed otherwise what is meant is told, and each reading whose figure is not known.

    Raises
    ------
    SceneError
        If readings name what the scene does not have; the first 20 of them at once.
    """
    due, spots = cells(made), points(made)
    rows = [part for taken in readings for part in taken.parts()]
    beside = with_words_of(readings, readings)
    named, told, unclear = mended(made, rows, due, spots, beside.letters)
    speech = speaking(made.scene.language)
    faults, notes = list(unclear), dict.fromkeys((*map(speech, beside.notes), *told))
    doubted = {fault.line for fault in unclear}
    kept = []
    for taken in named:
        if _lost(taken, due):
            words = WORDS[made.scene.language]["not sure"]
            place = f" ({taken.position})" if taken.position else ""
            notes[words.format(line=taken.line, segment=f"{taken.segment}{place}")] = None
            continue
        there = taken.line in doubted or (taken.pointed and taken.key in spots)
        if says := "" if there else _unknown(taken, due):
            there_is = letter_near(taken, spots)
            faults.append(Fault("", taken.line, there_is or says))
        kept.append(taken)
    if faults:
        raise SceneError(source, tuple(faults[:TOLD]))
    return with_signs(kept), tuple(notes)


def _lost(taken: Taken, due: Mapping[Key, Cell]) -> bool:
    """Whether a figure is null though its plan is drawn at that position, and it is there at others."""
    plan, segment, position = taken.key
    if taken.pointed:
        return False
    if _figure(due.get(taken.key), taken) is not None:
        return False
    if plan == RESULTS:
        return taken.key in due and taken.mm is None
    here = any((p, n) == (plan, position) for p, _, n in due)
    there = (_figure(cell, taken) for (p, s, _), cell in due.items() if (p, s) == (plan, segment))
    return here and any(figure is not None for figure in there)


def _figure(cell: Cell | None, taken: Taken) -> float | None:
    if cell is None:
        return None
    return cell.mm if taken.mm is not None else cell.value


def _unknown(taken: Taken, due: Mapping[Key, Cell]) -> str:
    """Return what is wrong with the name of a reading; empty if nothing."""
    plan, segment, position = taken.key
    if taken.key in due:
        cell = due[taken.key]
        if taken.mm is not None and cell.mm is None:
            return said("{segment} is not drawn in mm; give its value and unit", segment=segment)
        if taken.pointed:
            return said(
                "points are compared on plans of positions, velocities and accelerations, not "
                "{segment}",
                segment=segment,
            )
        try:
            taken_figure(taken, cell)
        except ValueError as error:
            return error.args[0]  # type: ignore[no-any-return]
        return ""
    there = sorted({plan for plan, _, _ in due})
    if plan not in there:
        return said(
            'there is no plan "{plan}"; there are {known}', plan=plan[:30], known=", ".join(there)
        )
    segments = sorted({s for p, s, _ in due if p == plan})
    if segment not in segments:
        return said(
            'plan {plan} has no segment "{segment}"; it has {known}',
            plan=plan,
            segment=segment[:30],
            known=", ".join(segments),
        )
    places = [n for p, s, n in due if (p, s) == (plan, segment)]
    return said(
        '{segment} has no figure at position "{position}"; it has some at {known}',
        segment=segment,
        position=position[:20],
        known=", ".join(places),
    )


TRIALS = 400
"""How often the hand draws to tell how far it scatters. A standard deviation is then known to 3.5 % of itself,
1/√800."""


class Checked(NamedTuple):
    """A report, and what its verdicts were found by: the readings beside the scene and the hand's drawings."""

    report: Report
    compared: Comparison


class Bench(NamedTuple):
    """A scene drawn exactly, in its own scale factors or a drawing's, with all that drawings are judged by."""

    made: DrawnScene
    mistakes: Mistakes
    teacher: Teacher
    yardsticks: Yardsticks
    unseen: Unseen


class _Judgement(NamedTuple):
    """Readings as the scene knows them, what is told of that, by what they were judged, and their verdicts."""

    agreed: Agreed
    notes: tuple[str, ...]
    bench: Bench
    by: Yardstick
    verdicts: tuple[Judged, ...]
    whole: Whole | None

    @property
    def wrong(self) -> int:
        """How many readings are wrong."""
        return sum(one.verdict == WRONG for one in self.verdicts)


class _Explained(NamedTuple):
    """A drawing as it was judged, and what happened to it."""

    judged: _Judgement
    compared: Comparison
    small: Sequence[Likely]
    diagnosis: Diagnosis

    @property
    def score(self) -> float:
        """How likely its readings are, by these scale factors and with what happened (logarithm)."""
        fitted = sum(one.by in MERE for one in self.judged.agreed.scales)
        return self.diagnosis.score - FITTED * fitted if self.diagnosis.wrong else np.inf


CLEAR = 8.0
"""By so much more likely (natural logarithm) readings must be in other scale factors than were decided."""
KEPT = 4
"""So many scale factors of drawings are kept with all that these are judged by; a class has a few more."""


class Checker:
    """A scene drawn exactly, with all that its drawings are checked by: the hand draws once for them.

    A drawing in scale factors of its own is judged by the scene drawn again in these.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        hand: str = "student",
        points: str = "paper",
        trials: int = TRIALS,
        limits: Limits = Limits(),  # noqa: B008
        given: Composition | None = None,
        scales: Sequence[str] = (),
        turns: Sequence[str] = (),
    ) -> None:
        """Draw a scene; for the rest see `check`."""
        self.scene, self._hand = scene, HANDS[hand]._replace(trials=trials, seed=scene.seed)
        self.hand, self._limits, self._points = hand, limits, points
        self.made = make(scene, exact=True, given=given)
        self._congruence = Congruence(self.made)
        self._scales, self._turns = tuple(scales), tuple(turns)
        self._due = self._bench_of(self.made)
        self._benches: dict[tuple[object, ...], Bench] = {}

    def _bench_of(self, made: DrawnScene) -> Bench:
        mistakes = Mistakes(made)
        yardsticks = Yardsticks(made, self._hand, self._limits, self._points)
        return Bench(made, mistakes, Teacher(made), yardsticks, Unseen(mistakes))

    def _bench(self, agreed: Agreed) -> Bench:
        """Return what a drawing is judged by: the scene in its scale factors; of the last few it is kept."""
        if not agreed.times and not agreed.places:
            return self._due
        own = {group: tuple(places.items()) for group, places in agreed.places.items()}
        key = (*sorted(agreed.times.items()), *sorted(own.items()))
        if key not in self._benches:
            if len(self._benches) >= KEPT:
                self._benches.pop(next(iter(self._benches)))
            made = self._congruence.remaking.of(agreed.times, agreed.places)
            self._benches[key] = self._bench_of(made)
        return self._benches[key]

    def verdicts(
        self, readings: Sequence[Taken], source: str = "readings"
    ) -> tuple[tuple[Judged, ...], Whole | None]:
        """Return the verdicts on a drawing and its readings, and look for no mistake; raises as `check`."""
        found = self._judged(readings, source)
        return found.verdicts, found.whole

    def _judged(self, readings: Sequence[Taken], source: str) -> _Judgement:
        stated = self._stated([one for one in readings if is_scale_row(one)], source)
        others = with_words_of(readings, [one for one in readings if not is_scale_row(one)])
        rows, notes = known_readings(self.made, others, source)
        plans = tuple(dict.fromkeys(plan for plan, _, _ in self._congruence.due))
        turns = turns_by(self._turns, plans, source) if self._turns else {}
        return self._judgement(self._congruence.of(rows, stated, turns), notes)

    def _judgement(self, agreed: Agreed, notes: tuple[str, ...]) -> _Judgement:
        bench = self._bench(agreed)
        rows, chosen = chosen_otherwise(bench.made, agreed.rows)
        agreed, notes = agreed._replace(rows=rows), (*notes, *chosen)
        by = bench.yardsticks.of(agreed.rows)
        verdicts, whole = sharpened(bench.made, judge(bench.made, agreed.rows, by), by)
        return _Judgement(agreed, notes, bench, by, verdicts, whole)

    def _explained(self, one: _Judgement) -> _Explained:
        """Return what happened to a drawing as it was judged."""
        parts = [part for taken in one.agreed.rows for part in taken.parts()]
        worse = worse_of([each.times for each in one.verdicts])
        compared = Comparison(one.bench.made, parts, one.by, worse)
        small = groups(one.bench.made, one.verdicts, one.by)
        rare, scaling = bool(small or one.whole), Scaling.of(one.agreed.scales)
        found = diagnosed(one.bench.mistakes, compared, one.verdicts, rare=rare, scaling=scaling)
        return _Explained(one, compared, small, found)

    def _likeliest(self, first: _Explained) -> _Explained:
        """Return what happened, by other scale factors where these, with a mistake, explain readings better."""
        best = first
        if not best.diagnosis.certain and first.judged.agreed.others:
            every = (self._judgement(one, first.judged.notes) for one in first.judged.agreed.others)
            fewest = min(every, key=lambda one: one.wrong)
            if fewest.wrong < first.judged.wrong:
                other = self._explained(fewest)
                best = other if other.score > best.score + CLEAR else best
        readings, agreed = best.diagnosis.readings, best.judged.agreed
        free = first.judged.agreed.free - {*agreed.times}
        if best.diagnosis.certain or readings is None or not free:
            return best
        drawn = {at: one.of for at, one in self._congruence.groups.items() if one in free}
        k = rescaled(readings, best.judged.bench.mistakes.boards[0], drawn)
        if k:
            times = {group: k[group.of] for group in free if group.of in k}
            supposed = self._congruence.supposing(agreed, times)
            other = self._explained(self._judgement(supposed, first.judged.notes))
            best = other if other.score > best.score + CLEAR else best
        return best

    def _stated(self, rows: Sequence[Taken], source: str) -> list[Stated]:
        """Return the scale factors that rows and options state; options go before rows."""
        if not rows and not self._scales:
            return []
        symbols = self._congruence.remaking.symbols
        stated, faults = stated_in(rows, symbols)
        if faults:
            raise SceneError(source, tuple(faults[:TOLD]))
        return [*stated, *stated_by(self._scales, symbols, source)]

    def of(self, readings: Sequence[Taken], source: str = "readings") -> Checked:
        """Return what there is to say of the readings of a drawing; raises as `check`."""
        language = self.scene.language
        explained = self._likeliest(self._explained(self._judged(readings, source)))
        (agreed, notes, bench, by, judged, whole), compared, small, diagnosis = explained
        found = likely_mistakes(diagnosis, compared, language)
        wrongly = mistaken_scenes(found, diagnosis, bench.made)
        if any(one.kind in (MISTAKE, INSTRUMENT) and sure(one) for one in found):
            whole = None  # it is off by that
        found = found or tuple(small)
        notes = (*notes, *told_unseen(bench.unseen.of(compared), language))
        lessons = bench.teacher.lessons(judged, found, by.reader, wrongly)
        name, title = scene_name(self.scene.source), self.scene.title
        said = head(agreed.scales, agreed.moves, agreed.units, language)
        report = Report(name, title, language, self.hand, judged, found, notes, lessons, whole)
        return Checked(report._replace(head=said, scales=agreed.scales), compared)


def check(
    scene: Scene,
    readings: Sequence[Taken],
    *,
    hand: str = "student",
    points: str = "paper",
    trials: int = TRIALS,
    limits: Limits = Limits(),  # noqa: B008
    given: Composition | None = None,
    scales: Sequence[str] = (),
    turns: Sequence[str] = (),
    source: str = "readings",
) -> Report:
    """Return the report on readings of a hand-made drawing of a scene.

    ``hand``: by whose drawings they are judged; ``points``: how x and y were read, one of ``POINTS``;
    ``given``: the composition that the drawing's sheets have, as for `make`; ``scales``: scale factors that it
    was drawn in, "velocities=0.02" or "=scene"; ``turns``: plans that are turned, "velocities=90"; ``source``:
    the file of the readings, for messages.

    Raises
    ------
    SceneError
        If readings name what the scene does not have.
    """
    by = {"hand": hand, "points": points, "trials": trials, "limits": limits}
    checker = Checker(scene, **by, given=given, scales=scales, turns=turns)  # type: ignore[arg-type]
    return checker.of(readings, source).report
