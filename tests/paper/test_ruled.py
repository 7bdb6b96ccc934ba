from __future__ import annotations

import cmath
import itertools
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing, Label, Stroke, line
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.ruled import Box, Slot, fit, ruled_table, set_text
from graphic_tmm.paper.views import captioned, wrapped

DRAWABLE = [chr(k) for k in range(32, 0x2300) if not letters.missing(chr(k))]


def ink(label: Label) -> tuple[float, float, float, float]:
    """Left, bottom, right, top of a label's ink, by the vertices of its strokes and half a pen."""
    written = letters.letter(label.text, size=label.size, inclined=label.inclined)
    share = {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor]
    way = cmath.rect(1, math.radians(label.turn))
    found = [
        label.at + (complex(x, y) - share * written.width) * way
        for stroke in written.strokes
        for x, y, _ in stroke
    ]
    half = written.pen / 2
    return (
        min(z.real for z in found) - half,
        min(z.imag for z in found) - half,
        max(z.real for z in found) + half,
        max(z.imag for z in found) + half,
    )


def inside(label: Label, box: Box, slack: float = 0.0) -> bool:
    left, bottom, right, top = ink(label)
    return (
        left >= box.left - slack
        and bottom >= box.bottom - slack
        and right <= box.right + slack
        and top <= box.top + slack
    )


BOXES = st.sampled_from(
    [
        Slot("", Box(65, 15, 135, 40), (7, 5, 3.5, 2.5), 3, pad=2),
        Slot("", Box(0, 0, 185, 15), (7, 5, 3.5, 2.5), 2),
        Slot("", Box(17, 5, 40, 10)),
        Slot("", Box(17, 5, 40, 10), anchor="start"),
        Slot("", Box(0, 0, 70, 14), (7, 5, 3.5, 2.5), 2, turn=180, pad=2),
        Slot("", Box(8, 5, 13, 40), (2.5, 1.8), turn=90),
        Slot("", Box(0, 0, 10, 5), (2.5, 1.8)),
    ]
)
TEXTS = st.one_of(
    st.text(alphabet=DRAWABLE, max_size=400),
    st.text(alphabet="ЩЖФЙруЁ,;_^{}\\ ", max_size=300),
    st.integers(1, 10_000).map("Щ".__mul__),
    st.integers(1, 2_000).map("слово ".__mul__),
    st.integers(1, 5_000).map("_^".__mul__),
)


@pytest.mark.slow
@settings(deadline=None)
@given(TEXTS, BOXES)
def test_no_text_leaves_its_box(text: str, slot: Slot) -> None:
    for label in set_text(text, slot):
        if letters.letter(label.text, size=label.size).strokes:
            assert inside(label, slot.box)


def test_a_short_text_keeps_the_first_size_and_a_long_one_is_broken_then_smaller_then_cut() -> None:
    slot = Slot("", Box(0, 0, 70, 25), (7, 5, 3.5), 3, pad=2)
    assert fit("Планы", slot) == (7, ("Планы",))
    words = "Динамический анализ рычажного механизма"
    broken = fit(words, slot)
    assert len(broken.lines) > 1
    assert " ".join(broken.lines) == words
    longer = fit(words + " поперечно-строгального станка", slot)
    assert longer.size < broken.size
    cut = fit(words * 30, slot)
    assert cut.size == 3.5
    assert len(cut.lines) == 3
    assert cut.lines[-1].endswith("…")


def test_a_word_too_long_is_cut_within_the_box() -> None:
    cut = fit("Щ" * 10_000, Slot("", Box(0, 0, 70, 25), (5, 3.5), 2))
    assert len(cut.lines) == 2
    assert cut.lines[0] == "Щ" * len(cut.lines[0])
    assert cut.lines[1].endswith("…")


def test_nothing_to_write_gives_nothing() -> None:
    assert set_text("  \n", Slot("", Box(0, 0, 70, 25))) == ()


def test_lines_of_a_text_stand_below_one_another() -> None:
    slot = Slot("", Box(0, 0, 40, 25), (5,), 3)
    first, second = set_text("первая вторая", slot)
    assert first.at.imag - second.at.imag == pytest.approx(8.5)
    upward = set_text("первая вторая", slot._replace(box=Box(0, 0, 25, 40), turn=90))
    assert upward[1].at.real - upward[0].at.real == pytest.approx(8.5)


def rulings(drawing: Drawing) -> tuple[list[float], list[float]]:
    """The x of the vertical and the y of the horizontal lines."""
    xs, ys = set(), set()
    for stroke in drawing.strokes:
        assert isinstance(stroke, Stroke)
        points = list(stroke.path) + ([stroke.path[0]] if stroke.closed else [])
        for (x, y, _), (u, v, _) in itertools.pairwise(points):
            xs |= {x} if x == u else set()
            ys |= {y} if y == v else set()
    return sorted(xs), sorted(ys)


CELL = st.one_of(
    st.sampled_from(["v_B", "ω_2", "–", "", "a^n_{BA}", "12,5", "Скорость"]),
    st.floats(-1e4, 1e4).map(lambda x: f"{x:.2f}"),
)


