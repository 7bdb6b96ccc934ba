"""Plans of velocities and accelerations in ink, one position or all from a pole; their vector equations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, product
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.operations.instruments import (
    homologous,
    lay_off,
    measure,
    measure_along,
    similar,
)
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.kinematics.accelerations import VIEW as ACCELERATIONS
from graphic_tmm.chapters.kinematics.motion import Vector, vectors
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.arithmetic import larger
from graphic_tmm.paper.drawing import EQUATIONS, Drawing, Ink, Label, Stroke, Wanted
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.formats import HEIGHTS, Heights
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow
from graphic_tmm.paper.symbols.kinematic import pole
from graphic_tmm.readers.equations import Equation, Term, by_group, heading

CLOSE = 2.0
"""Images nearer than this, mm, share one label: arrows end in one place there."""
SHORTEST = 0.01
"""A vector below this share of the longest of its plan is a point, and so is one below half a millimetre."""


class Place(NamedTuple):
    """A position of a plan: its index in the reading, and the number that its letters bear ("" for none)."""

    at: int
    number: str = ""


def draw_plan(
    on: Subject,
    plan: str,
    places: Sequence[Place],
    mu: float,
    unit: str,
    *,
    upon: Sequence[Stroke] = (),
    helping: bool = True,
) -> Drawing:
    """Return a plan in one position, or in several from a common pole: vectors with arrows, lines, letters.

    From a common pole the vectors between images are thin and construction lines are left out. ``mu``
    (SI per mm) and ``unit`` are told to a page that reads the sheet. ``upon``: what is drawn over the plan;
    letters stay clear of it. Not ``helping``: without what is rubbed out.
    """
    view = on.construction.view(plan)
    assert view is not None
    assert view.pole is not None
    common = len(places) > 1
    seen = on.seen((plan,), [place.at for place in places])
    told = vectors(on.construction, plan)
    manner = _manner(seen, told, mu, unit, common=common)
    traces = figure(seen, manner, helping=helping)
    spot = seen.point(view.pole, places[0].at)
    strokes = (*traces.staying, *body(pole(spot), "pole", [view.pole]), *upon)
    parts = [] if common else _parts(seen, told)
    wanted = _letters(seen, places, view.pole, on.heights, parts)
    positions = ((place.at, place.number) for place in places if place.number)
    return traces.drawing(on, strokes, wanted, (), positions)


def _manner(seen: Seen, told: Sequence[Vector], mu: float, unit: str, *, common: bool) -> Manner:
    """Return how a plan is inked: what was measured or laid off is a vector, seen once."""
    lengths = [
        abs(seen.point(one.end, k) - seen.point(one.start, k))
        for one in told
        for k in seen.positions
    ]
    longest = larger(0.0, *(length for length in lengths if np.isfinite(length)))
    least = larger(SHORTEST * longest, 0.5)
    by_mark = {one.step.it: one for one in told}

    def vector(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        one = by_mark.get(step.it)
        if one is not None:
            a, b = seen.point(one.start, k), seen.point(one.end, k)
            if abs(b - a) >= least:
                yield from _vector(one, a, b, mu, unit, thin=common)
        elif not common:
            yield from _projected(seen, step, k)

    drawn = {frozenset((one.start, one.end)) for one in told}

    def alike(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        for base in step.uses[: 2 if step.op is similar else 1]:
            if frozenset((base, step.it)) not in drawn:
                yield from segment("thin", seen.point(base, k), seen.point(step.it, k))

    kept = seen.views == (ACCELERATIONS,)

    def stays(seen: Seen, step: Step) -> bool:
        if step.op in (similar, homologous):
            return kept and not common
        return step.it in by_mark or (not common and usual(seen, step))

    rules = dict.fromkeys((measure.name, measure_along.name, lay_off.name), vector)
    return Manner({**rules, similar.name: alike, homologous.name: alike}, stays)


def _vector(
    vector: Vector, a: complex, b: complex, mu: float, unit: str, *, thin: bool
) -> list[Stroke]:
    pen = ("medium" if thin else "main") if vector.absolute else ("thin" if thin else "medium")
    return told_arrow(a, b, pen, vector.segment, mu, unit)


def _foot(seen: Seen, step: Step, k: int) -> complex | None:
    """Return the foot of a vector's end on a line that a part of it is measured along; None if it is on it."""
    start, end = (seen.point(mark, k) for mark in step.uses[:2])
    along = seen.line(step.uses[2], k)[1]
    foot = start + ((end - start) * along.conjugate()).real * along
    return foot if finite(foot) and abs(end - foot) > CLOSE else None


