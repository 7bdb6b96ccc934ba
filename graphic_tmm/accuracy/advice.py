"""What a study says, as sentences: slopes, best numbers of positions, one sentence of advice per quantity."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.lessons import Optimum, along, divisions
from graphic_tmm.accuracy.settings import POSITIONS, dividing, own_parts
from graphic_tmm.accuracy.study import Study
from graphic_tmm.accuracy.words import WORDS, counted
from graphic_tmm.language.numbers import number

KNOWN, LEVEL = 0.5, 0.25
"""A slope is printed if its error is below the first; it is zero if below the second. Both chosen by eye."""
MORE = 1.05
"""From this ratio on, work counts as more. Chosen by eye."""
TOLD = "student"
"""The hand that advice is given to."""


def slopes(study: Study) -> Iterator[str]:
    """Yield how the exact hand's error falls with the number of positions, and how its costs grow."""
    language, words = study.scene.language, WORDS[study.scene.language]
    for one in study.fitted:
        width = one.error.half_width()
        if not width < KNOWN:
            continue
        spread = one.seconds.half_width()
        form = "slope timed" if spread < KNOWN else "slope"
        form = form if one.error.slope < -LEVEL else "slope flat"
        yield words[form].format(
            quantity=words[one.quantity],
            error=number(one.error.slope, language, 3),
            width=number(width, language, 1),
            minutes=number(one.minutes.slope, language, 3),
            seconds=number(one.seconds.slope, language, 2),
            spread=number(spread, language, 1),
        )


def best_numbers(study: Study) -> Iterator[str]:
    """Yield at which number of positions each hand errs least."""
    language, words = study.scene.language, WORDS[study.scene.language]
    for one in study.optima:
        form = "optimum" if len(one.sure) > 1 else "optimum sure"
        form = "optimum edge" if not one.inside else form
        form = "optimum flat" if one.flat else form
        yield words[form].format(
            quantity=words[one.quantity],
            hand=words[one.hand],
            best=counted(divisions(one.best), one.axis, language),
            error=number(one.best.error, language, 2),
            low=min(one.sure),
            high=max(one.sure),
        )


def advice(study: Study) -> Iterator[str]:
    """Yield one sentence for each quantity."""
    for one in study.optima:
        if one.hand == TOLD:
            yield _advice(study, one)


def _advice(study: Study, one: Optimum) -> str:
    language, words = study.scene.language, WORDS[study.scene.language]
    row = along(study.runs, one.quantity, one.hand)
    best, other, form = one.best, one.finer, "advice"
    if one.flat:
        own = [run for run in row if divisions(run) == own_parts(study.scene, one.axis)]
        best = (own or row)[0]
        other = next((r for r in row if divisions(r) >= 2 * divisions(best)), row[-1])
        form = "advice flat"
    elif other is None:
        other = max((r for r in row if 2 * divisions(r) <= divisions(best)), key=divisions)
        form = "advice last"
    times = other.work.minutes / best.work.minutes
    form = "advice same" if form == "advice flat" and times < MORE else form
    return words[form].format(
        quantity=words[one.quantity],
        hand=words[one.hand],
        unit=counted(0, one.axis, language).removeprefix("0 "),
        number=divisions(best),
        best=counted(divisions(best), one.axis, language),
        error=number(best.error, language, 2),
        finer=counted(divisions(other), one.axis, language),
        times=number(times, language, 2),
        other=number(other.error, language, 2),
    )


def own_count(study: Study) -> int:
    """Return into how many parts the scene's own setting divides the drawing."""
    divided = dividing()
    axis = next((run.axis for run in study.runs if run.axis in divided), POSITIONS.name)
    return own_parts(study.scene, axis)
