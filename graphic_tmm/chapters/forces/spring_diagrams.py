"""Diagrams of springs, the force by the length, with its positions; springs on the plan of positions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.load_diagrams import At, Diagram, Part, draw_load, mu_l
from graphic_tmm.chapters.forces.loads import Sprung
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.spring_signs import draw_ink, letter_of, middle
from graphic_tmm.chapters.forces.task import LOADS as PLACE
from graphic_tmm.chapters.forces.words import SPRING
from graphic_tmm.chapters.kinematics.along import AlongGuide
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Stand, Wanted
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.views import captioned, mu_text

VIEW = "spring"
"""What the diagram of a spring is called by code, before its letter."""
LETTER = 8.0
"""How far from a spring its letter begins, mm."""


class SpringLaw(NamedTuple):
    """A spring on its diagram: its letter; from where to where its length goes (m), the largest force (N)."""

    sprung: Sprung
    letter: str
    low: float
    reach: float
    largest: float

    @property
    def begin(self) -> float:
        """Where the base begins, m."""
        return max(0.0, self.low - ROOM * (self.reach - self.low))

    @property
    def view(self) -> str:
        """What code calls the diagram."""
        return f"{VIEW} {self.letter}"

    def force(self, length: float) -> float:
        """Return the force at a length, N."""
        spring = self.sprung.spring
        assert spring.rate is not None
        assert spring.free is not None
        return spring.rate * (length - spring.free) + spring.force


def laws(drawn: Drawn) -> Iterator[SpringLaw]:
    """Yield the springs whose force goes by their length, over all lengths of the positions that are drawn."""
    for sprung in FORCES_PLAN.on(drawn).loads.springs:
        if sprung.length is None or sprung.force is None:
            continue
        long = mu_l(drawn) * _row(drawn, sprung.length)
        known = long[np.isfinite(long)]
        law = SpringLaw(sprung, sprung.force.name.split("^")[0], 0.0, 0.0, 0.0)
        if not known.size:
            continue
        low, high = float(known.min()), float(known.max())
        free = sprung.spring.free
        assert free is not None
        if low - (high - low) < free < low:
            low = free
        largest = max(abs(law.force(low)), abs(law.force(high)))
        if high - low > TELLING * high and largest > 0.0:
            yield law._replace(low=low, reach=high, largest=largest)


ROOM = 0.2
"""The base begins before the least length by this share of how far the length goes."""
TELLING = 1e-6
"""A spring whose length changes by less than this share of it has no diagram."""


def _row(drawn: Drawn, mark: Mark) -> np.ndarray:
    return np.broadcast_to(drawn.reading[mark][0], len(drawn.names))


def spring_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagram of each spring: lengths as on the plan of positions, the force to its own scale."""
    if FORCES_PLAN.of(drawn) is None:
        return []
    language, high, views = drawn.scene.language, heights(drawn.scene, PLACE), list[Drawing]()
    for one in laws(drawn):
        letter = symbol(one.letter, language)
        title = speaking(language)(SPRING, letter=letter)
        up, along = choices(drawn).scale(one.view, "μ_F"), drawn.scales[POSITIONS]
        shown = _diagram(drawn, one, letter)
        name = "spring-" + "".join(one.sprung.ends.letters)
        view = draw_load(shown, name, title, (mu_l(drawn), up.value), language, high)
        told = ", ".join(mu_text(scale, language) for scale in (along, up))
        view = finished(view._replace(stand=Stand(kind="table")), lettered)
        views.append(captioned(view, title, told, heights=high))
    return views


def _diagram(drawn: Drawn, one: SpringLaw, letter: str) -> Diagram:
    language, sprung, mu = drawn.scene.language, one.sprung, mu_l(drawn)
    assert sprung.length is not None
    assert sprung.force is not None
    line = Part("main", tuple((x, one.force(x)) for x in (one.low, one.reach)))
    lengths, forces = _row(drawn, sprung.length), _row(drawn, sprung.force)
    at = tuple(
        At(drawn.names[k], float(mu * lengths[k]), float(forces[k]), k, sprung.force.slot)
        for k in range(drawn.scene.row.count)
        if k not in drawn.undrawn and np.isfinite(forces[k])
    )
    axes = (
        f"{markup(sprung.length.name)}, {unit('m', language)}",
        f"{letter}, {unit('N', language)}",
    )
    return Diagram((line,), at, axes, one.reach, one.largest, one.begin)


def springs_on_plan(drawn: Drawn) -> Iterator[AlongGuide]:
    """Yield the springs between their ends in the main position of the plan of positions."""
    made = FORCES_PLAN.of(drawn)
    if made is None:
        return
    mechanism, size = KINEMATICS_PLAN.on(drawn).mechanism, heights(drawn.scene, POSITIONS).point
    bodies = KINEMATICS_PLAN.on(drawn).positions.bodies
    for sprung in made.loads.springs:
        ends = zip(sprung.ends.letters, sprung.ends.links, strict=True)
        marks = [bodies[link].marks[letter] for letter, link in ends]
        start, end = (complex(_row(drawn, mark)[drawn.main]) for mark in marks)
        if not np.isfinite(end - start):
            continue
        strokes = tuple(added(draw_ink(sprung.spring, mechanism, start, end), "given"))
        at = middle(sprung.spring, mechanism, start, end)
        letter = letter_of(sprung.spring, sprung.number)
        yield AlongGuide(strokes, (Wanted(letter, at, size, LETTER, 1j * (end - start)),), "")
