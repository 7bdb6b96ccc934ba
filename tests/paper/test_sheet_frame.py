from __future__ import annotations

import cmath
import itertools
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Polygon, box
from support.each import each
from support.examples import most

from graphic_tmm.errors import SheetError
from graphic_tmm.paper import labels, title_block
from graphic_tmm.paper.drawing import Drawing, Label, Stroke
from graphic_tmm.paper.formats import FORMATS, size_of
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.sheet_frame import FIELDS, drawing_area, frame
from graphic_tmm.paper.title_block import FORM_1, FORM_2, FORM_2A, Block

BLOCKS = [one for one in vars(title_block).values() if isinstance(one, Block)]
FILLED = {
    "designation": "ТММ 12.04.00.000",
    "name": "Динамический анализ рычажного механизма",
    "organisation": "Каф. ТММ, гр. М-31",
    "drawn_by": "Петров",
    "checked_by": "Щукин",
    "approved_by": "Ёлкина-Фаддеева",
    "scale": "1:2",
    "letter": "у",
    "mass": "–",
    "date": "12.03.26",
}
SHEETS = list(itertools.product(FORMATS, ("ru", "en"), (True, False)))


def made(format: str = "A1", language: str = "ru", first: bool = True, count: int = 3) -> Drawing:
    number = 1 if first else 2
    return frame(format, language=language, first=first, number=number, count=count, fields=FILLED)


DRAWABLE = [chr(k) for k in range(32, 0x2300) if not letters.missing(chr(k))]


def ink(label: Label) -> list[complex]:
    """The points of a label's strokes in sheet coordinates."""
    written = letters.letter(label.text, size=label.size, inclined=label.inclined)
    share = {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor]
    way = cmath.rect(1, math.radians(label.turn))
    return [
        label.at + (complex(x, y) - share * written.width) * way
        for stroke in written.strokes
        for x, y, _ in stroke
    ]


def bounds(label: Label) -> tuple[float, float, float, float]:
    half = label.size / 20
    xs, ys = [z.real for z in ink(label)], [z.imag for z in ink(label)]
    return min(xs) - half, min(ys) - half, max(xs) + half, max(ys) + half


def inked(drawing: Drawing, format: str) -> list[Polygon]:
    """The ink of a frame's lines, as wide as their pens."""
    return [
        LineString([(x, y) for x, y, _ in (*s.path, *(s.path[:1] if s.closed else ()))]).buffer(
            pens(format)[s.pen].width / 2, cap_style="flat"
        )
        for s in drawing.strokes
        if isinstance(s, Stroke)
    ]


def lines(block: Block) -> set[tuple[str, float, float, float, float]]:
    return set(block.ruling)


def test_form_1_is_ruled_as_the_standard_rules_it() -> None:
    main, thin = {}, {}
    for pen, x0, y0, x1, y1 in FORM_1.ruling:
        lot = main if pen == "main" else thin
        key = ("y", y0) if y0 == y1 else ("x", x0)
        assert x0 == x1 or y0 == y1
        lot.setdefault(key, []).append((x0, x1) if y0 == y1 else (y0, y1))
    assert main == {
        ("y", 55): [(0, 185)],
        ("y", 40): [(65, 185)],
        ("y", 35): [(0, 65), (135, 185)],
        ("y", 30): [(0, 65)],
        ("y", 20): [(135, 185)],
        ("y", 15): [(65, 185)],
        **{("x", x): [(0, 55)] for x in (0, 17, 40, 55, 65)},
        ("x", 7): [(30, 55)],
        ("x", 135): [(0, 40)],
        ("x", 150): [(20, 40)],
        ("x", 167): [(20, 40)],
        ("x", 155): [(15, 20)],
    }
    assert thin == {
        **{("y", y): [(0, 65)] for y in (50, 45, 40, 25, 20, 15, 10, 5)},
        ("x", 140): [(20, 35)],
        ("x", 145): [(20, 35)],
    }


