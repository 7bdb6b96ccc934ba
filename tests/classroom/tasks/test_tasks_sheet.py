"""Task sheets as paper: nothing stands on anything else, nothing leaves the frame; broken before headings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as some
from support.gallery import ALL, SHEETS
from support.set_tasks import languages_of, papers

from graphic_tmm.classroom.batch.work import done
from graphic_tmm.classroom.tasks.sheet import Band, paged
from graphic_tmm.classroom.tasks.task import task_sheets
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.variant import base
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.sheet_frame import drawing_area
from graphic_tmm.scene.document import document
from graphic_tmm.scene.packaged import SCENE
from graphic_tmm.scene.read import read

ROOM = 100.0


def bands(*heights: float, heads: tuple[int, ...] = ()) -> list[Band]:
    return [Band((), height, 2.0, k in heads) for k, height in enumerate(heights)]


def greedy(heights: list[float]) -> int:
    """How many sheets there are if each is filled as far as it goes: no fewer hold them."""
    count, used = 0, ROOM + 1.0
    for height in heights:
        if used + 2.0 + height > ROOM:
            count, used = count + 1, 0.0
        used += 2.0 + height
    return count


@given(some.lists(some.floats(1.0, 90.0), min_size=1, max_size=14))
def test_no_sheet_is_wasted_and_none_overfull(heights: list[float]) -> None:
    found = paged(bands(*heights), ROOM, ROOM, 2.0).sheets
    assert [one.height for page in found for one in page] == heights
    assert len(found) == greedy(heights)
    assert all(sum(one.height + 2.0 for one in page) <= ROOM + 1e-6 for page in found)


def test_a_break_stands_before_a_heading_that_is_near() -> None:
    found = paged(bands(40, 20, 20, 20, 20, heads=(0, 2)), ROOM, ROOM, 2.0).sheets
    assert [len(page) for page in found] == [2, 3]


def test_what_no_sheet_holds_has_one_of_its_own() -> None:
    found = paged(bands(20, 150, 20), ROOM, ROOM, 2.0).sheets
    assert [len(page) for page in found] == [1, 1, 1]


@pytest.mark.turns(2)
@pytest.mark.parametrize(
    "name", ["shaper", "lever", "crank-press", "four-stroke", "locomobile", "toggle-press"]
)
@pytest.mark.parametrize("language", ["ru", "en"])
def test_a_task_is_handed_out_on_one_sheet(name: str, language: str) -> None:
    (work,) = works(base(SHEETS / name), (), keys=(), language=language)
    assert len(done(work).files) == 1


@pytest.mark.slow
@pytest.mark.parametrize("name", ["engine", "project"])
def test_no_sheet_of_several_is_left_white(name: str) -> None:
    """What was a third white is a quarter at most, between the uppermost ink and the title block."""
    file = SHEETS / name / "scene.toml"
    made = task_sheets(read(file), *document(file, SCENE), readings=False)
    assert len(made) > 1
    for sheet in made:
        area, taken = drawing_area("A4", "ru", first=False)
        floor = max(one.top for one in taken if one.right - one.left > 100.0)
        low = min(bounds(one)[1] for one in sheet.drawings)
        assert low - floor < 0.25 * (area.top - floor), sheet


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_nothing_stands_on_anything_else(name: str, many: Callable[[int, int], int]) -> None:
    for language in languages_of(name, many):
        stands_free(papers(name, language), language)


def stands_free(found: Sequence[Sheet], language: str) -> None:
    inner, occupied = drawing_area("A4", language, first=False)
    taken = [shapely.box(one.left, one.bottom, one.right, one.top) for one in occupied]
    for sheet in found:
        labels = [box(label) for drawing in sheet.drawings for label in drawing.labels]
        pairs = shapely.STRtree(labels).query(labels, predicate="intersects")
        assert not [1 for a, b in pairs.T if a < b and labels[a].intersection(labels[b]).area > 0.1]
        ink = [
            shapely.box(*shapely.total_bounds([*map(shape, d.strokes), *map(box, d.labels)]))
            for d in sheet.drawings[1:]
        ]
        assert all(a.disjoint(b) for a, b in combinations(ink, 2))
        frame = shapely.box(inner.left, inner.bottom, inner.right, inner.top)
        assert all(frame.contains(one) for one in ink)
        assert not [1 for one in ink for other in taken if one.intersects(other)]
