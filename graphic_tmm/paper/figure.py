"""What a recorded construction leaves on paper: the one reader from the log to ink.

Every step leaves its strokes by the rule of its operation (`rules`), or is named there as leaving no trace. A
stroke knows the mark whose step left it and the position it belongs to. What only helped is rubbed out at the
end, as at the board; everything else stays and is the sheet's view, once the bodies of the plan and what a view
adds have joined it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.paper.drawing import Drawing, Ink, Label
from graphic_tmm.paper.rules import rule_of, stays
from graphic_tmm.paper.seen import Rule, Seen


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


def figure(seen: Seen, manner: Manner | None = None) -> Traces:
    """Return what the steps of a plan leave, in the order in which they are done."""
    manner = manner or Manner()
    keep = manner.stays or stays
    staying: list[Ink] = []
    rubbed: list[Ink] = []
    for step in seen.steps:
        rule = manner.marks.get(step.it) or manner.rules.get(step.op.name) or rule_of(step)
        if rule is None:
            continue
        kept = staying if keep(seen, step) else rubbed
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


def pictures(construction: Construction, drawing: Drawing) -> tuple[Picture, ...]:
    """Return the pictures of a view in the order in which it is drawn: the given first, then its steps.

    A body and a letter appear with the last of the marks that they stand on; what a view adds is there from the
    beginning. In other positions than the first, steps that follow each other make one picture.
    """
    order = {step.it.slot: n for n, step in enumerate(construction.steps)}
    ink: dict[tuple[int, int | None], list[Ink]] = {}
    letters: dict[tuple[int, int | None], list[Label]] = {}
    for stroke in (*drawing.strokes, *drawing.rubbed):
        ink.setdefault(_when(order, stroke.of, stroke.position), []).append(stroke)
    for label in drawing.labels:
        letters.setdefault(_when(order, label.of, label.position), []).append(label)
    begun = (-1, None)
    made = [Picture((), None, tuple(ink.pop(begun, ())), tuple(letters.pop(begun, ())), given=True)]
    keys = sorted({*ink, *letters}, key=lambda key: (key[0], -1 if key[1] is None else key[1]))
    first = min((k for _, k in keys if k is not None), default=None)
    slots = {n: slot for slot, n in order.items()}
    for run in _runs(keys):
        others: dict[int | None, list[tuple[int, int | None]]] = {}
        for key in run:
            others.setdefault(key[1], []).append(key)
        for position in sorted(others, key=lambda k: -1 if k is None else k):
            again = position is not None and position != first
            for some in [others[position]] if again else [[key] for key in others[position]]:
                made.append(
                    Picture(
                        tuple(slots[n] for n, _ in some if n >= 0),
                        position,
                        tuple(s for key in some for s in ink.get(key, ())),
                        tuple(s for key in some for s in letters.get(key, ())),
                        again=again,
                    )
                )
    return tuple(made)


class Part(NamedTuple):
    """What of a view belongs together: its strokes, rubbed ones among them, and its letters."""

    ink: tuple[Ink, ...]
    letters: tuple[Label, ...]


def of_step(drawing: Drawing, mark: Mark) -> Part:
    """Return what the step that left a mark drew, and the letters that name it."""
    return Part(
        tuple(s for s in (*drawing.strokes, *drawing.rubbed) if not s.part and mark.slot in s.of),
        tuple(label for label in drawing.labels if mark.slot in label.of),
    )


def until(construction: Construction, drawing: Drawing, mark: Mark, position: int) -> Part:
    """Return what is there when the step that leaves a mark is done in a position: helping lines too.

    What is the same in all positions is there with its step; in positions before it all is there.
    """
    order = {step.it.slot: n for n, step in enumerate(construction.steps)}
    now = order[mark.slot]

    def there(one: Ink | Label) -> bool:
        when, place = _when(order, one.of, one.position)
        return when <= now if place is None or place == position else place < position

    ink = (*drawing.strokes, *drawing.rubbed)
    return Part(tuple(filter(there, ink)), tuple(filter(there, drawing.labels)))


def _when(
    order: Mapping[int, int], of: tuple[int, ...], position: int | None
) -> tuple[int, int | None]:
    """Return the step with which something appears, -1 before the first, and its position."""
    last = max((order.get(slot, -1) for slot in of), default=-1)
    return (last, position) if last >= 0 else (-1, None)


def _runs(
    keys: Sequence[tuple[int, int | None]],
) -> Iterator[list[tuple[int, int | None]]]:
    """Yield what appears in runs: of steps that differ from position to position, and of those that do not."""
    run: list[tuple[int, int | None]] = []
    for key in keys:
        if run and (key[1] is None) != (run[-1][1] is None):
            yield run
            run = []
        run.append(key)
    if run:
        yield run
