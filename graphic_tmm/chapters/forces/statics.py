"""A group detached: tangential components from moments, then the polygon; last the driving link."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure, measure_along, meet, square
from graphic_tmm.board.operations.statics import place_of, tangential
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import (
    Chain,
    Detached,
    Pair,
    Parted,
    Polygon,
    Reaction,
    Side,
    Solution,
)
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force
from graphic_tmm.chapters.forces.special import Special, solve_special
from graphic_tmm.chapters.forces.unknowns import (
    Hinged,
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
    last_legs,
)
from graphic_tmm.mechanism.groups import Pair as KinematicPair


class Solved(NamedTuple):
    """A group as solved: its reactions (outer ones by leg, then the inner), its polygon.

    ``hinged``: its legs in the order in which moments about their inner ends are taken. ``turning``: the sum of
    moments that the outer pair of a link has to balance; ``tangents``: by link, the component of the outer
    reaction that does (N) and its arm (Length). ``figure``: the group as detached. ``rods``: by rod, the ends
    of the vector whose part along it drives it out. ``special``: the special point of a plate on three legs,
    or of two plates.
    """

    closing: AnyClosing
    reactions: tuple[Reaction, ...]
    polygon: Polygon
    hinged: tuple[Hinged, ...]
    turning: dict[int, Mark | None]
    tangents: dict[int, Tangent]
    figure: Detached
    rods: dict[int, tuple[Mark, Mark]]
    special: Special | None = None

    @property
    def pairs(self) -> tuple[KinematicPair, ...]:
        """The pairs in which its reactions act, in their order."""
        return (*(leg.pair for leg in self.closing.group.legs), *self.closing.group.inner_pairs)


def inside(closing: AnyClosing) -> tuple[Pair, ...]:
    """Return the links that its inner pairs join: in each the one that pushes, and the one that is pushed."""
    ends = {leg.link: links_of(leg)[-1] for leg in closing.legs}
    return tuple((ends.get(one, one), ends.get(two, two)) for one, two in closing.group.inside)


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

    Two plates are solved like two links; then the polygon of the first parts what the links do that join them.
    ``rough``: friction is called for, so the normal parts of sliding pairs are wanted.
    """
    first, second = last_legs(closing)
    draft = figure.draft
    draft.open(figure.view)
    turning, tangents = dict[int, Mark | None](), dict[int, Tangent]()
    hinged = tuple(Hinged(k, closing.pin(k), summed_links(closing, k)) for k in closing.arms)
    _balance(figure, acting, hinged, turning, tangents)
    third = [leg for leg in closing.legs if leg not in (first, second)]
    special, plates = solve_special(figure, closing, acting, slopes, turning, tangents)
    _balance(figure, acting, plates, turning, tangents)
    if plates:
        first, second = (one.leg for one in plates)
    hinged += plates
    chain = of.begin(draft)
    start = chain.end
    _across(chain, first, tangents)
    loads = chain.end
    halves = [_lay_loads(chain, acting, links_of(first))]
    middle, before = chain.end, len(chain.sides)
    found = dict[int, _Stands]()
    if special is not None and third:
        _lay_loads(chain, acting, closing.group.rest)
        found[third[0].link], special = _third(chain, acting, third[0], tangents, special)
    joining = closing.arms if plates else ()
    ends = [_lay_loads(chain, acting, (one.link,)) for one in joining[::-1]]
    behind = chain.end
    halves.append(_lay_loads(chain, acting, links_of(second)[::-1]))
    loaded = chain.end
    _across(chain, second, tangents)
    lines = [
        unknown_line(draft, first, middle if first.inner else start, slopes, tangents),
        unknown_line(draft, second, behind if second.inner else chain.end, slopes, tangents),
    ]
    top = draft.draw(meet, str(chain.count + 1), lines[1], lines[0], why=why.POLYGON_CLOSES)
    found[first.link] = _Stands((top, loads), (top, middle), halves[0])
    found[second.link] = _Stands((loaded, top), (behind, top), halves[1])
    letters = [closing_letter(leg, tangents) for leg in (first, second)]
    sides = (*chain.sides, (letters[1], chain.end, top), (letters[0], top, start))
    parted = None
    if joining:
        parts = _part(chain, joining, acting, tangents, (top, middle, ends[0]), found)
        parted = Parted((sides[-1], *sides[:before]), *parts)
    reactions = _read(figure, closing, found, turning, joining, rough=rough)
    drawn = Polygon(figure.of, chain.mu, sides, parted)
    rods = _rods(closing, found, second)
    return Solved(closing, reactions, drawn, hinged, turning, tangents, figure, rods, special)


