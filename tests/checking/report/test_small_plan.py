"""A small plan read back: it stands by itself, holds what it shows, and is true to shape."""

from __future__ import annotations

import math
import re
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt
from support.lessons_told import lessons, plan_of_velocities, points_of_positions, row
from support.reports import HOSTILE, report

from graphic_tmm.checking.records import FINE, WRONG, Lesson
from graphic_tmm.checking.report.chart import COLOURS
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.checking.report.small_plan import HEIGHT, WIDTH, small_plan

Box = tuple[float, float, float, float]


def lesson(position: int = 1, mm: float = 33.0) -> Lesson:
    due = plan_of_velocities(position)["pb"]
    (found,) = lessons(row("velocities", str(position), "pb", abs(due), "10 pb", mm=mm))
    return found


def of_point(position: int, off: complex) -> Lesson:
    due = points_of_positions(position)["B"]
    (found,) = lessons(row("positions", str(position), "B", abs(due), "7 B", at=due + off))
    return found


def svg(one: Lesson, label: str = "a plan") -> ElementTree.Element:
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
    root, due = svg(lesson(position, mm)), plan_of_velocities(position)["pb"]
    start, end = ends(next(p for p in group(root, WRONG).iter("path")).attrib["d"])
    ratio = (end - start) / (disc(root) - start)
    assert ratio == pytest.approx(mm / abs(due), abs=0.02)  # the circle is written to 0.01 mm
    assert cross(root) == pytest.approx(end, abs=0.01)


@pytest.mark.parametrize("off", [12.0 + 9.0j, -30.0j, 5.0])
def test_a_point_stands_off_its_due_in_its_direction(off: complex) -> None:
    root = svg(of_point(3, off))
    away = cross(root) - disc(root)
    assert away / abs(away) == pytest.approx(off / abs(off), abs=0.01)
    assert abs(away) <= abs(off) * 1.001


@pytest.mark.parametrize("position", [0, 1, 3, 6])
@pytest.mark.parametrize("off", [3.0 + 2.0j, -900.0 + 40.0j])
def test_a_plan_is_small_and_its_ink_is_inside(position: int, off: complex) -> None:
    root = svg(of_point(position, off))
    left, top, right, low = box(root)
    assert right - left <= WIDTH + 8.0  # and a letter at its edge
    assert low - top <= HEIGHT + 8.0
    ink = [p.attrib["d"] for g in list(root.iter("g"))[:2] for p in g.iter("path")]
    begins = [
        complex(*map(float, at)) for d in ink for at in re.findall(r"M([-\d.]+) ([-\d.]+)", d)
    ]
    assert len(begins) > 10
    assert all(left <= z.real <= right and top <= z.imag <= low for z in begins)
    inside = left <= cross(root).real <= right
    assert inside is (abs(off) < 100)  # what is very far off runs out of the picture


@pytest.mark.parametrize("label", ["plain", *HOSTILE])
def test_a_plan_stands_by_itself(label: str) -> None:
    one = lesson()
    assert one.picture is not None
    text = str(small_plan(one.picture, label))
    assert re.sub(r"\s", "", svg(one, "x").attrib["aria-label"]) == "x"
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
