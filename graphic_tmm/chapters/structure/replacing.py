"""The replacing linkage: for each higher pair of wheels a link with two turning pairs.

Teeth press along the line of action, which the base circles touch in the points N: the centres of curvature of
both flanks. A link from one to the other, a pin in each wheel, moves both as the teeth do at that moment,
velocities and accelerations alike. Of a belt it is the run that pulls. Wheel and link are a group of class II,
kind 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import incline, meet, square
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.bodies import Meshed, Positions
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.structure import Structure
from graphic_tmm.mechanism.wheels import Rolling

TANGENT = said("Where they roll on each other both pitch circles have one tangent.")
ACTION = said("Teeth press along the line of action, at this angle to the common tangent.")
BASE = said(
    "The base circle touches the line of action where the square from its centre meets that."
)


class Replaced(NamedTuple):
    """A higher pair as it is replaced: centre and pin of the wheel, those of the one that it rolls on."""

    rolling: Rolling
    centre: Mark
    pin: Mark
    other: Mark
    far: Mark

    @property
    def name(self) -> str:
        """The group of the wheel and the link in place of the pair: "4-6"."""
        return f"{self.rolling.link}-{self.rolling.span}"

    @property
    def lines(self) -> Mapping[str, tuple[Mark, Mark]]:
        """By the number of a link, the line that it is: of both wheels, of what stands for their pair."""
        rolling = self.rolling
        return {
            str(rolling.on): (self.other, self.far),
            str(rolling.link): (self.centre, self.pin),
            str(rolling.span): (self.far, self.pin),
        }


def replace(draft: Draft, positions: Positions) -> Iterator[Replaced]:
    """Yield what replaces each higher pair; its points are drawn unless they are the ends of a belt."""
    taken = {letter for body in positions.bodies.values() for letter in body.link.points}
    for wheel in positions.wheels:
        rolling = wheel.rolling
        other = positions.bodies[rolling.arm].marks[rolling.other]
        ends = (wheel.pitch, wheel.far) if wheel.span else _on_action(draft, wheel, other, taken)
        yield Replaced(rolling, wheel.leg.pivot, ends[0], other, ends[1])


def _on_action(draft: Draft, wheel: Meshed, other: Mark, taken: set[str]) -> tuple[Mark, Mark]:
    """Draw the line of action, and where the base circles touch it: that of the wheel, that of the other."""
    rolling, letter = wheel.rolling, wheel.rolling.letter
    common = draft.draw(square, f"({letter}τ)", wheel.pitch, wheel.leg.line, sense=1, why=TANGENT)
    alpha = draft.angle("α_w", rolling.mesh.pressure)
    line = draft.draw(incline, f"({letter}N)", wheel.pitch, common, alpha, why=ACTION)
    found = list[Mark]()
    for at, link in ((wheel.leg.pivot, rolling.link), (other, rolling.on)):
        name = f"N{link}"
        while name in taken:
            name += "′"
        taken.add(name)
        out = draft.draw(square, f"({at.letter}{name})", at, line, sense=1, why=BASE)
        found.append(draft.draw(meet, name, out, line, why=BASE))
    return found[0], found[1]


def replaced_formula(structure: Structure) -> str:
    """Return the formula of structure of the replacing linkage."""
    names = {one.name: f"{one.name}-{one.span}" for one in structure.wheels}
    initial = ", ".join(f"I({one.name})" for one in structure.driven)
    groups = (
        one.formula.replace(one.name, names.get(one.name, one.name))
        if not isinstance(one, Rolling)
        else f"II({names.get(one.name, one.name)})"
        for one in structure.attached
    )
    return " → ".join([initial, *groups])