def test_form_2_is_ruled_as_the_standard_rules_it() -> None:
    uprights = {0: (0, 40), 17: (0, 40), 40: (0, 40), 55: (0, 40), 65: (0, 40), 7: (25, 40)}
    uprights |= {135: (0, 25), 150: (15, 25), 165: (15, 25)}
    assert lines(FORM_2) == {
        *(("main", 0, y, 185, y) for y in (40, 25)),
        ("main", 0, 30, 65, 30),
        *(("main", 135, y, 185, y) for y in (20, 15)),
        *(("thin", 0, y, 65, y) for y in (35, 20, 15, 10, 5)),
        *(("main", x, low, x, high) for x, (low, high) in uprights.items()),
        *(("thin", x, 15, x, 20) for x in (140, 145)),
    }


def test_the_first_sheet_of_a_text_bears_form_2() -> None:
    """Its room ends 40 mm above the frame's lower edge, its signatures begin a row lower."""
    area = drawing_area("A4", "ru", True, text=True)
    assert area.occupied[0].top - area.inner.bottom == 40
    assert drawing_area("A4", "ru", False, text=True) == drawing_area("A4", "ru", False)
    drawing = frame("A4", language="ru", first=True, number=1, count=2, fields=FILLED, text=True)
    told = words(drawing)
    assert "Т. контр." not in told
    assert {"Разраб.", "Пров.", "Н. контр.", "Утв.", "Листов", "2", "1"} <= set(told)
    rulings = inked(drawing, "A4")
    places = [box(*bounds(label)) for label in drawing.labels]
    assert not any(place.intersects(ruling) for place in places for ruling in rulings)


def test_a_document_is_one_of_study_unless_the_scene_says_otherwise() -> None:
    fields = {key: text for key, text in FILLED.items() if key != "letter"}
    for text in (False, True):
        (own, others) = (
            frame(
                "A4", language="ru", first=True, number=1, count=1, fields=fields | more, text=text
            )
            for more in ({}, {"letter": "О"})
        )
        assert words(own).count("У") == 1
        assert "У" not in words(others)
        assert "О" in words(others)


def test_form_2a_is_ruled_as_the_standard_rules_it() -> None:
    assert lines(FORM_2A) == {
        ("main", 0, 15, 185, 15),
        ("main", 0, 5, 65, 5),
        ("thin", 0, 10, 65, 10),
        ("main", 175, 8, 185, 8),
        *(("main", x, 0, x, 15) for x in (0, 7, 17, 40, 55, 65, 175)),
    }


def test_the_entries_of_form_1_are_in_their_columns() -> None:
    places = {slot.text: tuple(slot.box) for slot in FORM_1.entries}
    assert places["designation"] == (65, 40, 185, 55)
    assert places["name"] == (65, 15, 135, 40)
    assert places["material"] == (65, 0, 135, 15)
    assert places["organisation"] == (135, 0, 185, 15)
    assert places["drawn_by"] == (17, 25, 40, 30)
    assert places["approved_by"] == (17, 0, 40, 5)


@pytest.mark.parametrize("block", BLOCKS)
def test_no_line_of_a_block_runs_through_a_slot(block: Block) -> None:
    rulings = [LineString([(a, b), (c, d)]) for _, a, b, c, d in block.ruling]
    for slot in (*block.captions, *block.entries):
        place = box(*slot.box)
        assert box(0, 0, block.width, block.height).covers(place)
        assert not any(ruling.crosses(place) for ruling in rulings)


@pytest.mark.parametrize("block", BLOCKS)
def test_no_two_slots_share_room(block: Block) -> None:
    slots = (*block.captions, *block.entries)
    for one, two in itertools.combinations(slots, 2):
        assert box(*one.box).intersection(box(*two.box)).area == 0


@each("format, language, first", SHEETS)
def test_everything_is_on_the_paper(format: str, language: str, first: bool) -> None:
    drawing = made(format, language, first)
    width, height = size_of(format)
    box_of_pens = pens(format)
    for stroke in drawing.strokes:
        assert isinstance(stroke, Stroke)
        half = box_of_pens[stroke.pen].width / 2
        for x, y, _ in stroke.path:
            assert half - 1e-9 <= x <= width - half + 1e-9
            assert half - 1e-9 <= y <= height - half + 1e-9
    for label in drawing.labels:
        left, bottom, right, top = bounds(label)
        assert min(left, bottom) > 0.3
        assert right < width - 0.3
        assert top < height - 0.3


