"""A graph, or polygons of forces, in a scale factor that only a mistake lets tell."""

from __future__ import annotations

import pytest
from support.own_told import kind_of, report_of, scales, told, with_mistake


@pytest.mark.slow
def test_a_mistake_tells_the_scale_factor_of_its_graph() -> None:
    """No length of S has the right ratio: it is counted from another zero, in another scale factor."""
    drawing = with_mistake(kind_of("S from another zero"), 0, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert told(report, drawing).name
    (one,) = (one for one in report.scales if one.symbol == "μ_S")
    assert (one.by, one.mu) == ("supposed", pytest.approx(0.0025))


@pytest.mark.slow
def test_all_polygons_of_forces_have_one() -> None:
    drawing = with_mistake(kind_of("inertia along a, header"), 0, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert told(report, drawing).name
    found = [one.mu for one in report.scales if one.plan == "forces"]
    assert len(found) == 3
    assert max(found) == min(found)


@pytest.mark.slow
def test_no_scale_factor_is_told_of_what_is_as_long_as_due() -> None:
    drawing = with_mistake(kind_of("load left out of the lever"), 0, 61000, own=False)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert not [one for one in scales(report, drawing) if one[1] == "false"]
    assert not [one for one in report.scales if one.by == "supposed"]
