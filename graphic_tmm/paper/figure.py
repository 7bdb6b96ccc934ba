"""What a recorded construction leaves on paper: the one reader from the log to ink.

Every step leaves its strokes by the rule of its operation (`rules`), or is named there as leaving no trace. A
stroke knows the mark whose step left it and the position it belongs to. What only helped is rubbed out at the
end, as at the board; everything else stays and is the sheet's view, once the bodies of the plan and what a view
adds have joined it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field

from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted
from graphic_tmm.paper.rules import rule_of, stays
from graphic_tmm.paper.seen import Rule, Seen, Subject


@dataclass(frozen=True)
class Manner:
    """How a view inks its steps, where not as usual.

    ``rules``: by the name of an operation what it leaves instead; ``marks``: by the mark that a step left;
    ``stays``: whether what a step leaves is there at the end.
    """

    rules: Mapping[str, Rule] = field(default_factory=dict)
    stays: Callable[[Seen, Step], bool] | None = None
    marks: Mapping[Mark, Rule] = field(default_factory=dict)


def showing(marks: Mapping[Mark, Rule], rules: Mapping[str, Rule] | None = None) -> Manner:
    """Return the manner in which some marks stay, each by a rule, and all else is rubbed out at the end."""
    return Manner(rules or {}, lambda seen, step: step.it in marks, marks)


class Traces:
    """The strokes that the steps of a plan leave, each with its mark and its position: see `figure`."""

    def __init__(self, seen: Seen, staying: tuple[Ink, ...], rubbed: tuple[Ink, ...]) -> None:
        self.seen, self.staying, self.rubbed = seen, staying, rubbed

    def drawing(
        self,
        subject: Subject,
        strokes: Iterable[Ink],
        wanted: Iterable[Wanted],
        labels: Iterable[Label] = (),
        positions: Iterable[tuple[int, str]] = (),
    ) -> Drawing:
        """Return the view: ``strokes``, of which what stays is a part, its letters and what is rubbed out.

        ``positions``: what those that stand in it together are called, by index.
        """
        return Drawing(
            subject.name or self.seen.views[0],
            subject.title,
            tuple(strokes),
            tuple(labels),
            rubbed=self.rubbed,
            shows=self.seen.views,
            wanted=tuple(wanted),
            numbers=tuple(positions),
        )


def figure(seen: Seen, manner: Manner | None = None, *, helping: bool = True) -> Traces:
    """Return what the steps of a plan leave, in the order in which they are done.

    Not ``helping``: without what is rubbed out at the end.
    """
    manner = manner or Manner()
    keep = manner.stays or stays
    staying: list[Ink] = []
    rubbed: list[Ink] = []
    for step in seen.steps:
        rule = manner.marks.get(step.it) or manner.rules.get(step.op.name) or rule_of(step)
        if rule is None:
            continue
        stays_ = keep(seen, step)
        if not (stays_ or helping):
            continue
        kept = staying if stays_ else rubbed
        varies = seen.varies(step)
        for k in seen.positions if varies else seen.positions[:1]:
            for stroke in rule(seen, step, k):
                of = stroke.of or (step.it.slot,)
                kept.append(stroke._replace(of=of, position=k if varies else None))
    return Traces(seen, tuple(staying), tuple(rubbed))


def body(
    strokes: Iterable[Ink], part: str, marks: Iterable[Mark], position: int | None = None
) -> Iterator[Ink]:
    """Yield the strokes of a body of the plan, which stands on marks: it is there when they are."""
    of = tuple(dict.fromkeys(mark.slot for mark in marks))
    for stroke in strokes:
        yield stroke._replace(of=of, part=part, position=position)


def added(strokes: Iterable[Ink], part: str) -> Iterator[Ink]:
    """Yield strokes that a view adds to a plan: axes, dimensions, hatching."""
    for stroke in strokes:
        yield stroke._replace(part=stroke.part or part)


@dataclass(frozen=True)
class Picture:
    """One picture of a plan being drawn: the marks whose steps are done in it, the position (None: all).

    ``ink``: what is drawn; ``letters``: what is lettered. ``given``: it shows what is there before the first
    step. ``again``: it repeats the steps of the first position in another one.
    """

    marks: tuple[int, ...]
    position: int | None
    ink: tuple[Ink, ...]
    letters: tuple[Label, ...]
    given: bool = False
    again: bool = False


def pictures(
    construction: Construction, drawing: Drawing, begin: int | None = None
) -> tuple[Picture, ...]:
    """Return the pictures of a view in the order in which it is drawn: the given first, then its steps.

    ``begin``: the position (index) that is drawn step by step, of those that have ink; None: the first of them.
    A body and a letter appear with the last of the marks that they stand on, the names of points in one place
    with the first of these; what a view adds is there at once, or with the marks that it begins with;
    where no ink is given, letters of given points wait for the first of it; if there are none, all letters do.
    What is the same in all positions is drawn once, with the first position; the others follow, one picture
    each, and then what comes of all of them: a curve through their points. Where steps of positions need that
    (the curve of a diagram that another is drawn from), they follow in turn.
    """
    order = {step.it.slot: n for n, step in enumerate(construction.steps)}
    points = _points(construction)
    ink: dict[_When, list[Ink]] = {}
    letters: dict[_When, list[Label]] = {}
    for stroke in (*drawing.strokes, *drawing.rubbed):
        ink.setdefault(_when(order, stroke.of or drawing.begins, stroke.position), []).append(
            stroke
        )
    for label in drawing.labels:
        letters.setdefault(_lettered(order, points, label, drawing.begins), []).append(label)
    begun = (-1, None)
    if begun not in ink and begun in letters:
        given = letters.pop(begun)
        waiting = [one for one in given if one.of] or given
        first = min((*ink, *letters), key=_in_turn, default=begun)
        letters[first] = [*waiting, *letters.get(first, ())]
        letters.setdefault(begun, []).extend(one for one in given if one not in waiting)
    made = [Picture((), None, tuple(ink.pop(begun, ())), tuple(letters.pop(begun, ())), given=True)]
    keys = sorted({*ink, *letters}, key=_in_turn)
    for some, again in _of_a_step(_together(construction, keys, begin)):
        made.append(
            Picture(
                tuple(dict.fromkeys(construction.steps[n].it.slot for n, _ in some)),
                next((k for _, k in some if k is not None), None),
                tuple(s for key in some for s in ink.get(key, ())),
                tuple(s for key in some for s in letters.get(key, ())),
                again=again,
            )
        )
    return tuple(made)


_When = tuple[int, int | None]
"""The number of the step with which something appears, -1 before the first, and its position (None: all)."""


def _points(construction: Construction) -> set[int]:
    """Return the slots of the points of a log."""
    steps = (step.it for step in construction.steps)
    return {mark.slot for mark in (*construction.given, *steps) if mark.kind is Point}


def _lettered(
    order: Mapping[int, int], points: Set[int], label: Label, begins: tuple[int, ...] = ()
) -> _When:
    """Return when a letter appears; the names of points in one place (p, b) with the first of them."""
    of = label.of
    if len(of) > 1 and points >= set(of) and len(label.text.split(", ")) == len(of):
        of = (min(of, key=lambda slot: order.get(slot, -1)),)
    return _when(order, of or begins, label.position)


def _when(order: Mapping[int, int], of: tuple[int, ...], position: int | None) -> _When:
    last = max((order.get(slot, -1) for slot in of), default=-1)
    return (last, position) if last >= 0 else (-1, None)


def _in_turn(key: _When) -> tuple[int, int]:
    """Return by what things stand in turn: of one step what is the same in all positions is first."""
    return key[0], -1 if key[1] is None else key[1]


def _latest(construction: Construction, own: Set[int]) -> Mapping[int, int]:
    """Return, for steps that are no position's own but come of such, the number of the last one.

    ``own``: the numbers of steps that differ from position to position. A curve through the points of a row
    comes of the last of these.
    """
    number = {step.it: n for n, step in enumerate(construction.steps)}
    found: dict[int, int] = {}
    for n, step in enumerate(construction.steps):
        used = (number.get(mark, -1) for mark in step.uses)
        last = max((m if m in own else found.get(m, -1) for m in used), default=-1)
        if n not in own and last >= 0:
            found[n] = last
    return found


def _needed(construction: Construction, own: Set[int]) -> set[int]:
    """Return the numbers of the steps that steps of positions, ``own``, come of."""
    number = {step.it: n for n, step in enumerate(construction.steps)}
    found: set[int] = set()
    for n, step in reversed(list(enumerate(construction.steps))):
        if n in own or n in found:
            found.update(number[mark] for mark in step.uses if mark in number)
    return found


def _together(
    construction: Construction, keys: Sequence[_When], first: int | None
) -> Iterator[tuple[list[_When], bool]]:
    """Yield what appears in one picture, and whether it repeats in another position what the first one has.

    What comes of all positions waits until these are drawn; they are when the steps of a position need it.
    """
    count = Counter(n for n, position in keys if position is not None)
    own = {n for n, times in count.items() if times > 1}
    latest, needed = _latest(construction, own), _needed(construction, own)
    there = {k for _, k in keys if k is not None}
    first = first if first in there else min(there, default=None)
    others: dict[int, list[_When]] = {}
    curves: list[_When] = []
    for key in keys:
        n, position = key
        if position is not None and position != first:
            others.setdefault(position, []).append(key)
            continue
        if any(waiting[0][0] <= latest.get(n, -1) for waiting in others.values()):
            if n not in needed:
                curves.append(key)
                continue
            yield from _repeated(others, curves)
            others, curves = {}, []
        yield [key], False
    yield from _repeated(others, curves)


def _of_a_step(
    found: Iterable[tuple[list[_When], bool]],
) -> Iterator[tuple[list[_When], bool]]:
    """Yield what appears in one picture: what one step leaves in a position and in all of them is one."""
    held: list[_When] = []
    for keys, again in found:
        if held and (again or held[0][0] != keys[0][0]):
            yield held, False
            held = []
        if again:
            yield keys, True
        else:
            held += keys
    if held:
        yield held, False


def _repeated(
    others: Mapping[int, list[_When]], curves: Iterable[_When]
) -> Iterator[tuple[list[_When], bool]]:
    """Yield what is drawn again in the other positions, then what comes of all of them."""
    yield from ((others[k], True) for k in sorted(others))
    yield from (([key], False) for key in curves)
