"""Task sheets as paper: nothing stands on anything else, nothing leaves the frame or enters the title block."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

import pytest
import shapely
from support.gallery import ALL
from support.set_tasks import languages_of, papers

from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.frame.frame import drawing_area
from graphic_tmm.paper.shapes import box, shape


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
