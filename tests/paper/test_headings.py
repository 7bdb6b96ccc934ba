"""Captions once a row: one heading with the scale factor of all, a number at each plan, each still a view."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path

import pytest
from support.gallery import CASES
from support.mechanisms import sample
from support.rewritten import text_of

from graphic_tmm.fitting.formats import room_on
from graphic_tmm.note.figures import picture
from graphic_tmm.paper.compose.sheets import Order
from graphic_tmm.paper.compose.sheets import composed as laid
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import HEADING, Drawing, Sheet, line
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.headings import headings
from graphic_tmm.paper.lettering.letters import letter, plain
from graphic_tmm.paper.packing import GAP, Room, bounds
from graphic_tmm.paper.views import alone, in_rows
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

TAIL = """
accelerations = [1, 3, 6]
[[sheet]]
format = "{format}"
place = ["equations", "positions", "velocities", "accelerations", "results"]
"""
HIGH = HEIGHTS["A1"]


def strangers(folder: Path) -> Iterator[tuple[Sheet, ...]]:
    """Yield the sheets of random mechanisms, and of one found from outside, in their usual size."""
    texts = [
        text_of(one.mechanism, one.phi, 12, TAIL.format(format=("A1", "A2", "A1 portrait")[k % 3]))
        for k, one in enumerate(sample(6, seed=43, dyads=(1, 3)))
    ]
    texts.append((CASES / "sheets" / "upright.toml").read_text(encoding="utf-8"))
    for k, text in enumerate(texts):
        file = folder / f"{k}.toml"
        file.write_text(text, encoding="utf-8")
        yield sheets(read(file))[1]


def rows_of(sheet: Sheet) -> dict[str, list[Drawing]]:
    """Return the plans of a sheet that stand in rows, by their kind."""
    found: dict[str, list[Drawing]] = {}
    for view in sheet.drawings[1:]:
        kind, _, number = view.name.partition("-")
        if kind in ("velocities", "accelerations") and number:
            found.setdefault(kind, []).append(view)
    return found


def lines_of(views: list[Drawing]) -> list[tuple[float, float, float, float]]:
    """Return the boxes of the lines in which plans stand, from the top."""
    found: dict[float, list[tuple[float, float, float, float]]] = {}
    for view in views:
        found.setdefault(round(bounds(view)[1] + view.foot, 1), []).append(bounds(view))
    return [
        (min(b[0] for b in row), level, max(b[2] for b in row), max(b[3] for b in row))
        for level, row in sorted(found.items(), reverse=True)
    ]


def caption(view: Drawing) -> list[str]:
    low = bounds(view)[1] + view.foot - 1e-6
    return [label.text for label in view.labels if label.at.imag < low]


def clear(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


@pytest.mark.slow
def test_a_row_has_one_heading_and_every_plan_its_number(tmp_path: Path) -> None:
    plans = larger = broken = 0
    for papers in strangers(tmp_path):
        for sheet in papers:
            told = {one.name: one for one in sheet.drawings if one.role == HEADING}
            assert {re.sub(r"-\d+$", "", name) for name in told} == {
                f"heading-{kind}" for kind in rows_of(sheet)
            }
            for kind, views in rows_of(sheet).items():
                own = [one for name, one in told.items() if name.startswith(f"heading-{kind}")]
                assert all(" = " in "".join(plain(n.text) for n in one.labels) for one in own)
                assert bounds(own[0])[1] >= bounds(views[0])[3]
                lines = lines_of(views)
                below = [
                    max((n for n in lines if n[3] <= bounds(each)[1]), key=lambda n: n[3])
                    for each in own
                ]
                for left, _, right, top in lines:
                    # most of a line stands below one that has a heading, or it has its own
                    above = [min(right, b[2]) - max(left, b[0]) for b in below if b[3] >= top]
                    assert max(above) > (right - left) / 2
                broken += len(own) > 1
                for view in views:
                    assert caption(view) == [view.name.partition("-")[2]]
                    assert view.shows
                    assert view.position is not None
                    left, low, right, top = bounds(view)
                    plans += 1
                    wide = letter(caption(view)[0], size=HIGH.title).width
                    larger += wide * view.foot > (right - left) * (top - low - view.foot)
    assert plans > 80
    assert broken
    assert larger <= 0.05 * plans


@pytest.mark.slow
def test_a_heading_stands_clear_within_the_frame(tmp_path: Path) -> None:
    for papers in strangers(tmp_path):
        for sheet in papers:
            boxes = [bounds(view) for view in sheet.drawings[1:]]
            assert all(clear(a, b) for a, b in combinations(boxes, 2))
            edge = room_on(sheet.format, "en", False).inner
            assert all(box[3] <= edge[3] and box[0] >= edge[0] for box in boxes)


def plan(name: str, wide: float = 60.0, high: float = 80.0) -> Drawing:
    title = f"Velocity plan, position {name}"
    return Drawing(f"velocities-{name}", title, (line("main", 0j, complex(wide, high)),))


def row(count: int, *scales: str) -> list[Drawing]:
    told = [(str(k), scales[k % len(scales)]) for k in range(count)]
    views = [plan(str(k)) for k in range(count)]
    return in_rows(views, "velocities", "Velocity plans", told, HIGH)


def test_scale_factors_that_differ_are_told_at_the_plans() -> None:
    views = row(3, "μ = 1", "μ = 2")
    assert [caption(view) for view in views] == [["0", "μ = 1"], ["1", "μ = 2"], ["2", "μ = 1"]]
    (heading,) = headings(views)
    assert [label.text for label in heading.labels] == ["Velocity plans"]


def test_one_plan_alone_has_its_own_title() -> None:
    views = row(1, "μ = 1")
    assert " ".join(caption(views[0])) == "Velocity plan, position 0 μ = 1"
    assert list(headings(views)) == []


@pytest.mark.parametrize("scales", [("μ = 1",), ("μ = 1", "μ = 2")])
def test_a_plan_by_itself_has_the_caption_of_one_alone(scales: tuple[str, ...]) -> None:
    views = row(2, *scales)
    assert " ".join(caption(alone(views[0]))) == "Velocity plan, position 0 μ = 1"
    figure = picture(views[1], "en")
    assert "Velocity plan, position 1" in figure.alt
    assert [label.text for label in figure.drawing.labels] == [scales[-1]]


def test_a_row_over_two_sheets_has_its_heading_on_both() -> None:
    views = row(40, "μ = 1")
    boxes = tuple(Outline.of(view) for view in views)
    room = Room((0.0, 0.0, 420.0, 297.0), ())
    sheets = laid([Order(boxes, (room, room), "A3")])
    assert len(sheets) > 1
    for _, places in sheets:
        stand = [views[k].moved(at - boxes[k].corner) for k, at in sorted(places.items())]
        (heading,) = headings(stand)
        others = [bounds(view) for view in stand]
        assert all(clear(bounds(heading), box) for box in others)
        assert bounds(heading)[3] <= 297.0 - GAP + 0.01
        assert heading.title == "Velocity plans, μ = 1"
