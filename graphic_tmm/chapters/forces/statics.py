"""A group detached: tangential components from moments, then the polygon; last the driving link."""

from __future__ import annotations

from collections.abc import Callable, Container
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure, measure_along, meet, parallel, square
from graphic_tmm.board.operations.statics import (
    at_friction_angle,
    place_of,
    tangential,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Chain, Detached, Pair, Polygon, Reaction, Solution
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force
from graphic_tmm.chapters.kinematics.closings import (
    Closing,
    ClosingLeg,
    GuideLeg,
    PinLeg,
    unheld,
)


class Slope(NamedTuple):
    """How a sliding pair's reaction leans off the normal: f, the normal part in the pass before, the speed.

    ``normal`` and ``segment`` are those of the first link of the pair against the second; ``pin``: the crank
    pin's speed on the same plan.
    """

    f: Mark
    normal: Mark
    segment: Mark
    pin: Mark


class Solved(NamedTuple):
    """A group as solved: its reactions (outer ones by leg, then the inner), its polygon.

    ``turning``: the sum of moments about the closing point that the outer pair of a link has to balance;
    ``tangents``: by link, the component of the outer reaction that does (N) and its arm (Length). ``figure``:
    the group as detached. ``rods``: by rod, the ends of the vector whose part along it drives it out.
    """

    closing: Closing
    reactions: tuple[Reaction, Reaction, Reaction]
    polygon: Polygon
    turning: dict[int, Mark | None]
    tangents: dict[int, Tangent]
    figure: Detached
    rods: dict[int, tuple[Mark, Mark]]


class Tangent(NamedTuple):
    """A tangential component: its letter, its value (N), its arm about the closing point (Length).

    ``side``: the ends of its side of the polygon.
    """

    letter: str
    value: Mark
    arm: Mark
    side: tuple[Mark, Mark] | None = None


def solve_group(
    figure: Detached,
    closing: Closing,
    acting: Acting,
    of: Solution,
    slopes: dict[Pair, Slope],
    *,
    rough: bool,
) -> Solved:
    """Solve a group.

    ``slopes``: friction along guides by pair (link, body); of the inner guide by (link 3, link 2).
    ``rough``: friction is called for, so the normal parts of sliding pairs are wanted.
    """
    first, second = closing.legs
    draft = figure.draft
    draft.open(figure.view)
    turning: dict[int, Mark | None] = {}
    for leg in closing.legs:
        links = summed_links(closing, leg)
        turning[leg.link] = _moments_of(figure, closing, acting, links, f"ΣM_{leg.link}")
    tangents = _tangents(figure, closing, turning)
    chain = of.begin(draft)
    start = chain.end
    if first.link in tangents and isinstance(first, PinLeg):
        tangents[first.link] = _across(chain, first, tangents[first.link])
    loads = chain.end
    halves = [_lay_loads(chain, acting, links_of(first))]
    middle = chain.end
    halves.append(_lay_loads(chain, acting, links_of(second)[::-1]))
    loaded = chain.end
    if second.link in tangents and isinstance(second, PinLeg):
        tangents[second.link] = _across(chain, second, tangents[second.link])
    held = isinstance(first, GuideLeg) and first.inner
    lines = [
        _unknown(draft, first, middle if held else start, slopes, tangents),
        _unknown(draft, second, chain.end, slopes, tangents),
    ]
    top = draft.draw(meet, str(chain.count + 1), lines[1], lines[0], why=why.POLYGON_CLOSES)
    corners = _Corners(start, loads, middle, loaded, chain.end, top)
    solved = _read(figure, closing, chain, corners, (turning, tangents), rough=rough)
    return solved._replace(rods=_rods(closing, halves, top))


def links_of(leg: ClosingLeg) -> tuple[int, ...]:
    """Return the links of a leg, from what holds it to the closing point: a cylinder and its rod are two."""
    return leg.links if isinstance(leg, PinLeg) else (leg.link,)


def _lay_loads(chain: Chain, acting: Acting, links: tuple[int, ...]) -> Mark:
    """Lay off the loads of a leg, link by link; return where those of its first link end."""
    ends = []
    for link in links:
        for force in acting.forces.get(link, []):
            chain.add(force.letter, force.line, force.value)
        ends.append(chain.end)
    return ends[0]


def _rods(closing: Closing, halves: list[Mark], top: Mark) -> dict[int, tuple[Mark, Mark]]:
    """Return, by rod, ends of the vector whose part along the leg is the force that drives it out.

    It goes against what else acts on the rod. In the polygon the loads of the link at the closing point stand
    beside its reaction, those of the other one beside the reaction of what holds the leg.
    """
    found = {}
    for k, (leg, half) in enumerate(zip(closing.legs, halves, strict=True)):
        if isinstance(leg, PinLeg) and leg.rod:
            found[leg.rod] = (top, half) if k == 0 else (half, top)
    return found


def summed_links(closing: Closing, leg: ClosingLeg) -> tuple[int, ...]:
    """Return the links whose moments about the closing point the outer pair of a leg has to balance.

    Through an inner sliding pair they are passed on, so that it balances those of both links.
    """
    first, second = closing.legs
    held = isinstance(leg, GuideLeg) and leg.inner
    if closing.group.inner.kind == "P" and not held:
        return first.link, second.link
    return links_of(leg)


def _moments_of(
    figure: Detached, closing: Closing, acting: Acting, links: tuple[int, ...], letter: str
) -> Mark | None:
    forces = [force for link in links for force in acting.forces.get(link, [])]
    couples = [couple for link in links for couple in acting.couples.get(link, [])]
    return figure.sum(closing.point, forces, couples, letter)


def _tangents(
    figure: Detached, closing: Closing, turning: dict[int, Mark | None]
) -> dict[int, Tangent]:
    """Calculate the tangential components of the turning legs, where there is a moment to balance."""
    found = {}
    for leg in closing.legs:
        total = turning[leg.link]
        if isinstance(leg, PinLeg) and total is not None:
            letter = f"R_{{{leg.body}{links_of(leg)[0]}}}^{{t}}"
            reach = figure.length(leg.pivot, closing.point)
            uses = (total, reach, figure.mu)
            value = figure.draft.draw(tangential, letter, *uses, unit="N")
            found[leg.link] = Tangent(letter, value, reach)
    return found


def _across(chain: Chain, leg: PinLeg, found: Tangent) -> Tangent:
    """Lay a tangential component off: square to its leg."""
    start = chain.end
    chain.add_across(found.letter, leg.line, found.value)
    return found._replace(side=(start, chain.end))


class _Corners(NamedTuple):
    """Vertices of a polygon: its beginning, before, between and behind the loads, its end, where lines met."""

    start: Mark
    loads: Mark
    middle: Mark
    loaded: Mark
    end: Mark
    top: Mark


def _closing(leg: ClosingLeg, tangents: Container[int]) -> str:
    """Return the letter of the side of a leg that closes a polygon; beside a tangential one it is normal."""
    return f"R_{{{leg.body}{links_of(leg)[0]}}}" + ("^{n}" if leg.link in tangents else "")


def _unknown(
    draft: Draft,
    leg: ClosingLeg,
    through: Mark,
    slopes: dict[Pair, Slope],
    tangents: Container[int],
) -> Mark:
    """Draw the line of an unknown force: along a link, or square to a guide but for the angle of friction."""
    match leg:
        case PinLeg():
            letter, along = f"({_closing(leg, tangents)})", leg.line
            return draft.draw(parallel, letter, through, along, sense=1, why=why.NORMAL_UNKNOWN)
        case GuideLeg():
            pair = _pair(leg)
            letter = f"(R_{{{pair[1]}{pair[0]}}})"
            if pair in slopes:
                return draft.draw(at_friction_angle, letter, through, leg.line, *slopes[pair])
            return draft.draw(square, letter, through, leg.line, sense=1, why=why.GUIDE_UNKNOWN)
        case _:
            unheld(leg, "forces")


def _pair(leg: GuideLeg) -> Pair:
    """Return whose reaction a guide's line shows: link and body; of the inner guide rocker and stone."""
    return (leg.on, leg.link) if leg.inner else (leg.link, leg.body)


def _read(
    figure: Detached,
    closing: Closing,
    chain: Chain,
    at: _Corners,
    sums: tuple[dict[int, Mark | None], dict[int, Tangent]],
    *,
    rough: bool,
) -> Solved:
    """Measure the reactions; close the polygon with the unknown sides.

    ``sums``: the moments that the outer pairs have to balance, the tangential components found of them.
    """
    turning, tangents = sums
    first, second = closing.legs
    inner = closing.group.inner.kind == "P"
    vectors = ((at.top, at.loads), (at.loaded, at.top))
    found = []
    for leg, vector in zip(closing.legs, vectors, strict=True):
        slides = isinstance(leg, GuideLeg) and not leg.inner
        guide = leg.line if slides and rough else None
        couple = turning[leg.link] if slides else None
        held = leg.body, links_of(leg)[0]
        found.append(reaction_of(figure, held, vector, guide, couple))
    guide, couple = (first.line if rough else None, turning[first.link]) if inner else (None, None)
    inside = links_of(first)[-1], links_of(second)[-1]
    between = reaction_of(figure, inside, (at.top, at.middle), guide, couple)
    letters = [_closing(leg, tangents) for leg in closing.legs]
    sides = (*chain.sides, (letters[1], at.end, at.top), (letters[0], at.top, at.start))
    drawn = Polygon(figure.of, chain.mu, sides)
    return Solved(closing, (found[0], found[1], between), drawn, turning, tangents, figure, {})


def reaction_of(
    figure: Detached,
    links: Pair,
    vector: tuple[Mark, Mark],
    guide: Mark | None,
    couple: Mark | None,
) -> Reaction:
    """Measure a reaction; ``guide``: to which its normal part is wanted; ``couple``: that it has to hold."""
    name, draft = f"{links[0]}{links[1]}", figure.draft
    length = draft.draw(measure, f"y_{{R{name}}}", *vector, why=why.REACTION_READ)
    value = draft.draw(in_si, f"R_{{{name}}}", length, unit="N")
    force, normal, place = value, None, None
    if guide is not None:
        across = draft.draw(
            square, f"(N_{{{name}}})", vector[0], guide, sense=1, why=why.NORMAL_PART
        )
        normal = draft.draw(measure_along, f"y_{{N{name}}}", *vector, across, why=why.NORMAL_PART)
        if couple is not None:
            force = draft.draw(in_si, f"N_{{{name}}}", normal, unit="N")
    if couple is not None:
        place = draft.draw(place_of, f"h_{{{name}}}", couple, force, figure.mu)
    held = None if place is None else (place, figure.mu)
    return Reaction(f"R_{{{name}}}", links, *vector, length, value, normal, held)


def hand_on(
    solved: Solved, acting: Acting, frame: int, figure_of: Callable[[int], Detached]
) -> None:
    """Enter the reactions of a group, reversed, as loads of the bodies that it is attached to.

    ``figure_of``: link -> the figure that shows it.
    """
    closing = solved.closing
    for leg, reaction in zip(closing.legs, solved.reactions, strict=False):
        if leg.body == frame:
            continue
        figure = figure_of(leg.body)
        point = closing.at(leg)
        letter = f"R_{{{links_of(leg)[0]}{leg.body}}}"
        line = figure.act(letter, point, reaction.head, reaction.tail)
        acting.add(Force(letter, leg.body, point, line, reaction.value))
        couple = solved.turning.get(leg.link)
        if isinstance(leg, GuideLeg) and not leg.inner and couple is not None:
            acting.add(Couple(f"M_{{{leg.link}{leg.body}}}", leg.body, couple))
