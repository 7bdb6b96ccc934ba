"""DXF: letters are TEXT, as tall, as long and where our own are; strokes on wish."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable

import pytest
from support.dxf_read import at, model, opened, sheet_of
from support.each import each
from support.gallery import ALL, by_turns, paper

from graphic_tmm.paper.drawing import Label, Sheet


@pytest.fixture(scope="module")
def sheet():
    return paper("engine")[1][0]


def letters_of(markup: str) -> str:
    """The letters of a mark-up, by reading it as a person does: without marks and spaces."""
    escaped = re.sub(r"\\([_^{}\\])", lambda m: chr(0xE000 + ord(m[1])), markup)
    bare = re.sub(r"\\(bar|uu|u)(?={)|[_^{}\s]", "", escaped)
    return "".join(chr(ord(c) - 0xE000) if "\ue000" <= c <= "\uf8ff" else c for c in bare)


def share_of_text(sheet: Sheet) -> tuple[int, int]:
    """How many letters of a sheet are TEXT, and how many it has."""
    texts = opened(sheet).modelspace().query("TEXT")
    written = sum(len(re.sub(r"\s", "", text.plain_text())) for text in texts)
    return written, sum(len(letters_of(la.text)) for d in sheet.drawings for la in d.labels)


def test_letters_are_text(sheet) -> None:
    written, due = share_of_text(sheet)
    assert 0.99 * due < written <= due


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_letters_of_every_scene_are_text(name: str, many: Callable[[int, int], int]) -> None:
    """On one of its sheets, which it is by turns; on all of them when measured."""
    for sheet in by_turns(name, many):
        document = opened(sheet)
        assert not document.audit().errors
        written, due = share_of_text(sheet)
        assert 0.95 * due <= written <= due


@pytest.mark.slow
def test_letters_as_strokes_are_had_on_wish(sheet) -> None:
    document = opened(sheet, stroked=True)
    assert not document.modelspace().query("TEXT")
    assert not len(document.groups)


@each("turn", [0.0, 90.0, 30.0])
@each("anchor, share", [("start", 0.0), ("middle", 0.5), ("end", 1.0)])
def test_a_run_of_text_stands_where_our_letters_stand(
    turn: float, anchor: str, share: float
) -> None:
    """ГОСТ 2.304, type B: five Н of 6/10 h with four gaps of 2/10 h, half a gap on either side."""
    label = Label("ННННН", 100 + 100j, 10, anchor, turn, inclined=False)
    (text,) = model(labels=(label,))
    assert (text.dxf.text, text.dxf.height, text.dxf.oblique) == ("ННННН", 10.0, 0.0)
    assert text.get_align_enum().name == "FIT"
    way = cmath.rect(1, math.radians(turn))
    ends = [at(text.dxf.get(end)) for end in ("insert", "align_point")]
    begin, end = ((z - 100 - 100j) / way for z in ends)
    assert begin == pytest.approx(-38 * share - 1, abs=1e-5)
    assert end - begin == pytest.approx(40, abs=1e-5)


def test_indices_are_smaller_text_and_bars_are_lines_of_one_group() -> None:
    """v is 5/10 h wide, the index begins 1.5/10 h behind it, 3/10 h lower; B and A are 4.2 and 4.9 mm."""
    document = opened(sheet_of(labels=(Label(r"\bar{v}_{BA}", 50 + 50j, 10, inclined=False),)))
    found = {entity.dxftype(): entity for entity in document.modelspace()}
    v, index = document.modelspace().query("TEXT")
    bar = found["LWPOLYLINE"]
    assert (v.dxf.text, v.dxf.height, v.get_align_enum().name) == ("v", 10.0, "CENTER")
    assert tuple(v.dxf.align_point)[:2] == pytest.approx((52.5, 50), abs=1e-5)
    assert (index.dxf.text, index.dxf.height, index.get_align_enum().name) == ("BA", 7.0, "FIT")
    assert tuple(index.dxf.insert)[:2] == pytest.approx((50 + 5 + 1.5 - 0.7, 47), abs=1e-5)
    end = 56.5 + 4.2 + 1.4 + 4.9 + 0.7
    assert tuple(index.dxf.align_point)[:2] == pytest.approx((end, 47), abs=1e-5)
    (group,) = [group for _, group in document.groups]
    assert set(group) == {v, index, bar}
    assert group.dxf.description == "v_BA"


def test_inclined_letters_lean_by_15_degrees_and_raised_ones_stand_farther_right() -> None:
    document = opened(sheet_of(labels=(Label("a^n", 50 + 50j, 10),)))
    a, n = document.modelspace()
    style = document.styles.get(a.dxf.style)
    assert (a.dxf.oblique, style.dxf.oblique, style.dxf.height) == (15.0, 15.0, 0.0)
    assert document.header["$TEXTSTYLE"] == a.dxf.style
    assert (style.dxf.font, style.get_extended_font_data()[0]) == ("isocpeur.ttf", "ISOCPEUR")
    upright = opened(sheet_of(labels=(Label("a^n", 50 + 50j, 10, inclined=False),)))
    rise = n.dxf.insert.y - 50
    shifted = n.dxf.insert.x - list(upright.modelspace())[1].dxf.insert.x
    assert shifted == pytest.approx(rise * math.tan(math.radians(15)), abs=1e-5)


def test_signs_that_fonts_do_not_hold_are_drawn_among_the_text() -> None:
    made = model(labels=(Label("AB ⊥ CD", 50 + 50j, 5),))
    assert [text.dxf.text for text in made if text.dxftype() == "TEXT"] == ["AB", "CD"]
    drawn = [e for e in made if e.dxftype() == "LWPOLYLINE"]
    reach = [x for e in drawn for x, _ in e.get_points("xy")]
    first, second = (text for text in made if text.dxftype() == "TEXT")
    assert first.dxf.align_point.x < min(reach) < max(reach) < second.dxf.insert.x + 1.0


@each("text", [r"\\U+0041", "a \\^ b", "%%c 100%", r"\{x\}", "№ «5»", "  a  "])
def test_no_letter_of_a_text_becomes_a_mark(text: str) -> None:
    """Of a percent sign twice three each time: what "%%%" means to CAD programs, ezdxf leaves as it is."""
    found = [
        t.plain_text() for t in model(labels=(Label(text, 50 + 50j),)) if t.dxftype() == "TEXT"
    ]
    told = "".join(found).replace("%%%", "%").replace(" ", "")
    assert told == re.sub(r"[\\^]", "", letters_of(text))