@each("format, language, first", SHEETS)
def test_no_lettering_touches_a_line_or_other_lettering(
    format: str, language: str, first: bool
) -> None:
    drawing = made(format, language, first)
    rulings = inked(drawing, format)
    places = [box(*bounds(label)) for label in drawing.labels]
    for label, place in zip(drawing.labels, places, strict=True):
        assert not any(place.intersects(ruling) for ruling in rulings), label.text
    for one, two in itertools.combinations(places, 2):
        assert not one.intersects(two)


@each("format, language, first", SHEETS)
def test_the_frame_stands_where_the_standard_has_it(
    format: str, language: str, first: bool
) -> None:
    drawing = made(format, language, first)
    width, height = size_of(format)
    other = 5 if language == "ru" else 10
    frames = [s for s in drawing.strokes if isinstance(s, Stroke) and s.closed and s.pen == "main"]
    corners = {(x, y) for s in frames for x, y, _ in s.path}
    assert corners == {
        (20, other),
        (width - other, other),
        (width - other, height - other),
        (20, height - other),
    }
    area = drawing_area(format, language, first)
    assert tuple(area.inner) == (20, other, width - other, height - other)
    right = width - other
    size = {
        ("ru", True): (185, 55),
        ("ru", False): (185, 15),
        ("en", True): (180, 40),
        ("en", False): (180, 10),
    }[language, first]
    assert tuple(area.occupied[0]) == (right - size[0], other, right, other + size[1])
    if language == "ru":
        upright = (width - 19, height - 75, width - 5, height - 5)
        lying = (20, height - 19, 90, height - 5)
        due = upright if format.endswith("portrait") else lying
        assert tuple(area.occupied[1]) == due


@each("format, language, first", SHEETS)
def test_the_check_line_is_100_mm_and_crosses_nothing(
    format: str, language: str, first: bool
) -> None:
    drawing = made(format, language, first)
    (check,) = [s for s in drawing.strokes if s.data == (("check-line", "100"),)]
    assert isinstance(check, Stroke)
    (a, b, _), (c, d, _) = check.path
    assert math.hypot(c - a, d - b) == 100.0
    here = LineString([(a, b), (c, d)])
    crossing = [
        s
        for s in drawing.strokes
        if isinstance(s, Stroke)
        and s is not check
        and LineString([(x, y) for x, y, _ in s.path]).intersects(here)
    ]
    assert len(crossing) == 2
    for tick in crossing:
        assert tick.path[0][0] == tick.path[1][0]
        assert tick.path[0][0] in (a, c)
    inner = drawing_area(format, language, first).inner
    assert inner.left < min(a, c) < max(a, c) < inner.right
    assert min(b, d) > inner.top
    texts = {label.text for label in drawing.labels if label.at.imag > inner.top}
    assert {"0", "100 мм" if language == "ru" else "100 mm"} <= texts


@each("format, language, first", SHEETS)
def test_the_check_line_can_be_left_out(format: str, language: str, first: bool) -> None:
    number = 1 if first else 2
    whole = made(format, language, first)
    bare = frame(
        format,
        language=language,
        first=first,
        number=number,
        count=3,
        fields=FILLED,
        check=False,
    )
    assert set(bare.strokes) < set(whole.strokes)
    assert set(bare.labels) < set(whole.labels)
    assert (len(whole.strokes) - len(bare.strokes), len(whole.labels) - len(bare.labels)) == (3, 3)
    assert not any(stroke.data for stroke in bare.strokes)


@each("format, language, first", SHEETS)
def test_every_sheet_tells_its_name_and_designation(
    format: str, language: str, first: bool
) -> None:
    """Of the form for following sheets, too; broken into lines where they are long."""
    told = " ".join(words(made(format, language, first)))
    for field in ("designation", "name"):
        assert all(word in told for word in FILLED[field].split())


