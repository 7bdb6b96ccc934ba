"""The words of the study of accuracy, by the names that its writers have for them."""

from __future__ import annotations

from itertools import chain

from graphic_tmm.accuracy.quantities import Accuracy
from graphic_tmm.accuracy.settings import dividing
from graphic_tmm.language.catalogue import Speech, Tongues, Words, speaking
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
    "quartiles": said("log, ms (quartiles)"),
    "board": said("work at the board, minutes"),
    "machine": said("time on the machine, CPU seconds"),
    "front": said("the front"),
    "figure all": said("settings tried"),
    "figure own": said("as in the scene"),
    "figure knee": said("the knee"),
    "figure printed": said("as printed"),
    "printed": said("printed"),
    "figure sources": said("{quantity}: where the error comes from"),
    "worst error": said("error of the worst, %"),
    "timed log": said("the log"),
    "timed table": said("the table"),
    "timed sheets": said("sheets"),
    "timed drawings": said("10 000 drawings"),
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
    "quantity": said("quantity"),
    "step": said("step"),
    "share": said("share"),
    "shares": said("Where the error comes from: shares of the mean square error"),
    "sources": said("sources"),
    "step of": said("{view}, step {number}: {text}"),
    "answer exact": said(
        "Drawn so, nothing is off: the construction itself is exact, and nothing slips."
    ),
    "answer far": said(
        "This drawing ({setting}) gives {quantity} to {error} % of its largest value; nothing in it is "
        "less exact."
    ),
    "answer far main": said(
        "This drawing ({setting}) gives what it is made for, {main}, to {least} % of its largest value, "
        "and {quantity}, the least exact, to {error} %."
    ),
    "answer printed": said("Printed by the program, it would be off by {error} %."),
    "answer printed main": said(
        "Printed by the program, they would be off by {least} and {error} %."
    ),
    "answer lost": said("{quantity} cannot be drawn at all in more than one such drawing of ten."),
    "answer unjudged": said("There is no true value of {quantity} here to judge it by."),
    "answer compared": said("Drawn in several ways: {each}. The truest: {truest}."),
    "answer compared alike": said("Drawn in several ways: {each}. They are as true as each other."),
    "answer halved": said(
        "Half the error: {setting} ({error} %; {minutes} min at the board instead of {own})."
    ),
    "answer halved less": said(
        "Half the error, and no more work: {setting} ({error} %; {minutes} min at the board instead of {own})."
    ),
    "answer not halved": said(
        "Nothing tried halves the error; the nearest: {setting} ({error} %; {minutes} min at the board)."
    ),
    "answer wasted": said(
        "Not worth its cost: {setting}; {minutes} min more, and {error} % instead of {own} %."
    ),
    "answer wasted same": said(
        "Not worth its cost: {setting}; {minutes} min more, and the error stays {error} %."
    ),
    "answer none wasted": said(
        "Nothing is in vain: each single change that costs more brings a tenth or more."
    ),
    "answer knee": said(
        "The knee: {setting} ({error} %, {minutes} min); beyond it each per cent takes ever more time."
    ),
    "answer from": said("The error of {quantity} comes from: {each}."),
    "answer from printed": said("As the program prints it, it comes from: {each}."),
    "answer step": said("The step that brings most: {step} ({share} %)."),
    "answer table": said("Settings none of which is both dearer and less exact than another"),
    "answer letters": said(
        "● the scene as it is, ◆ the knee, × how many times as large. Nine readings of ten are off by no "
        "more than so many % of the largest value; min: minutes at the board for all that the sheets show. "
        "More with --all."
    ),
    "hand": said("hand"),
    "how": said("how", context="method"),
    "worst": said("worst, %"),
    "main": said("main, %"),
    "from together": said("several together"),
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
    "slopes": said("Slopes"),
    "optima": said("Best numbers"),
    "left out": said("Not drawn: {text}"),
    "budget": said("budget {percent} %: {setting}; {minutes} min at the board; {errors}"),
    "budget size": said("{times} times as large"),
    "by exact": said("by an exact hand"),
    "by cad": said("in CAD"),
    "by careful": said("by a careful hand"),
    "by student": said("by a student's hand"),
    "by ruler": said("ruler {ruler} mm"),
    "budget others": said("all else at most {error} %"),
    "budget none": said(
        "--budget {percent} %: nothing tried keeps within it; the nearest: {setting}; {errors}."
    ),
    "budget source": said(
        "In its way stands {source}: {share} % of the mean square error of {quantity}."
    ),
    "budget hint": said("Allow more, or draw the nearest with --nearest"),
    "from method": said("the method (chords, number of positions)"),
    "from swing": said("rays of square and protractor"),
    "from prick": said("pricked points, copying"),
    "from compass": said("the opening of the compass"),
    "from reading": said("reading lengths by eye"),
    "from ruler": said("divisions of the ruler"),
    "from digits": said("digits of calculation"),
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
        texts = _Names({**TEXTS, **dict(chain.from_iterable(told))})
        return Words(texts, speaking(language), _called)


def _called(name: str, speech: Speech) -> str:
    """Return the word of a name that a scene makes up; "" where it has none."""
    words = (Accuracy.of(one).called(name, speech) for one in chapters())
    return next(filter(None, words), "")


WORDS = _Words(TEXTS)


def counted(number: int, axis: str, language: str) -> str:
    """Return a number of what an axis divides a drawing into, with its noun.

    >>> counted(24, "positions", "ru"), counted(1, "steps", "en")
    ('24 положения', '1 step')
    """
    return speaking(language)(dividing()[axis].counted, n=number)
