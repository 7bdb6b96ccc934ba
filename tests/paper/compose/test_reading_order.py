"""Every sheet is read as a book is: positions first, plans in order, polygons beside their groups."""

from __future__ import annotations

import random

import pytest
from support.gallery import NAMES, paper
from support.order import LINE, faults, gap

from graphic_tmm.fitting.formats import room_on
from graphic_tmm.paper.compose import search
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import Stand
from graphic_tmm.paper.packing import bounds

GIVEN = ("table-given", "table-links", "table-pairs")
"""Tables that stand with the mechanism."""


@pytest.mark.parametrize("name", NAMES)
def test_sheets_are_read_in_order(name: str) -> None:
    made, papers = paper(name)
    assert made.mechanism is not None
    for sheet in papers:
        views = sheet.drawings[1:]
        boxes = {view.name: bounds(view) for view in views}
        bases = {view.name: bounds(view)[1] + view.foot for view in views}
        assert list(faults(boxes, bases, made.mechanism.names)) == []


def test_the_judge_of_order_sees_what_is_out_of_order() -> None:
    boxes = {
        "positions": (100.0, 300.0, 200.0, 500.0),
        "table-links": (20.0, 300.0, 90.0, 350.0),
        "velocities-1": (210.0, 400.0, 300.0, 500.0),
        "velocities-2": (310.0, 390.0, 400.0, 490.0),
        "velocities-3": (410.0, 400.0, 500.0, 500.0),
        "velocities-4": (210.0, 280.0, 300.0, 380.0),
        "accelerations-1": (510.0, 350.0, 600.0, 450.0),
        "group-2-3-1": (20.0, 20.0, 100.0, 100.0),
        "forces-2-3-1": (130.0, 20.0, 200.0, 100.0),
    }
    bases = {name: box[1] for name, box in boxes.items()}
    told = list(faults(boxes, bases, ["1", "2", "3", "4"]))
    assert [text.partition(" stands")[0] for text in told] == [
        "table-links",
        "velocities-2",
        "velocities-3",
        "accelerations-1",
        "the polygon of group-2-3-1 is 30 mm off",
    ]
    assert gap(boxes["group-2-3-1"], boxes["forces-2-3-1"]) == 30.0


@pytest.mark.parametrize("name", ["arc-cam", "four-stroke", "gear-pair", "planetary", "windrower"])
def test_tables_of_results_come_after_what_they_tell_of(name: str) -> None:
    for sheet in paper(name)[1]:
        views = [view for view in sheet.drawings[1:] if not view.name.startswith("heading-")]
        single = [bounds(view) for view in views if not view.stand.kind]
        for view in views:
            if view.stand.kind == "table" and view.name not in GIVEN:
                box = bounds(view)
                late = all(box[0] >= one[2] - LINE or box[3] <= one[1] + LINE for one in single)
                assert late, view.name


def test_a_table_of_boxes_at_random_comes_last_where_there_is_room() -> None:
    """Graphs and their table, half of an A1: the table comes before none of them."""
    room, pick = room_on("A1", "en", True), random.Random(7)
    for _ in range(20):
        sizes = [(pick.uniform(90, 240), pick.uniform(60, 200)) for _ in range(pick.randint(3, 6))]
        share = (0.45 * room.area / sum(wide * high for wide, high in sizes)) ** 0.5
        boxes = [
            Outline(f"graph-{k}", min(share, 1.0) * wide, min(share, 1.0) * high)
            for k, (wide, high) in enumerate(sizes)
        ]
        boxes.append(Outline("table", 130.0, 60.0, Stand(kind="table")))
        places = search.composed(boxes, room)
        assert places is not None
        left, top = places[len(sizes)].real, places[len(sizes)].imag + 60.0
        for k in range(len(sizes)):
            right, low = places[k].real + boxes[k].width, places[k].imag
            assert left >= right - LINE or top <= low + LINE
