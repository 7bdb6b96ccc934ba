"""The sketch of a flywheel: outlines in their places at the scale asked for, dimensions in its millimetres."""

from __future__ import annotations

from itertools import combinations

import pytest
import shapely

from graphic_tmm.chapters.flywheel.ink_sketch import KEYS, Sizes, draw_flywheel
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.shapes import box, shape

A2 = Sizes(0.45, 0.3825, 0.115, 0.055)


def outlines(view: Drawing) -> list[shapely.Geometry]:
    return [shape(s) for s in view.strokes if s.pen == "main"]


@pytest.mark.parametrize("reduction", [2.5, 4.0, 5.0])
def test_the_rim_is_as_large_as_the_scale_says(reduction: float) -> None:
    view = draw_flywheel(A2, reduction, "x", "ru")
    left, low, right, high = shapely.total_bounds(outlines(view))
    assert high - low == pytest.approx(450.0 / reduction)
    wide = [g.bounds[2] for g in outlines(view) if g.bounds[0] < 1e-9]
    assert max(wide) == pytest.approx(115.0 / reduction)
    assert right - left > 450.0 / reduction + 115.0 / reduction


def test_dimensions_are_those_of_the_flywheel() -> None:
    texts = {label.text for label in draw_flywheel(A2, 4.0, "x", "ru").labels}
    assert texts == {"⌀450", "⌀382,5", "⌀55", "115", "3 отв. ⌀16"}
    assert "3 holes ⌀16" in {k.text for k in draw_flywheel(A2, 4.0, "x", "en").labels}


@pytest.mark.parametrize("sizes", [A2, A2._replace(width=0.03), A2._replace(studs=6)])
def test_letters_stand_clear_of_each_other_and_of_outlines(sizes: Sizes) -> None:
    view = draw_flywheel(sizes, 5.0, "x", "ru")
    boxes = [box(label) for label in view.labels]
    assert all(a.disjoint(b) for a, b in combinations(boxes, 2))
    assert all(frame.disjoint(g) for frame in boxes for g in outlines(view))


def test_stud_holes_stand_evenly_between_hub_and_rim() -> None:
    view = draw_flywheel(A2, 4.0, "x", "ru")
    sides = [(g, g.bounds) for g in outlines(view)]
    small = [g for g, b in sides if max(abs(b[2] - b[0] - 4.0), abs(b[3] - b[1] - 4.0)) < 0.1]
    assert len(small) == 3
    rings = {round(g.centroid.distance(shapely.Point(115 / 4 + 30 + 450 / 8, 0)), 3) for g in small}
    assert len(rings) == 1
    assert 0.099 * 1000 / 8 < rings.pop() < 382.5 / 8


def test_the_key_is_the_one_of_its_shaft() -> None:
    assert next(k for k in KEYS if k[0] >= 0.055)[1:] == (16, 4.3)
    assert [k[0] for k in KEYS] == sorted(k[0] for k in KEYS)


@pytest.mark.parametrize(
    "sizes", [A2._replace(shaft=0.25), A2._replace(inner=0.46), A2._replace(stud=0.2)]
)
def test_parts_that_find_no_room_are_refused(sizes: Sizes) -> None:
    with pytest.raises(SheetError, match="smaller shaft"):
        draw_flywheel(sizes, 4.0, "x", "ru")


def test_a_rim_that_would_be_a_roll_is_refused() -> None:
    with pytest.raises(SheetError, match="larger D_e"):
        draw_flywheel(A2._replace(width=23.0), 4.0, "x", "ru")
