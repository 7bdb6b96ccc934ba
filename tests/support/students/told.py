"""What a finding of the check tells, in the student's words: where, of which family, in which position.

A finding names the first reading that shows a mistake, its sentence the step. Lines stand in brackets, the
views of forces are the student's plan of forces, their ordinates his forces.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from graphic_tmm.checking.records import Likely
from support.students.places import Place
from support.students.records import CAM, A, D, F, P, V

VIEWS = ("loads", "group", "forces", "link", "lever", "couples")
TITLES = {
    "Velocity plan": V, "Acceleration plan": A, "Plan of positions": P, "Loads": F, "Group": F,
    "Force polygon": F, "Link": F, "Zhukovsky": F, "Displacement diagram": D, "Velocity diagram": D,
    "Acceleration diagram": D, "Diagram of": CAM, "Displacement of": CAM, "Pressure angle": CAM,
    "Region of": CAM,
}  # fmt: skip
DRAWN = {"Diagram of dS/dφ": "dS", "Diagram of d²S/dφ²": "ddS", "Pressure angle": "pressure"}
"""Diagrams of the cam, by the ordinates that are read of them."""
MET = "of two meetings the other one was marked for "
SAYS = {
    "left out": "left out", "sense": "opposite sense", "meeting": "meetings", "start": "drawn from",
    "previous": "position before", "factor": "times as large", "power": "was calculated as",
    "given": "which is given", "direction": "parallel to|square to", "table": "readings of",
    "crank": "crank", "wrong end": "other end|wrong end", "operand": "instead of",
}  # fmt: skip
"""By which words of a sentence its family is known, for names that no reading tells apart from the first."""


class Told(NamedTuple):
    """One name of a mistake: its kind and family, the places it may mean, its position, its sentence."""

    kind: str
    family: str
    places: frozenset[Place]
    position: str
    says: str


def alternatives(found: Likely) -> list[Told]:
    """Return what a finding tells: its own name and those that no reading tells apart from it."""
    own = Told(
        found.kind, found.family, places_of(found) | step_in(found.says), found.position, found.says
    )
    return [own, *(_like(found, says) for says in found.like)]


def _like(found: Likely, says: str) -> Told:
    family = next((name for name, words in SAYS.items() if re.search(words, says)), "")
    return Told(found.kind, family, step_in(says), found.position, says)


def places_of(found: Likely) -> frozenset[Place]:
    """Return the places that a finding's fields tell."""
    first = found.plan.split()[:1]
    plan = F if first and first[0] in VIEWS else D if first == ["diagram"] else found.plan
    return frozenset(
        (plan, short) for name in (found.segment, found.step) if name for short in shorter(name)
    )


def step_in(says: str) -> frozenset[Place]:
    """Return the place of the step that a sentence names, or of the given."""
    given = re.search(r"(\S+), which is given", says)
    if given:
        return frozenset(("", name) for name in shorter(given[1]))
    named = re.search(rf"([A-Z][^:]*), step \d+: (?:{MET})?(\S+)", says)
    if not named:
        return frozenset()
    plans = [plan for title, plan in TITLES.items() if title in named[1]]
    names = shorter(named[2]) | {name for title, name in DRAWN.items() if title in named[1]}
    return frozenset((plan, name) for plan in plans[:1] for name in names)


def shorter(name: str) -> set[str]:
    """Return a name as the student has it: (n2b) is n2b, y_Pi2 the force Pi2, l_AS2 the length AS2."""
    plain = name.strip("(),").replace("_", "")
    names = {plain, name.strip("(),")}
    if re.match("[ylh][A-Z]", plain):
        names.add(plain[1:])
    return names | {inner.replace("_", "") for inner in re.findall(r"\(([^()]+)\)", name)}
