"""The words of the study of accuracy, by the names that its writers have for them."""

from __future__ import annotations

from itertools import chain

from graphic_tmm.accuracy.quantities import Accuracy
from graphic_tmm.accuracy.settings import dividing
from graphic_tmm.language.catalogue import Tongues, Words, speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import chapters

TEXTS: dict[str, str] = {
    "title": said("{title}. What accuracy costs"),
    "measure": said(
        "Error in % of the largest value that nine readings of ten keep within "
        "({trials} drawings by each hand that slips); work of that quantity at all positions."
    ),
    "error": said("error, %"),
    "axis": said("varied"),
    "value": said("value"),
    "positions": said("positions", context="how many"),
    "slip": said("single slip of the student"),
    "ruler": said("ruler, mm"),
    "size": said("drawing, times as large"),
    "pole": said("pole distance H, times"),
    "trials": said("drawings by the student"),
    "others": said(
        "One thing varied about the scene's own setting ({hand}); in brackets minutes "
        "where the work changes"
    ),
    "exact": said("exact"),
    "cad": said("CAD"),
    "careful": said("careful"),
    "student": said("student"),
    "scene": said("as in the scene"),
    "prick": said("prick"),
    "compass": said("compass"),
    "swing": said("square and protractor"),
    "reading": said("reading"),
    "digits": said("digits"),
    "minutes": said("min"),
    "milliseconds": said("log, ms"),
    "quartiles": said("log, ms (quartiles)"),
    "board": said("work at the board, minutes"),
    "machine": said("time on the machine, milliseconds"),
    "machine seconds": said("Time on the machine, s, by number of positions (parts, steps)"),
    "asked": said("what is asked for"),
    "time log": said("log: all quantities once, exactly"),
    "time table": said("table"),
    "time sheets": said("sheets as SVG"),
    "time drawings": said("10 000 drawings by the student (ten times 1000)"),
    "timed": said(
        "Time of the processor, warm: the least of at least five; ~ marks what scatters by half or was timed "
        "only once."
    ),
    "busy": said(
        "The machine was busy: other work had {share} % of the time, {scattered} times of {calls} scatter; "
        "repeat this on a quiet machine."
    ),
    "front": said("Pareto front of a hand"),
    "other": said("one thing varied"),
    "count": said("number of positions (parts, steps)"),
    "quantity": said("quantity"),
    "step": said("step"),
    "share": said("share"),
    "shares": said("Share of the variance per step, student, {count} positions"),
    "step of": said("{view}, step {number}: {text}"),
    "choice": said(
        "Choosing the scale factors takes S = {simplicity}, {minutes} min besides, once for all positions: "
        "{symbol}."
    ),
    "slope": said(
        "{quantity}: with the exact hand the error falls as N^{error} ± {width}, the work "
        "grows as N^{minutes}."
    ),
    "slope timed": said(
        "{quantity}: with the exact hand the error falls as N^{error} ± {width}, "
        "the work grows as N^{minutes}, the time of the log on the machine as N^{seconds} ± {spread}."
    ),
    "optimum": said(
        "{quantity}, {hand}: least with {best} ({error} %), as good from {low} to {high}."
    ),
    "optimum sure": said("{quantity}, {hand}: least with {best} ({error} %)."),
    "optimum edge": said(
        "{quantity}, {hand}: least at the end of what was tried, {best} ({error} %)."
    ),
    "optimum flat": said("{quantity}, {hand}: about {error} % at any number."),
    "advice": said(
        "{best}, {hand}: {quantity} to {error} %; {finer} cost {times} times the work "
        "and give {other} %."
    ),
    "advice flat": said(
        "{quantity}, {hand}: to {error} % with any number of {unit}; {finer} "
        "instead of {number} only cost {times} times the work."
    ),
    "advice last": said(
        "{best}, {hand}: {quantity} to {error} %, the more the better: {finer} take "
        "{times} of the work and give {other} %."
    ),
    "most": said(
        "{quantity}: most of the student's error comes from {step} ({share} % of the variance)."
    ),
    "slopes": said("Slopes"),
    "optima": said("Best numbers"),
    "advices": said("Advice"),
    "left out": said("Not drawn: {text}"),
    "budget": said("budget {percent} %: {setting}; {minutes} min at the board; {errors}"),
    "budget size": said("{times} times as large"),
    "budget pole": said("H {times} times as far"),
    "budget none": said(
        "--budget {percent} %: no setting keeps within it; the best found: "
        "{setting}; {errors}. Allow more, or let a better hand draw (--hand)"
    ),
    "advice same": said("{quantity}, {hand}: to {error} % with any number of {unit}."),
    "slope flat": said(
        "{quantity}: with the exact hand the error is the same at any number "
        "(N^{error}), the work grows as N^{minutes}."
    ),
}


class _Names(dict[str, str]):
    """Texts by name; what has none is called by its letters."""

    def __missing__(self, name: str) -> str:
        return name


class _Words(Tongues):
    """These texts and those of chapters, in every language."""

    def __getitem__(self, language: str) -> Words:
        told = (Accuracy.of(one).words.items() for one in chapters())
        return Words(_Names({**TEXTS, **dict(chain.from_iterable(told))}), speaking(language))


WORDS = _Words(TEXTS)


def counted(number: int, axis: str, language: str) -> str:
    """Return a number of what an axis divides a drawing into, with its noun.

    >>> counted(24, "positions", "ru"), counted(1, "steps", "en")
    ('24 положения', '1 step')
    """
    return speaking(language)(dividing()[axis].counted, n=number)
