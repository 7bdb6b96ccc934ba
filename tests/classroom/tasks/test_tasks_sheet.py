"""Task sheets as paper: nothing stands on anything else, nothing leaves the frame or enters the title block."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import pytest
import shapely
from support.each import each
from support.gallery import ALL, SHEETS

from graphic_tmm.classroom.tasks.task import task_sheets
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.frame.frame import drawing_area
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.scene.document import document
from graphic_tmm.scene.read import SCENE, read


def papers(name: str, language: str) -> list[Sheet]:
    file = SHEETS / name / "scene.toml"
    return task_sheets(
        replace(read(file), language=language), *document(file, SCENE), readings=True
    )


@pytest.mark.slow
@each("name", ALL)
@each("language", ["ru", "en"])
def test_nothing_stands_on_anything_else(language: str, name: str) -> None:
    inner, occupied = drawing_area("A4", language, first=False)
    taken = [shapely.box(one.left, one.bottom, one.right, one.top) for one in occupied]
    for sheet in papers(name, language):
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
