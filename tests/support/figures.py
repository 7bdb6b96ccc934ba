"""What holds of every picture of a plan, whoever drew it: asked of the drawing and the log, not of the ink."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from graphic_tmm.board.record import Construction, Step
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import Picture, pictures
from graphic_tmm.paper.rules import traceless


def slots_shown(view: Drawing) -> set[int]:
    """The marks that strokes, rubbed ones too, and letters of a view come from."""
    everything = (*view.strokes, *view.rubbed, *view.labels)
    return {slot for one in everything for slot in one.of}


def steps_of(log: Construction, view: Drawing) -> list[Step]:
    """The steps of the plans that a view is the picture of, but for those that leave no trace by name."""
    there = [step for step in log.steps if step.it.view in view.shows]
    return [step for step in there if not traceless(step.op)]


def without_ink(
    log: Construction, views: Iterable[Drawing], traceless: Iterable[str] = ()
) -> set[str]:
    """The operations of steps that leave nothing in any of the views which show their plan.

    ``traceless``: operations of the chapter that leave no trace by name.
    """
    drawn = list(views)
    shown = set[int]().union(*(slots_shown(view) for view in drawn))
    wanted = {step.it.slot: step for view in drawn for step in steps_of(log, view)}
    missing = {step.op.name for slot, step in wanted.items() if slot not in shown}
    return missing - set(traceless)


def without_source(view: Drawing) -> list[str]:
    """The strokes of a plan's view that neither come from steps nor are a part of something by name."""
    return [stroke.pen for stroke in view.strokes if not (stroke.of or stroke.part)]


def assert_drawn_after_what_it_uses(log: Construction, made: Sequence[Picture]) -> None:
    """No picture does a step before those that it uses: its own position's, or where it has none those of all.

    Only steps that leave ink in the view count; those of other views, and calculations, are there.
    """
    steps = {step.it.slot: step for step in log.steps}
    due: dict[int, set[int | None]] = {}
    for picture in made:
        for slot in picture.marks:
            due.setdefault(slot, set()).add(picture.position)
    # a body that one position alone has may stand on a mark that is there in all of them
    due = {slot: places if len(places - {None}) > 1 else {None} for slot, places in due.items()}
    own = {slot for slot, places in due.items() if places != {None}}
    sources: dict[int, set[int]] = {}
    for step in log.steps:
        used = {mark.slot for mark in step.uses}
        sources[step.it.slot] = used.union(*(sources.get(s, set()) for s in used - due.keys()))
    done: set[tuple[int, int | None]] = set()
    for picture in made:
        done |= {(s, picture.position if s in own else None) for s in picture.marks}
        for slot in picture.marks:
            if picture.position is None and slot in own:
                continue  # what is the same of a step whose other ink differs from position to position
            for used in sources[slot] & due.keys():
                places = (
                    due[used] if picture.position is None else due[used] & {picture.position, None}
                )
                missing = {(used, place) for place in places} - done
                assert not missing, (steps[slot], steps[used])


def assert_pictures_make_the_view(log: Construction, view: Drawing) -> None:
    """The last picture without what is rubbed out is the view; no stroke is drawn twice or too early."""
    made = pictures(log, view)
    ink = [stroke for picture in made for stroke in picture.ink]
    letters = [label for picture in made for label in picture.letters]
    rubbed = set(view.rubbed)
    assert sorted(map(repr, ink)) == sorted(map(repr, (*view.strokes, *view.rubbed)))
    assert sorted(map(repr, letters)) == sorted(map(repr, view.labels))
    left = [stroke for stroke in ink if stroke not in rubbed]
    assert set(left) == set(view.strokes)
    order = {step.it.slot: n for n, step in enumerate(log.steps)}
    last: dict[int | None, int] = {}
    for picture in made[1:]:
        when = max(order[slot] for slot in picture.marks)
        if picture.position is not None:
            assert when > last.get(picture.position, -1), "pictures go in the order of the steps"
        last[picture.position] = when
        for stroke in picture.ink:
            assert all(order.get(slot, -1) <= when for slot in stroke.of)
        for label in picture.letters:
            there = [order.get(slot, -1) <= when for slot in label.of]
            assert all(there) or (", " in label.text and any(there)), "one name is there at least"
    assert_drawn_after_what_it_uses(log, made)
