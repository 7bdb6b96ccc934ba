"""SVG: a page finds the strokes of a step, a person the layers of a line kind; lengths are true."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest
from support.each import each
from support.gallery import paper

from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Sheet, line
from graphic_tmm.paper.pens import KINDS, pens
from graphic_tmm.paper.write.svg import svg

NS = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"


def parse(*strokes, labels: tuple[Label, ...] = (), language: str = "ru") -> ElementTree.Element:
    drawing = Drawing("plan", "План", strokes, labels)
    return ElementTree.fromstring(svg(Sheet("s", "t", "A4", 210, 297, (drawing,), language)))


def told(element: ElementTree.Element) -> tuple[str | None, ...]:
    return tuple(element.get(f"data-{name}") for name in ("of", "at", "part"))


def test_strokes_tell_their_steps_their_position_and_their_part() -> None:
    strokes = (
        line("thin", 0j, 1j)._replace(of=(12, 3), position=4),
        line("thin", 2j, 3j)._replace(of=(12, 3), position=4),
        line("thin", 4j, 5j)._replace(of=(12, 3), position=0),
        line("thin", 6j, 7j)._replace(part='a "part" <b>'),
        line("thin", 8j, 9j),
        Bezier("thin", (0j, 1j, 2j, 3j), of=(0,), part="contour"),
        line("thin", 0j, 9j)._replace(of=(12, 3), position=4, title="vector", data=(("mm", "9"),)),
    )
    found = parse(*strokes).findall(f".//{NS}g[@class='pen thin']/{NS}path")
    assert [told(path) for path in found] == [
        ("12 3", "4", None),
        ("12 3", "0", None),
        (None, None, 'a "part" <b>'),
        (None, None, None),
        ("0", None, "contour"),
        ("12 3", "4", None),
    ]
    assert found[0].get("d").count("M") == 2
    assert found[-1].get("data-mm") == "9"


def test_letters_tell_what_they_name() -> None:
    labels = (Label("a", 5j, of=(7,), position=2), Label("План", 9j))
    found = parse(labels=labels).findall(f".//{NS}g[@class='label']")
    assert [told(group) for group in found] == [("7", "2", None), (None, None, None)]


@pytest.mark.slow
def test_no_stroke_of_a_scene_is_lost_and_each_tells_what_it_knows() -> None:
    """As many pieces of path with each tale as strokes of it."""
    for sheet in paper("crank-rocker")[1]:
        due: dict[tuple[object, ...], int] = {}
        for drawing in sheet.drawings:
            for stroke in drawing.strokes:
                of = " ".join(map(str, stroke.of)) or None
                at = None if stroke.position is None else str(stroke.position)
                key = (of, at, stroke.part or None)
                due[key] = due.get(key, 0) + 1
        found: dict[tuple[object, ...], int] = {}
        root = ElementTree.fromstring(svg(sheet))
        for group in root.iter(f"{NS}g"):
            if (group.get("class") or "").startswith("pen "):
                for path in group.findall(f"{NS}path"):
                    pieces = path.get("d").count("M")
                    found[told(path)] = found.get(told(path), 0) + pieces
        assert found == due


def layers(element: ElementTree.Element) -> list[str]:
    return [child.get(f"{INKSCAPE}label") for child in element if child.get(f"{INKSCAPE}groupmode")]


def test_line_kinds_are_layers_within_that_of_their_view() -> None:
    strokes = (line("main", 0j, 1j), line("thin", 0j, 1j), line("dashed", 0j, 9j))
    labels = (Label("a", 1j), Label("b", 2j, 2.5))
    for language, due in (
        (
            "ru",
            ["тонкие линии", "штриховые линии", "основные линии", "надписи 5", "надписи 2,5"],
        ),
        ("en", ["thin lines", "dashed lines", "main lines", "lettering 5", "lettering 2.5"]),
    ):
        root = parse(*strokes, labels=labels, language=language)
        assert layers(root) == ["План"]
        (view,) = root.findall(f"{NS}g")
        assert layers(view) == due


def test_every_pen_has_a_name() -> None:
    assert set(KINDS) == set(pens("A1"))
    assert len(set(KINDS.values())) == len(KINDS)


@each("name, crank", [("crank-rocker", 20.0), ("shaper", 110.0)])
def test_a_crank_is_as_long_as_its_scale_says(name: str, crank: float) -> None:
    """The circle of the crank pin, of l/μ_l (``crank``: OA as the scene's file has it, mm)."""
    sheet = paper(name)[1][0]
    texts = " ".join(label.text for drawing in sheet.drawings for label in drawing.labels)
    scale = float(re.search(r"μ_l = ([\d.,]+)", texts)[1].replace(",", "."))
    root = ElementTree.fromstring(svg(sheet))
    assert root.get("width") == f"{root.get('viewBox').split()[2]}mm"
    plan = root.find(f".//{NS}g[@class='drawing positions']")
    paths = " ".join(path.get("d") for path in plan.iter(f"{NS}path"))
    radii = {float(radius) for radius in re.findall(r"A([\d.]+) \1 ", paths)}
    assert min(abs(radius - crank / 1000 / scale) for radius in radii) <= 5.001e-4


def test_the_check_line_is_100_mm() -> None:
    for name in ("engine", "crank-rocker"):
        for sheet in paper(name)[1]:
            root = ElementTree.fromstring(svg(sheet))
            (path,) = root.findall(f".//{NS}path[@data-check-line]")
            x, y, u, v = (float(number) for number in re.findall(r"[\d.]+", path.get("d")))
            assert {abs(x - u), abs(y - v)} == {0.0, 100.0}