@settings(deadline=None, max_examples=most(60))
@given(
    st.integers(1, 5).flatmap(
        lambda n: st.tuples(
            st.lists(
                st.sampled_from(["№", "v_B,\nм/с", "Длинное слово", "a\nb\nc"]),
                min_size=n,
                max_size=n,
            ),
            st.lists(st.lists(CELL, min_size=n, max_size=n), max_size=6),
            st.sampled_from([2.5, 3.5, 5.0]),
        )
    )
)
def test_no_text_of_a_table_crosses_a_ruling(
    case: tuple[list[str], list[list[str]], float],
) -> None:
    columns, rows, size = case
    made = ruled_table("t", "Таблица", columns, rows, size=size)
    xs, ys = rulings(made)
    assert xs[0] == ys[0] == 0
    assert len(xs) == len(columns) + 1
    assert len(ys) == len(rows) + 2
    for label in made.labels[:-1]:
        left, bottom, right, top = ink(label)
        column = max(x for x in xs if x <= left)
        row = max(y for y in ys if y <= bottom)
        assert right < xs[xs.index(column) + 1] - 1.0
        assert left > column + 1.0
        assert top <= ys[ys.index(row) + 1] - 0.3
        assert bottom >= row + 0.3
    assert ink(made.labels[-1])[1] > ys[-1]
    steps = [b - a for a, b in itertools.pairwise(ys)]
    assert min(steps) >= 2 * size - 1e-9


def test_the_outside_and_the_head_are_heavy() -> None:
    made = ruled_table("t", "", ["a", "b"], [["1", "2"], ["3", "4"], ["5", "6"]])
    heavy = [s for s in made.strokes if s.pen == "main"]
    thin = [s for s in made.strokes if s.pen == "thin"]
    assert len(heavy) == 2
    assert len(thin) == 3
    assert not [label for label in made.labels if label.size == 5]


def test_numerals_share_their_decimal_place() -> None:
    cells = ["1,5", "12,25", "−103", "–", "0,125"]
    made = ruled_table("t", "", ["x"], [[cell] for cell in cells])
    labels = {label.text: label for label in made.labels}
    points = {
        round(labels[cell].at.real + letters.width(cell.split(",")[0], size=3.5), 6)
        for cell in cells
        if cell != "–"
    }
    assert len(points) == 1
    assert labels["–"].anchor == "middle"


def test_columns_are_as_wide_as_their_widest_text_and_its_padding() -> None:
    made = ruled_table("t", "", ["Положение", "v"], [["1", "длинное значение"]], size=5)
    xs, _ = rulings(made)
    assert xs[1] == pytest.approx(letters.letter("Положение", size=5).right + 5)
    assert xs[2] - xs[1] == pytest.approx(letters.letter("длинное значение", size=5).right + 5)


def test_left_and_centre_can_be_asked_for() -> None:
    rows = [["1", "1"], ["100", "100"]]
    made = ruled_table("t", "", ["длинный заголовок", "c"], rows, align=("left", "centre"))
    (a, b, c, d) = (label for label in made.labels if label.text in ("1", "100"))
    assert a.at.real == b.at.real == 1.75
    assert a.anchor == "start"
    assert c.at.real == d.at.real
    assert d.anchor == "middle"


def test_a_ragged_table_and_an_unknown_alignment_are_refused() -> None:
    with pytest.raises(SheetError, match="table t"):
        ruled_table("t", "", ["a", "b"], [["1"]])
    with pytest.raises(SheetError, match="table t"):
        ruled_table("t", "", [], [])
    with pytest.raises(SheetError, match="right"):
        ruled_table("t", "", ["a"], [["1"]], align=("right",))


def test_a_title_much_wider_than_its_table_stands_in_two_lines() -> None:
    heads, rows = ["a", "b"], [["1", "2"], ["3", "4"]]
    wide = breakable("t", "Given data: the pair of wheels", heads, rows, again="more")
    plain = breakable("t", "Given", heads, rows, again="more")
    high = [label for label in wide.labels if label.size == 5.0]
    lines = sorted(high, key=lambda label: -label.at.imag)
    assert [label.text for label in lines] == ["Given data: the", "pair of wheels"]
    assert lines[0].at.real == lines[1].at.real == 0.0
    assert lines[0].at.imag - lines[1].at.imag == pytest.approx(1.7 * 5.0)
    assert wide.title == "Given data: the pair of wheels"
    assert [label.text for label in plain.labels if label.size == 5.0] == ["Given"]
    # the lower line stands where the only one does
    assert lines[1].at == next(label.at for label in plain.labels if label.text == "Given")


def test_a_long_title_is_broken_into_lines_as_even_as_can_be() -> None:
    view = Drawing("v", "", (line("thin", 0j, 60 + 40j),))
    told = captioned(view, "Rolling of the tooth of wheel 2")
    lines = [label.text for label in told.labels]
    assert " ".join(lines) == "Rolling of the tooth of wheel 2"
    widths = [letters.letter(text, size=5.0).width for text in lines]
    assert len(lines) == 2
    assert min(widths) > 0.5 * max(widths)


def test_a_note_below_a_table_is_no_wider_than_the_table() -> None:
    note = (
        "Links 1, 2, 3 meet in pin A, which is counted to link 1: a load at A acts on its own link"
    )
    narrow = ruled_table("t", "T", ["a", "b"], [["1", "2"]] * 4)
    told = captioned(narrow, note, heights=HEIGHTS["A1"])
    left, _, right, _ = bounds(told)
    assert right - left < 15 * HEIGHTS["A1"].number
    words = [label.text for label in told.labels if label not in narrow.labels]
    assert " ".join(words) == note


@pytest.mark.parametrize("width", [30.0, 34.0, 38.0, 44.0, 50.0])
def test_what_is_equal_and_a_number_with_its_unit_stand_in_one_line(width: float) -> None:
    lines = wrapped("по 360 положениям J = 43,12 кг меньше должного на 2,2 %", 3.5, width)
    assert len(lines) > 1
    assert any("J = 43,12 кг" in line for line in lines)
    assert any("2,2 %" in line for line in lines)
