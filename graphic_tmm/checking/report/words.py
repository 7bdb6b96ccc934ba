"""The words of a report; and text of others made fit to be shown.

Titles, plans, letters, units and notes come from a scene or from a file of readings: they are data, and every
report passes them through `shown` before it escapes them for its own medium.
"""

from __future__ import annotations

from graphic_tmm.captions import captions
from graphic_tmm.chapter import chapters
from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.language.said import said
from graphic_tmm.language.tables import Tongues
from graphic_tmm.language.units import known
from graphic_tmm.language.units import unit as translated

LONGEST = 80
"""Of a name, a letter or a unit so many characters are shown."""
LONGEST_SENTENCE = 600
"""Of a sentence (a mistake's, a note) so many characters are shown."""
HANDS = Tongues(
    {
        "exact": said("exact"),
        "cad": said("CAD"),
        "careful": said("careful"),
        "student": said("student"),
    }
)

TEXTS: dict[str, str] = {
    "check": said("Check: {title}"),
    "who": said("Scene: {scene}. Hand: {hand}."),
    "counts": said("Readings: {all}. Fine {fine}, doubtful {doubtful}, wrong {wrong}."),
    "none": said("There are no readings."),
    "all right": said("Nothing is wrong."),
    "explained": said("The wrong ones are explained by: {mistakes}."),
    "explains": said("{name} ({count} of {wrong})"),
    "the same": said("{name} (the same: {like})"),
    "more": said("{count} more"),
    "left over": said("Not explained: {count}{lines}."),
    "at lines": said(" (lines of the file: {lines})"),
    "unexplained": said("No known mistake explains the wrong ones."),
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
    "verdict": said("verdict"),
    "step": said("step"),
    "own": said("own, mm"),
    "follows": said("follows from"),
    "follows from": said("{segment}"),
    "follows from line": said("{segment} (line {line})"),
    "not sure": said("Line {line}: {segment} is not judged: no digit of the figure due is sure."),
    "mistakes": said("Likely mistakes"),
    "mistake": said("mistake"),
    "says": said("what was done"),
    "count": said("wrong ones"),
    "rest": said("left, %"),
    "lines": said("lines"),
    "notes": said("Notes"),
    "not listed": said(
        "{count} more are not listed here, none of them worse; Markdown, JSON and HTML have all."
    ),
    "chart": said("Deviations in % of the longest vector of the plan"),
    "beyond": said("an arrow: beyond the axis"),
    "legend": said(
        "Line: of the file. Found, due and off by are in mm where no unit stands. "
        "% of plan: of its longest vector. "
        "Farther: so many of the hand's own drawings are farther off. Step: where the error was made. "
        "Own: the error that this step made itself. "
        "Follows from: the earlier reading whose deviation it has, though it is found from it rightly. "
        "Left: what the mistake leaves of the deviations that it explains."
    ),
}
"""What a report says, by the names that its writers have for it."""
WORDS = Tongues(TEXTS)


def shown(text: str, most: int = LONGEST) -> str:
    r"""Return text as it may be shown: on one line, what is not printable as its escape, cut to ``most``.

    >>> shown(" a\n\x1b[31mb"), shown("abcdef", 4)
    ('a \\x1b[31mb', 'abc…')
    """
    line = " ".join(text.split())[: most + 1]
    line = "".join(sign if sign.isprintable() else ascii(sign)[1:-1] for sign in line)
    return line if len(line) <= most else f"{line[: most - 1]}…"


def plan_name(plan: str, language: str) -> str:
    """Return what a plan is called in a language; as the reading calls it if no chapter has a name for it."""
    known = plan == RESULTS or any(plan in one.captions for one in chapters())
    return captions(language)[plan or RESULTS] if known or not plan else shown(plan)


def unit_name(unit: str, language: str) -> str:
    """Return a unit in a language; as it was written if it is no unit of the package."""
    return translated(unit, language) if known(unit) else shown(unit)
