"""A group detached: tangential components from moments, then the polygon; last the driving link."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure, measure_along, meet, square
from graphic_tmm.board.operations.statics import place_of, tangential
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Chain, Detached, Pair, Polygon, Reaction, Solution
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force
from graphic_tmm.chapters.forces.special import Special, solve_third
from graphic_tmm.chapters.forces.unknowns import (
    Slopes,
    Tangent,
    closing_letter,
    links_of,
    unknown_line,
)
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    Closing,
    ClosingLeg,
    GuideLeg,
    PinLeg,
)
from graphic_tmm.mechanism.groups import Pair as KinematicPair


class Solved(NamedTuple):
    """A group as solved: its reactions (outer ones by leg, then the inner), its polygon.

    ``turning``: the sum of moments about its inner pin that the outer pair of a link has to balance;
    ``tangents``: by link, the component of the outer reaction that does (N) and its arm (Length). ``figure``:
    the group as detached. ``rods``: by rod, the ends of the vector whose part along it drives it out.
    ``special``: of a plate on three legs, what moments about its special point give.
    """

    closing: AnyClosing
    reactions: tuple[Reaction, ...]
    polygon: Polygon
    turning: dict[int, Mark | None]
    tangents: dict[int, Tangent]
    figure: Detached
    rods: dict[int, tuple[Mark, Mark]]
    special: Special | None = None

    @property
    def pairs(self) -> tuple[KinematicPair, ...]:
        """The pairs in which its reactions act, in their order."""
        return (*(leg.pair for leg in self.closing.group.legs), *inner_pairs(self.closing))


def inner_pairs(closing: AnyClosing) -> tuple[KinematicPair, ...]:
    """Return the inner pairs of a group: that of both links, or of a plate with each of its legs."""
    return (closing.group.inner,) if isinstance(closing, Closing) else closing.group.inner


def inside(closing: AnyClosing) -> tuple[Pair, ...]:
    """Return the links that its inner pairs join: in each the one that pushes, and the one that is pushed."""
    ends = [links_of(leg)[-1] for leg in closing.legs]
    if isinstance(closing, Closing):
        return ((ends[0], ends[1]),)
    return tuple((end, closing.group.plate) for end in ends)


def last_legs(closing: AnyClosing) -> tuple[ClosingLeg, ClosingLeg]:
    """Return the legs whose unknown sides close a polygon: that of the first leg is its last."""
    return closing.legs if isinstance(closing, Closing) else closing.crossing


class _Stands(NamedTuple):
    """Where a leg stands in a polygon: vectors of what holds it, and of what it does to what it carries.

    ``half``: where the loads of its outer link end.
    """

    outer: tuple[Mark, Mark]
    inner: tuple[Mark, Mark]
    half: Mark


def solve_group(
    figure: Detached,
    closing: AnyClosing,
    acting: Acting,
    of: Solution,
    slopes: Slopes,
    *,
    rough: bool,
) -> Solved:
    """Solve a group: of two links, or a plate on three legs, of which the third stands beside its loads.

    ``rough``: friction is called for, so the normal parts of sliding pairs are wanted.
    """
    first, second = last_legs(closing)
    draft = figure.draft
    draft.open(figure.view)
    turning: dict[int, Mark | None] = {}
    for leg in closing.legs:
        turning[leg.link] = _moments_of(figure, closing, acting, leg, f"ΣM_{leg.link}")
    tangents = _tangents(figure, closing, turning)
    special = None
    if not isinstance(closing, Closing):
        special = solve_third(figure, closing, acting, slopes, turning, tangents)
    chain = of.begin(draft)
    start = chain.end
    _across(chain, first, tangents)
    loads = chain.end
    halves = [_lay_loads(chain, acting, links_of(first))]
    middle = chain.end
    found = dict[int, _Stands]()
    if not isinstance(closing, Closing) and special is not None:
        _lay_loads(chain, acting, (closing.group.plate,))
        found[closing.third.link], special = _third(chain, acting, closing.third, tangents, special)
    behind = chain.end
    halves.append(_lay_loads(chain, acting, links_of(second)[::-1]))
    loaded = chain.end
    _across(chain, second, tangents)
    held = isinstance(first, GuideLeg) and first.inner
    lines = [
        unknown_line(draft, first, middle if held else start, slopes, tangents),
        unknown_line(draft, second, chain.end, slopes, tangents),
    ]
    top = draft.draw(meet, str(chain.count + 1), lines[1], lines[0], why=why.POLYGON_CLOSES)
    found[first.link] = _Stands((top, loads), (top, middle), halves[0])
    found[second.link] = _Stands((loaded, top), (behind, top), halves[1])
    letters = [closing_letter(leg, tangents) for leg in (first, second)]
    sides = (*chain.sides, (letters[1], chain.end, top), (letters[0], top, start))
    reactions = _read(figure, closing, found, turning, rough=rough)
    drawn = Polygon(figure.of, chain.mu, sides)
    rods = _rods(closing, found, second)
    return Solved(closing, reactions, drawn, turning, tangents, figure, rods, special)


def _lay_loads(chain: Chain, acting: Acting, links: tuple[int, ...]) -> Mark:
    """Lay off the loads of a leg, link by link; return where those of its first link end."""
    ends = []
    for link in links:
        for force in acting.forces.get(link, []):
            chain.add(force.letter, force.line, force.value)
        ends.append(chain.end)
    return ends[0]


def _third(
    chain: Chain,
    acting: Acting,
    leg: ClosingLeg,
    tangents: dict[int, Tangent],
    special: Special,
) -> tuple[_Stands, Special]:
    """Lay off what holds the third leg of a plate, and its loads behind."""
    start = chain.end
    _across(chain, leg, tangents)
    corner, third = chain.end, special.third
    chain.add(third.letter, special.line, third.value)
    held = chain.end
    half = _lay_loads(chain, acting, links_of(leg))
    special = special._replace(third=third._replace(side=(corner, held)))
    return _Stands((start, held), (start, chain.end), half), special


def _rods(
    closing: AnyClosing, found: dict[int, _Stands], second: ClosingLeg
) -> dict[int, tuple[Mark, Mark]]:
    """Return, by rod, ends of the vector whose part along the leg is the force that drives it out.

    It goes against what else acts on the rod. In the polygon the loads of the link at the inner pin stand
    beside what the leg carries, those of the other one beside the reaction of what holds the leg.
    """
    rods = {}
    for leg in closing.legs:
        if isinstance(leg, PinLeg) and leg.rod:
            stands = found[leg.link]
            behind = leg == second
            rods[leg.rod] = (
                (stands.half, stands.outer[1]) if behind else (stands.outer[0], stands.half)
            )
    return rods


def summed_links(closing: AnyClosing, leg: ClosingLeg) -> tuple[int, ...]:
    """Return the links whose moments about its inner pin the outer pair of a leg has to balance.

    Through an inner sliding pair they are passed on, so that it balances those of both links.
    """
    held = isinstance(leg, GuideLeg) and leg.inner
    if isinstance(closing, Closing) and closing.group.inner.kind == "P" and not held:
        first, second = closing.legs
        return first.link, second.link
    return links_of(leg)


def _moments_of(
    figure: Detached, closing: AnyClosing, acting: Acting, leg: ClosingLeg, letter: str
) -> Mark | None:
    links = summed_links(closing, leg)
    forces = [force for link in links for force in acting.forces.get(link, [])]
    couples = [couple for link in links for couple in acting.couples.get(link, [])]
    return figure.sum(closing.pin(leg), forces, couples, letter)


def _tangents(
    figure: Detached, closing: AnyClosing, turning: dict[int, Mark | None]
) -> dict[int, Tangent]:
    """Calculate the tangential components of the turning legs, where there is a moment to balance."""
    found = {}
    for leg in closing.legs:
        total = turning[leg.link]
        if isinstance(leg, PinLeg) and total is not None:
            letter = f"R_{{{leg.body}{links_of(leg)[0]}}}^{{t}}"
            reach = figure.length(leg.pivot, closing.pin(leg))
            uses = (total, reach, figure.mu)
            value = figure.draft.draw(tangential, letter, *uses, unit="N")
            found[leg.link] = Tangent(letter, value, reach)
    return found


def _across(chain: Chain, leg: ClosingLeg, tangents: dict[int, Tangent]) -> None:
    """Lay a tangential component off, if a leg has one: square to the leg."""
    if leg.link in tangents:
        start, found = chain.end, tangents[leg.link]
        chain.add_across(found.letter, leg.line, found.value)
        tangents[leg.link] = found._replace(side=(start, chain.end))


def _read(
    figure: Detached,
    closing: AnyClosing,
    found: dict[int, _Stands],
    turning: dict[int, Mark | None],
    *,
    rough: bool,
) -> tuple[Reaction, ...]:
    """Measure the reactions: what holds the legs, and what acts in the inner pairs."""
    reactions = []
    for leg in closing.legs:
        slides = isinstance(leg, GuideLeg) and not leg.inner
        guide = leg.line if slides and rough else None
        couple = turning[leg.link] if slides else None
        held = leg.body, links_of(leg)[0]
        reactions.append(reaction_of(figure, held, found[leg.link].outer, guide, couple))
    for leg, pair, links in zip(closing.legs, inner_pairs(closing), inside(closing), strict=False):
        slides = pair.kind == "P"
        guide, couple = (leg.line if rough else None, turning[leg.link]) if slides else (None, None)
        reactions.append(reaction_of(figure, links, found[leg.link].inner, guide, couple))
    return tuple(reactions)


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
