"""The rule of a file, marks.toml: every fault of it at once, with key and line.

::

    [mark]
    steps = { 5 = 85, 4 = 70, 3 = 50 }   # the mark, and from how many points of 100 on
    below = "2"                          # the mark below them
    # or, without steps, in proportion:
    scale  = 100                         # the mark for all points
    lowest = 0                           # the mark for none
    round  = 1                           # marks are multiples of it, a half is rounded up

    [points]                             # what is lost of 100
    wrong         = 4                    # by a wrong reading, one that only follows from another is none
    segment       = 10                   # by all wrong readings of a segment: no more
    mistake       = 16                   # by a mistake that is named, however much it makes wrong: no more
    doubtful      = 4                    # by a doubtful reading at the limit; nearer to 2 σ of the hand, less
    doubtful_most = 8                    # by all of them: no more
    whole         = 16                   # by a drawing that is off as a whole, though hardly a reading is wrong
    plan          = 25                   # by a plan that is missing
    reading       = 2                    # by a reading missing in a plan that is there
    variant       = 51                   # by readings that fit another variant of the table than the own one

    [asked]
    plans = ["velocities"]               # the plans asked for; left out: those of check --template --short
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

from graphic_tmm.classroom.marks.rule import FIVE, WHOLE, Rule
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import Kind
from graphic_tmm.language.said import said
from graphic_tmm.scene.document import document, number
from graphic_tmm.scene.lines import line_of, locate
from graphic_tmm.scene.tables import unknown_key

MARKS = Kind(said("a rule for marks"), said("name a file as marks.toml"), 64_000)
TOLD = 20
"""So many faults of a file are told."""
LONGEST, MOST = 20, 100
"""A mark has no more letters; there are no more steps, and no more plans."""
LARGEST = 1_000_000
_LOST = (
    *("wrong", "segment", "mistake", "doubtful", "doubtful_most", "whole"),
    *("plan", "reading", "variant"),
)
_KEYS = {
    "mark": ("steps", "below", "scale", "lowest", "round"),
    "points": _LOST,
    "asked": ("plans",),
}


def read_rule(file: Path) -> Rule:
    """Return the rule of a file; what it leaves out is as in `FIVE`, but the steps if it has a scale.

    Raises
    ------
    SceneError
        If it cannot be read, is no TOML, or with all that is wrong in it.
    """
    text, doc = document(file, MARKS)
    found = _Reading()
    sections = {name: found.table(doc, name) for name in _KEYS}
    for name in doc.keys() - _KEYS.keys():
        found.fault((name,), unknown_key(name, list(_KEYS)))
    values: dict[str, Any] = {
        key: found.number(sections["points"], ("points", key), 0, 1000) for key in _LOST
    }
    values |= found.scale(sections["mark"])
    values["plans"] = found.plans(sections["asked"])
    if found.faults:
        lines = locate(text)
        faults = [Fault(".".join(path), line_of(lines, path), says) for path, says in found.faults]
        raise SceneError(
            str(file), first_of(sorted(faults, key=lambda one: (one.line, one.key)), TOLD)
        )
    return FIVE._replace(**{key: value for key, value in values.items() if value is not None})


class _Reading:
    """What is read of a document; what is wrong with it, each with its path."""

    def __init__(self) -> None:
        self.faults: list[tuple[tuple[str, ...], str]] = []

    def fault(self, path: tuple[str, ...], says: str) -> None:
        self.faults.append((path, says))

    def table(self, doc: dict[str, Any], name: str) -> dict[str, Any]:
        """Return a section; what in it means nothing is a fault."""
        there = doc.get(name, {})
        if not isinstance(there, dict):
            says = said(
                "a section is wanted: [{name}] on a line of its own, its keys below it", name=name
            )
            self.fault((name,), says)
            return {}
        for key in there.keys() - set(_KEYS[name]):
            self.fault((name, key), unknown_key(key, list(_KEYS[name])))
        return there

    def number(
        self, table: dict[str, Any], path: tuple[str, ...], least: int, most: int = LARGEST
    ) -> Fraction | None:
        """Return a number of a table, exactly as it is written; None if it is not there or none."""
        value = table.get(path[-1])
        if value is None:
            return None
        if number(value) is None:
            self.fault(path, said("a number is wanted, such as 4 or 0.5"))
            return None
        exact = Fraction(repr(value))
        if not least <= exact <= most:
            says = said("a number from {least} to {most} is wanted", least=least, most=most)
            self.fault(path, says)
            return None
        return exact

    def scale(self, table: dict[str, Any]) -> dict[str, Any]:
        """Return the part of the rule that makes marks of points."""
        if "steps" in table:
            for key in ("scale", "lowest", "round"):
                if key in table:
                    says = said(
                        "marks go by steps or by a scale: take out {key}, or steps", key=key
                    )
                    self.fault(("mark", key), says)
            return {"steps": self.steps(table["steps"]), "below": self.below(table)}
        if "below" in table:
            self.fault(("mark", "below"), said("this goes with steps; write lowest with a scale"))
        if not table.keys() & {"scale", "lowest", "round"}:
            return {}
        scale = self.number(table, ("mark", "scale"), -LARGEST)
        lowest = self.number(table, ("mark", "lowest"), -LARGEST) or Fraction(0)
        unit = self.number(table, ("mark", "round"), 0)
        if "scale" not in table:
            self.fault(("mark", "scale"), said("write the mark for all points, scale = 100"))
        elif scale is not None and scale == lowest:
            self.fault(("mark", "scale"), said("this is the lowest mark, too: write another"))
        if unit is not None and unit == 0:
            self.fault(("mark", "round"), said("a number above 0 is wanted"))
        return {"steps": (), "scale": scale, "lowest": lowest, "round": unit or Fraction(1)}

    def below(self, table: dict[str, Any]) -> str | None:
        """Return the mark below the steps."""
        value = table.get("below")
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            value = str(value)
        if not _is_mark(value):
            says = said(
                'write the mark below the steps, below = "2" ({most} letters)', most=LONGEST
            )
            self.fault(("mark", "below"), says)
            return None
        return str(value)

    def steps(self, value: object) -> tuple[tuple[str, Fraction], ...] | None:
        """Return the steps, the best mark first."""
        if not isinstance(value, dict) or not 0 < len(value) <= MOST:
            says = said("write each mark and from how many points on, steps = { 5 = 85, 4 = 70 }")
            self.fault(("mark", "steps"), says)
            return None
        found = []
        for name in value:
            path = ("mark", "steps", name)
            least = self.number(value, path, 0, int(WHOLE))
            if not _is_mark(name):
                self.fault(path, said("a mark has at most {most} letters", most=LONGEST))
            if least is not None:
                found.append((name, least))
        found.sort(key=lambda one: -one[1])
        for (name, least), (other, beside) in pairwise(found):
            if least == beside:
                says = said("{other} begins with as many points", other=other)
                self.fault(("mark", "steps", name), says)
        return tuple(found)

    def plans(self, table: dict[str, Any]) -> tuple[str, ...] | None:
        """Return the plans that are asked for, as they are typed."""
        value = table.get("plans")
        if value is None:
            return None
        if not isinstance(value, list) or not 0 < len(value) <= MOST or not _texts(value):
            says = said('name plans as readings do, plans = ["velocities", "accelerations"]')
            self.fault(("asked", "plans"), says)
            return None
        return tuple(dict.fromkeys(" ".join(one.split()) for one in value))


def _is_mark(value: object) -> bool:
    fine = isinstance(value, str) and 0 < len(value.strip()) <= LONGEST
    return fine and str(value).isprintable()


def _texts(value: Iterable[object]) -> bool:
    return all(isinstance(one, str) and one.strip() for one in value)
