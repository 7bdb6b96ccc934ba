"""Sheets of series: nothing stands on another, all within the frame, the sentences as they are lettered."""

from __future__ import annotations

from itertools import pairwise

import pytest
import shapely
from support.each import each
from support.gallery import ALL, EVERYDAY
from support.handouts import lettered, papers, read, told

from graphic_tmm.handout.handout import overview
from graphic_tmm.handout.ink import FORMAT
from graphic_tmm.handout.sheets import pages, ratio
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.lettering.letters import SIZES
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.sheet_frame import drawing_area

SCENES = [name for name in ALL if name != "lettering"]
CHEAP = [name for name in ("slider-diagrams",) if name in EVERYDAY]
OTHER = {"slider-diagrams": "en", "crank-rocker": "ru"}
"""Scenes told in the language that is not their own, too."""
CELL = 1e-6


def rectangle(drawing: Drawing) -> shapely.Polygon:
    return shapely.box(*bounds(drawing))


def assert_nothing_overlaps(sheet: Sheet) -> None:
    """Pictures with their sentences keep apart, within the frame, off its blocks."""
    area = drawing_area(FORMAT, sheet.language, first=False)
    frame, *drawings = sheet.drawings
    boxes = [rectangle(one) for one in drawings]
    inner = shapely.box(*area.inner)
    blocks = [shapely.box(*one) for one in area.occupied]
    for k, one in enumerate(boxes):
        where = (sheet.name, drawings[k].name)
        assert inner.contains(one), where
        assert not [1 for block in blocks if block.intersection(one).area > CELL], where
        for other in boxes[:k]:
            assert one.intersection(other).area < CELL, where
    assert frame.name == "frame"
    assert (sheet.format, sheet.width, sheet.height) == (FORMAT, *size_of(FORMAT))


def assert_sentences_keep_off_ink(drawing: Drawing) -> None:
    """No stroke of a picture runs through its sentences or its number, which stand on none of its letters."""
    texts = [label for label in drawing.labels if not label.of and len(label.text) > 12]
    ink = shapely.STRtree([shape(one) for one in drawing.strokes])
    others = [label for label in drawing.labels if label not in texts]
    for one in texts:
        area = box(one)
        assert not ink.query(area, predicate="intersects").size, (drawing.name, one.text)
        assert all(area.intersection(box(two)).area < CELL for two in others), one.text
    for one, two in pairwise(texts):
        assert box(one).intersection(box(two)).area < CELL, (one.text, two.text)


def assert_letters_stand_on_none(some: list[Drawing]) -> None:
    for drawing in some:
        there = [box(label) for label in drawing.labels]
        pairs = shapely.STRtree(there).query(there, predicate="overlaps").T
        bad = [(a, b) for a, b in pairs if a < b and there[a].intersection(there[b]).area > CELL]
        assert not bad, [(drawing.labels[a].text, drawing.labels[b].text) for a, b in bad[:3]]


def judge(name: str, language: str = "") -> None:
    sheets = papers(name, language)
    for sheet in sheets:
        assert_nothing_overlaps(sheet)
        for drawing in sheet.drawings[1:]:
            assert_sentences_keep_off_ink(drawing)
            sizes = {label.size for label in drawing.labels}
            assert sizes <= set(map(float, SIZES)), (drawing.name, sizes)
        assert_letters_stand_on_none(list(sheet.drawings[1:]))
    assert_sheets_are_the_series(name, language)


def assert_sheets_are_the_series(name: str, language: str) -> None:
    """All pictures stand on the overview and on the sheets, in their order, with all that they tell."""
    sheets = papers(name, language)
    names = [drawing.name for sheet in sheets for drawing in sheet.drawings]
    whole = "".join(lettered(drawing) for sheet in sheets for drawing in sheet.drawings)
    for _, one in told(name, language):
        due = [f"{one.name} {picture.number}" for picture in one.pictures]
        shown = [drawing for drawing in dict.fromkeys(names) if drawing in due]
        assert shown == due
        small = [f"{one.name} small {picture.number}" for picture in one.pictures]
        assert [drawing for drawing in names if drawing in small] == small
        said = "".join(
            lettered(drawing) for page in pages(one) for drawing in page if drawing.name in due
        )
        for picture in one.pictures:
            for line in picture.lines:
                assert read(line.text) in said, line.text
                assert read(line.calculation) in said, line.calculation
                assert read(line.why) in said, line.why
        assert read(one.title) in whole


@pytest.mark.parametrize("name", CHEAP)
@pytest.mark.slow
def test_the_sheets_of_a_scene(name: str) -> None:
    judge(name)


@pytest.mark.slow
@pytest.mark.parametrize("name", OTHER)
def test_the_sheets_speak_either_language(name: str) -> None:
    judge(name, OTHER[name])


@pytest.mark.slow
@each("name", sorted(set(SCENES) - set(CHEAP)), turns=1)
def test_the_sheets_of_every_scene(name: str) -> None:
    judge(name)


def test_several_pictures_stand_on_a_sheet() -> None:
    for name in CHEAP:
        for _, one in told(name):
            assert len(one.pictures) >= 2.5 * len(pages(one)), one.name


@pytest.mark.slow
def test_the_overview_is_one_sheet_where_it_can_be() -> None:
    found = [one for _, one in told("crank-rocker")]
    assert sum(len(one.pictures) for one in found) < 80
    assert len(overview(found, "Overview", "en")) <= 2
    assert len(overview(found[1:2], "Overview", "en")) == 1


def test_scales_are_written_as_the_field_does() -> None:
    assert [ratio(f, "en") for f in (10.0, 2.5, 1.0, 1 / 2, 1 / 2.5)] == [
        "10:1",
        "2.5:1",
        "1:1",
        "1:2",
        "1:2.5",
    ]
    assert ratio(1 / 2.5, "ru") == "1:2,5"
