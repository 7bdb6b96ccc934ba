"""A detached group: its points to a scale of its own, lines of action, arms, moments; its polygon of forces."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, measure, parallel, square
from graphic_tmm.board.operations.statics import action, arm, detach, moment
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.task import FORCES

Pair = tuple[int, int]
Side = tuple[str, Mark, Mark]
"""A side of a polygon: its letter, its tail, its head."""


class Reaction(NamedTuple):
    """The force of one link on another: its letter R_{12}, its vector, its length and its size (N).

    ``normal``: of a sliding pair, the part square to its guide (Length, signed); ``place``: how far from the
    closing point the reaction acts along the guide (Length), and the scale factor of that; None where it acts
    there.
    """

    letter: str
    links: Pair
    tail: Mark
    head: Mark
    length: Mark
    value: Mark
    normal: Mark | None = None
    place: tuple[Mark, Mark] | None = None


class Solution(NamedTuple):
    """What is solved: links that are detached together; in which pass of friction, None in the last."""

    links: tuple[int, ...]
    tried: int | None = None

    @property
    def name(self) -> str:
        """The links, as people write them: 2-3."""
        return "-".join(map(str, self.links))

    def key(self, of: str) -> str:
        """Return what machines call a scale factor of it: that of forces, "F", of lengths, "l"."""
        links = "_".join(map(str, self.links))
        return f"mu_{of}_{links}"

    def begin(self, draft: Draft) -> Chain:
        """Open the polygon: take its scale and its first vertex."""
        last = f"{FORCES} {self.name}"
        draft.open(last if self.tried is None else f"{last} {self.tried}")
        mu = draft.scale("μ_F", "N/mm")
        start = draft.take(Point, "1", 0j)
        draft.lay_out(start, role=roles.FORCE_POLYGON, last=last)
        return Chain(draft, mu, start)


class Parted(NamedTuple):
    """What the first of two plates does to the links that join them, as parted in the polygon of the group.

    ``plate``: the sides of all else that acts on it; ``sides``: what it does, the two last along the links;
    ``carried``: the loads of the first link once more.
    """

    plate: tuple[Side, ...]
    sides: tuple[Side, ...]
    carried: tuple[Side, ...]


class Polygon(NamedTuple):
    """A polygon of forces as drawn: of what, its scale, its sides in order, what is parted in it."""

    of: Solution
    mu: Mark
    sides: tuple[Side, ...]
    parted: Parted | None = None

    @property
    def inside(self) -> tuple[Side, ...]:
        """The sides that part what acts in the inner pairs."""
        return () if self.parted is None else (*self.parted.sides, *self.parted.carried)

    @property
    def view(self) -> str:
        """Where it is drawn."""
        return self.mu.view


class Chain:
    """The known sides of a polygon, laid off one after another; ``before``: vertices that are there already."""

    def __init__(self, draft: Draft, mu: Mark, start: Mark, before: int = 0) -> None:
        self.draft, self.mu, self.end, self.before = draft, mu, start, before
        self.sides: list[Side] = []

    def add(self, letter: str, line: Mark, value: Mark, vertex: str = "") -> None:
        """Lay off a load parallel to its line of action; ``vertex``: its end's name, if no number."""
        draft = self.draft
        side = draft.draw(parallel, f"({letter})", self.end, line, sense=1, why=why.KNOWN_SIDE)
        self.lay(letter, side, value, vertex)

    def add_across(self, letter: str, line: Mark, value: Mark, *, back: bool = False) -> None:
        """Lay off a tangential component, square to its link; ``back``: so that it ends where it begins."""
        sense = -1 if back else 1
        side = self.draft.draw(
            square, f"({letter})", self.end, line, sense=sense, why=why.KNOWN_TANGENTIAL
        )
        self.lay(letter, side, value)
        if back:
            _, tail, head = self.sides.pop()
            self.sides.append((letter, head, tail))

    def lay(self, letter: str, side: Mark, value: Mark, vertex: str = "") -> None:
        """Lay off a force along a line that begins at the end of the chain."""
        draft = self.draft
        length = draft.draw(to_board, f"y_{{{bare(letter)}}}", value)
        name = vertex or str(self.count + 1)
        head = draft.draw(lay_off, name, side, length, why=why.KNOWN_SIDE)
        self.sides.append((letter, self.end, head))
        self.end = head

    @property
    def count(self) -> int:
        """How many vertices there are."""
        return self.before + len(self.sides) + 1


def bare(letter: str) -> str:
    """Return a letter as it stands in the index of another: F_{12} -> F12."""
    return letter.replace("_", "").replace("{", "").replace("}", "")


