"""The log: marks, steps, views, the Board that writes it; names of segments; what follows from given marks."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Mapping
from functools import lru_cache
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np

from graphic_tmm.board.dimensions import fault, unit_of
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.values import KINDS, Kind, Length, Point, places
from graphic_tmm.errors import ConstructionError

T = TypeVar("T")
TALLY = "#"
"""What a letter bears that other marks of its view have too: it tells them apart and is shown to nobody."""


class Mark(NamedTuple):
    """What a plan's author holds: the slot in the log, the letter, the kind, the view, the unit, the role.

    The letter is the mark's alone in its view; the ``name`` is what readers see, and others may bear it too.
    Both are for people. What a mark is for code is its ``role``, a term of the field ("normal", "pole"); code
    that looks for marks asks for it, or holds the marks themselves.
    """

    slot: int
    letter: str
    kind: Kind
    view: str
    unit: str = ""
    role: str = ""

    @property
    def key(self) -> tuple[str, str]:
        """View and letter: by these a mark is known again in another recording of the same plan."""
        return self.view, self.letter

    @property
    def name(self) -> str:
        """What the mark is called on sheets, in tables and protocols; "" if it is told by its value."""
        return self.letter.replace(TALLY, "")


class Step(NamedTuple):
    """One operation done: it leaves the mark ``it`` and uses earlier marks; ``note`` is said before it.

    ``why``: the reason of this step in its plan, with the names of the operation's arguments and {it} in
    braces; "" where that of its operation says it.
    """

    op: Operation
    it: Mark
    uses: tuple[Mark, ...]
    choice: Mapping[str, int]
    note: str
    why: str = ""

    @property
    def reason(self) -> str:
        """Why it is done: its own reason, else that of its operation; "" if nobody gave one."""
        return self.why or self.op.why


class View(NamedTuple):
    """A plan's own corner of the board: its name, its pole (if it has one), its scale factor, its role.

    ``last``: of a view that is drawn again, pass after pass, the one that it comes to; else its own name.
    """

    name: str
    pole: Mark | None
    scale: Mark | None
    role: str = ""
    last: str = ""


class Figure(NamedTuple):
    """Marks that belong together as a body on the plan: ``kind`` says what (link, slider, guide ...)."""

    view: str
    kind: str
    name: str
    marks: tuple[Mark, ...]


class Construction(NamedTuple):
    """The log: what was given, what was done, the views it was done in, the figures it shows."""

    given: tuple[Mark, ...]
    steps: tuple[Step, ...]
    views: tuple[View, ...]
    figures: tuple[Figure, ...]
    size: int

    def view(self, name: str) -> View | None:
        """Return the view of that name, or None."""
        return next((view for view in self.views if view.name == name), None)

    def roles(self, view: str, role: str) -> tuple[Mark, ...]:
        """Return the marks of a view that have a role, given ones first, then in the order of the steps."""
        return _roles(ByIdentity(self)).get((view, role), ())

    def step(self, mark: Mark) -> Step | None:
        """Return the step that left ``mark``; None for a given one."""
        at = bisect_left(self.steps, mark.slot, key=_slot)
        if at < len(self.steps) and self.steps[at].it == mark:
            return self.steps[at]
        # a log that was put together anew may have its steps in another order
        return next((step for step in self.steps if step.it == mark), None)


def _slot(step: Step) -> int:
    return step.it.slot


class ByIdentity(Generic[T]):
    """Something that is known by being this one: comparing two would take longer than what is kept of them."""

    def __init__(self, it: T) -> None:
        self.it = it

    def __hash__(self) -> int:
        return id(self.it)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ByIdentity) and self.it is other.it


@lru_cache(maxsize=8)
def _roles(log: ByIdentity[Construction]) -> Mapping[tuple[str, str], tuple[Mark, ...]]:
    found: dict[tuple[str, str], list[Mark]] = {}
    for mark in (*log.it.given, *(step.it for step in log.it.steps)):
        found.setdefault((mark.view, mark.role), []).append(mark)
    return {key: tuple(marks) for key, marks in found.items()}


class Board:
    """Writes the log: take what is given, open a view, draw, say what is about to be done."""

    def __init__(self) -> None:
        self._given: list[Mark] = []
        self._steps: list[Step] = []
        self._made: dict[int, Step] = {}
        self._read: dict[tuple[Mark, ...], Mark] = {}
        self._views: list[View] = []
        self._figures: list[Figure] = []
        self._letters: set[tuple[str, str]] = set()
        self._count = 0
        self._view = ""
        self._note = ""

    def open(self, view: str) -> None:
        """Begin (or go on with) the view of that name; marks made from now on are in it."""
        self._view = view

    @property
    def view(self) -> str:
        """The view that is open."""
        return self._view

    def lay_out(
        self, pole: Mark | None, scale: Mark | None, role: str = "", last: str = ""
    ) -> None:
        """Tell the pole and the scale factor of the view that is open (see `View`)."""
        self._views.append(View(self._view, pole, scale, role, last or self._view))

    def take(self, kind: Kind, letter: str, unit: str = "", role: str = "") -> Mark:
        """Return a mark given before work begins."""
        mark = self._mark(letter, kind, unit, role, kind is not Point)
        self._given.append(mark)
        return mark

    def say(self, note: str) -> None:
        """Write a remark (a vector equation, a heading) that stands before the next step."""
        self._note = f"{self._note}\n{note}" if self._note else note

    def draw(
        self,
        op: Operation,
        letter: str,
        *uses: Mark,
        unit: str = "",
        role: str = "",
        free: bool = False,
        why: str = "",
        **choice: int,
    ) -> Mark:
        """Record one operation and return the mark it leaves; ``why``: see `Step`.

        Two bodies may share a line or a length: its letter is freed, it gets a tally. A point bears its letter
        alone in its view, so that one drawn twice by mistake is found; ``free``: it may stand beside others.

        Raises
        ------
        ConstructionError
            If the kinds of the marks are not those the operation takes, a choice is not one of its
            choices, the unit is not what the formula makes of theirs, or a point of that letter stands in
            this view already and is not to be ``free``.
        """
        kinds = tuple(mark.kind for mark in uses)
        if kinds != op.takes:
            names = [", ".join(KINDS[kind] for kind in row) for row in (op.takes, kinds)]
            raise ConstructionError(
                f"{self._place(op, letter)} takes ({names[0]}), was given ({names[1]})"
            )
        if unknown := set(choice) - set(op.choices):
            raise ConstructionError(f"{self._place(op, letter)} has no choice {sorted(unknown)}")
        if op.formula:
            units = tuple(unit_of(mark.kind, mark.unit) for mark in uses)
            if says := fault(op.name, units, unit_of(op.leaves, unit)):
                raise ConstructionError(f"{self._place(op, letter)} {says}")
        mark = self._mark(letter, op.leaves, unit, role, free or op.leaves is not Point)
        step = Step(op, mark, uses, choice, self._note, why)
        self._steps.append(step)
        self._made[mark.slot] = step
        if op.reads and op.leaves is Length:
            self._read.setdefault(uses[:2], mark)
        self._note = ""
        return mark

    def uses(self, mark: Mark) -> tuple[Mark, ...]:
        """Return the marks that the step which left ``mark`` used."""
        return self.step(mark).uses

    def step(self, mark: Mark) -> Step:
        """Return the step that left ``mark``."""
        return self._made[mark.slot]

    def length(self, start: Mark, end: Mark) -> Mark | None:
        """Return the first length that was read from one point to another; None if none was."""
        return self._read.get((start, end))

    def free(self, letter: str) -> str:
        """Return the letter, with as many tallies as it takes to be new in the view that is open."""
        while (self._view, letter) in self._letters:
            letter += TALLY
        return letter

    def figure(self, kind: str, name: str, *marks: Mark) -> None:
        """Tell that marks belong together as a body on the plan."""
        self._figures.append(Figure(self._view, kind, name, marks))

    def construction(self) -> Construction:
        """Return the log as it stands."""
        return Construction(
            tuple(self._given),
            tuple(self._steps),
            tuple(self._views),
            tuple(self._figures),
            self._count,
        )

    def _place(self, op: Operation, letter: str) -> str:
        return f"{self._view}, step {len(self._steps) + 1}: {op.name} '{letter}'"

    def _mark(self, letter: str, kind: Kind, unit: str, role: str, free: bool) -> Mark:
        if free:
            letter = self.free(letter)
        if (self._view, letter) in self._letters:
            raise ConstructionError(
                f"{self._view}, step {len(self._steps) + 1}: the letter '{letter}' stands in this plan already"
            )
        self._letters.add((self._view, letter))
        mark = Mark(self._count, letter, kind, self._view, unit, role)
        self._count += 1
        return mark


RATES = {"ω": "omega", "ε": "epsilon"}


def between(start: Mark, end: str) -> str:
    """Return the letter of the segment from a point to another: πa, aa3, n3a3, as both stand on the plan.

    The one place where a segment of a plan of vectors gets its name: the end may not be drawn yet.
    """
    return f"{start.letter}{end}"


def segment_name(letter: str) -> str:
    """Return a letter of the log as machines read it: P_{i3} -> Pi3, ω_2 -> omega2."""
    stem, _, rest = letter.partition("_")
    if rest and stem in RATES:
        return RATES[stem] + rest.strip("{}")
    return letter.replace(TALLY, "′").translate({ord(sign): None for sign in "_{}"})


def kept(
    log: Construction, given: Mapping[Mark, object], drawn: Mapping[int, Any]
) -> dict[Mark, Any]:
    """Return what is given that does not vary, and what is drawn across positions, once for all of them.

    ``drawn``: by slot the numbers of the log, as it was executed at the positions of its row.
    """
    known: dict[Mark, Any] = {
        mark: value
        for mark, value in given.items()
        if not (isinstance(value, np.ndarray) and value.ndim == 2 and value.shape[1] > 1)
    }
    across = [step.it for step in log.steps if step.op.across and step.it.slot in drawn]
    return known | {mark: drawn[mark.slot] for mark in across if places(drawn[mark.slot]) == 1}


def again(log: Construction, known: Collection[Mark]) -> Construction:
    """Return the log of what follows, position by position, from what is known, and from nothing else."""
    there, steps = set(known), []
    for step in log.steps:
        if step.it in known:
            continue
        if not step.op.across and there.issuperset(step.uses):
            there.add(step.it)
            steps.append(step)
    begun = tuple(mark for mark in (*log.given, *(s.it for s in log.steps)) if mark in known)
    return log._replace(given=begun, steps=tuple(steps))
