"""A link drawn once more to a scale of its own: its points, the points by which it is held, circles on it."""

from __future__ import annotations

from typing import Any, NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.carried import carry_over
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import (
    join,
    measure,
    measure_along,
    ray,
    square,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.curvature import words as why
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.plan import KinematicPlans


class Held(NamedTuple):
    """One of the two points by which the link is held: its ``normal`` begins at it.

    ``centre``: of curvature of its path, None infinitely far; ``guide``: along which it slides, a line on the
    plan of positions; ``pivot``: its centre, a point of the frame there.
    """

    point: str
    at: Mark
    centre: Mark | None
    normal: Mark
    guide: Mark | None = None
    pivot: Mark | None = None


class Circle(NamedTuple):
    """A circle through P: the other end of its diameter, its centre, the arc."""

    end: Mark
    middle: Mark
    arc: Mark


class LinkFigure:
    """A link in a ``view`` with a ``mu`` of its own; ``points``: by the marks that they stand for.

    ``held``: the points by which the link is held, ``results``: points that are found, ``circles``: in order.
    """

    def __init__(
        self, draft: Draft, plans: KinematicPlans, body: Body, view: str, index: str
    ) -> None:
        self.draft, self.plans, self.body, self.view = draft, plans, body, view
        self.number, self.frame = body.link.number, plans.mechanism.frame.number
        draft.open(view)
        self.mu = draft.scale(f"μ_{{{index}}}", "m/mm")
        draft.lay_out()
        self.points: dict[Mark, Mark] = {}
        self.held: list[Held] = []
        self.results: list[Mark] = []
        self.circles: list[Circle] = []
        bodies = plans.positions.bodies
        self.origin = self.point(bodies[self.frame].marks[plans.structure.origin])
        self.letters = {letter: self.point(body.marks[letter]) for letter in body.link.points}

    def put(
        self, op: Operation, letter: str, *uses: Mark, unit: str = "", why: str = "", **choice: Any
    ) -> Mark:
        """Record an operation in the view, whose letter may stand on other marks too."""
        self.draft.open(self.view)
        return self.draft.draw(op, letter, *uses, unit=unit, free=True, why=why, **choice)

    def point(self, of: Mark, mu: Mark | None = None) -> Mark:
        """Return a point of the plan of positions, or of a view with that ``mu``, as it stands in this one."""
        if of not in self.points:
            factors = (mu or self.draft.mu_l, self.mu)
            self.points[of] = self.put(carry_over, of.letter, of, *factors)
        return self.points[of]

    def line(self, start: Mark, end: Mark, because: str = "") -> Mark:
        """Draw the line through two points."""
        return self.put(join, f"({start.letter}{end.letter})", start, end, why=because)

    def circle(self, pole: Mark, end: Mark, middle: str, because: str) -> Circle:
        """Draw the circle over a diameter from the instantaneous centre."""
        centre = self.put(halve, middle, pole, end, why=why.MIDDLE)
        radius = self.put(measure, f"{middle}P", centre, pole)
        arc = self.put(strike, f"({middle})", centre, radius, why=because)
        self.circles.append(Circle(end, centre, arc))
        return self.circles[-1]

    def coordinates(self, *named: Mark) -> None:
        """Measure where points that are found stand, along x and y from a point of the frame."""
        x = self.put(ray, "(x)", self.origin, self.draft.direction(0.0))
        y = self.put(square, "(y)", self.origin, x, sense=1)
        for mark in named:
            index = mark.letter.replace("_", "").replace("{", "").replace("}", "")
            for axis, line in (("x", x), ("y", y)):
                self.put(measure_along, f"{axis}_{{{index}}}", self.origin, mark, line)
        self.results += named
