"""What the author of a note says and no drawing knows: its title page, words of his own, books."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene import letters
from graphic_tmm.scene import values as v
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.declare import FAULTY, Flaw, Kind, Names, Path, Schema, key
from graphic_tmm.scene.misfits import meant, stands
from graphic_tmm.scene.tables import Named

LONGEST = 4000
"""Characters of a paragraph at the most."""
_APART = re.compile(r"\r?\n[ \t]*\r?\n\s*")
"""What stands between two paragraphs of one text: an empty line."""
_SPACES = re.compile(r"[ \t\r\n]+")
_UNTOLD = ("Cc", "Cf", "Cn", "Co", "Cs", "Zl", "Zp")
"""Kinds of characters that no file of a note can hold, or that nobody sees."""

PROJECT, WORK = "course project", "course work"
ASSIGNMENT, DIPLOMA = "graphical assignment", "diploma project"


def _text(value: object) -> str:
    """Return a text on one line, without spaces about it."""
    if not isinstance(value, str):
        raise ValueError(stands(value, said("a text in quotes is wanted")))
    told = _SPACES.sub(" ", value).strip(" ")
    for character in told:
        if unicodedata.category(character) in _UNTOLD:
            raise ValueError(
                said(
                    "the character U+{code:04X} cannot be written into a note; take it out",
                    code=ord(character),
                )
            )
    return told


def _line(value: object, names: Names) -> str:
    told = _text(value)
    if len(told) > letters.LONGEST_TEXT:
        most = letters.LONGEST_TEXT
        raise ValueError(
            said(
                "a text of {n} characters; a line of the title page has {most} at most",
                n=len(told),
                most=most,
            )
        )
    return told


def _label(value: object, names: Names) -> str:
    whole = isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= 10**6
    if not whole and not isinstance(value, str):
        raise ValueError(stands(value, said('a whole number is wanted, or a text, "8a"')))
    return _line(str(value), names)


def _paragraphs(value: object, names: Names) -> tuple[str, ...]:
    items = value if isinstance(value, list) else [value]
    texts = [item for item in items if isinstance(item, str)]
    if len(texts) < len(items):
        raise ValueError(
            stands(
                value,
                said('a text in quotes is wanted, or a list of texts, one a paragraph: ["…", "…"]'),
            )
        )
    found = [told for item in texts for part in _APART.split(item) if (told := _text(part))]
    if longest := max(map(len, found), default=0):
        _refuse_long(longest)
    return tuple(found)


def _refuse_long(longest: int) -> None:
    if longest > LONGEST:
        raise ValueError(
            said(
                "a paragraph of {n} characters; {most} at most: leave an empty line between paragraphs",
                n=longest,
                most=LONGEST,
            )
        )


_SEVERAL: Schema = {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}
LINE = Kind(_line, {"type": "string"})
LABEL = Kind(_label, {"anyOf": [{"type": "string"}, {"type": "integer"}]}, unit="number or a text")
PARAGRAPHS = Kind(_paragraphs, _SEVERAL, unit="text, or a list of texts, one a paragraph")
BOOKS = Kind(_paragraphs, _SEVERAL, unit="list of texts, one a book")
KIND_OF_WORK = v.choice(
    PROJECT, WORK, ASSIGNMENT, DIPLOMA,
    курсовой_проект=PROJECT, курсовая_работа=WORK,
    **{"расчётно-графическая работа": ASSIGNMENT}, дипломный_проект=DIPLOMA,
)  # fmt: skip
YEAR = v.number(Bound(1900, 2200, whole=True))


@dataclass(frozen=True)
class ByChapter(Named):
    """A table whose keys are names of chapters."""

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return the values by chapter, or FAULTY."""
        told = super().understood(value, at, names, found)
        known = [one.name for one in chapters()]
        strange = [name for name in told if name not in known] if told is not FAULTY else []
        for name in strange:
            says = said('there is no chapter "{name}"', name=name[:40])
            there = said("chapters are {listed}", listed=", ".join(known))
            found.append(
                Flaw((*at, name), joined("; ", filter(None, (says, meant(name, known), there))))
            )
        return FAULTY if strange else told

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return what an editor is told."""
        return {
            **super().schema(tables),
            "propertyNames": {"enum": [one.name for one in chapters()]},
        }


@dataclass(frozen=True)
class Author:
    """What the author of the explanatory note says; what is left out is left out there."""

    ministry: str = key(LINE, "on top of the title page", said("Ministry of Education"), "")
    university: str = key(LINE, "below it", said("State Technical University"), "")
    department: str = key(
        LINE,
        "left out: the organisation of the title block",
        said("Department of Applied Mechanics"),
        "",
    )
    discipline: str = key(LINE, "what is studied", said("Theory of mechanisms and machines"), "")
    kind_of_work: str | None = key(
        KIND_OF_WORK, "what the note belongs to", said("course project"), None
    )
    theme: str = key(
        LINE,
        "left out: the name of the title block and the title of the scene",
        said("Design and study of the mechanism of a windrower"),
        "",
    )
    variant: str = key(LABEL, "of the task", 8, "")
    group: str = key(LABEL, "of the author, who is drawn_by of the title block", said("M-31"), "")
    city: str = key(LINE, "at the foot of the title page", said("Kirov"), "")
    year: int | None = key(YEAR, "beside the city", 2026, None)
    machine: tuple[str, ...] = key(
        PARAGRAPHS,
        "what the machine is for: the introduction begins with it",
        said("The windrower cuts grain and lays it in swaths."),
        (),
    )
    introduction: tuple[str, ...] = key(
        PARAGRAPHS,
        "goes on with the introduction",
        [said("A slotted rocker drives the knife.")],
        (),
    )
    task: tuple[str, ...] = key(
        PARAGRAPHS,
        "conditions of the task, behind what is given",
        said("Take the connecting rod as long as the rocker's arm."),
        (),
    )
    remarks: Mapping[str, tuple[str, ...]] = key(
        ByChapter(PARAGRAPHS),
        "what the sections of chapters begin with, by the name of the chapter",
        {},
        {},
    )
    conclusions: tuple[str, ...] = key(
        PARAGRAPHS,
        "behind those that follow from the results",
        said("The conditions of the task are met."),
        (),
    )
    frame: bool = key(
        v.SWITCH,
        "pages of a PDF have a frame and a title block, forms 2 and 2a",
        True,
        False,
    )
    literature: tuple[str, ...] = key(
        BOOKS,
        "left out: the books that the chapters follow",
        [said("Norton R. L. Design of Machinery. New York: McGraw-Hill, 2012.")],
        (),
    )
