"""The report as JSON: null for what is not finite, and nothing lost."""

from __future__ import annotations

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.reports import (
    HOSTILE,
    PUBLISHED,
    due,
    engine,
    explaining,
    hostile,
    judged,
    loaded,
    printed,
    report,
)

from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Judged, Taken
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.markdown import markdown_report

KEYS = ["plan", "position", "segment", "mm", "due_mm", "deviation_mm"]
KEYS += ["percent_of_plan", "verdict", "step"]


def test_json_holds_the_engines_36_readings_as_the_vector_loop_has_them() -> None:
    rows = loaded(json_report(engine()))["readings"]
    assert len(rows) == 36
    longest = max(due(s, k) for s in PUBLISHED for k in range(12))
    for row in rows:
        k = int(row["position"]) - 1
        mm, ought = PUBLISHED[row["segment"]][k], due(row["segment"], k)
        assert list(row)[:9] == KEYS
        # 12 significant digits of figures below 100 mm: half a unit of the last is 5e-11
        assert row["mm"] == mm
        assert row["due_mm"] == pytest.approx(ought, abs=5e-11)
        assert row["deviation_mm"] == pytest.approx(mm - ought, abs=5e-11)
        assert row["percent_of_plan"] == pytest.approx(100 * abs(mm - ought) / longest, abs=5e-11)
    worst = max(abs(row["deviation_mm"]) for row in rows)
    assert round(worst, 2) == 1.83  # as published


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_json_has_null_where_there_is_no_finite_figure(value: float) -> None:
    bad = judged()._replace(
        found=value, due=value, deviation=value, percent=value, quantile=value, own=value
    )
    (row,) = loaded(json_report(report(bad, mistakes=[explaining(2)._replace(rest=value)])))[
        "readings"
    ]
    null = {key for key, cell in row.items() if cell is None}
    assert null == {*KEYS[3:7], "quantile", "own_error_mm"}
    for text in (markdown_report(report(bad)), html_report(report(bad)), printed(report(bad), 80)):
        assert not re.search(r"\b(nan|inf)\b", text)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_json_has_twelve_digits_and_no_minus_zero(value: float) -> None:
    (row,) = loaded(json_report(report(judged(found=value, due=0.0))))["readings"]
    assert row["mm"] == float(f"{value:.11e}")
    assert math.copysign(1, row["mm"]) > 0 or row["mm"] < 0


def test_json_has_values_where_nothing_is_drawn_and_points_where_points_were_read() -> None:
    mass = Judged(Taken("results", "", "J_fly", value=1.77, unit="kg*m^2"), 1.77, 1.5, 0.27, 18.0, 0.1,
                  DOUBTFUL, unit="kg·m²")  # fmt: skip
    point = Judged(Taken("velocities", "2", "b", x=3.0, y=-4.0, line=9), 5.0, 5.5, -0.5, 1.0, 0.4, FINE,
                   step="10", own=0.25)  # fmt: skip
    rows = loaded(json_report(report(mass, point)))["readings"]
    assert [rows[0][key] for key in KEYS[3:6]] == [None] * 3
    assert (rows[0]["value"], rows[0]["due_value"], rows[0]["unit"]) == (1.77, 1.5, "kg·m²")
    assert "line" not in rows[0]
    assert "value" not in rows[1]
    assert (rows[1]["x"], rows[1]["y"], rows[1]["own_error_mm"], rows[1]["line"]) == (
        3,
        -4,
        0.25,
        9,
    )


@given(st.text() | st.sampled_from(HOSTILE))
def test_json_loses_nothing_of_a_text_and_does_nothing_to_a_terminal(text: str) -> None:
    out = json_report(hostile(text))
    found = loaded(out)
    assert all(line.isprintable() for line in out.split("\n"))
    assert found["scene"] == found["title"] == found["hand"] == text
    assert {found["readings"][0][key] for key in ("plan", "position", "unit", "step")} == {text}
    assert found["mistakes"][0]["like"] == [text, text]
    assert found["notes"] == [text]


def test_json_tells_counts_and_what_is_explained() -> None:
    readings = [judged(line=k, verdict=WRONG) for k in (2, 3)] + [judged(line=4)]
    found = loaded(json_report(report(*readings, mistakes=[explaining(3, 4)])))
    assert found["counts"] == {"fine": 1, "doubtful": 0, "wrong": 2}
    assert found["unexplained"] == 1
    assert found["mistakes"][0]["explains"] == 1
    assert found["mistakes"][0]["lines"] == [3, 4]
    assert loaded(json_report(report()))["readings"] == []
