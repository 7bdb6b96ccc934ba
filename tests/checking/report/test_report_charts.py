"""The pictures of a report: its charts of deviations, its small plans."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from support.each import each
from support.lessons_told import lessons, plan_of_velocities, points_of_positions, row
from support.reports import HOSTILE, engine, judged, report

from graphic_tmm.checking.records import FINE, VERDICTS, WRONG, Lesson, PlanPicture
from graphic_tmm.checking.report.charts import (
    COLOURS,
    PLAN_HEIGHT,
    PLAN_WIDTH,
    SHAPES,
    Letter,
    apart,
    axis,
    chart,
    small_plan,
)
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.paper.drawing import Drawing, Label, line


def svg(text: str) -> ElementTree.Element:
    return ElementTree.fromstring(text)


def scale(root: ElementTree.Element) -> Callable[[float], float]:
    """Return the deviation at a height, from the figures beside the axis, 0.9 mm below their rules."""
    ruled = {}
    for text in root.iter("text"):
        if (text.text or "").strip() and text.get("x") == "13":
            figure = float(text.text.replace("%", "").replace("−", "-").replace(",", "."))
            ruled[figure] = float(text.attrib["y"]) - 0.9
    top, bottom = max(ruled), min(ruled)
    each = (ruled[top] - ruled[bottom]) / (top - bottom)
    return lambda y: bottom + (y - ruled[bottom]) / each


def marks(root: ElementTree.Element) -> list[tuple[str, float, float, str]]:
    found = []
    for group in root.iter("g"):
        for path in group.findall("path") if group.get("class") else []:
            x, y = re.match(r"M([\d.]+) ([\d.]+)", path.attrib["d"]).groups()
            found.append((group.attrib["class"], float(x), float(y), path.attrib["d"]))
    return found


def test_every_reading_stands_at_its_deviation() -> None:
    made = engine()
    root = svg(chart("velocities", made.readings, "en"))
    at, found = scale(root), marks(root)
    assert len(found) == 36
    due = sorted(made.readings, key=lambda one: (int(one.taken.position), made.readings.index(one)))
    for one, (verdict, _, y, _) in zip(due, sorted(found, key=lambda m: m[1]), strict=True):
        assert verdict == one.verdict
        # heights are written to 0.01 mm and 18 mm stand for at most 6 %: 0.005 mm twice is 0.004 %
        assert at(y) == pytest.approx(math.copysign(one.percent, one.deviation), abs=0.004)


def test_verdicts_have_shapes_and_colours_of_their_own_and_the_far_ones_an_arrow() -> None:
    few = [judged(found=17.9, percent=2.5, verdict=verdict) for verdict in VERDICTS]
    far = judged(found=-80.0, percent=90.0, verdict=WRONG)
    root = svg(chart("velocities", [*few, far], "en"))
    shapes = {verdict: d.split("m", 1)[1] for verdict, _, _, d in marks(root)[:3]}
    assert len(set(shapes.values())) == len(set(SHAPES.values())) == len(set(COLOURS.values())) == 3
    *near, (_, _, y, path) = marks(root)
    assert path.count("M") == 2
    assert [d.count("M") for *_, d in near] == [1, 1, 1]
    assert y == 39.0  # the lower edge of the field
    titles = [t.text for t in root.iter("title")]
    assert titles[-1] == "1 pb: −90.0 %, wrong"


def luminance(colour: str) -> float:
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    r, g, b = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return 0.2126 * r + 0.7152 * g + 0.0722 * b


@pytest.mark.parametrize("colour", COLOURS.values())
def test_colours_stand_out_from_the_paper(colour: str) -> None:
    paper = min(map(luminance, ("#ffffff", "#fdeff0", "#fdf5ea")))
    assert (paper + 0.05) / (luminance(colour) + 0.05) >= 4.5  # WCAG 2, text


@given(st.lists(st.floats(allow_nan=True), min_size=2, max_size=30))
def test_any_deviations_make_a_chart_inside_its_field(percents: list[float]) -> None:
    readings = [judged(percent=p, verdict=VERDICTS[k % 3]) for k, p in enumerate(percents)]
    text = chart("velocities", readings, "ru")
    finite = [p for p in percents if math.isfinite(p)]
    if len(finite) < 2:
        assert text == ""
        return
    assert "nan" not in text
    assert "inf" not in text
    found = marks(svg(text))
    assert len(found) == len(finite)
    assert all(14 <= x <= 178 and 3 <= y <= 39 for _, x, y, _ in found)
    limit, step = axis([one for one in readings if math.isfinite(one.percent)])
    count = limit / step
    assert abs(count - round(count)) < 1e-9
    assert 1 <= round(count) <= 4


def test_results_are_named_under_the_chart_and_one_reading_makes_none() -> None:
    readings = [judged(name, "") for name in ("J_fly", "cd")]
    texts = [t.text for t in svg(chart("results", readings, "en")).iter("text")]
    assert texts[-2:] == ["J_fly", "cd"]
    assert chart("results", readings[:1], "en") == ""


Box = tuple[float, float, float, float]


def lesson(position: int = 1, mm: float = 33.0) -> Lesson:
    due = plan_of_velocities(position)["pb"]
    (found,) = lessons(row("velocities", str(position), "pb", abs(due), "10 pb", mm=mm))
    return found


def of_point(position: int, off: complex) -> Lesson:
    due = points_of_positions(position)["B"]
    (found,) = lessons(row("positions", str(position), "B", abs(due), "7 B", at=due + off))
    return found


def plan_svg(one: Lesson, label: str = "a plan") -> ElementTree.Element:
    assert one.picture is not None
    return ElementTree.fromstring(str(small_plan(one.picture, label)))


def box(root: ElementTree.Element) -> Box:
    x, y, width, height = map(float, root.attrib["viewBox"].split())
    return x, y, x + width, y + height


def group(root: ElementTree.Element, verdict: str) -> ElementTree.Element:
    (found,) = (g for g in root.iter("g") if g.get("stroke") == COLOURS[verdict])
    return found


def ends(path: str) -> list[complex]:
    """Return where straight lines of a path begin and end, y upward."""
    return [complex(float(x), -float(y)) for x, y in re.findall(r"[ML]([-\d.]+) ([-\d.]+)", path)]


def disc(root: ElementTree.Element) -> complex:
    (one,) = group(root, FINE).iter("circle")
    return complex(float(one.attrib["cx"]), -float(one.attrib["cy"]))


def cross(root: ElementTree.Element) -> complex:
    spots = ends(list(group(root, WRONG).iter("path"))[-1].attrib["d"])
    assert len(spots) == 4
    return sum(spots) / 4


@pytest.mark.parametrize("position", [1, 3, 5])
@pytest.mark.parametrize("mm", [3.0, 33.0, 90.0])
def test_due_and_found_stand_in_true_proportion(position: int, mm: float) -> None:
    root, due = plan_svg(lesson(position, mm)), plan_of_velocities(position)["pb"]
    start, end = ends(next(p for p in group(root, WRONG).iter("path")).attrib["d"])
    ratio = (end - start) / (disc(root) - start)
    assert ratio == pytest.approx(mm / abs(due), abs=0.02)  # the circle is written to 0.01 mm
    assert cross(root) == pytest.approx(end, abs=0.01)


@pytest.mark.parametrize("off", [12.0 + 9.0j, -30.0j, 5.0])
def test_a_point_stands_off_its_due_in_its_direction(off: complex) -> None:
    root = plan_svg(of_point(3, off))
    away = cross(root) - disc(root)
    assert away / abs(away) == pytest.approx(off / abs(off), abs=0.01)
    assert abs(away) <= abs(off) * 1.001


@pytest.mark.parametrize("position", [0, 1, 3, 6])
@pytest.mark.parametrize("off", [3.0 + 2.0j, -900.0 + 40.0j])
def test_a_plan_is_small_and_its_ink_is_inside(position: int, off: complex) -> None:
    root = plan_svg(of_point(position, off))
    left, top, right, low = box(root)
    assert right - left <= PLAN_WIDTH + 8.0  # and a letter at its edge
    assert low - top <= PLAN_HEIGHT + 8.0
    ink = [p.attrib["d"] for g in list(root.iter("g"))[:2] for p in g.iter("path")]
    begins = [
        complex(*map(float, at)) for d in ink for at in re.findall(r"M([-\d.]+) ([-\d.]+)", d)
    ]
    assert len(begins) > 10
    assert all(left <= z.real <= right and top <= z.imag <= low for z in begins)
    inside = left <= cross(root).real <= right
    assert inside is (abs(off) < 100)  # what is very far off runs out of the picture


@each("label", ["plain", *HOSTILE])
def test_a_plan_stands_by_itself(label: str) -> None:
    one = lesson()
    assert one.picture is not None
    text = str(small_plan(one.picture, label))
    assert re.sub(r"\s", "", plan_svg(one, "x").attrib["aria-label"]) == "x"
    assert not re.search(r"href|url\(|<script|<text|<title|\n\s*\n", text)
    assert not re.search(r"\b(nan|inf)\b", text.replace(label, ""))


@pytest.mark.parametrize("x", [math.inf, math.nan, 1e300, -1e18])
def test_absurd_figures_do_not_break_the_plan(x: float) -> None:
    one = lesson()
    assert one.picture is not None
    text = str(small_plan(one.picture._replace(found=(0j, complex(x, 0.0))), "x"))
    assert not re.search(r"\b(nan|inf)\b|\d{7}", text)
    ElementTree.fromstring(text)


def test_markdown_takes_it_as_one_block() -> None:
    made = report()._replace(lessons=(lesson(), of_point(2, 9.0)))
    blocks = MarkdownIt("commonmark", {"html": True}).parse(markdown_report(made))
    plans = [one.content for one in blocks if one.type == "html_block" and "<svg" in one.content]
    assert len(plans) == 2
    for text in plans:
        assert text.rstrip().endswith("</svg>")
        ElementTree.fromstring(text)
    assert html_report(made).count('<svg class="plan"') == 2


def test_letters_that_would_stand_on_others_are_left_out_the_farther_first() -> None:
    labels = [Label("F_1", 3j, 3.5), Label("F_2", 1 + 3.2j, 3.5), Label("F_3", 40 + 3j, 3.5)]
    drawing = Drawing("v", "", [line("thin", 0j, 50 + 0j)], labels)
    named = (0j, 10 + 0j, 40 + 0j)

    def letters(*due: complex) -> int:
        picture = PlanPicture(drawing, due=due, named=named)
        return len(svg(str(small_plan(picture, "a plan")))[-1])

    places = zip(labels, (0.0, 1.0, 40.0), strict=True)
    boxes = [Letter(one.text, "", (x, 0.0, x + 4.0, 3.0)) for one, x in places]
    for due, first in ((10 + 0j, "F_2"), (0j, "F_1")):
        kept = apart(boxes, PlanPicture(drawing, due=(due - 1, due + 1), named=named))
        assert [one.data for one in kept] == [first, "F_3"]
    assert letters(0j, 1 + 0j) == 2
