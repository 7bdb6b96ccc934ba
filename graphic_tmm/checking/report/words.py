"""The words of a report; and text of others made fit to be shown.

Titles, plans, letters, units and notes come from a scene or from a file of readings: they are data, and every
report passes them through `shown` before it escapes them for its own medium.
"""

from __future__ import annotations

from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.language.catalogue import Tongues
from graphic_tmm.language.said import said
from graphic_tmm.language.units import known
from graphic_tmm.language.units import unit as translated
from graphic_tmm.scene.captions import Named, captions
from graphic_tmm.scene.chapter import chapters

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
    "all right": said(
        "Nothing is wrong: every reading agrees with the exact drawing as well as a hand can draw."
    ),
    "look again": said("Nothing is wrong, but look once more at what is doubtful."),
    "mistake": said("Most likely: {says}."),
    "perhaps": said("Perhaps, but the readings do not say it for sure: {says}."),
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
    "fine ones": said("Fine: {count}"),
    "at": said("position {position}"),
    "drawn so": said("It is drawn so: {steps}"),
    "own numbers": said("From your own numbers"),
    "due numbers": said("It should be"),
    "yours": said("You have {found}."),
    "yours for": said("You have {found}; due is {due}."),
    "it shows": said("It shows in {segment}: you have {found}; due is {due}."),
    "off itself": said("This step itself puts your point {segment} {off} mm off."),
    "off": said("Your point {segment} is {off} mm away from where it is due."),
    "drawn": said("The plan in position {position}: due in green, yours in red"),
    "notes": said("Notes"),
    "not listed": said(
        "{count} more are not listed here, none of them worse; Markdown, JSON and HTML have all."
    ),
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
    "own": said("Own: the error that this step made itself."),
    "follows": said(
        "Follows from: the earlier reading whose deviation it has, though it is found from it rightly."
    ),
}
"""What the columns of a report's tables mean, in their order."""
LEGEND = Tongues(LEGENDS)


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
    known = plan == RESULTS or any(plan in Named.of(one).captions for one in chapters())
    return captions(language)[plan or RESULTS] if known or not plan else shown(plan)


def unit_name(unit: str, language: str) -> str:
    """Return a unit in a language; as it was written if it is no unit of the package."""
    return translated(unit, language) if known(unit) else shown(unit)
