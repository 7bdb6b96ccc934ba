from __future__ import annotations

import cmath
import itertools
import math
import os
import re
import subprocess
import sys
from urllib.parse import unquote_to_bytes
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Sheet, Stroke, arc, circle, line
from graphic_tmm.paper.lettering.letters import (
    escape,
    missing,
)
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.write.svg import Under, clean, svg
from graphic_tmm.paper.write.svg_path import number, path_data

NS = "{http://www.w3.org/2000/svg}"
ALLOWED = {f"{NS}{tag}" for tag in ("svg", "g", "path", "rect", "title", "desc")}
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
XML = "{http://www.w3.org/XML/1998/namespace}"
NASTY = [
    "<script>alert(1)</script>",
    "a & b",
    "\"quotes\" and 'single'",
    "../../etc/passwd",
    "]]>",
    "<!DOCTYPE x [<!ENTITY y 'z'>]>&y;",
    "\x00\x07\ud800\ufffe",
    "url(http://example.org/x)",
]


def sheet(*strokes: Stroke | Bezier, labels: tuple[Label, ...] = (), name: str = "plan") -> Sheet:
    return Sheet("s1", "Лист", "A1", 841, 594, (Drawing(name, "План", strokes, labels),))


def drawable(text: str) -> str:
    """Text without the characters that have no glyph."""
    return "".join(c for c in text if c not in missing(text))


def parse(made: Sheet) -> ElementTree.Element:
    return ElementTree.fromstring(svg(made))


def inked(root: ElementTree.Element, pen: str) -> list[str]:
    return [e.attrib["d"] for e in root.findall(f".//{NS}g[@class='pen {pen}']/{NS}path")]


def traced(data: str) -> list[complex]:
    """Points along a path of M, L and A, by arithmetic of its own (end point to centre form)."""
    here, found = 0j, []
    for letter, text in re.findall("([MLAZ])([^MLAZ]*)", data):
        v = [float(x) for x in text.split()]
        if letter in "ML":
            here = complex(*v)
            found.append(here)
        elif letter == "A":
            radius, sweep, end = v[0], v[4], complex(v[5], v[6])
            half = (end - here) / 2
            rise = math.sqrt(max(radius**2 - abs(half) ** 2, 0.0))
            side = 1j if sweep == 1 else -1j
            centre = here + half + side * half / abs(half) * rise
            turn = cmath.phase((end - centre) / (here - centre)) if v[3] == 0 else math.nan
            found += [centre + (here - centre) * cmath.rect(1, turn * k / 16) for k in range(1, 17)]
            here = end
    return found


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.1 + 0.2, "0.3"),
        (-0.0, "0"),
        (-0.0004, "0"),
        (1e-17, "0"),
        (12.3456, "12.346"),
        (5, "5"),
        (100.0, "100"),
    ],
)
def test_numbers_are_short(value: float, text: str) -> None:
    assert number(value) == text


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_number_that_is_none_is_refused(value: float) -> None:
    with pytest.raises(SheetError, match="finite"):
        number(value)
    with pytest.raises(SheetError, match="finite"):
        svg(sheet(line("main", 0j, complex(value, 1))))


@given(st.floats(-1e5, 1e5))
def test_a_number_is_read_back_within_half_a_micrometre(value: float) -> None:
    assert abs(float(number(value)) - value) <= 5.001e-4
    assert re.fullmatch(r"-?\d+(\.\d{1,3})?", number(value))


def test_the_page_is_in_true_millimetres_with_y_downward() -> None:
    root = parse(sheet(line("main", 10 + 20j, 30 + 594j)))
    assert root.attrib["width"] == "841mm"
    assert root.attrib["height"] == "594mm"
    assert root.attrib["viewBox"] == "0 0 841 594"
    assert inked(root, "main") == ["M10 574L30 0"]
    assert root.find(f".//{NS}g[@class='pen main']").attrib["stroke-width"] == "0.8"


@given(
    st.builds(complex, st.floats(0, 800), st.floats(0, 590)),
    st.floats(0.5, 400),
    st.floats(-360, 360),
    st.floats(-360, 360).filter(lambda x: abs(x) > 1),
)
def test_an_arc_keeps_its_centre_and_radius(
    centre: complex, radius: float, start: float, sweep: float
) -> None:
    found = traced(path_data(arc("main", centre, radius, start, sweep), 594.0))
    flipped = complex(centre.real, 594 - centre.imag)
    assert max(abs(abs(z - flipped) - radius) for z in found) < 0.004
    begin = centre + cmath.rect(radius, math.radians(start))
    end = centre + cmath.rect(radius, math.radians(start + sweep))
    assert abs(found[0] - complex(begin.real, 594 - begin.imag)) < 1e-3
    assert abs(found[-1] - complex(end.real, 594 - end.imag)) < 1e-3
    length = sum(abs(b - a) for a, b in itertools.pairwise(found))
    assert length == pytest.approx(radius * math.radians(abs(sweep)), rel=0.01, abs=0.01)


