"""Curves by matplotlib: the figures of the tables, one pair of axes a unit."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from support.drives import BOOM, scene

import graphic_tmm as tmm

matplotlib = pytest.importorskip("matplotlib")
DRAWN = tmm.draw("crank-rocker")


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield
    pyplot.close("all")


def test_each_unit_has_axes_of_its_own() -> None:
    found = DRAWN.plot("velocities")
    table = DRAWN.table("velocities")
    assert len(found) == len({one.unit for one in table.values()}) == 2
    assert [axes.get_ylabel() for axes in found] == ["m/s", "1/s"]
    assert found[-1].get_xlabel() == "φ, °"
    assert sum(len(axes.get_lines()) for axes in found) == len(table)


def test_a_curve_goes_through_the_figures_of_the_table() -> None:
    (axes,) = DRAWN.plot("velocities", ["pb"])
    (line,) = axes.get_lines()
    column = DRAWN.table("velocities")["pb"]
    assert sorted(line.get_ydata()) == pytest.approx(sorted(column.value[0]))
    x = np.asarray(line.get_xdata())
    assert (np.diff(x) >= 0).all()
    by_angle = dict(zip(np.round(column.angles % 360.0, 6), column.value[0], strict=True))
    assert [by_angle[one] for one in np.round(x % 360.0, 6)] == pytest.approx(
        list(line.get_ydata())
    )


def test_many_drawings_are_a_median_and_a_band() -> None:
    many = tmm.draw("crank-rocker", hand="student", trials=50)
    (axes,) = many.plot("velocities", ["pb"])
    rows = many.table("velocities")["pb"].value
    assert sorted(axes.get_lines()[0].get_ydata()) == pytest.approx(sorted(np.median(rows, axis=0)))
    assert len(axes.collections) == 1


def test_axes_of_ones_own_are_drawn_on() -> None:
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    assert DRAWN.plot("velocities", ["pb", "pa"], ax=axes) == [axes]
    assert len(axes.get_lines()) == 2
    with pytest.raises(tmm.SheetError, match="one pair of axes shows one unit, here are m/s, 1/s"):
        DRAWN.plot("velocities", ax=axes)
    with pytest.raises(tmm.AbsentError):
        DRAWN.plot("velocities", ["qq"])


def test_what_has_no_angles_stands_by_its_names() -> None:
    (axes,) = tmm.draw("gear-pair").plot("sliding")
    axes.figure.canvas.draw()
    assert [one.get_text() for one in axes.get_xticklabels()][:3] == ["1", "2", "3"]


def test_a_package_that_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(tmm.MissingError, match="pip install matplotlib"):
        DRAWN.plot("velocities")
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(tmm.MissingError, match="pip install pandas"):
        DRAWN.table("velocities").to_pandas()


def test_what_slides_is_drawn_over_its_lengths() -> None:
    drawn = tmm.draw(scene(BOOM))
    (axes,) = drawn.plot("velocities", ["pn"])
    (line,) = axes.get_lines()
    assert line.get_xdata() == pytest.approx(np.linspace(0.6, 0.85, 6))
    assert axes.get_xlabel() == "$\\mathdefault{l_{GN}}$, m"
