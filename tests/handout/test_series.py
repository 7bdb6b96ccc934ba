"""A series is the log: a picture a step with ink, the view in the end, every line of the protocol told."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

import pytest
from support.each import each
from support.gallery import ALL, EVERYDAY
from support.handouts import drawn_last, shape_of, told

from graphic_tmm.handout.chosen import Chosen
from graphic_tmm.handout.ink import HEIGHTS
from graphic_tmm.handout.series import Series
from graphic_tmm.handout.story import places_of
from graphic_tmm.paper.drawing import Ink, Stroke
from graphic_tmm.readers.narration import protocol
from graphic_tmm.readers.protocol import covering
from graphic_tmm.scene.chapter import MECHANISM

SCENES = [name for name in ALL if name != "lettering"]
CHEAP = [name for name in ("slider-diagrams", "crank-rocker") if name in EVERYDAY]
THIN = {"thin", "dashed", "centre", "phantom", "outline", "pin", "over", "paper"}


def assert_a_picture_a_step(one: Chosen, found: Series) -> None:
    """Each step that leaves ink or a letter has one picture, and one for each other position in which it is."""
    view = one.draw(found.factor, True)
    due = drawn_last(one.drawn.construction, view)
    made = found.pictures[:-1] if found.ready else found.pictures
    alone = Counter(slot for picture in made if not picture.again for slot in picture.marks)
    again = Counter(slot for picture in made if picture.again for slot in picture.marks)
    assert sum(1 for picture in made if picture.marks and not picture.again) == alone.total()
    everywhere = set[int | None]().union(*due.values()) - {None}
    own = places_of(one.drawn, view).get(one.place)
    begin = own if own in everywhere else min(everywhere, default=None, key=lambda k: k or 0)
    for slot, places in due.items():
        assert alone[slot] == bool(places & {begin, None}), slot
        assert again[slot] == len(places - {begin, None}), slot
    assert alone.keys() | again.keys() == due.keys()
    assert [picture.number for picture in found.pictures] == list(
        range(found.pictures[0].number, found.pictures[0].number + len(found.pictures))
    )
    assert found.pictures[0].number in (0, 1)


def assert_the_view_in_the_end(one: Chosen, found: Series) -> None:
    """The last picture without rubbed-out ink is the sheet's view, so many times as large."""
    view = one.draw(found.factor, True)
    step = found.pictures[-2] if found.ready else found.pictures[-1]
    left = Counter(map(shape_of, step.ink))
    whole = Counter(shape_of(stroke) for stroke in _times(view.strokes, found.factor))
    rubbed = Counter(shape_of(stroke) for stroke in _times(view.rubbed, found.factor))
    assert left == whole + rubbed
    if found.ready:
        assert Counter(map(shape_of, found.pictures[-1].ink)) == whole
        assert [s.pen for s in found.pictures[-1].ink] == [s.pen for s in view.strokes]


def assert_as_on_its_sheet(one: Chosen, found: Series) -> None:
    """What is heavy lies as the view of the scene's own sheet has it, so many times as large."""
    there: dict[object, list[tuple[float, ...]]] = {}
    for stroke in found.pictures[-1].ink:
        there.setdefault((stroke.of, stroke.position), []).append(shape_of(stroke))
    own = [s for s in one.view.strokes if s.pen in ("main", "medium") and s.of and not s.part]
    solid = [s for s in own if not (isinstance(s, Stroke) and (s.filled or s.data))]
    ways: set[complex] = set()
    for stroke in _times(solid, found.factor):
        shape = shape_of(stroke)
        alike = [o for o in there.get((stroke.of, stroke.position), []) if len(o) == len(shape)]
        here = {_way(shape, other) for other in alike} - {None}
        assert here, stroke
        ways = (
            {way for way in ways if near(way, here)} if ways else {w for w in here if w is not None}
        )
        assert ways, stroke


def _way(shape: tuple[float, ...], other: tuple[float, ...]) -> complex | None:
    """How far one line lies from another of the same shape, mm; None if it has another shape."""
    ways = [
        complex(*other[k : k + 2]) - complex(*shape[k : k + 2]) for k in range(0, len(shape), 2)
    ]
    return ways[0] if all(abs(way - ways[0]) < CLOSE for way in ways) else None


CLOSE = 0.01
"""Places nearer to one another, mm, are one."""


def near(way: complex, some: Iterable[complex | None]) -> bool:
    return any(other is not None and abs(way - other) < CLOSE for other in some)


