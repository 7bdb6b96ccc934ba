"""Diagrams one below the other: their origins stand above each other, also where no sheet holds all of them."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.gallery import paper

from graphic_tmm.chapters.diagrams.task import VIEWS
from graphic_tmm.paper.drawing import Drawing, Within, line
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import stacked

sizes = st.tuples(st.floats(0.0, 60.0), st.floats(20.0, 120.0), st.floats(5.0, 80.0))


def view(name: str, left: float, right: float, high: float) -> Drawing:
    """A base from its origin to the right, with something left of it and above."""
    return Drawing(name, name, (line("thin", -left + 0j, right + 0j), line("main", 0j, 1j * high)))


def told(chosen: Sequence[int]) -> list[str]:
    return ["T", ", ".join(map(str, chosen))]


@given(st.lists(sizes, min_size=2, max_size=5), st.floats(30.0, 300.0))
def test_parts_are_equally_wide_and_none_is_lost(
    made: list[tuple[float, float, float]], room: float
) -> None:
    views = [view(str(k), *one) for k, one in enumerate(made)]
    whole = stacked("all", views, told)
    assert whole.apart is not None
    parts = whole.apart(Within(((500.0, room),)))
    left = min(bounds(one)[0] for one in views)
    right = max(bounds(one)[2] for one in views)
    found: list[int] = []
    for part in (whole, *parts):
        assert bounds(part)[0] <= left + 1e-9
        assert bounds(part)[2] >= right - 1e-9
        origins = {round(s.path[0][0], 9) for s in part.strokes if s.pen == "main"}
        assert origins == {0.0}
    for part in parts:
        words = [label.text for label in part.labels]
        assert words[0] == "T"
        own = [int(k) for k in words[1].split(", ")]
        found += own
        assert len(part.strokes) == 2 * len(own)
    assert found == list(range(len(made)))
    assert len(parts) > 1


def test_parts_are_as_large_as_there_is_room() -> None:
    views = [view(str(k), 10.0, 100.0, 40.0) for k in range(4)]
    whole = stacked("all", views)
    assert whole.apart is not None
    assert [len(part.strokes) // 2 for part in whole.apart(Within(((200.0, 90.0),)))] == [2, 2]
    assert [len(part.strokes) // 2 for part in whole.apart(Within(((200.0, 130.0),)))] == [3, 1]


@pytest.mark.slow
def test_velocities_stand_above_accelerations_on_one_sheet() -> None:
    """The figure of the published task: one A4, one axis."""
    made, sheets = paper("slider-diagrams")
    assert made.mechanism is not None
    log = made.mechanism.construction
    (sheet,) = [s for s in sheets if any(VIEWS["V"] in d.shows for d in s.drawings)]
    assert sheet.format == "A4"
    (drawing,) = [d for d in sheet.drawings if VIEWS["V"] in d.shows]
    assert drawing.shows == (VIEWS["V"], VIEWS["a"])
    feet = {s.it.slot: s.it.view for s in log.steps if s.it.letter == "i"}
    at = {
        feet[stroke.of[0]]: stroke.path[0][:2]
        for stroke in drawing.strokes
        if stroke.of and stroke.of[0] in feet and stroke.position == 0
    }
    (x, high), (below, low) = at[VIEWS["V"]], at[VIEWS["a"]]
    assert x == pytest.approx(below, abs=1e-6)
    assert high > low
