"""Layout: views never overlap, never leave their room; what does not fit says so."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most

from graphic_tmm.errors import SheetError, ViewError
from graphic_tmm.paper.compose.sheets import pack
from graphic_tmm.paper.drawing import Drawing, Stand, line
from graphic_tmm.paper.packing import GAP, Room, bounds, in_pieces

ROOM = Room((20.0, 5.0, 836.0, 589.0), ((651.0, 5.0, 836.0, 60.0), (20.0, 575.0, 90.0, 589.0)))
kinds = st.sampled_from(["velocities-1", "table-links", "accelerations-2"])
sizes = st.tuples(kinds, st.integers(5, 300), st.integers(5, 250))


def view(name: str, width: float, height: float) -> Drawing:
    return Drawing(name, name, (line("thin", 3 + 4j, complex(3 + width, 4 + height)),))


def apart(a: tuple, b: tuple) -> bool:
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


@settings(max_examples=most(25), deadline=None)
@given(st.lists(sizes, min_size=1, max_size=25), st.booleans())
def test_views_never_overlap_or_leave_their_room(rows: list, first: bool) -> None:
    views = [view("positions", 200, 230)] * first + [view(*row) for row in rows]
    sheets = pack(views, (ROOM, ROOM), "A1")
    assert sum(map(len, sheets)) == len(views)
    for sheet in sheets:
        boxes = [bounds(v) for v in sheet]
        for box in boxes:
            assert box[0] + 1e-6 >= 20 + GAP
            assert box[2] <= 836 - GAP + 1e-6
            assert box[1] + 1e-6 >= 5 + GAP
            assert box[3] <= 589 - GAP + 1e-6
            assert all(apart(box, taken) for taken in ROOM.occupied)
        assert all(apart(a, b) for a, b in itertools.combinations(boxes, 2))


def test_plans_stand_in_rows_in_order_from_what_leads_on() -> None:
    views = [view("positions", 200, 300)._replace(stand=Stand(kind="lead"))] + [
        view(f"velocities-{k}", 100, 90)._replace(stand=Stand("velocities", "row"))
        for k in range(8)
    ]
    (sheet,) = pack(views, (ROOM, ROOM), "A1")
    placed = {one.name: bounds(one) for one in sheet}
    first, *rest = (placed[one.name] for one in views)
    assert first[0] == min(box[0] for box in placed.values())
    assert first[3] + 1e-6 >= max(box[3] for box in rest)
    for one, two in itertools.pairwise(rest):
        same = one[1] == pytest.approx(two[1])
        assert two[0] >= one[2] + GAP - 1e-6 if same else two[3] <= one[1] - GAP + 1e-6


def test_a_view_that_fits_no_sheet_says_its_name_and_size() -> None:
    with pytest.raises(ViewError, match=r"900×20 mm and does not fit on A1") as told:
        pack([view("velocities-1", 900, 20)], (ROOM, ROOM), "A1")
    assert told.value.view == "velocities-1"
    assert told.value.size == (900.0, 20.0)


def test_a_view_comes_apart_only_where_no_sheet_holds_it() -> None:
    halves = [view("table-a", 400, 20), view("table-b", 400, 20)]
    whole = view("table", 800, 20)._replace(apart=lambda within: halves)
    assert in_pieces(whole, ROOM.within) == [whole]
    wider = view("table", 810, 20)._replace(apart=lambda within: halves)
    assert in_pieces(wider, ROOM.within) == halves
    stand = Stand("group-2-3-1", "pair", position=1)
    parts = in_pieces(wider._replace(stand=stand), ROOM.within)
    assert [part.stand for part in parts] == [stand, stand]


def test_a_sheet_offers_its_largest_free_rectangles() -> None:
    # the whole width above the title block, or below the column; the whole height left of the block
    assert ROOM.within.width == 836 - 20 - 2 * GAP
    for size in ROOM.within.sizes:
        pack([view("velocities-1", *size)], (ROOM, ROOM), "A1")
        assert ROOM.within.share(size[0] + 1, size[1] + 1) < 1


def test_a_view_without_ink_is_told_and_not_measured() -> None:
    with pytest.raises(
        SheetError, match="nothing of the view 'План' can be drawn: change its data"
    ):
        bounds(Drawing("a", "План"))