@given(st.floats(-3, 3).filter(lambda b: abs(b) > 0.01), st.floats(1, 300), st.floats(-180, 180))
def test_any_bulge_is_the_arc_that_dxf_means(bulge: float, chord: float, angle: float) -> None:
    end = cmath.rect(chord, math.radians(angle))
    stroke = Stroke("main", ((0.0, 0.0, bulge), (end.real, end.imag, 0.0)))
    found = [z.conjugate() for z in traced(path_data(stroke, 0.0))]
    highest = max(found, key=lambda z: abs((z / end).imag))
    sagitta = (highest / (end / chord)).imag
    assert sagitta == pytest.approx(-bulge * chord / 2, rel=0.02, abs=0.02)


@given(st.builds(complex, st.floats(50, 800), st.floats(50, 500)), st.floats(0.5, 400))
def test_a_circle_is_round(centre: complex, radius: float) -> None:
    data = path_data(circle("main", centre, radius), 594.0)
    assert data.endswith("Z")
    flipped = complex(centre.real, 594 - centre.imag)
    found = traced(data)
    assert max(abs(abs(z - flipped) - radius) for z in found) < 0.004
    assert sum(abs(b - a) for a, b in itertools.pairwise(found)) > 6.2 * radius


def test_a_closed_outline_is_closed_once() -> None:
    square = line("main", 0j, 1 + 0j, 1 + 1j, 1j, closed=True)
    assert path_data(square, 1.0) == "M0 1L1 1L1 0L0 0Z"


def test_a_curve_goes_out_as_cubic_arcs() -> None:
    controls = (0j, 1 + 1j, 2 + 1j, 3 + 0j, 4 - 1j, 5 - 1j, 6 + 0j)
    data = path_data(Bezier("thin", controls), 10.0)
    assert data == "M0 10C1 9 2 9 3 10 4 11 5 11 6 10"
    with pytest.raises(SheetError, match="3n"):
        path_data(Bezier("thin", controls[:3]), 10.0)


def test_strokes_of_one_pen_are_one_path_and_those_with_data_stand_alone() -> None:
    vector = line("medium", 0j, 10 + 0j)._replace(
        title="pb = 10 мм", data=(("mm", "10"), ("segment", "pb"))
    )
    root = parse(sheet(line("main", 0j, 1j), line("main", 5j, 6j), vector, line("medium", 1j, 2j)))
    assert inked(root, "main") == ["M0 594L0 593M0 589L0 588"]
    paths = root.findall(f".//{NS}g[@class='pen medium']/{NS}path")
    assert len(paths) == 2
    (marked,) = [p for p in paths if "data-mm" in p.attrib]
    assert marked.attrib["data-segment"] == "pb"
    assert marked.find(f"{NS}title").text == "pb = 10 мм"


def test_dashes_are_in_millimetres_and_fit_the_line() -> None:
    root = parse(
        sheet(line("dashed", 0j, 200 + 0j), line("dashed", 0j, 3 + 0j), line("centre", 0j, 60 + 0j))
    )
    dashed = root.findall(f".//{NS}g[@class='pen dashed']/{NS}path")
    assert len(dashed) == 2
    stroke, gap = (float(x) for x in dashed[0].attrib["stroke-dasharray"].split())
    assert (200 - stroke) / (stroke + gap) == pytest.approx(30, abs=0.01)
    assert "stroke-dasharray" not in dashed[1].attrib
    group = root.find(f".//{NS}g[@class='pen centre']")
    assert group.attrib["stroke-linecap"] == "butt"


def test_filled_shapes_have_no_outline_and_opposite_turns_stay_apart() -> None:
    corners = (0j, 10 + 0j, 10j)
    root = parse(
        sheet(
            line("main", *corners, closed=True, filled=True),
            line("main", *corners[::-1], closed=True, filled=True),
            circle("main", 5 + 5j, 2, filled=True),
        )
    )
    paths = root.findall(f".//{NS}g[@class='pen main']/{NS}path")
    assert [p.attrib["fill"] for p in paths] == ["black", "black"]
    assert [p.attrib["stroke"] for p in paths] == ["none", "none"]
    assert [p.attrib["d"].count("M") for p in paths] == [2, 1]


