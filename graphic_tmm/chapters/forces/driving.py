"""What drives, balanced: a crank, a slider by themselves; a rod out of its cylinder as its group stands."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure, measure_along, meet, parallel, square
from graphic_tmm.board.operations.statics import at_friction_angle, balancing, reversed_
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Detached, Polygon, Reaction, Side, Solution
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force
from graphic_tmm.chapters.forces.statics import Solved, reaction_of
from graphic_tmm.chapters.forces.unknowns import Slope, links_of
from graphic_tmm.chapters.forces.wheels import SolvedWheel
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said


class Alone(NamedTuple):
    """A driven link that stands by itself: its polygon, the frame's reaction, the figure of it detached.

    ``total``: the sum of moments (N·m) that its balance or its guide holds, None where there is none; ``arm``:
    of the balancing force (Length), None where none is needed; ``about``: the point that moments are taken
    about, where the frame's reaction acts.
    """

    polygon: Polygon
    reaction: Reaction
    figure: Detached
    total: Mark | None
    arm: Mark | None
    about: Mark


class RodForce(NamedTuple):
    """What drives a rod, on its group's polygon: its letter, its ends, its length (signed).

    It is drawn as it acts on the link at the closing point, rod or cylinder. ``rest``: the side square to the
    rod that both hold each other with; None where a side of the polygon lies along the rod already.
    """

    letter: str
    tail: Mark
    head: Mark
    length: Mark
    rest: Side | None

    @property
    def side(self) -> Side:
        """Its side."""
        return self.letter, self.tail, self.head


class Driven(NamedTuple):
    """A drive as solved: the balancing force (N) or moment (N·m), its letter, what it is on its link.

    ``alone``: of a link that stands by itself; ``rod``: of a rod, whose force is read off its group's polygon.
    """

    pair: DrivenPair
    letter: str
    balance: Mark
    force: Force | None
    couple: Couple | None
    alone: Alone | None
    rod: RodForce | None = None


class Place(NamedTuple):
    """Where drives are balanced: the plan of positions, the frame, which kind; friction along guides.

    ``driven``: the links of all drives.
    """

    draft: Draft
    positions: Positions
    frame: int
    kind: str
    driven: tuple[int, ...]
    tried: int | None
    slopes: dict[tuple[int, int], Slope]
    rough: bool

    def letter(self, symbol: str, link: int) -> str:
        """Return the letter of what balances a drive, with the pass of friction that it is of."""
        raised = "" if self.tried is None else f"^{{({self.tried})}}"
        return f"{symbol}_{{b{link}}}{raised}" if len(self.driven) > 1 else f"{symbol}_b{raised}"


def solve_crank(place: Place, figure: Detached, pair: DrivenPair, acting: Acting) -> Driven:
    """Balance a link that turns about a fixed pivot, by a force at its pin, square to it, or by a moment."""
    number, draft = pair.link, figure.draft
    body, (pivot, pin) = place.positions.bodies[number], pair.arm_ends(place.positions)
    draft.open(figure.view)
    forces, couples = acting.forces.get(number, []), acting.couples.get(number, [])
    total = figure.sum(pivot, forces, couples, f"ΣM_{number}")
    if total is None:
        total = draft.take(Number, f"ΣM_{number}", 0.0, "N·m")
    sides = [(force.letter, force.line, force.value) for force in forces]
    arm = figure.length(pivot, pin)
    force, couple = None, None
    if place.kind == "force":
        letter = place.letter("P", number)
        balance = draft.draw(balancing, letter, total, arm, figure.mu, unit="N")
        at, axis = figure.point(pin), body.axis
        line = draft.draw(square, f"({letter})", at, axis, sense=1, why=why.BALANCING_LINE)
        force = Force(letter, number, pin, line, balance)
        sides.append((letter, line, balance))
    else:
        letter = place.letter("M", number)
        balance = draft.draw(reversed_, letter, total, unit="N·m", why=why.BALANCING_MOMENT)
        couple = Couple(letter, number, balance)
    chain = Solution((number,), place.tried).begin(draft)
    start = chain.end
    for side in sides:
        chain.add(*side)
    end, frame = chain.end, place.frame
    name = f"R_{{{frame}{number}}}"
    length = draft.draw(measure, f"y_{{R{frame}{number}}}", end, start, why=why.CRANK_REACTION)
    value = draft.draw(in_si, name, length, unit="N")
    reaction = Reaction(name, (frame, number), end, start, length, value, value)
    of = Solution((number,), place.tried)
    polygon = Polygon(of, chain.mu, (*chain.sides, (name, end, start)))
    alone = Alone(polygon, reaction, figure, total, arm, pivot)
    return Driven(pair, letter, balance, force, couple, alone)


def solve_slider(place: Place, figure: Detached, pair: DrivenPair, acting: Acting) -> Driven:
    """Balance a link that slides on a fixed guide: by a force along it; the guide pushes square to itself."""
    _refuse_moment(place, pair)
    number, draft, frame = pair.link, figure.draft, place.frame
    _, pin = pair.led(place.positions)
    guide = pair.path(place.positions, draft.uses)
    draft.open(figure.view)
    forces, couples = acting.forces.get(number, []), acting.couples.get(number, [])
    total = figure.sum(pin, forces, couples, f"ΣM_{number}")
    letter = place.letter("P", number)
    at = figure.point(pin)
    line = draft.draw(parallel, f"({letter})", at, guide, sense=1, why=why.ALONG_GUIDE)
    of = Solution((number,), place.tried)
    chain = of.begin(draft)
    start = chain.end
    for force in forces:
        chain.add(force.letter, force.line, force.value)
    end, name = chain.end, f"R_{{{frame}{number}}}"
    along = draft.draw(parallel, f"({letter})", end, guide, sense=1, why=why.ALONG_GUIDE)
    slope = place.slopes.get((number, frame))
    across = (
        draft.draw(square, f"({name})", start, guide, sense=1, why=why.GUIDE_UNKNOWN)
        if slope is None
        else draft.draw(at_friction_angle, f"({name})", start, guide, *slope)
    )
    top = draft.draw(meet, str(chain.count + 1), along, across, why=why.POLYGON_CLOSES)
    length = draft.draw(measure_along, f"y_{{{letter}}}", end, top, along, why=why.REACTION_READ)
    balance = draft.draw(in_si, letter, length, unit="N")
    reaction = reaction_of(
        figure, (frame, number), (top, start), guide if place.rough else None, total
    )
    polygon = Polygon(of, chain.mu, (*chain.sides, (letter, end, top), (name, top, start)))
    alone = Alone(polygon, reaction, figure, total, None, pin)
    force = Force(letter, number, pin, line, balance)
    return Driven(pair, letter, balance, force, None, alone)


def read_rod(place: Place, pair: DrivenPair, groups: Iterable[Solved | SolvedWheel]) -> Driven:
    """Read the force that drives a rod out of its cylinder off the polygon of their group."""
    _refuse_moment(place, pair)
    whole = (one for one in groups if isinstance(one, Solved))
    solved = next(one for one in whole if pair.link in one.rods)
    tail, head = solved.rods[pair.link]
    draft, letter = place.draft, place.letter("P", pair.link)
    draft.open(solved.polygon.view)
    leg = pair.path(place.positions, draft.uses)
    along = draft.draw(parallel, f"({letter})", tail, leg, sense=1, why=why.ROD_FORCE)
    end, rest = head, None
    if (tail, head) not in (side[1:] for side in solved.polygon.sides):
        both = next(own for own in map(links_of, solved.closing.legs) if pair.link in own)
        name = "R_{{{}{}}}".format(*both)
        across = draft.draw(square, f"({name})", head, leg, sense=1, why=why.ROD_HELD)
        number = len(solved.polygon.sides) + 1 + list(solved.rods).index(pair.link)
        end = draft.draw(meet, str(number), along, across, why=why.ROD_HELD)
        rest = (name, end, head)
    length = draft.draw(measure_along, f"y_{{{letter}}}", tail, end, along, why=why.ROD_FORCE)
    balance = draft.draw(in_si, letter, length, unit="N")
    rod = RodForce(letter, tail, end, length, rest)
    return Driven(pair, letter, balance, None, None, None, rod)


def _refuse_moment(place: Place, pair: DrivenPair) -> None:
    if place.kind != "force":
        raise StructureError(
            said(
                'link {link} slides: it is balanced by a force; write balance = "force", or leave it out',
                link=pair.link,
            ),
            "forces.balance",
            head="balance",
        )


def solve_drives(
    place: Place,
    pairs: Iterable[DrivenPair],
    figure_of: Callable[[int], Detached],
    acting: Acting,
    groups: Iterable[Solved | SolvedWheel],
) -> tuple[Driven, ...]:
    """Balance all drives, once the groups are solved; ``figure_of``: link -> the figure that shows it."""
    solved, found = tuple(groups), list[Driven]()
    for pair in pairs:
        if pair.driven.telescopes:
            found.append(read_rod(place, pair, solved))
        elif pair.arm_ends(place.positions):
            found.append(solve_crank(place, figure_of(pair.link), pair, acting))
        else:
            found.append(solve_slider(place, figure_of(pair.link), pair, acting))
    return tuple(found)