def _part(
    chain: Chain,
    joining: tuple[ClosingLeg, ...],
    acting: Acting,
    tangents: dict[int, Tangent],
    ends: tuple[Mark, Mark, Mark],
    found: dict[int, _Stands],
) -> tuple[tuple[Side, ...], tuple[Side, ...]]:
    """Part what the first plate does to the links that join it to the second; return the sides that do so.

    Then those of the loads of the first link, carried to where it is parted.

    ``ends``: of all that it does to both, and where the loads of the second link end; ``found``: where the
    links stand is entered.
    """
    draft, (first, second), (top, middle, behind) = chain.draft, joining, ends
    known, lines = Chain(draft, chain.mu, top, chain.count), list[Mark]()
    corners = list[Mark]()
    for leg, end in ((first, top), (second, middle)):
        known.end = end
        _across(known, leg, tangents, back=leg == second)
        corners.append(known.end)
        lines.append(unknown_line(draft, leg, known.end, {}, tangents))
    at = draft.draw(meet, str(known.count + 1), *lines, why=why.PLATE_CLOSES)
    carried = Chain(draft, chain.mu, at, known.count)
    _lay_loads(carried, acting, (first.link,))
    found[first.link] = _Stands((top, at), (top, carried.end), at)
    found[second.link] = _Stands((at, middle), (at, behind), middle)
    letters = [closing_letter(leg, tangents) for leg in (first, second)]
    parts = (letters[0], corners[0], at), (letters[1], at, corners[1])
    return (*known.sides, *parts), tuple(carried.sides)


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
    """Lay off what holds the third leg of a plate, and its loads behind.

    Of a leg that slides along the plate it is what that does to the plate: with its loads what holds it gives
    the same.
    """
    start = chain.end
    half = _lay_loads(chain, acting, links_of(leg)) if leg.inner else start
    chain.end = start
    _across(chain, leg, tangents)
    corner, third = chain.end, special.third
    assert third is not None
    chain.add(third.given.letter, third.line, third.given.value)
    held, outer = chain.end, start
    if leg.inner:
        outer = half
        chain.sides[-1] = closing_letter(leg, tangents), half, held
    else:
        half = _lay_loads(chain, acting, links_of(leg))
    given = third.given._replace(side=(corner, held))
    special = special._replace(third=third._replace(given=given))
    return _Stands((outer, held), (start, chain.end), half), special


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
    if isinstance(closing, Closing) and closing.group.inner.kind == "P" and not leg.inner:
        first, second = closing.legs
        return first.link, second.link
    return links_of(leg)


def _balance(
    figure: Detached,
    acting: Acting,
    hinged: tuple[Hinged, ...],
    turning: dict[int, Mark | None],
    tangents: dict[int, Tangent],
) -> None:
    """Enter the moments of legs about their inner ends; of those that turn the tangential components too."""
    for leg, pin, links, borne in hinged:
        forces = [force for link in links for force in acting.forces.get(link, [])]
        couples = [couple for link in links for couple in acting.couples.get(link, [])]
        turning[leg.link] = figure.sum(pin, [*forces, *borne], couples, f"ΣM_{leg.link}")
    for leg, pin, *_ in hinged:
        total = turning[leg.link]
        if isinstance(leg, PinLeg) and total is not None:
            letter = f"R_{{{leg.body}{links_of(leg)[0]}}}^{{t}}"
            reach = figure.length(leg.pivot, pin)
            uses = (total, reach, figure.mu)
            value = figure.draft.draw(tangential, letter, *uses, unit="N")
            tangents[leg.link] = Tangent(letter, value, reach)


def _across(
    chain: Chain, leg: ClosingLeg, tangents: dict[int, Tangent], *, back: bool = False
) -> None:
    """Lay a tangential component off, if a leg has one: square to the leg; ``back``: so that it ends there."""
    if leg.link in tangents:
        found = tangents[leg.link]
        chain.add_across(found.letter, leg.line, found.value, back=back)
        tangents[leg.link] = found._replace(side=chain.sides[-1][1:])


def _read(
    figure: Detached,
    closing: AnyClosing,
    found: dict[int, _Stands],
    turning: dict[int, Mark | None],
    joining: tuple[ClosingLeg, ...],
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
    inner = [(leg, found[leg.link].inner) for leg in closing.legs]
    if joining:
        stands = [(leg, found[leg.link]) for leg in joining]
        inner = [(leg, ends) for leg, one in stands for ends in (one.outer, one.inner)]
    for (leg, ends), pair, links in zip(
        inner, closing.group.inner_pairs, inside(closing), strict=False
    ):
        slides = pair.kind == "P"
        guide, couple = (leg.line if rough else None, turning[leg.link]) if slides else (None, None)
        reactions.append(reaction_of(figure, links, ends, guide, couple))
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
