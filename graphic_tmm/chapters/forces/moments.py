"""What acts on the links of a mechanism, and its moments about points by arms measured on the drawing."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.statics import arm, moment
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.polygons import bare


class Moments:
    """Moments of forces about points, each arm measured once."""

    def __init__(self, draft: Draft) -> None:
        self.draft = draft
        self._known: dict[tuple[Mark, Mark], Mark] = {}

    def sum(
        self, about: Mark, forces: Iterable[Force], couples: Iterable[Couple], letter: str
    ) -> Mark | None:
        """Return the sum of moments about a point, N·m; None where nothing turns about it."""
        found = [self._of(about, force) for force in forces if force.point != about]
        found += [couple.value for couple in couples]
        total: Mark | None = None
        for one in found:
            total = one if total is None else self._added(total, one, letter)
        return total

    def _added(self, first: Mark, second: Mark, letter: str) -> Mark:
        draft = self.draft
        return draft.draw(added, letter, first, second, unit="N·m", role=roles.SUM)

    def _of(self, about: Mark, force: Force) -> Mark:
        known = self._known.get((about, force.line))
        if known is None:
            draft, mu_l = self.draft, self.draft.mu_l
            assert mu_l is not None
            height = draft.draw(arm, f"h_{{{bare(force.letter)}}}", about, force.line)
            letter = f"M_{{{about.letter}}}({force.letter})"
            known = draft.draw(moment, letter, force.value, height, unit="N·m")
            self._known[about, force.line] = known
        return known


@dataclass
class Acting:
    """What acts on the links while groups are solved one after another: loads, then reactions handed on."""

    forces: dict[int, list[Force]] = field(default_factory=dict)
    couples: dict[int, list[Couple]] = field(default_factory=dict)

    def add(self, load: Force | Couple) -> None:
        """Enter a load."""
        if isinstance(load, Force):
            self.forces.setdefault(load.link, []).append(load)
        else:
            self.couples.setdefault(load.link, []).append(load)