def _times(strokes: Iterable[Ink], factor: float) -> Iterator[Ink]:
    for one in strokes:
        if isinstance(one, Stroke):
            yield one._replace(path=tuple((x * factor, y * factor, b) for x, y, b in one.path))
        else:
            yield one._replace(controls=tuple(z * factor for z in one.controls))


def assert_all_is_told(some: Sequence[tuple[Chosen, Series]]) -> None:
    """Each line of the protocol of the plans is told, as it stands, in its own view; none of another."""
    due: dict[tuple[str, str, int], set[Told]] = {}
    found: dict[tuple[str, str, int], set[Told]] = {}
    for one, made in some:
        for view in one.view.shows:
            for number, words in lines_of(one, view):
                due.setdefault((one.drawn.board, view, number), set()).add(words)
        for line in (line for picture in made.pictures for line in picture.lines):
            if line.step is not None:
                key = one.drawn.board, line.step.it.view, line.number
                found.setdefault(key, set()).add((line.text, line.calculation, line.why))
    assert found.keys() == due.keys()
    assert not {key: told - due[key] for key, told in found.items() if told - due[key]}


Told = tuple[str, str, str]
"""A line: its sentence, its calculation, its reason."""


def lines_of(one: Chosen, view: str) -> Iterator[tuple[int, Told]]:
    """The protocol of a view in the position of its pictures, by the numbers of the lines."""
    drawn, reading = one.drawn, one.drawn.of(view)
    if reading is None:
        return
    row = drawn.row(view)
    place = row.index(one.place) if view in drawn.project.rows and one.place in row else one.place
    others: list[tuple[int, str]] = []
    if drawn.board != MECHANISM:
        marks = [step.it for step in drawn.construction.steps if step.it.view == view]
        others = [(k, drawn.names[k]) for k in covering(reading, marks, [place])]
    turned = drawn.scene.turned and drawn.board == MECHANISM
    for line in protocol(
        drawn.construction,
        view,
        reading,
        place,
        drawn.scene.language,
        turned=turned,
        elsewhere=others,
    ):
        if line.number:
            yield line.number, (line.text, line.calculation, line.why)


def assert_numbers_go_on(one: Chosen, found: Series) -> None:
    """Steps of one plan are told in their order, but for curves that wait for all positions."""
    last: dict[str, int] = {}
    waits = {step.it.slot for step in one.drawn.construction.steps if step.op.across}
    for picture in found.pictures:
        if picture.again:
            return
        for line in picture.lines:
            if line.step is not None and line.step.it.slot not in waits:
                assert line.number > last.get(line.step.it.view, 0), line
                last[line.step.it.view] = line.number


def assert_done_is_thin_and_new_is_heavy(found: Series) -> None:
    """What was there is thin; a step's own lines are not."""
    before = 0
    for picture in found.pictures[: -1 if found.ready else None]:
        assert all(s.pen in THIN for s in picture.ink[:before] if not _solid(s)), picture.number
        new = picture.ink[before:]
        heavy = [s for s in new if not s.part and s.pen not in ("dashed", "centre", "phantom")]
        assert all(s.pen not in THIN for s in heavy) or not picture.marks, picture.number
        before = len(picture.ink)


def _solid(stroke: Ink) -> bool:
    return isinstance(stroke, Stroke) and stroke.filled


def assert_letters_are_standard(found: Series) -> None:
    """Letters within pictures have the heights of ГОСТ 2.304 that are meant for them, whatever the scale."""
    sizes = {label.size for picture in found.pictures for label in picture.letters}
    assert sizes <= set(HEIGHTS), sizes


def judge(name: str) -> None:
    some = told(name)
    assert some
    for one, found in some:
        try:
            assert_a_picture_a_step(one, found)
            assert_the_view_in_the_end(one, found)
            assert_as_on_its_sheet(one, found)
            assert_numbers_go_on(one, found)
            assert_done_is_thin_and_new_is_heavy(found)
            assert_letters_are_standard(found)
        except AssertionError as error:
            error.add_note(found.name)
            raise
    assert_all_is_told(some)


@pytest.mark.parametrize("name", CHEAP)
def test_the_series_of_a_scene(name: str) -> None:
    judge(name)


@pytest.mark.slow
@each("name", sorted(set(SCENES) - set(CHEAP)), turns=1)
def test_the_series_of_every_scene(name: str) -> None:
    judge(name)
