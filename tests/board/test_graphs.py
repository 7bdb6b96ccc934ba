"""Differentiation and integration against a pole: the published example, convergence, closure."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pytest

from graphic_tmm.board import graphs
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.graphs import Axes, Base, Boundaries, Middles
from graphic_tmm.board.operations.formulas import (
    scale_of_derivative,
    scale_of_integral,
    time_per_mm,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.errors import ConstructionError

R, L, W = 0.15, 0.75, 250 * np.pi / 30
MU_V, BASE = 0.075, 96.0


def motion(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Velocity and acceleration of the slider of the published example, closed form."""
    phi = 2 * np.pi * np.arange(n) / n
    root = np.sqrt(L**2 - (R * np.sin(phi)) ** 2)
    v = -R * W * (np.sin(phi) + R * np.sin(2 * phi) / (2 * root))
    bend = np.cos(2 * phi) / root + R**2 * np.sin(2 * phi) ** 2 / (4 * root**3)
    return v, -R * W**2 * (np.cos(phi) + R * bend)


class Sheet(NamedTuple):
    draft: Draft
    base: Base
    axes: Axes
    at: Boundaries

    def run(self, *marks: Mark) -> list[Any]:
        reading = execute(self.draft.board.construction(), self.draft.given, marks)
        return [reading[mark] for mark in marks]


def velocities(n: int) -> Sheet:
    draft = Draft()
    draft.board.open("V")
    length = draft.take(Length, "L", BASE)
    mu_t = draft.board.draw(
        time_per_mm, "μ_t", draft.take(Number, "ω", W, "1/s"), length, unit="s/mm"
    )
    base = graphs.lay_base(draft, length, mu_t, n, np.arange(n, dtype=float)[None, :])
    axes = graphs.draw_axes(draft, "V", base, draft.take(Number, "μ_V", MU_V, "(m/s)/mm"))
    heights = draft.take(Length, "y", motion(n)[0][None, :] / MU_V)
    return Sheet(draft, base, axes, graphs.lay_ordinates(draft, axes, heights, "v"))


class Differentiated(NamedTuple):
    mu: float
    middles: np.ndarray | None
    values: np.ndarray


def differentiated(n: int, method: str = "chords", pole: float = 15.0) -> Differentiated:
    sheet = velocities(n)
    draft, axes = sheet.draft, sheet.axes
    draft.board.open("a")
    distance = draft.take(Length, "H", pole)
    known = axes.mu, sheet.base.mu, distance
    mu = draft.board.draw(scale_of_derivative, "μ_a", *known, unit="(m/s²)/mm")
    to = graphs.draw_axes(draft, "a", sheet.base, mu)
    at_pole = graphs.set_pole(draft, to, distance)
    if method == "chords":
        middles = graphs.by_chords(draft, axes, sheet.at, to, at_pole, "a′")
        points = graphs.on_curve(draft, to, graphs.through(draft, to, middles), "a")
        extra = middles.points
    else:
        curve = graphs.through(draft, axes, sheet.at)
        points = graphs.by_tangents(draft, axes, curve, to, at_pole, "a")
        extra = points.points
    reading = graphs.measure_ordinates(draft, to, points.points, "a")
    value, found, scale = sheet.run(reading, extra, mu)
    factor = float(scale[0, 0])
    between = found.imag[0] * factor if method == "chords" else None
    return Differentiated(factor, between, value[0] * factor)


def test_the_published_example_by_chords() -> None:
    found = differentiated(8)
    assert found.mu == pytest.approx(2.0)
    assert found.middles is not None
    np.testing.assert_allclose(np.abs(found.middles[:4]), [105.8, 25.1, 51.6, 79.3], atol=0.1)
    due = [118.3, 70.8, 18.2, 70.8, 81.9, 70.8, 18.2, 70.8]
    np.testing.assert_allclose(np.abs(found.values), due, atol=0.1)
    exact = motion(8)[1]
    off = np.abs(found.values - exact) / np.abs(exact).max()
    assert off.max() == pytest.approx(0.0415, abs=0.0005)
    assert off.argmax() == 0


def test_the_published_example_by_tangents() -> None:
    exact = motion(8)[1]
    off = np.abs(differentiated(8, "tangents").values - exact) / np.abs(exact).max()
    assert off.max() == pytest.approx(0.0093, abs=0.0005)


def test_chords_converge_with_the_square_of_the_number_of_positions() -> None:
    counts = np.array([12, 24, 48, 96, 192, 384, 768])
    worst = [np.abs(differentiated(int(n)).values - motion(int(n))[1]).max() for n in counts]
    assert np.polyfit(np.log(counts), np.log(worst), 1)[0] == pytest.approx(-2.0, abs=0.1)


