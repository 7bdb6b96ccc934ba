"""The figure of a detached group or link: its points to a scale of its own, lines of action, arms, moments."""

from __future__ import annotations

from collections.abc import Iterable

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.instruments import measure, parallel
from graphic_tmm.board.operations.statics import action, arm, detach, moment
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import reasons as why
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.polygons import bare


def own_scale(view: str) -> str:
    """Return the letter of the scale factor of what is detached, for it is not that of the plan of positions.

    >>> own_scale("group 2-3"), own_scale("group 1")
    ('μ_{l23}', 'μ_{l1}')
    """
    return f"μ_{{l{view.removeprefix('group ').replace('-', '')}}}"


class Detached:
    """A group or a link drawn by itself while it is solved, in a ``view`` of its own; ``mu``: its μ_l.

    What is drawn in it stands for what is drawn on the plan of positions: it is asked for by those marks, and
    drawn once. ``note``: a remark that stands before the first step.
    """

    def __init__(self, draft: Draft, view: str, note: str, points: Iterable[Mark]) -> None:
        self.draft, self.view = draft, view
        draft.open(view)
        self.mu = draft.scale(own_scale(view), "m/mm")
        draft.lay_out(role=roles.DETACHED)
        draft.say(note)
        self.points: dict[Mark, Mark] = {}
        self.lines: dict[Mark, Mark] = {}
        self._lengths: dict[tuple[Mark, Mark], Mark] = {}
        self._moments: dict[tuple[Mark, Mark], Mark] = {}
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

    def _moment(self, about: Mark, force: Force) -> Mark:
        known = self._moments.get((about, force.line))
        if known is None:
            draft, line = self.draft, self.line(force)
            height = draft.draw(arm, f"h_{{{bare(force.letter)}}}", self.point(about), line)
            letter = f"M_{{{about.letter}}}({force.letter})"
            known = draft.draw(moment, letter, force.value, height, self.mu, unit="N·m")
            self._moments[about, force.line] = known
        return known
