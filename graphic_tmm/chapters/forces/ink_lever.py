"""Zhukovsky's lever in ink: the turned plan, forces at the image points, arms about the pole."""

from __future__ import annotations

import cmath
import math
from itertools import combinations

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.forces.ink_polygons import LEAST, bar, spot
from graphic_tmm.chapters.forces.lever import Lever
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, line
from graphic_tmm.paper.finish import TOGETHER
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.symbols.arrows import arrow
from graphic_tmm.paper.symbols.kinematic import pole

SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
SMALL = 2.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
LONGEST = 45.0
"""Length of the arrow of the largest force on the lever, mm."""
SHORTEST = 8.0
"""Of the smallest one: the lever shows points and lines of action, sizes are written."""
MARGIN = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


def draw_lever_ink(
    construction: Construction,
    reading: Reading,
    lever: Lever,
    balance: tuple[str, float, complex] | None,
    index: int,
    name: str,
    title: str,
    language: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the lever in one position.

    ``balance``: the balancing force's letter, its size (N) and its direction at the crank pin's image.
    """
    ink = _Ink(reading, index, language)
    at_pole = ink.at(lever.pole)
    strokes: list[Stroke | Bezier] = []
    images = {m: ink.at(m) for marks in lever.images.values() for m in marks}
    images = {m: z for m, z in images.items() if cmath.isfinite(z)}
    for z in images.values():
        if abs(z - at_pole) >= LEAST:
            strokes.append(line("medium", at_pole, z))
    for marks in lever.images.values():
        for one, other in combinations(marks, 2):
            ends = images.get(one, at_pole), images.get(other, at_pole)
            if min(abs(ends[0] - ends[1]), *(abs(z - at_pole) for z in ends)) >= LEAST:
                strokes.append(line("medium", *ends))
    wanted = _letters(images, lever.pole, at_pole)
    sizes = [abs(ink.number(f.value)) for f in lever.forces] + (
        [abs(balance[1])] if balance else []
    )
    largest = max((s for s in sizes if math.isfinite(s)), default=0.0)
    for force in lever.forces:
        start, along = ink.line_of(force.line)
        letter = symbol(force.letter, language)
        ink.force(letter, start, along * _shown(ink.number(force.value), largest), strokes, wanted)
    if balance is not None:
        letter, size, way = balance
        ink.force(letter, ink.at(lever.pin), way * _shown(size, largest), strokes, wanted, "main")
    ink.arms(construction, lever, at_pole, strokes, wanted)
    strokes += pole(at_pole)
    if not lettered:
        spots = [*images.values(), *(one.at for one in wanted)]
        x, y = [z.real for z in spots], [z.imag for z in spots]
        cell = (min(x) - MARGIN, min(y) - MARGIN, max(x) + MARGIN, max(y) + MARGIN)
        return Drawing(name, title, cell=cell)
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def _shown(size: float, largest: float) -> float:
    """Return the length of an arrow, signed: it grows with the force, but a small one is seen too."""
    if not (math.isfinite(size) and largest > 0.0) or size == 0.0:
        return 0.0
    return math.copysign(SHORTEST + (LONGEST - SHORTEST) * abs(size) / largest, size)


def _letters(images: dict[Mark, complex], pole_mark: Mark, at_pole: complex) -> list[Wanted]:
    groups: list[tuple[complex, list[str]]] = [(at_pole, [pole_mark.name])]
    for mark, z in images.items():
        if mark == pole_mark:
            continue
        near = next((names for at, names in groups if abs(at - z) < TOGETHER), None)
        text = markup(mark.name)
        if near is None:
            groups.append((z, [text]))
        elif text not in near:
            near.append(text)
    return [Wanted(", ".join(names), z, SIZE, 1.0, z - at_pole) for z, names in groups]


class _Ink:
    """The lever in one position while it is inked."""

    def __init__(self, reading: Reading, index: int, language: str) -> None:
        self.reading, self.index, self.language = reading, index, language

    def at(self, mark: Mark) -> complex:
        return spot(self.reading, mark, self.index)

    def number(self, mark: Mark) -> float:
        return self.at(mark).real

    def line_of(self, mark: Mark) -> tuple[complex, complex]:
        value: Line = self.reading[mark]
        at, along = (complex(p[0, self.index if p.shape[1] > 1 else 0]) for p in value)
        return at, along

    def force(
        self,
        letter: str,
        at: complex,
        vector: complex,
        strokes: list[Stroke | Bezier],
        wanted: list[Wanted],
        pen: str = "medium",
    ) -> None:
        """An arrow at its image point; where one goes that way already it comes from the other side."""
        if not abs(vector) >= LEAST:  # also where it is not there
            return
        same = any(abs(one.at - at - vector) < 3.0 for one in wanted)
        start = at - vector if same else at
        strokes += arrow(start, start + vector, pen)
        end = start if same else start + vector
        wanted.append(Wanted(bar(letter), end, SIZE, 1.5, end - at))

    def arms(
        self,
        construction: Construction,
        lever: Lever,
        at_pole: complex,
        strokes: list[Stroke | Bezier],
        wanted: list[Wanted],
    ) -> None:
        """Arms about the pole and lines of action drawn on to their feet; arms on one another share a line."""
        lines = {force.line: force.letter for force in lever.forces}
        feet: list[tuple[complex, list[str]]] = []
        for step in construction.steps:
            if step.op is not arm or step.uses[1] not in lines:
                continue
            at, along = self.line_of(step.uses[1])
            reach = ((at_pole - at) * along.conjugate()).real
            foot = at + reach * along
            if along == 0 or not abs(foot - at_pole) >= 2.0:
                continue
            strokes.append(line("thin", at, foot + along * math.copysign(3.0, reach)))
            letter = markup(symbol(step.it.name, self.language))
            near = next((names for z, names in feet if abs(z - foot) < 1.0), None)
            if near is None:
                feet.append((foot, [letter]))
            else:
                near.append(letter)
        for foot, names in feet:
            strokes.append(line("thin", at_pole, foot))
            middle = (at_pole + foot) / 2
            wanted.append(Wanted(" = ".join(names), middle, SMALL, 0.8, 1j * (foot - at_pole)))