@pytest.mark.parametrize("method", ["chords", "tangents"])
def test_another_pole_distance_changes_the_drawing_and_not_the_values(method: str) -> None:
    near, far = differentiated(12, method, 10.0), differentiated(12, method, 35.0)
    assert near.mu == pytest.approx(3.5 * far.mu)
    np.testing.assert_allclose(near.values, far.values, rtol=1e-11, atol=1e-9)


@pytest.mark.parametrize("closed", [True, False])
def test_integrating_the_chords_returns_the_curve_and_closes(closed: bool) -> None:
    sheet = velocities(12)
    draft, axes = sheet.draft, sheet.axes
    draft.board.open("a")
    distance = draft.take(Length, "H", 15.0)
    known = axes.mu, sheet.base.mu, distance
    mu = draft.board.draw(scale_of_derivative, "μ_a", *known, unit="(m/s²)/mm")
    to = graphs.draw_axes(draft, "a", sheet.base, mu)
    pole = graphs.set_pole(draft, to, distance)
    middles = graphs.by_chords(draft, axes, sheet.at, to, pole, "a′")
    curve = graphs.through(draft, to, middles, closed=closed)
    draft.board.open("back")
    known = mu, sheet.base.mu, distance
    again = draft.board.draw(scale_of_integral, "μ", *known, unit="(m/s)/mm")
    back = graphs.draw_axes(draft, "back", sheet.base, again)
    found = graphs.integrate(draft, to, curve, back, pole, "w", mean="middles")
    points, end, scale = sheet.run(found.points, found.end, again)
    v, _ = motion(12)
    assert scale[0, 0] == pytest.approx(MU_V)
    np.testing.assert_allclose(points.imag[0], (v - v[0]) / MU_V, atol=1e-9)
    assert abs(end[0, 0].imag) < 1e-9


def test_open_graphs_differentiate_twice() -> None:
    """A cubic's second derivative is a straight line: chords of its chords give it inside."""
    n = 12
    draft = Draft()
    draft.board.open("S")
    length = draft.take(Length, "L", BASE)
    one = draft.take(Number, "μ_t", 1.0)
    base = graphs.lay_base(draft, length, one, n, np.arange(n, dtype=float)[None, :])
    axes = graphs.draw_axes(draft, "S", base, draft.take(Number, "μ_S", 1.0))

    def cubic(x: np.ndarray) -> np.ndarray:
        return 20 + x / 4 - x**2 / 80 + x**3 / 9000

    x = np.arange(n) * BASE / n
    at = graphs.lay_ordinates(draft, axes, draft.take(Length, "y", cubic(x)[None, :]), "s")
    line = draft.board.draw(graphs.square, "(e)", axes.end, axes.along, sense=1)
    last = draft.take(Length, "y_N", float(cubic(np.array(BASE))))
    at = Boundaries(at.points, draft.board.draw(graphs.lay_off, "s_e", line, last))
    for view, letter in (("V", "v"), ("a", "a")):
        draft.board.open(view)
        distance = draft.take(Length, "H", 30.0)
        to = graphs.draw_axes(draft, view, base, draft.take(Number, "μ", 1 / 30.0))
        pole = graphs.set_pole(draft, to, distance)
        middles = graphs.by_chords(draft, axes, at, to, pole, f"{letter}′")
        curve = graphs.through(draft, to, middles, closed=False)
        at, axes = graphs.on_curve(draft, to, curve, letter), to
    reading = execute(draft.board.construction(), draft.given, [at.points, at.end])
    found = np.append(reading[at.points].imag[0], reading[at.end].imag[0]) / 900.0
    due = -1 / 40 + np.append(x, BASE) / 1500
    # a chord's slope is the derivative at the middle and h²/24 of the third one, which is constant here
    np.testing.assert_allclose(found, due, atol=1e-9)


def test_too_few_intervals_are_refused() -> None:
    draft = Draft()
    draft.board.open("S")
    length = draft.take(Length, "L", BASE)
    mu = draft.take(Number, "μ_t", 1.0)
    with pytest.raises(ConstructionError, match="4 intervals at least, not 3"):
        graphs.lay_base(draft, length, mu, 3, np.arange(3.0)[None, :])


def test_a_value_of_the_middle_cannot_be_taken_for_one_of_a_boundary() -> None:
    assert Middles._fields == ("points",)
    assert Boundaries._fields == ("points", "end")  # what a chord leaves has no end of the base
