"""What is said of plans stands where the plans do; as much is left above what a sheet shows as below."""

from __future__ import annotations

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
from support import asked
from support.examples import most

from graphic_tmm.fitting.formats import room_on
from graphic_tmm.paper.compose.homes import homed, spared
from graphic_tmm.paper.compose.search import composed, fits
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import Stand
from graphic_tmm.paper.packing import GAP, Room
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets

A4 = room_on("A4", "en", False)
BLOCKS = ("velocities", "accelerations")
LEAST = 0.02
"""Places are told to hundredths of a mm."""

rows = st.builds(
    lambda wide, high, block: Outline("plan", wide, high, Stand(block, "row")),
    st.floats(20, 80),
    st.floats(20, 80),
    st.sampled_from(BLOCKS),
)
notes = st.builds(
    lambda wide, high, block: Outline("equations", wide, high, Stand(block, "note")),
    st.floats(20, 100),
    st.floats(10, 60),
    st.sampled_from(BLOCKS),
)
tables = st.builds(
    lambda wide, high: Outline("table", wide, high, Stand(kind="table")),
    st.floats(20, 100),
    st.floats(10, 100),
)
sheets = st.lists(st.lists(st.one_of(rows, notes, tables), max_size=5), min_size=1, max_size=4)


def numbered(
    shown: list[list[Outline]],
) -> tuple[list[Outline], list[tuple[Room, tuple[int, ...]]]]:
    """Boxes counted through all sheets, and the sheets of them."""
    held, first = [], 0
    for own in shown:
        held.append((A4, tuple(range(first, first + len(own)))))
        first += len(own)
    return [one for own in shown for one in own], held


def area(boxes: list[Outline], chosen: tuple[int, ...]) -> float:
    return sum(boxes[k].width * boxes[k].height for k in chosen)


@settings(max_examples=most(60), deadline=None)
@given(sheets)
def test_only_what_is_said_of_plans_moves_and_only_to_them(shown: list[list[Outline]]) -> None:
    boxes, before = numbered(shown)
    after = homed(boxes, before)
    assert sorted(k for _, own in after for k in own) == list(range(len(boxes)))
    for (_, was), (room, own) in zip(before, after, strict=True):
        assert set(was) - set(own) <= {k for k in was if boxes[k].stand.kind == "note"}
        come = set(own) - set(was)
        assert all(
            any(boxes[j].stand.block == boxes[k].stand.block for j in own if j != k) for k in come
        )
        if come:
            assert fits([boxes[k] for k in own], room) is not None


@settings(max_examples=most(60), deadline=None)
@given(sheets)
def test_no_sheet_is_emptied_for_what_is_said_of_plans(shown: list[list[Outline]]) -> None:
    boxes, before = numbered(shown)
    least = min(area(boxes, own) for _, own in before)
    assert min(area(boxes, own) for _, own in homed(boxes, before)) >= least


def test_equations_leave_a_fuller_sheet_for_their_plans() -> None:
    plans = [Outline(f"p{k}", 60.0, 90.0, Stand("velocities", "row")) for k in range(4)]
    few = [Outline(f"q{k}", 70.0, 80.0, Stand("accelerations", "row")) for k in range(2)]
    told = Outline("equations", 80.0, 30.0, Stand("accelerations", "note"))
    boxes, held = numbered([[*plans, told], few])
    assert [own for _, own in homed(boxes, held)] == [(0, 1, 2, 3), (5, 6, 4)]
    boxes, held = numbered([[plans[0], told], few])
    assert homed(boxes, held) == held
    boxes, held = numbered([[*plans, few[0], told], [few[1]]])
    assert homed(boxes, held) == held