def test_pins_lie_above_lines_whatever_their_order() -> None:
    root = parse(sheet(circle("joint", 5j, 1.5), line("main", 0j, 10j), line("thin", 0j, 10 + 0j)))
    groups = root.findall(f".//{NS}g[@class='drawing plan']/{NS}g")
    assert [g.attrib["class"] for g in groups] == ["pen thin", "pen main", "pen joint"]
    assert groups[-1].attrib["fill"] == "white"


def test_an_unknown_pen_an_unfit_name_and_an_unknown_anchor_are_refused() -> None:
    with pytest.raises(SheetError, match="crayon"):
        svg(sheet(line("crayon", 0j, 1j)))
    with pytest.raises(SheetError, match="onclick"):
        svg(sheet(line("main", 0j, 1j)._replace(data=(('x" onclick="', "1"),))))
    with pytest.raises(SheetError, match="left"):
        svg(sheet(labels=(Label("a", 0j, 5, "left"),)))
    with pytest.raises(SheetError, match="no points"):
        svg(sheet(Stroke("main", ())))


@pytest.mark.parametrize("text", NASTY)
def test_nothing_of_a_text_becomes_markup(text: str) -> None:
    stroke = line("main", 0j, 1j)._replace(title=text, data=(("note", text),))
    made = Sheet(
        text,
        text,
        "A4",
        210,
        297,
        (Drawing(text, text, (stroke,), (Label(escape(drawable(text)), 9j),)),),
    )
    out = svg(made)
    out.encode("utf-8")
    root = ElementTree.fromstring(out)
    assert {e.tag for e in root.iter()} <= ALLOWED
    for element in root.iter():
        assert not any("href" in key or key.startswith("on") for key in element.attrib)
    assert root.find(f"{NS}title").text in (clean(text), None)
    assert re.fullmatch("[A-Za-z][A-Za-z0-9-]*", root.find(f".//{NS}g[@id]").attrib["id"])
    assert "<!" not in out
    assert "<script" not in out


@given(st.text(max_size=200))
def test_any_text_parses_back(text: str) -> None:
    stroke = line("main", 0j, 1j)._replace(title=text, data=(("note", text),))
    root = ElementTree.fromstring(svg(sheet(stroke, name=text)))
    element = root.find(f".//{NS}g[@class='pen main']/{NS}path")
    assert element.attrib.get("data-note", "") == clean(text)


def test_labels_are_drawn_and_named_and_live_text_is_asked_for() -> None:
    labels = (
        Label("план", 100 + 100j, 5),
        Label("план", 100 + 100j, 5, "middle"),
        Label("план", 100 + 100j, 5, "end", 90),
        Label("", 0j),
    )
    assert not parse(sheet(labels=labels)).findall(f".//{NS}text")
    root = ElementTree.fromstring(svg(sheet(labels=labels), searchable=True))
    drawn = root.findall(f".//{NS}g[@class='label']")
    assert [g.attrib["aria-label"] for g in drawn] == ["план"] * 3
    assert all(g.find(f"{NS}title").text == "план" for g in drawn)
    words = root.findall(f".//{NS}g[@class='words']/{NS}text")
    assert [w.text for w in words] == ["план"] * 3
    assert [w.attrib["text-anchor"] for w in words] == ["start", "middle", "end"]
    assert words[2].attrib["transform"] == "rotate(-90 100 494)"
    assert root.find(f".//{NS}g[@class='words']").attrib["fill"] == "white"
    order = [e.attrib.get("class", "") for e in root]
    assert order.index("words") < order.index("drawing plan")


@each("turn, way", [(0.0, 1), (90.0, 1j), (180.0, -1), (30.0, cmath.rect(1, math.pi / 6))])
@each("anchor, share", [("start", 0.0), ("middle", 0.5), ("end", 1.0)])
def test_lettering_starts_where_its_anchor_says(
    turn: float, way: complex, anchor: str, share: float
) -> None:
    root = parse(sheet(labels=(Label("ННННН", 300 + 300j, 10, anchor, turn, inclined=False),)))
    data = root.find(f".//{NS}g[@class='label']/{NS}path").attrib["d"]
    found = [(complex(z.real, 594 - z.imag) - (300 + 300j)) / way for z in traced_any(data)]
    width = max(z.real for z in found) - min(z.real for z in found)
    assert width == pytest.approx(5 * 6 + 4 * 2 - 1, abs=0.6)
    assert min(z.real for z in found) == pytest.approx(-share * (width + 1) + 0.5, abs=0.6)
    assert min(z.imag for z in found) == pytest.approx(0.5, abs=0.6)
    assert max(z.imag for z in found) == pytest.approx(9.5, abs=0.6)


