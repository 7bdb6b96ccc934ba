"""A report as words and rows of text: what its every form shows, made fit to be shown, escaped by none."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from typing import NamedTuple

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import RESULTS, segment_text
from graphic_tmm.checking.records import DOUBTFUL, FINE, VERDICTS, WRONG, Judged, Report
from graphic_tmm.language.catalogue import Tongues
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import known
from graphic_tmm.language.units import unit as translated
from graphic_tmm.scene.captions import Named, captions
from graphic_tmm.scene.chapter import chapters

LONGEST = 80
"""Of a name, a letter or a unit so many characters are shown."""
LONGEST_SENTENCE = 600
"""Of a sentence (a mistake's, a note) so many characters are shown."""
NAMES = Tongues(
    {
        "exact": said("exact"),
        "cad": said("CAD"),
        "careful": said("careful"),
        "student": said("student"),
    }
)

TEXTS: dict[str, str] = {
    "check": said("Check: {title}"),
    "who": said("Scene: {scene}. Judged by the hand: {hand}{slips}."),
    "slips": said(" (lines ±{swing}°, readings ±{reading} mm{strict})"),
    "strict": said("; more strictly: --hand careful"),
    "counts": said("Readings: {all}. Fine {fine}, doubtful {doubtful}, wrong {wrong}."),
    "none": said("There are no readings."),
    "all right": said(
        "Nothing is wrong: every reading agrees with the exact drawing as well as a hand can draw."
    ),
    "look again": said("No mistake was found, but look once more at what is doubtful."),
    "seen right": said("What was seen is right as far as it goes, but not every plan was seen."),
    "points seen": said("Seen: {points} of {of} points."),
    "plans seen": said("{name}: {seen} of {of}"),
    "nothing said": said(", nothing is said about them"),
    "unseen plans": said(", not {positions}"),
    "not whole": said(", in part {positions}"),
    "only whole": said("No reading is wrong by itself, but the drawing as a whole is."),
    "whole alone": said("As a whole the drawing is farther off than 99.9 % of hands."),
    "whole": said(
        "As a whole the drawing is farther off than 99.9 % of hands: of {of} lengths (wrong ones apart) "
        "{doubtful} are doubtful, usually {due}."
    ),
    "mistake": said("Most likely: {says}."),
    "perhaps": said("Perhaps, but the readings do not say it for sure: {says}."),
    "perhaps alike": said("Perhaps one of these, but the readings do not say it for sure: {says}."),
    "alike": said("One of these, and the readings do not tell which: {says}."),
    "instrument": said("There is no mistake in the construction: {says}."),
    "unseen": said("These readings cannot tell: {says}."),
    "begin at": said("No known mistake explains what is wrong; begin with {segment} ({plan})."),
    "begin": said(
        "No known mistake explains what is wrong; begin with {letter} ({plan}, step {number})."
    ),
    "explains": said("explains {count} of {wrong} wrong readings"),
    "leaves": said("leaves {rest} % of their deviations"),
    "at lines": said("lines of the file: {lines}"),
    "rare": said("of honest drawings {percent} % at the most are so far off"),
    "sure": said("sure to {percent} %"),
    "more": said("Less likely, and not told here: {count}."),
    "left over": said("Not explained: {count} ({lines})."),
    "fine": said("fine"),
    "doubtful": said("doubtful"),
    "wrong": said("wrong"),
    "line": said("line"),
    "position": said("pos."),
    "segment": said("segment"),
    "found": said("found"),
    "due": said("due"),
    "unit": said("unit"),
    "deviation": said("off by"),
    "percent": said("% of plan"),
    "farther": said("farther, %"),
    "step": said("step"),
    "own": said("own, mm"),
    "follows": said("follows from"),
    "follows from": said("{segment}"),
    "follows from line": said("{segment} (line {line})"),
    "not sure": said("Line {line}: {segment} is not judged: no digit of the figure due is sure."),
    "found wrong": said("{plan}, step {number}: {letter}"),
    "for that": said("{plan}: wrong for the same reason"),
    "wrong ones": said("{plan}: wrong"),
    "doubtful ones": said("{plan}: doubtful, look once more"),
    "so many": said("Readings: {count}"),
    "fine ones": said("Fine: {count}"),
    "at": said("position {position}"),
    "drawn so": said("It is drawn so: {steps}"),
    "own numbers": said("From your own numbers"),
    "due numbers": said("It should be"),
    "yours": said("You have {found}."),
    "yours fine": said("You have {found}, as it should be."),
    "yours for": said("You have {found}; due is {due}."),
    "it shows": said("It shows in {segment}: you have {found}; due is {due}."),
    "off itself": said("This step itself puts your point {segment} {off} mm off."),
    "off": said("Your point {segment} is {off} mm away from where it is due."),
    "drawn": said("The plan in position {position}: due in green, yours in red"),
    "drawn length": said(
        "The plan in position {position}: due in green; your length, laid along what is due, in red"
    ),
    "drawn amiss": said("The plan in position {position}: due in green, with the mistake in red"),
    "drawn due": said("The plan in position {position}: due in green"),
    "notes": said("Notes"),
    "not listed": said("{count} more are not listed here; Markdown, JSON and HTML have all."),
    "chart": said("Deviations in % of the longest vector of the plan"),
    "beyond": said("an arrow: beyond the axis"),
}
"""What a report says, by the names that its writers have for it."""
WORDS = Tongues(TEXTS)
LEGENDS: dict[str, str] = {
    "line": said("Line: of the file."),
    "found": said("Found, due and off by are in mm where no unit stands."),
    "percent": said("% of plan: of its longest vector."),
    "farther": said("Farther: so many of the hand's own drawings are farther off."),
    "step": said("Step: where the error was made."),
    "own": said("Own: the error that this step made itself, as far as earlier readings tell it."),
    "follows": said(
        "Follows from: the earlier reading whose deviation it has, though it is found from it rightly."
    ),
}
"""What the columns of a report's tables mean, in their order."""
LEGEND = Tongues(LEGENDS)


def printable_text(text: str, most: int = LONGEST) -> str:
    r"""Return text as it may be shown: on one line, what is not printable as its escape, cut to ``most``.

    >>> printable_text(" a\n\x1b[31mb"), printable_text("abcdef", 4)
    ('a \\x1b[31mb', 'abc…')
    """
    line = " ".join(text.split())[: most + 1]
    line = "".join(sign if sign.isprintable() else ascii(sign)[1:-1] for sign in line)
    return line if len(line) <= most else f"{line[: most - 1]}…"


def plan_name(plan: str, language: str) -> str:
    """Return what a plan is called in a language; as the reading calls it if no chapter has a name for it."""
    known = plan == RESULTS or any(plan in Named.of(one).captions for one in chapters())
    return captions(language)[plan or RESULTS] if known or not plan else printable_text(plan)


def unit_name(unit: str, language: str) -> str:
    """Return a unit in a language; as it was written if it is no unit of the package."""
    return translated(unit, language) if known(unit) else printable_text(unit)


SIGNS = {FINE: "●", DOUBTFUL: "▲", WRONG: "✖"}
"""Verdicts are told by a shape as well as by a colour."""
LARGE = 1e6
"""From here on a figure is written with a power of ten."""
NOISE = 1e-12
"""A deviation below this share of its figure is none: numbers of the machine agree no better."""
ROUNDED = 0.005
"""mm: figures of two decimals that differ by less are told as the same."""
RUNS = 12
"""So many runs of lines are listed; the JSON has all of them."""
FIGURES = frozenset({"line", "found", "due", "deviation", "percent", "farther", "own"})
"""Columns of figures, set to the right."""
OPTIONAL = frozenset({"line", "position", "unit", "percent", "step", "own", "follows"})
"""Columns left out where nothing stands in them, or a dash."""


class Grid(NamedTuple):
    """A table: its title, its columns (keys of the words), its rows, the verdict of each row ("" for none)."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    verdicts: tuple[str, ...]


def title(report: Report) -> str:
    """Return the heading of a report."""
    name = printable_text(report.title) or printable_text(report.scene)
    return WORDS[report.language]["check"].format(title=name)


def who(report: Report) -> str:
    """Return which scene was checked against whose hand, and how far that is off (standard deviations)."""
    words, language = WORDS[report.language], report.language
    slips, hand = "", HANDS.get(report.hand)
    if hand is not None:
        slips = words["slips"].format(
            swing=number(hand.swing, language),
            reading=number(hand.reading, language),
            strict=words["strict"] if report.hand == "student" else "",
        )
    return words["who"].format(
        scene=printable_text(report.scene),
        hand=printable_text(NAMES[language].get(report.hand, report.hand)),
        slips=slips,
    )


def counts(report: Report) -> dict[str, int]:
    """Return how many readings there are of each verdict."""
    return {key: sum(one.verdict == key for one in report.readings) for key in VERDICTS}


def worst(report: Report) -> str:
    """Return the worst verdict that a reading got; "" if there are no readings."""
    found = {one.verdict for one in report.readings}
    return next((verdict for verdict in reversed(VERDICTS) if verdict in found), "")


def by_plan(readings: Sequence[Judged]) -> dict[str, list[Judged]]:
    """Return the readings of each plan, plans and readings in the order in which they come."""
    plans: dict[str, list[Judged]] = {}
    for one in readings:
        plans.setdefault(one.taken.plan, []).append(one)
    return plans


def reading_grid(
    readings: Sequence[Judged], language: str, title: str, without: Collection[str] = ()
) -> Grid:
    """Return the table of some readings; ``without``: columns that are left out."""
    rows = [_reading(one, language) for one in readings]
    columns = tuple(
        key
        for key in rows[0]
        if key not in without
        and (key not in OPTIONAL or any(row[key] not in ("", "—") for row in rows))
    )
    cells = tuple(tuple(row[key] for key in columns) for row in rows)
    return Grid(title, columns, cells, tuple(one.verdict for one in readings))


def notes(report: Report) -> tuple[str, ...]:
    """Return the notes, as they may be shown."""
    return tuple(printable_text(note, LONGEST_SENTENCE) for note in report.notes)


def verdict_name(verdict: str, language: str) -> str:
    """Return a verdict with its shape: ✖ wrong."""
    return f"{SIGNS[verdict]} {WORDS[language][verdict]}"


def runs(lines: Sequence[int]) -> str:
    """Return the numbers of lines in short: 2–5, 9; lines without a number (0) are not counted.

    >>> runs([9, 2, 3, 4, 5, 0])
    '2–5, 9'
    """
    found: list[list[int]] = []
    for line in sorted({line for line in lines if line > 0}):
        if found and line == found[-1][1] + 1:
            found[-1][1] = line
        else:
            found.append([line, line])
    told = [str(a) if a == b else f"{a}–{b}" for a, b in found[:RUNS]]
    return ", ".join([*told, "…"] if len(found) > RUNS else told)


def signed(value: float, places: int, language: str) -> str:
    """Return a figure with its sign, + too; a dash where there is none.

    >>> signed(0.46, 1, "ru"), signed(-0.04, 1, "en")
    ('+0,5', '0.0')
    """
    text = figure_of(value, places, language)
    return f"+{text}" if value > 0 and text.strip("0.,") and text != "—" else text


def figure_of(value: float, places: int, language: str) -> str:
    """Return a figure with ``places`` decimals, or with a power of ten if it is large."""
    if math.isfinite(value) and abs(value) >= LARGE:
        return number(value, language)
    return fixed(value, places, language)


def _reading(one: Judged, language: str) -> dict[str, str]:
    taken, drawn = one.taken, one.unit == "mm"

    def figure_text(value: float) -> str:
        return figure_of(value, 2, language) if drawn else number(value, language)

    deviation = 0.0 if abs(one.deviation) <= NOISE * abs(one.due) else one.deviation
    off = signed(deviation, 2, language) if drawn else figure_text(deviation)
    return {
        "line": str(taken.line) if taken.line else "",
        "position": printable_text(taken.position),
        "segment": printable_text(segment_text(taken.segment, language)) + _place(one, language),
        "found": figure_text(one.found),
        "due": figure_text(one.due),
        "unit": "" if drawn else unit_name(one.unit, language),
        "deviation": off if drawn or not deviation > 0 else f"+{off}",
        "percent": figure_of(one.percent, 1, language),
        "farther": _share(one.quantile, language),
        "step": printable_text(plain(one.step)),
        "own": "" if (own := own_error(one)) is None else signed(own, 2, language),
        "follows": _source(one, language),
    }


def own_error(one: Judged) -> float | None:
    """Return the error that a step made itself; None where it is not known apart from the whole deviation."""
    if one.own is None or abs(abs(one.own) - abs(one.deviation)) < ROUNDED:
        return None
    return one.own


def _source(one: Judged, language: str) -> str:
    """Return the earlier reading that a deviation follows from; "" for none."""
    if one.follows is None:
        return ""
    line, words = one.follows.line, WORDS[language]
    told = words["follows from line" if line else "follows from"]
    return told.format(
        segment=printable_text(segment_text(one.follows.segment, language)), line=line
    )


def _place(one: Judged, language: str) -> str:
    x, y = one.taken.x, one.taken.y
    if x is None or y is None:
        return ""
    return f" ({figure_of(x, 2, language)}; {figure_of(y, 2, language)})"


def _share(share: float, language: str) -> str:
    """Return a share of the hand's drawings in %; one that rounding would hide is not called none."""
    if 0 < share < 0.0005:
        return f"< {fixed(0.1, 1, language)}"
    return fixed(100 * share, 1, language)
