"""Speeds of the drive that a chapter gives: ``drive.speed`` names what it draws, the plans take them there.

The chapter's sections are then about another sheet. The scene is read a second time without them, with what was
read off that sheet as a list for each position.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.errors import TmmError
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Answer, Chapter, chapters
from graphic_tmm.scene.declare import Flaw
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.scene.records import Scene

Speeds = tuple[Sequence[float], Sequence[float]]
"""Speeds (1/s) and accelerations (1/s²) of the driving link in its sense, one for each position."""


@dataclass(frozen=True)
class GivenSpeeds(Answer):
    """What a chapter gives the drive.

    ``words``: by which ``drive.speed`` names it. ``speed``: at which its own plans are drawn. ``speeds``: of a
    scene read with that one. ``chapters``: whose sections the second reading leaves out, besides its own.
    """

    stands: ClassVar[str] = "record.GIVEN_SPEEDS"
    words: tuple[str, ...] = ()
    speed: str = "10 rad/s"
    speeds: Callable[[Scene], Speeds] = lambda scene: ((), ())
    chapters: tuple[str, ...] = ()


def with_speeds(doc: Document, read: Callable[[Document], Scene]) -> tuple[Document, list[Flaw]]:
    """Return a document with the speeds that it names listed, and what is wrong with naming them.

    Parameters
    ----------
    doc : Document
        As the file has it; returned as it is where its speed is a number or a list.
    read : callable
        The scene of another document of the same file.
    """
    if (giver := _giver(doc)) is None:
        return doc, []
    drive, answer = as_table(doc["drive"]), GivenSpeeds.of(giver)
    gone = [one for one in chapters() if one is giver or one.name in answer.chapters]
    if flaws := list(_flaws(doc, drive, giver, gone)):
        return doc, flaws
    # what the chapter draws is read off a sheet that shows nothing else
    first = next(iter(_sheets(doc)), {})
    sheet = {**first, "place": [place.name for place in giver.places]}
    base = read({**doc, "drive": {**drive, "speed": answer.speed}, "sheet": [sheet]})
    try:
        speeds, gains = answer.speeds(base)
    except TmmError as error:
        return doc, [Flaw(("drive", "speed"), error.args[0])]
    taken = {section.name for one in gone for section in one.sections}
    rest = {key: value for key, value in doc.items() if key not in taken}
    listed = {"speed": _texts(speeds, "rad/s"), "acceleration": _texts(gains, "rad/s^2")}
    return {**rest, "drive": {**drive, **listed}}, []


def at_one_speed(doc: Document) -> Document:
    """Return a document for who asks only where everything lies: without speeds that a chapter gives."""
    if (giver := _giver(doc)) is None:
        return doc
    return {**doc, "drive": {**as_table(doc["drive"]), "speed": GivenSpeeds.of(giver).speed}}


def _giver(doc: Document) -> Chapter | None:
    """Return the chapter that the speed of the drive names."""
    word = as_table(doc.get("drive")).get("speed")
    return next((one for one in chapters() if word in GivenSpeeds.of(one).words), None)


def _flaws(
    doc: Document, drive: Mapping[str, object], giver: Chapter, gone: Sequence[Chapter]
) -> Iterator[Flaw]:
    section = giver.asking.name if giver.asking is not None else giver.name
    if section not in doc:
        says = said("[{section}] gives this speed: write it", section=section)
        yield Flaw(("drive", "speed"), says)
    if "acceleration" in drive:
        says = said("[{section}] gives it with the speed: leave it out", section=section)
        yield Flaw(("drive", "acceleration"), says)
    own = [place.name for one in gone for place in one.places]
    for k, sheet in enumerate(_sheets(doc)):
        places = sheet.get("place", ())
        written = places if isinstance(places, list) else [places]
        for name in (one for one in own if one in written):
            says = said(
                "{place} is drawn at one speed of the drive, and here [{section}] gives it: show it on a sheet "
                "of a scene that writes the speed",
                place=name,
                section=section,
            )
            yield Flaw(("sheet", k, "place"), says)


def _sheets(doc: Document) -> list[Mapping[str, object]]:
    sheets = doc.get("sheet")
    return [as_table(one) for one in sheets] if isinstance(sheets, list) else []


def _texts(values: Sequence[float], unit: str) -> list[str]:
    return [f"{float(value)!r} {unit}" for value in values]