def moves_by(places: list[tuple[float, float, float, float]], room: Room, way: float) -> float:
    """How far, mm, boxes can be moved up (1) or down (−1) together until one touches what is there."""

    def touches(shift: float) -> bool:
        for left, low, right, high in places:
            low, high = low + way * shift, high + way * shift
            if low < room.inner[1] or high > room.inner[3]:
                return True
            for box in room.occupied:
                beside = left - GAP >= box[2] or right + GAP <= box[0]
                if not beside and low < box[3] and high > box[1]:
                    return True
        return False

    free, met = 0.0, 1000.0
    while met - free > LEAST / 10:
        middle = (free + met) / 2
        free, met = (free, middle) if touches(middle) else (middle, met)
    return free


@settings(max_examples=most(40), deadline=None)
@given(
    st.lists(st.one_of(rows, notes, tables), min_size=1, max_size=5),
    st.sampled_from([("A4", "en"), ("A4", "ru"), ("A3", "ru"), ("A2", "en")]),
    st.booleans(),
)
def test_as_much_is_left_above_all_views_as_below(
    boxes: list[Outline], format: tuple[str, str], first: bool
) -> None:
    room = room_on(*format, first)
    found = composed(boxes, room)
    if found is None:
        return
    places = [
        (at.real, at.imag, at.real + boxes[k].width, at.imag + boxes[k].height)
        for k, at in found.items()
    ]
    assert abs(moves_by(places, room, 1.0) - moves_by(places, room, -1.0)) < LEAST


@settings(max_examples=most(60), deadline=None)
@given(sheets, st.lists(st.booleans(), min_size=4, max_size=4))
def test_only_one_small_table_alone_gives_up_its_sheet(
    shown: list[list[Outline]], may: list[bool]
) -> None:
    boxes, before = numbered(shown)
    after = spared(boxes, before, may)
    assert sorted(k for _, own in after for k in own) == list(range(len(boxes)))
    for wished, (_, was), (room, own) in zip(may, before, after, strict=False):
        if was and not own:
            (k,) = was
            assert wished
            assert boxes[k].stand.kind in ("table", "note")
            assert area(boxes, was) < 0.3 * room.area
        else:
            assert own[: len(was)] == was
            assert own == was or fits([boxes[k] for k in own], room) is not None


def test_a_small_table_alone_goes_to_the_nearest_sheet_that_holds_it() -> None:
    table = Outline("table", 90.0, 50.0, Stand(kind="table"))
    plan, large = Outline("plan", 150.0, 150.0), Outline("graphs", 160.0, 240.0)
    boxes, held = numbered([[plan], [large], [table]])
    may = [True, True, True]
    assert [own for _, own in spared(boxes, held, may)] == [(0, 2), (1,), ()]
    assert spared(boxes, held, [True, True, False]) == held
    boxes, held = numbered([[large], [table]])
    assert spared(boxes, held, may) == held


def locked(tmp_path: Path, name: str) -> Scene:
    """A slider-crank that locks where its forces are asked for: of the second sheet a table is left."""
    orders = [("A2", ("positions", "velocities")), ("A4", ("forces", "force table"))]
    text = asked.mechanism("slider", 8, orders, language="en")
    text = text.partition("[indicator]")[0] + text[text.index("[[sheet]]") :] + name
    text = text.replace("340 mm", "80 mm").replace("positions = [0, 2, 5]", "positions = [2]")
    file = tmp_path / "scene.toml"
    file.write_text(text, encoding="utf-8")
    return read(file)


def test_a_sheet_of_which_a_small_table_is_left_is_spared_and_that_is_told(tmp_path: Path) -> None:
    scene = locked(tmp_path, "")
    made, found = composed_sheets(scene)
    (sheet,) = found.sheets
    assert "table-forces" in [view.name for view in sheet.drawings]
    assert [one for one in made.scene.remarks if one.startswith("sheet 2: one small table")]
    again = composed_sheets(scene, found.composition)[1]
    assert again.remarks == ()
    assert again.composition == found.composition


def test_a_sheet_with_a_name_is_not_spared(tmp_path: Path) -> None:
    _, found = composed_sheets(locked(tmp_path, '\nname = "Forces"\n'))
    assert len(found.sheets) == 2
    assert found.remarks == ()
