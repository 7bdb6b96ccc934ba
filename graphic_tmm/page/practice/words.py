"""What the page says where a person draws, by the names that its program has for it; packed only with it."""

from __future__ import annotations

from graphic_tmm.checking.readings.csv_cells import HEADS
from graphic_tmm.checking.readings.writing import write_readings
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit

WORDS: dict[str, str] = {
    "practice": said("Practice"),
    # the instruments: what each is called, what it is laid to
    "edge": said("Line"),
    "edge takes": said("Line with the edge of the ruler: two points."),
    "parallel": said("Parallel"),
    "parallel takes": said("Parallel: a point and a line, or a line and how far from it."),
    "square": said("Square"),
    "square takes": said("Perpendicular: a point and a line."),
    "protractor": said("Angle"),
    "protractor takes": said("Line at an angle: a point and the angle."),
    "compass": said("Arc"),
    "compass takes": said("Arc: its centre and the opening of the compass."),
    "laying": said("Lay off"),
    "laying takes": said("Lay off: a line and a length."),
    "meeting": said("Meet"),
    "meeting takes": said("Point where two meet: lines or arcs."),
    "figure": said("Similar"),
    "figure takes": said(
        "Similar figure: two points of the plan, and the point of the link whose image is sought; or the point "
        "that is carried over."
    ),
    "reading": said("Measure"),
    "reading takes": said("Measure: from which point to which."),
    "formula": said("Calculate"),
    "formula takes": said("Calculate: of what?"),
    "palette": said("Instruments"),
    "choose": said("Next step: choose an instrument."),
    "laid to": said("What it is laid to"),
    "that is all": said("That is all"),
    # what comes of a step
    "points": said("Points"),
    "lines": said("Lines and arcs"),
    "on mechanism": said("On the mechanism"),
    "prick": said("Mark {letter} within {most} mm: click, drag, arrows; or its coordinates."),
    "which way": said("{letter}: which way?"),
    "read off": said("Read {letter} off the ruler."),
    "work out": said("Calculate {letter}."),
    "coordinates": said("mm from {letter}"),
    "mark it": said("Mark it"),
    "judge": said("Judge"),
    "no number": said("Write a number, such as {example}."),
    "board": said("The board"),
    "loupe": said("Loupe"),
    "meant": said("Which one?"),
    "nothing here": said("Nothing here that this instrument takes."),
    # how it is judged
    "drawn": said("{letter} is drawn."),
    "fine": said("Right."),
    "doubtful": said("Doubtful: farther off than most hands."),
    "wrong": said("Wrong."),
    "missed": said("Missed."),
    "missed by": said("A mark more than {most} mm off is missed."),
    "own error": said("Own error {error} {unit}, earlier marks as they stand."),
    "off figure": said("{error} mm off {letter}."),
    "times more": said("{times} times too large."),
    "times less": said("{times} times too small."),
    "other sense": said("The other sense: see the sign."),
    "other meeting": said("It is the other one of two meetings."),
    "leave": said("Let it stand"),
    "try again": said("Do {letter} again"),
    "no such step": said("No step of this plan."),
    "other instrument": said("The right things; another instrument."),
    "not yet": said("Something that {letter} needs is not there yet."),
    "done": said("{letter} is there already."),
    "undrawable": said("{letter} cannot be drawn with the marks as they stand: do one again."),
    # help, score, record
    "help why": said("Help: why?"),
    "help what": said("Help: what?"),
    "help show": said("Help: show it"),
    "its button": said("Instrument: {name}."),
    "score": said(
        "{done} of {count} steps: {once} at once, {helped} with help or again, {shown} shown, "
        "{wrong} wrong"
    ),
    "done steps": said("What you have done"),
    "at once": said("at once"),
    "helped": said("with help or again"),
    "was shown": said("shown"),
    "was wrong": said("left wrong"),
    "all done": said("The plan is ready."),
    "begin anew": said("Begin anew"),
    "surely anew": said("Wipe all that is done?"),
    "save record": said("Record, JSON"),
    "save readings": said("Readings, CSV"),
    "keys tools": said("Choose an instrument"),
    "keys whole": said("That is all; mark it; judge"),
    "keys nudge": said("Move the cross by 0.1 mm, with Shift by 5 mm"),
    "keys let go": said("Let go of what is picked, then of the instrument"),
    "keys help": said("Help with the next step: why, what, show"),
}
"""Braces are filled in by the page."""


def practice_words(language: str) -> dict[str, str]:
    """Return what is said where a person draws, in a language, and how its files of readings begin."""
    speech = speaking(language)
    head = write_readings((), language=language)
    first = speech(HEADS[0])
    separator = head[head.index(first) + len(first)]
    signs = {"decimal sign": decimal_sign(language), "mm": unit("mm", language)}
    return (
        {key: speech(text) for key, text in WORDS.items()}
        | signs
        | {"csv head": head, "csv separator": separator}
    )