def test_column_26_bears_the_designation_upside_down() -> None:
    (label,) = [label for label in made("A4").labels if label.turn == 180]
    assert letters.plain(label.text) == FILLED["designation"]
    left, bottom, right, top = bounds(label)
    assert 20 < left < right < 90
    assert 297 - 19 < bottom < top < 297 - 5


def words(drawing: Drawing) -> list[str]:
    return [letters.plain(label.text) for label in drawing.labels]


def test_a_single_sheet_bears_no_number() -> None:
    assert words(made(count=1)).count("1") == 1
    assert words(made(count=3)).count("1") == 1
    assert words(made(count=3)).count("3") == 1
    assert words(made(first=False)).count("2") == 1
    assert "1/3" in words(made(language="en"))
    with pytest.raises(SheetError, match="4 of 3"):
        frame("A4", language="ru", first=False, number=4, count=3, fields={})


def test_captions_are_those_of_the_language() -> None:
    russian = words(made())
    for caption in ("Изм.", "Лист", "№ докум.", "Подп.", "Дата", "Разраб.", "Пров.", "Т. контр."):
        assert caption in russian
    for caption in ("Н. контр.", "Утв.", "Лит.", "Масса", "Масштаб", "Листов", "Копировал"):
        assert caption in russian
    english = words(made(language="en"))
    for caption in ("Legal owner", "Identification number", "Creator", "Approval person"):
        assert caption in english
    for caption in ("Document type", "Sheet", "Date of issue", "Title, supplementary title"):
        assert caption in english


@pytest.mark.parametrize("date", ["12.03.26", "12.03.2026", "2026-03-12"])
def test_a_date_is_never_cut(date: str) -> None:
    drawing = frame("A4", language="ru", first=True, number=1, count=1, fields={"date": date})
    assert "12.03.26" in words(drawing)
    free = frame("A4", language="en", first=True, number=1, count=1, fields={"date": date})
    assert date in words(free)


@pytest.mark.slow
@settings(deadline=None, max_examples=most(40))
@given(
    st.dictionaries(
        st.sampled_from(FIELDS),
        st.one_of(
            st.text(alphabet=DRAWABLE, max_size=120),
            st.integers(1, 10_000).map("Щ".__mul__),
            st.integers(1, 2_000).map("слово ".__mul__),
        ),
    ),
    st.sampled_from(SHEETS),
)
def test_no_entry_leaves_its_box_whatever_it_says(
    fields: dict[str, str], sheet: tuple[str, str, bool]
) -> None:
    format, language, first = sheet
    drawing = frame(format, language=language, first=first, number=1, count=9, fields=fields)
    rulings = inked(drawing, format)
    paper = box(0, 0, *size_of(format))
    for label in drawing.labels:
        if ink(label):
            place = box(*bounds(label))
            assert paper.covers(place)
            assert not any(place.intersects(ruling) for ruling in rulings)


def test_unknown_things_are_refused_with_their_names() -> None:
    with pytest.raises(SheetError, match="colour"):
        frame("A4", language="ru", first=True, number=1, count=1, fields={"colour": "red"})
    with pytest.raises(SheetError, match="A9"):
        frame("A9", language="ru", first=True, number=1, count=1, fields={})
    with pytest.raises(SheetError, match="tlh"):
        drawing_area("A4", "tlh", True)
    with pytest.raises(SheetError, match="name: no glyph for '☃'"):
        frame("A4", language="ru", first=True, number=1, count=1, fields={"name": "☃ snow"})


def test_an_upright_a1_has_its_designation_along_the_right_side_read_from_the_left() -> None:
    fields = {"designation": "ТММ.01.02.000"}
    drawing = frame("A1 portrait", language="ru", first=True, number=1, count=1, fields=fields)
    (label,) = [k for k in drawing.labels if k.turn == -90]
    assert label.text.startswith("ТММ")
    assert box(575, 766, 589, 836).covers(labels.box(label))
    assert "Формат A1" in {k.text for k in drawing.labels}
