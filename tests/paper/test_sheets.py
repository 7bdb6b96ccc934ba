"""Golden sheets: every folder of sheets/ redraws to the committed bytes; --redraw accepts new ones."""

from __future__ import annotations

import math
from itertools import combinations
from pathlib import Path

import pytest
import shapely
from support.gallery import FOLDERS, composed, paper

from graphic_tmm.files import write
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.studio import files_of

pytestmark = pytest.mark.every


@pytest.mark.slow
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_a_scene_redraws_to_the_committed_sheets(
    folder: Path, request: pytest.FixtureRequest
) -> None:
    texts = files_of(*composed(folder.name), ("svg",))
    if request.config.getoption("--redraw"):
        for stale in folder.glob("*.svg"):
            stale.unlink()
        write(folder, texts)
    assert {path.name for path in folder.glob("*.svg")} == set(texts)
    for name, text in texts.items():
        assert (folder / name).read_text(encoding="utf-8") == text, f"{name}: redraw with --redraw"


@pytest.mark.slow
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_few_letters_are_crossed_by_a_main_line(folder: Path) -> None:
    for sheet in paper(folder.name)[1]:
        count = crossed = 0
        for drawing in sheet.drawings:
            heavy = [shape(s) for s in drawing.strokes if s.pen in ("main", "rod", "medium")]
            tree = shapely.STRtree(heavy)
            count += len(drawing.labels)
            crossed += sum(
                bool(tree.query(box(k), predicate="intersects").size) for k in drawing.labels
            )
        assert crossed <= 0.02 * count, (sheet.name, crossed, count)


@pytest.mark.slow
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_no_leader_can_be_read_as_a_minus(folder: Path) -> None:
    """None is as short as a minus, and none that is short lies level: what is left of it under letters, too."""
    for sheet in paper(folder.name)[1]:
        for drawing in sheet.drawings:
            for one in drawing.strokes:
                if one.part == "leader":
                    (x0, y0), *_, (x1, y1) = shape(one).coords
                    long = math.hypot(x1 - x0, y1 - y0)
                    assert long > 3.5, (drawing.name, x0, y0)
                    assert long > 8.0 or abs(y1 - y0) > 0.3 * long, (drawing.name, x0, y0)


@pytest.mark.slow
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_no_leader_passes_through_another_label(folder: Path) -> None:
    """It reaches its own label unbroken, and none of the others touches it."""
    for sheet in paper(folder.name)[1]:
        for drawing in sheet.drawings:
            labels = [(label, box(label)) for label in drawing.labels]
            for one in (s for s in drawing.strokes if s.part == "leader"):
                own = [k for label, k in labels if label.of == one.of]
                others = [k for label, k in labels if label.of != one.of]
                where = (drawing.name, shape(one).coords[0])
                assert min(map(shape(one).distance, own)) < 1.0, where
                assert all(shape(one).distance(k) > 0.2 for k in others), where


@pytest.mark.slow
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_no_letter_stands_on_another_and_no_view_on_another(folder: Path) -> None:
    for sheet in paper(folder.name)[1]:
        labels = [box(label) for drawing in sheet.drawings for label in drawing.labels]
        tree = shapely.STRtree(labels)
        pairs = tree.query(labels, predicate="intersects")
        touching = [(a, b) for a, b in pairs.T if a < b]
        assert not [1 for a, b in touching if labels[a].intersection(labels[b]).area > 1e-6]
        ink = [
            shapely.box(*shapely.total_bounds([*map(shape, d.strokes), *map(box, d.labels)]))
            for d in sheet.drawings[1:]
        ]
        assert all(a.disjoint(b) for a, b in combinations(ink, 2))