def _parts(seen: Seen, told: Sequence[Vector]) -> list[Step]:
    """Return what was measured of vectors along other lines than their own."""
    whole = {one.step.it for one in told}
    return [one for one in seen.steps if one.op is measure_along and one.it not in whole]


def _projected(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The part of a vector that was measured along another line, and what squares it off."""
    foot = _foot(seen, step, k) if step.op is measure_along else None
    if foot is not None:
        for mark in step.uses[:2]:
            yield from segment("thin", seen.point(mark, k), foot)


def _letters(
    seen: Seen, places: Sequence[Place], pole_mark: Mark, heights: Heights, parts: Sequence[Step]
) -> list[Wanted]:
    """The letters of a plan: the pole's, those of images by the alphabet, those of ends of components.

    ``parts``: what was measured of vectors along other lines, lettered at its foot.
    """
    at_pole = seen.point(pole_mark, places[0].at)
    marks = sorted(
        (step.it for step in seen.steps if step.it.kind is Point),
        key=lambda mark: (seen.by_mark[mark].op is lay_off and mark.name[0] in "nk", mark.name),
    )
    named = [
        Named(seen.point(m, stood.at), markup(m.name, stood.number), (m.slot,), stood.at)
        for stood in places
        for m in marks
    ]
    for step, stood in product(parts, places):
        if (foot := _foot(seen, step, stood.at)) is not None:
            named.append(Named(foot, markup(step.it.name), (step.it.slot,), stood.at))
    named = [one for one in named if finite(one.at)]
    common = len(places) > 1
    pole = Named(at_pole, markup(pole_mark.name), (pole_mark.slot,))
    # about a common pole there is little room: images without velocity have a label beside its own
    letters = [pole, *shared(named, CLOSE)] if common else shared([pole, *named], CLOSE)
    middle = at_pole if common else complex(np.mean([one.at for one in (pole, *named)]))
    return lettered(letters, heights.number if common else heights.point, away_from=middle)


LEAD = 0.45
"""Clear height between two lines of lettering, of the height of their capitals."""


def draw_equations(
    construction: Construction,
    plan: str,
    title: str,
    found: Sequence[Equation],
    heights: Heights = HEIGHTS["A1"],
    language: str = "en",
) -> Drawing:
    """Return the equations of a plan under their title, each group's with its directions below it.

    What the log says of the crank stands first.
    """
    large, small = heights.point, heights.number
    told = [(text, large) for text in _crank(construction, plan)]
    for group, solved in by_group(found).items():
        told.append((f"{heading(group, language)}:", small))
        for equation in solved:
            told += [(equation.markup, large), (f"({equation.directions})", small)]
    rows = [(title, heights.title), *((symbol(text, language), size) for text, size in told)]
    labels, base = list[Label](), 0.0
    for text, size in rows:
        made = letter(text, size=size)
        base -= made.ascent + (0.0 if not labels else LEAD * size)
        labels.append(Label(text, complex(0.0, base), size))
        base -= made.descent
    return Drawing(f"equations-{plan}", title, labels=tuple(labels), role=EQUATIONS)


def _crank(construction: Construction, plan: str) -> list[str]:
    """Return what was said before a crank's vector was laid off; of two of its pin, that it is their sum."""
    notes = [step.note for step in construction.steps if step.it.view == plan and step.note]
    letters = {note: note.partition(" = ")[0] for note in notes if "=" in note}
    told = list[str]()
    for whole, own in groupby(letters, key=lambda note: letters[note].partition("^")[0]):
        told += (of_pin := list(own))
        if len(of_pin) > 1:
            parts = (str(Term(letters[note], known=True)) for note in of_pin)
            told.append(" = ".join([Term(whole, known=True).barred, " + ".join(parts)]))
    return told