def traced_any(data: str) -> list[complex]:
    """The absolute points of a path of straight strokes, absolute or relative."""
    here, found = 0j, []
    for letter, text in re.findall("([A-Za-z])([^A-Za-z]*)", data):
        values = [float(x) for x in re.findall(r"-?\d*\.?\d+", text)]
        size = {"h": 1, "v": 1, "a": 7, "z": 8}.get(letter.lower(), 2)
        for k in range(0, len(values) - size + 1, size):
            *_, last = group = values[k : k + size]
            step = {"h": complex(last, 0), "v": complex(0, last)}.get(letter.lower())
            if step is None:
                step = complex(group[-2], last)
            if letter.islower():
                here += step
            elif letter in "HV":
                here = complex(last, here.imag) if letter == "H" else complex(here.real, last)
            else:
                here = step
            found.append(here)
    return found


def test_ids_are_unique_and_the_same_input_gives_the_same_bytes() -> None:
    drawing = Drawing("План скоростей", "x", (line("main", 0j, 1j),))
    made = Sheet("лист", "t", "A1", 841, 594, (drawing, drawing, drawing._replace(name="v v")))
    out = svg(made)
    ids = re.findall('id="([^"]*)"', out)
    assert len(set(ids)) == len(ids) == 3
    assert out == svg(made)
    assert out.endswith("</svg>\n")


def test_one_element_a_line() -> None:
    out = svg(
        sheet(line("main", 0j, 1j), circle("joint", 0j, 1), labels=(Label("a", 1j), Label("b", 2j)))
    )
    for row in out.splitlines():
        assert len(re.findall("<[a-z]", row)) <= 1


def test_a_sheet_tells_its_language_and_what_is_on_it() -> None:
    root = parse(sheet()._replace(language="ru"))
    assert (root.attrib["lang"], root.attrib[f"{XML}lang"]) == ("ru", "ru")
    assert [child.tag for child in root[:2]] == [f"{NS}title", f"{NS}desc"]
    assert [child.text for child in root[:2]] == ["Лист", "План"]
    assert not {"lang", f"{XML}lang"} & set(parse(sheet()).attrib)


def test_every_drawing_is_a_layer_of_the_page_with_its_title() -> None:
    one = Drawing("a", "План <скоростей>", (line("main", 0j, 1j),))
    root = parse(Sheet("s", "t", "A4", 210, 297, (one, one._replace(name="b", title="Б"))))
    layers = [child for child in root if f"{INKSCAPE}groupmode" in child.attrib]
    assert [layer.attrib[f"{INKSCAPE}groupmode"] for layer in layers] == ["layer", "layer"]
    assert [layer.attrib[f"{INKSCAPE}label"] for layer in layers] == ["План <скоростей>", "Б"]
    assert [layer.find(f"{NS}title").text for layer in layers] == ["План <скоростей>", "Б"]


@pytest.mark.parametrize(
    "name", ["a.png", "a 'b' \"c\" & <d> #e?%f.png", "\udcff.png", "план.png", "a:b.png"]
)
def test_a_picture_lies_under_thin_coloured_ink_and_nothing_hides_it(name: str) -> None:
    strokes = (
        line("main", 0j, 9j),
        circle("joint", 5j, 1.5),
        line("paper", 0j, 1j, 1 + 1j, closed=True),
        line("thick", 0j, 1j, 1 + 1j, closed=True, filled=True),
    )
    made = sheet(*strokes, labels=(Label("a", 1j, 10),))
    root = ElementTree.fromstring(svg(made, under=Under(name, "#123456")))
    (picture,) = root.iter(f"{NS}image")
    (href,) = (v for k, v in picture.attrib.items() if k.endswith("href"))
    assert os.fsdecode(unquote_to_bytes(href)) == name
    assert not re.search(r"[#?\x00-\x1f]|^\w+:", href)
    assert [picture.attrib[k] for k in ("x", "y", "width", "height")] == ["0", "0", "841", "594"]
    assert picture.attrib["preserveAspectRatio"] == "none"
    assert not root.findall(f".//{NS}rect")
    everything = [e for e in root.iter() if e.tag != f"{NS}image"]
    fills = {e.attrib[k] for e in everything for k in ("fill", "stroke") if k in e.attrib}
    assert fills == {"none", "#123456"}
    widths = {e.attrib["stroke-width"] for e in everything if "stroke-width" in e.attrib}
    assert widths == {number(pens("A1")["thin"].width), "0"}  # "0": the pen that only hides
    layers = [child.tag for child in root if f"{INKSCAPE}groupmode" in child.attrib]
    assert len(layers) == 2


def test_svgwrite_is_not_loaded_before_a_sheet_is_written() -> None:
    code = "import sys, graphic_tmm.paper.write.svg; print('svgwrite' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
