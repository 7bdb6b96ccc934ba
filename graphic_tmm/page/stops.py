"""What a view is played in: every step a stop of its own, with the ink that appears in it and what is told.

A stop is a line of the protocol; one that leaves ink shows the picture in which that appears. What is drawn
again in another position is one stop, with what is calculated and read there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import Picture, pictures
from graphic_tmm.paper.rules import rule_of
from graphic_tmm.readers.narration import ProtocolLine, protocol
from graphic_tmm.scene.chapter import MECHANISM


class StepLine(NamedTuple):
    """A line of the protocol that tells a step: its view, the remarks before it, its number in the log."""

    view: str
    heads: tuple[ProtocolLine, ...]
    line: ProtocolLine
    at: int

    @property
    def slot(self) -> int:
        """The mark that its step leaves."""
        assert self.line.step is not None
        return self.line.step.it.slot


class Stop(NamedTuple):
    """A stop: the picture that appears in it (None: no ink), its position, what is told in it.

    ``missing``: what was drawn in the first position and cannot be in this one.
    """

    picture: Picture | None
    place: int
    told: tuple[StepLine, ...]
    missing: tuple[Mark, ...] = ()


class Played:
    """A view of a sheet, as it is played."""

    def __init__(self, drawn: Drawn, drawing: Drawing, language: str) -> None:
        self.drawn, self.drawing, self.language = drawn, drawing, language
        self.log = drawn.construction
        inked = {one.position for one in (*drawing.strokes, *drawing.rubbed, *drawing.labels)}
        places = sorted(k for k in inked if k is not None)
        main = next((k for k in places if self.position(k) == drawn.main), None)
        self.shown: Sequence[Picture] = pictures(self.log, drawing, main)
        self.others: tuple[Played, ...] = ()

    @cached_property
    def order(self) -> Mapping[int, int]:
        """The number of each step in the log by the slot of its mark."""
        return {step.it.slot: n for n, step in enumerate(self.log.steps)}

    @cached_property
    def steps(self) -> Mapping[int, Step]:
        """The steps of the log by the slots of their marks."""
        return {step.it.slot: step for step in self.log.steps}

    @cached_property
    def first(self) -> int:
        """The position (index) that is drawn step by step."""
        found = (one.position for one in self.shown if one.position is not None)
        at = next(found, None)
        if at is not None:
            return at
        return self.drawing.numbers[0][0] if self.drawing.numbers else 0

    @cached_property
    def places(self) -> list[int]:
        """The positions (indices) in which something is drawn, the first one among them."""
        return sorted({self.first, *(p.position for p in self.shown if p.position is not None)})

    def lines(self, place: int) -> list[StepLine]:
        """Return the lines of the protocol of all plans of the view in a position, in the order of the log."""
        found = []
        turned = self.drawn.scene.turned and self.drawn.board == MECHANISM
        for view in self.views:
            reading, own = self.drawn.of(view), self.place_in(view, place)
            if reading is None or own is None:
                continue
            heads: list[ProtocolLine] = []
            for line in protocol(self.log, view, reading, own, self.language, turned=turned):
                if line.step is None:
                    heads.append(line)
                    continue
                if line.step.it.slot in self.needed:
                    found.append(StepLine(view, tuple(heads), line, self.order[line.step.it.slot]))
                    heads = []
        return sorted(found, key=lambda told: told.at)

    @cached_property
    def views(self) -> tuple[str, ...]:
        """The views of the log of which it shows something: first those on which bodies of it stand."""
        inked = [self.steps[slot].it.view for one in self.shown for slot in one.marks]
        return tuple(
            dict.fromkeys((*(v for v in inked if v not in self.drawing.shows), *self.drawing.shows))
        )

    def position(self, place: int) -> int:
        """Return the position of the board (index) that is one of those drawn."""
        return self.drawn.row(self.drawing.shows[-1])[place]

    def place_in(self, view: str, place: int) -> int | None:
        """Return which position of a view of the log is one of those drawn; None if it is none of its own."""
        row, at = self.drawn.row(view), self.position(place)
        return row.index(at) if at in row else None

    @cached_property
    def inked(self) -> frozenset[int]:
        """The marks whose steps leave ink in the view."""
        return frozenset(slot for one in self.shown for slot in one.marks)

    def of_one_plan(self, other: Played) -> bool:
        """Whether another view of the sheets shows a part of the same plan in one of the same positions."""
        same = self.drawn is other.drawn and set(self.drawing.shows) & set(other.drawing.shows)
        return bool(same) and bool(set(self.places) & set(other.places))

    @cached_property
    def needed(self) -> frozenset[int]:
        """The marks whose steps are told: all of the plans of the view.

        Of a view that shows only a part of a plan it is what is drawn in it, what that comes of, and what is
        read off it and calculated of that.
        """
        steps = [step for step in self.log.steps if step.it.view in self.drawing.shows]
        inked = self.inked
        elsewhere = set().union(*(one.inked for one in self.others if self.of_one_plan(one)))
        if not any(step.it.slot in elsewhere - inked for step in steps):
            return inked.union(step.it.slot for step in steps)
        found, read = set(inked), set[int]()
        for step in reversed(steps):
            if step.it.slot in found:
                found.update(mark.slot for mark in step.uses)
        for step in steps:
            used = {mark.slot for mark in step.uses}
            if (step.op.reads and used & inked) or (not leaves_ink(step) and used & read):
                read.add(step.it.slot)
        return frozenset(found | read)

    @cached_property
    def stops(self) -> tuple[Stop, ...]:
        """The stops of the view; the first one shows what is given and tells nothing."""
        return tuple(_Telling(self).stops())


def leaves_ink(step: Step) -> bool:
    """Whether what a step leaves is usually seen."""
    return not (step.op.formula or step.op.reads) and rule_of(step) is not None


class _Telling:
    """The stops of a view while they are put in their order."""

    def __init__(self, played: Played) -> None:
        self.played = played
        self.inked = {slot for one in played.shown if not one.again for slot in one.marks}
        self.waiting = played.lines(played.first)
        self.own = {told.slot: told for told in self.waiting}
        self.waiting = [told for told in self.waiting if told.slot not in self.inked]
        self.done: set[int] = set()
        self.rows: dict[int, list[StepLine]] = {}
        self.gone: dict[int, set[int]] = {}

    def stops(self) -> Iterator[Stop]:
        """Yield the stops: those of the first position in turn, those of the others where they are drawn."""
        played, first = self.played, self.played.first
        yield Stop(played.shown[0], first, ())
        rest = played.shown[1:]
        for n, one in enumerate(rest):
            if one.again:
                due = next((x.marks[0] for x in rest[n:] if not x.again), None)
                yield from self.told_before(due, kept=True)
                place = first if one.position is None else one.position
                told = tuple(self.again(one, place))
                yield Stop(one, place, told, tuple(self.missing(place)))
            else:
                (slot,) = one.marks
                yield from self.told_before(slot)
                self.done.add(slot)
                yield Stop(one, first, (self.own[slot],) if slot in self.own else ())
        yield from self.told_before(None)

    def told_before(self, due: int | None, *, kept: bool = False) -> Iterator[Stop]:
        """Yield the steps without ink that stand before the one that is ``due``, or before the end.

        ``kept``: those that it needs are kept until it is drawn.
        """
        order = self.played.order
        end = len(order) if due is None else order[due]
        needed = self.needed(due) if kept and due is not None else set()
        for told in list(self.waiting):
            if told.at < end and told.slot not in needed and (due is None or self.ready(told)):
                self.waiting.remove(told)
                self.done.add(told.slot)
                yield Stop(None, self.played.first, (told,))

    def ready(self, told: StepLine) -> bool:
        """Whether what the step of a line uses is there."""
        step = told.line.step
        assert step is not None
        untold = {one.slot for one in self.waiting}
        used = {mark.slot for mark in step.uses}
        return not (used & (self.inked | untold)) - self.done

    def needed(self, due: int) -> set[int]:
        """Return the marks of waiting lines that a step comes of."""
        untold, found = {one.slot: one for one in self.waiting}, set[int]()
        wanted = [mark.slot for mark in self.played.steps[due].uses]
        while wanted:
            slot = wanted.pop()
            if slot in untold and slot not in found:
                found.add(slot)
                wanted += [mark.slot for mark in self.played.steps[slot].uses]
        return found

    def again(self, one: Picture, place: int) -> Iterator[StepLine]:
        """Yield what is told of another position: what has other figures there, what was not told before."""
        if place not in self.rows:
            self.rows[place] = self.played.lines(place)
            self.gone[place] = self.own.keys() - {told.slot for told in self.rows[place]}
        drawn, left = set(one.marks), []
        for told in self.rows[place]:
            before = self.own.get(told.slot)
            if told.slot not in (drawn if before is None or told.slot in drawn else self.done):
                left.append(told)
            elif before is None or before.line.calculation != told.line.calculation:
                yield told
        self.rows[place] = left

    def missing(self, place: int) -> Iterator[Mark]:
        """Yield, once, what was made in the first position so far and is not there in another one."""
        gone = self.gone[place] & self.done
        self.gone[place] -= gone
        yield from (self.played.steps[slot].it for slot in sorted(gone))
