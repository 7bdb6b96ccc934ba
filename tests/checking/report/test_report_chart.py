"""The chart: read back off its own axis, as a person would."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.reports import engine, judged

from graphic_tmm.checking.records import VERDICTS, WRONG
from graphic_tmm.checking.report.chart import COLOURS, SHAPES, axis, chart


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
