"""A wheel detached: the tooth's force by moments about its centre and by the pressure angle, then its pin's."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces.detached import Detached, Polygon, Reaction, Solution
from graphic_tmm.chapters.forces.loads import Acting, Force
from graphic_tmm.chapters.forces.operations import tooth_across, tooth_inwards, tooth_outwards
from graphic_tmm.chapters.forces.statics import reaction_of
from graphic_tmm.chapters.forces.unknowns import Tangent
from graphic_tmm.chapters.kinematics.bodies import Meshed
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said

BELT_PULLS = said(
    "The wheel is in equilibrium about its centre: the pulling run of the belt or chain, at the radius "
    "{length}, has the moment that all other moments leave open; the slack one is taken to pull nothing."
)


class SolvedWheel(NamedTuple):
    """A wheel as solved: the force of the other tooth and the reaction of its pin, its polygon.

    ``total``: the sum of moments about its centre that the tooth balances; ``parts``: of the tooth's force,
    along the common tangent and along the line of centres; of a belt its pull.
    """

    wheel: Meshed
    reactions: tuple[Reaction, Reaction]
    polygon: Polygon
    total: Mark
    parts: tuple[Tangent, ...]
    figure: Detached

    @property
    def links(self) -> tuple[int, ...]:
        """Its link."""
        return (self.wheel.leg.link,)


def refuse_friction(wheels: tuple[Meshed, ...]) -> None:
    """Refuse friction where wheels on links are in mesh."""
    if wheels:
        raise StructureError(
            said(
                "friction is drawn in pins and guides, not between the teeth of wheels on links, nor in belts: "
                "leave [friction] out"
            ),
            "effects.friction",
            "friction",
            head="friction",
        )


def solve_wheel(figure: Detached, wheel: Meshed, acting: Acting, of: Solution) -> SolvedWheel:
    """Solve a wheel: what turns it about its centre is held by the tooth, all that acts then by its pin."""
    draft, leg, rolling = figure.draft, wheel.leg, wheel.rolling
    link, on = leg.link, rolling.on
    draft.open(figure.view)
    forces, couples = acting.forces.get(link, []), acting.couples.get(link, [])
    total = figure.sum(leg.pivot, forces, couples, f"ΣM_{link}")
    if total is None:
        total = draft.take(Number, f"ΣM_{link}", 0.0, "N·m")
    radius = figure.length(leg.pivot, wheel.pitch)
    across, along = (f"R_{{{on}{link}}}^{{{part}}}" for part in "tr")
    because = BELT_PULLS if wheel.span else ""
    value = draft.draw(tooth_across, across, total, radius, figure.mu, unit="N", why=because)
    radial = None
    if not wheel.span:
        pressing = tooth_outwards if rolling.ring else tooth_inwards
        alpha = draft.angle("α_w", rolling.mesh.pressure)
        radial = draft.draw(pressing, along, value, alpha, unit="N")
    chain = of.begin(draft)
    start = chain.end
    chain.add_across(across, leg.line, value)
    corner = chain.end
    parts = [Tangent(across, value, radius, (start, corner))]
    if radial:
        chain.add(along, leg.line, radial)
        parts.append(Tangent(along, radial, radius, (corner, chain.end)))
    meshed = chain.end
    for force in forces:
        chain.add(force.letter, force.line, force.value)
    tooth = reaction_of(figure, (on, link), (start, meshed), None, None)
    pin = reaction_of(figure, (leg.body, link), (chain.end, start), None, None)
    polygon = Polygon(of, chain.mu, (*chain.sides, (pin.letter, pin.tail, pin.head)))
    return SolvedWheel(wheel, (tooth, pin), polygon, total, tuple(parts), figure)


def hand_on_wheel(
    solved: SolvedWheel, acting: Acting, frame: int, figure_of: Callable[[int], Detached]
) -> None:
    """Enter the force of a wheel's tooth and of its pin, reversed, as loads of what bears them."""
    wheel = solved.wheel
    for reaction, point in zip(solved.reactions, (wheel.far, wheel.leg.pivot), strict=True):
        body, link = reaction.links
        if body == frame:
            continue
        letter = f"R_{{{link}{body}}}"
        line = figure_of(body).act(letter, point, reaction.head, reaction.tail)
        acting.add(Force(letter, body, point, line, reaction.value))