def own_scale(links: Iterable[int]) -> str:
    """Return the letter of the scale factor of what is detached, for it is not that of the plan of positions.

    >>> own_scale((2, 3)), own_scale((1,))
    ('μ_{l23}', 'μ_{l1}')
    """
    return f"μ_{{l{''.join(map(str, links))}}}"


class Detached:
    """A group or a link drawn by itself in a ``view`` of its own to solve it: ``of`` what; ``mu``: its μ_l.

    What is drawn in it stands for what is drawn on the plan of positions: it is asked for by those marks, and
    drawn once. ``note``: a remark that stands before the first step.
    """

    def __init__(
        self, draft: Draft, links: tuple[int, ...], note: str, points: Iterable[Mark]
    ) -> None:
        self.draft, self.of = draft, Solution(links)
        self.view = f"group {self.of.name}"
        draft.open(self.view)
        self.mu = draft.scale(own_scale(links), "m/mm")
        draft.lay_out(role=roles.DETACHED)
        draft.say(note)
        self.points: dict[Mark, Mark] = {}
        self.lines: dict[Mark, Mark] = {}
        self._lengths: dict[tuple[Mark, Mark], Mark] = {}
        self._once: dict[Hashable, Mark] = {}
        for point in points:
            self.point(point)

    def point(self, of: Mark) -> Mark:
        """Return a point of the plan of positions as it stands in the figure."""
        if of not in self.points:
            factors = (self.draft.mu_l, self.mu)
            self.points[of] = self.draft.draw(detach, of.letter, of, *factors, free=True)
        return self.points[of]

    def line(self, force: Force) -> Mark:
        """Return the line of action of a force."""
        if force.line not in self.lines:
            letter, at = f"({force.letter})", self.point(force.point)
            self.lines[force.line] = self.draft.draw(
                parallel, letter, at, force.line, sense=1, why=why.CARRIED_LINE
            )
        return self.lines[force.line]

    def act(self, letter: str, point: Mark, tail: Mark, head: Mark) -> Mark:
        """Draw the line of action of a force whose vector is found; return it."""
        self.draft.open(self.view)
        line = self.draft.draw(
            action, f"({letter})", self.point(point), tail, head, why=why.REACTION_LINE
        )
        self.lines[line] = line
        return line

    def length(self, start: Mark, end: Mark) -> Mark:
        """Return how far two points are apart, as measured in the figure (Length)."""
        if (start, end) not in self._lengths:
            ends = self.point(start), self.point(end)
            letter = f"{start.letter}{end.letter}"
            self._lengths[start, end] = self.draft.draw(
                measure, letter, *ends, why=why.ARM_OF_TANGENTIAL
            )
        return self._lengths[start, end]

    def sum(
        self, about: Mark, forces: Iterable[Force], couples: Iterable[Couple], letter: str
    ) -> Mark | None:
        """Return the sum of moments about a point, N·m; None where nothing turns about it."""
        found = [self._moment(about, force) for force in forces if force.point != about]
        found += [couple.value for couple in couples]
        total: Mark | None = None
        for one in found:
            total = one if total is None else self._added(total, one, letter)
        return total

    def _added(self, first: Mark, second: Mark, letter: str) -> Mark:
        because = why.SUM_OF_MOMENTS
        return self.draft.draw(
            added, letter, first, second, unit="N·m", role=roles.SUM, why=because
        )

    def own(self, point: Mark) -> Mark:
        """Count a point that was found in the figure itself to its points; return it."""
        return self.points.setdefault(point, point)

    def arm(self, letter: str, about: Mark, line: Mark) -> Mark:
        """Measure the arm of a line of the figure; one about a point found in the figure bears its letter."""
        raised = f"^{{{about.letter[:1]}}}" if about.view == self.view else ""
        name = f"h_{{{bare(letter)}}}{raised}"
        return self.once(
            ("arm", about, line), lambda: self.draft.draw(arm, name, self.point(about), line)
        )

    def _moment(self, about: Mark, force: Force) -> Mark:
        draft, line = self.draft, self.line(force)

        def turns() -> Mark:
            uses = force.value, self.arm(force.letter, about, line), self.mu
            return draft.draw(moment, f"M_{{{about.letter}}}({force.letter})", *uses, unit="N·m")

        return self.once(("moment", about, force.line, force.value), turns)

    def once(self, key: Hashable, draw: Callable[[], Mark]) -> Mark:
        """Return what is drawn in the figure, drawn when it is first wanted."""
        if key not in self._once:
            self._once[key] = draw()
        return self._once[key]
