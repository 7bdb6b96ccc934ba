"""Where a step of the student may be said to stand: the segments and points that it gives."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from support.students.records import F, P, Step, V

Place = tuple[str, str]
"""A plan and a segment or letter."""
ENDS = {
    "an2": {"n2"}, "πn3": {"n3"}, "cn4": {"n4"}, "ak2": {"k2"},
    "pa": {"a", "vA"}, "πa": {"a", "aA"}, "Mi2": {"J2"}, "M_sum": {"ΣM2", "R01"},
    "V": {"HV"}, "a": {"Ha"}, "S": {"V"}, "φ": {"dS", "ddS"},
}  # fmt: skip
"""Where calculated segments end, and what else a calculation of them is called."""
POLYGON = ("R12", "R03", "R23", "R12t", "R12n")
"""What is read of the polygon of forces, which closes at one corner."""


def own_places(step: Step) -> set[Place]:
    """Return where a step may be said to stand: its name, the points and segments that it gives."""
    names = {step.name, step.takes.get("letter", step.name), *ENDS.get(step.name, ())}
    if step.kind == "image":
        names.add(("p" if step.plan == V else "π") + step.name)
    if step.plan == P:
        names |= {step.takes[role] for role in ("by", "about", "length") if role in step.takes}
    if step.plan == F:
        names.add(step.name.split()[-1])
        names |= set(POLYGON) if step.name[:1] in "MRy" or step.name[:2] == "Pi" else set()
        names |= {"P_bal_lever"} if step.name.startswith("lever") else set()
    if step.kind == "rate" and step.takes["of"] in ("pa3", "n3a3"):
        names |= {f"{step.name[:-1]}{k}" for k in (2, 3)}  # the stone turns with the rocker
    found = {(step.plan, name) for name in names}
    # which way it points is seen from the relative velocity alone
    return found | ({(V, "aa3")} if (step.kind, step.name) == ("laid", "ak2") else set())


def taking_given(steps: Iterable[Step], given: Mapping[str, Any]) -> set[Place]:
    """Return the places of the steps that take a given; anywhere if none tells."""
    at = [own_places(step) for step in steps if not given.keys().isdisjoint(named(step))]
    return set().union(*at) if at else {("", "")}


def named(step: Step) -> set[str]:
    """Return the names that a step takes."""
    return {value for value in step.takes.values() if isinstance(value, str)}
