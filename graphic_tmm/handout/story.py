"""The pictures of a view with what is told in each: every line of the protocol stands in one of them.

A picture tells the steps that it draws. What is calculated stands with the step that needs it, what is read or
follows from a reading with the step before, so that the numbers of the steps go on from picture to picture.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from typing import NamedTuple

from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import Picture, pictures
from graphic_tmm.readers.narration import ProtocolLine, protocol
from graphic_tmm.readers.protocol import covering
from graphic_tmm.scene.captions import view_name
from graphic_tmm.scene.chapter import MECHANISM


class StoryPicture(NamedTuple):
    """A picture and the lines of the protocol that it tells.

    ``position``: what the position is called in which it draws again what was drawn in the first one.
    """

    picture: Picture
    lines: tuple[ProtocolLine, ...]
    position: str = ""


def places_of(drawn: Drawn, view: Drawing) -> dict[int, int]:
    """Return the positions of the board that a view shows, each with its index in the view's own reading."""
    there = {one.position for one in (*view.strokes, *view.rubbed, *view.labels)}
    row = drawn.row(view.shows[0])
    return {row[k]: k for k in sorted(there - {None}, key=lambda k: k or 0) if k is not None}


def name_of(drawn: Drawn, view: Drawing, index: int) -> str:
    """Return what a position is called, by its index in the reading of a view."""
    return dict(view.numbers).get(index) or drawn.names[drawn.row(view.shows[0])[index]]


def story(
    drawn: Drawn, view: Drawing, place: int, language: str, untold: Set[int] = frozenset()
) -> tuple[StoryPicture, ...]:
    """Return the pictures of a view, the first position of which is ``place`` (index), and what they tell.

    ``untold``: slots of marks whose steps other pictures tell.
    """
    log = drawn.construction
    index = places_of(drawn, view).get(place)
    made = pictures(log, view, index)
    first = _first(made)
    lines = [
        one
        for one in _lines(drawn, view, place, language)
        if one.step is None or one.step.it.slot not in untold
    ]
    told = _shared_out(log, lines, first)
    return tuple(
        StoryPicture(
            one,
            tuple(told.get(n, ())),
            name_of(drawn, view, one.position) if one.again and one.position is not None else "",
        )
        for n, one in enumerate(made)
    )


def _first(made: Sequence[Picture]) -> dict[int, int]:
    """Return the number of the picture in which each step, by the slot of its mark, is drawn first."""
    found: dict[int, int] = {}
    for n, picture in enumerate(made):
        for slot in picture.marks if not picture.again else ():
            found.setdefault(slot, n)
    return found


def _lines(drawn: Drawn, view: Drawing, place: int, language: str) -> list[ProtocolLine]:
    """Return the protocol of all that a view shows, in the order of the log; a heading before each plan."""
    turned = drawn.scene.turned and drawn.board == MECHANISM
    log, found = drawn.construction, list[list[ProtocolLine]]()
    for name in view.shows:
        reading, row = drawn.of(name), drawn.row(name)
        if reading is None or not row:
            continue
        own = row.index(place) if name in drawn.project.rows and place in row else place
        others: list[tuple[int, str]] = []
        if drawn.board != MECHANISM:
            marks = [step.it for step in log.steps if step.it.view == name]
            others = [(k, drawn.names[k]) for k in covering(reading, marks, [own])]
        told = list(protocol(log, name, reading, own, language, turned=turned, elsewhere=others))
        if told:
            found.append(told)
    order = {step.it: n for n, step in enumerate(log.steps)}
    found.sort(key=lambda some: min((order[o.step.it] for o in some if o.step), default=0))
    if len(found) < 2:
        return [line for some in found for line in some]
    return [line for some in found for line in _headed(some, language)]


def _headed(lines: Sequence[ProtocolLine], language: str) -> Iterator[ProtocolLine]:
    """Yield the lines of one plan of several that a view shows, its name before them."""
    view = next((line.step.it.view for line in lines if line.step is not None), "")
    if view:
        yield ProtocolLine(0, view_name(view, language))
    yield from lines


def _shared_out(
    log: Construction, lines: Sequence[ProtocolLine], first: Mapping[int, int]
) -> dict[int, list[ProtocolLine]]:
    """Return the lines by the number of their picture; a remark goes with what it stands before."""
    found: dict[int, list[ProtocolLine]] = {}
    for n, some in _pieces(log, lines, first):
        found.setdefault(n, []).extend(some)
    return found


def _pieces(
    log: Construction, lines: Sequence[ProtocolLine], first: Mapping[int, int]
) -> Iterator[tuple[int, list[ProtocolLine]]]:
    waiting: list[ProtocolLine] = []
    before = 0
    drawn = False
    for line in lines:
        waiting.append(line)
        n = first.get(line.step.it.slot) if line.step is not None else None
        if n is None or line.step is None:
            continue
        own = _needs(log, line.step.it, first)
        count = _behind(waiting[:-1], own) if drawn else 0
        yield before, waiting[:count]
        yield n, waiting[count:]
        waiting, before, drawn = [], n, True
    yield before, waiting


def _needs(log: Construction, mark: Mark, inked: Iterable[int]) -> set[Mark]:
    """Return the marks that a step needs of those that leave no ink, what these need among them."""
    steps, there = {step.it: step for step in log.steps}, set(inked)
    found: set[Mark] = set()
    rest = list(steps[mark].uses)
    while rest:
        one = rest.pop()
        if one not in found and one in steps and one.slot not in there:
            found.add(one)
            rest += steps[one].uses
    return found


def _behind(waiting: Sequence[ProtocolLine], needed: Set[Mark]) -> int:
    """Return how many of the lines before a drawn step belong to the one before it: what is read of that."""
    read: set[Mark] = set()
    count = 0
    for n, line in enumerate(waiting):
        if line.step is None:
            continue
        step = line.step
        if step.it in needed or (step.op.formula and not read.intersection(step.uses)):
            break
        read.add(step.it)
        count = n + 1
    return count
