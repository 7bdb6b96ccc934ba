"""Klein's and Ritterhaus's constructions on published problems, each to the digits that are printed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from support.boards import in_usual_size
from support.published_mechanisms import slider_crank

import graphic_tmm
from graphic_tmm.chapters.klein.record import KLEIN_PLAN
from graphic_tmm.chapters.klein.task import KLEIN, RITTERHAUS, VIEWS


def figures(scene: dict[str, Any], view: str) -> tuple[Mapping[str, Any], Mapping[str, Any]]:
    """The sides of a construction by their letters, m, and its quantities, SI, along the row."""
    (drawn,) = in_usual_size(graphic_tmm.read(scene), exact=True).boards
    made, reading = KLEIN_PLAN.on(drawn).figures[view], drawn.of(view)
    assert reading is not None
    count, mu = len(drawn.row(view)), drawn.scales[view].value

    def row(mark: Any) -> Any:
        return np.abs(np.broadcast_to(reading[mark][0], (count,)))

    sides = {one.segment.name: mu * row(one.segment) for one in made.quantities}
    return sides, {one.vector: row(one.value) for one in made.quantities}


@pytest.mark.parametrize("view", VIEWS)
def test_a_rod_square_to_its_crank(view: str) -> None:
    """Meshchersky 18.12: OA 20 cm, AB 1 m, 10 rad/s, α = β = 45°: ω 2, ε 16 1/s², a_B 565.6 cm/s².

    The guide passes O at the distance AB·sin 45° − OA·cos 45°: the construction off the axis.
    """
    past = (1.0 - 0.2) * math.sqrt(0.5)
    scene = slider_crank(
        0.2, 1.0, "10 rad/s", through=past, angle=90.0, klein={},
        drive={"from": "45 deg", "to": "60 deg", "positions": 2, "accelerations": "all"},
    )  # fmt: skip
    sides, found = figures(scene, view)
    assert 10.0 * sides["AM"][0] / 1.0 == pytest.approx(2.0, rel=1e-9)
    assert 100.0 * sides["QN"][0] / 1.0 == pytest.approx(16.0, rel=1e-9)
    # 400·√2 = 565.685: the book cuts the digits
    assert found["a_B"][0] == pytest.approx(5.656, abs=1e-3)


@pytest.mark.parametrize(("view", "known"), [(KLEIN, (0, 1, 2)), (RITTERHAUS, ())])
def test_a_crank_in_line_and_square_to_the_guide(view: str, known: tuple[int, ...]) -> None:
    """Meshchersky 18.9: OA 40 cm, AB 2 m, 15 rad/s: a_B = 108, 18.37, 72 m/s² at 0, 90, 180°.

    Ritterhaus's lines coincide in the dead places, and where A is M there is no line AM to draw on.
    """
    scene = slider_crank(
        0.4, 2.0, "15 rad/s", klein={}, drive={"positions": 4, "accelerations": "all"}
    )
    _, found = figures(scene, view)
    for k, due in enumerate((108.0, 18.37, 72.0)):
        if k in known or np.isfinite(found["a_B"][k]):
            assert found["a_B"][k] == pytest.approx(due, abs=5e-3), k


@pytest.mark.parametrize("view", VIEWS)
def test_a_crank_along_a_guide_that_passes_its_axis(view: str) -> None:
    """Meshchersky 18.13, in letters: ω = rω_0/q, ε = hr²ω_0²/q³, v_B = hrω_0/q, a_B = rω_0²(1 + rl²/q³).

    q² = l² − h²; r 10, l 40, h 15 cm, 2 rad/s.
    """
    r, rod, h, omega = 0.1, 0.4, 0.15, 2.0
    q = math.sqrt(rod**2 - h**2)
    scene = slider_crank(
        r, rod, f"{omega!r} rad/s", through=-h, klein={},
        drive={"from": "0 deg", "to": "20 deg", "positions": 2, "accelerations": "all"},
    )  # fmt: skip
    sides, found = figures(scene, view)
    assert omega * sides["AM"][0] / rod == pytest.approx(r * omega / q, rel=1e-9)
    due = h * r**2 * omega**2 / q**3
    assert omega**2 * sides["QN"][0] / rod == pytest.approx(due, rel=1e-9)
    assert found["v_B"][0] == pytest.approx(h * r * omega / q, rel=1e-9)
    assert found["a_B"][0] == pytest.approx(r * omega**2 * (1 + r * rod**2 / q**3), rel=1e-9)


@pytest.mark.parametrize("view", VIEWS)
def test_the_middle_of_a_rod(view: str) -> None:
    """Khurmi and Gupta, Theory of Machines, example 8.1, read off plans: 117 m/s² of the middle D of the rod.

    Crank 150 mm, rod 600 mm, 300 rpm, 45° (mechdiploma.com prints that reading). From memory also v_AB 3.4 m/s
    and the tangential 103 m/s²: all to 1.5 %; v_D 4.1 m/s is read 2.6 % too long: half of v_A + v_B is 3.995.
    """
    scene = slider_crank(
        0.15, 0.6, "300 rpm", klein={"points": ["M"]},
        drive={"from": "45 deg", "to": "60 deg", "positions": 2, "accelerations": "all"},
    )  # fmt: skip
    omega = 10.0 * math.pi
    sides, found = figures(scene, view)
    told = {
        117.0: found["a_{M}"][0],
        3.4: omega * sides["AM"][0],
        103.0: omega**2 * sides["QN"][0],
    }
    for due, value in told.items():
        assert value == pytest.approx(due, rel=0.015), due
    pin = 0.15 * omega * 1j * np.exp(0.25j * math.pi)
    lean = math.asin(0.15 / 0.6 * math.sin(math.pi / 4))
    stone = pin.real - pin.imag * math.tan(lean)
    assert found["v_{M}"][0] == pytest.approx(abs(pin + stone) / 2, rel=1e-9)
    assert found["v_{M}"][0] == pytest.approx(4.1, rel=0.03)
