"""Radii of curvature of many paths against places alone, differentiated with 50 digits.

Forty random mechanisms: four-bars, slider-cranks on and off the axis, six-bars with a further dyad of two pins
or of a pin and a slider on the coupler's point. What is judged is the path of a point of the coupler, or of the
dyad's floating link. The judge knows where pins are, by two circles or a circle and a line, and nothing of
velocities or accelerations.

The tolerance: a place that two circles give is as much less sure than its data as their angle γ is flat,
1/sin γ; its velocity divides by that again, and its acceleration a third time. Of the acceleration a_n is the
part a_n/a. So ρ has the relative error C·ε·(a/a_n)/sin³γ, each group's sines multiplied; C counts operations
(two hundred), ε = 2⁻⁵³.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from mpmath import mp
from support.turns import in_turn

import graphic_tmm

OPERATIONS = 200
"""C: rounded operations from the crank's angle to ρ; the worst of 240 places needs 56."""
DIGITS = 50
Place = Callable[[Any], Any]


class Case(NamedTuple):
    """A scene whose point M goes along ``path``; ``sines``: of the groups' angles, by the crank's angle."""

    scene: dict[str, Any]
    path: Place
    sines: Place


def circles(first: Any, second: Any, near: float, far: float) -> tuple[Any, Any]:
    """Where circles about two places meet, left of the way from first to second; sine of their angle."""
    way = second - first
    reach = abs(way)
    along = (reach**2 + mp.mpf(near) ** 2 - mp.mpf(far) ** 2) / (2 * reach)
    up = mp.sqrt(mp.mpf(near) ** 2 - along**2)
    return first + way / reach * mp.mpc(along, up), reach * up / (mp.mpf(near) * mp.mpf(far))


def on_line(first: Any, near: float, height: float) -> tuple[Any, Any]:
    """Where a circle meets a level line, on the right; sine of the angle between the circle and the line."""
    up = mp.mpf(height) - first.imag
    right = mp.sqrt(mp.mpf(near) ** 2 - up**2)
    return mp.mpc(first.real + right, height), right / mp.mpf(near)


def carried(first: Any, second: Any, own: complex) -> Any:
    """A point that a link has at ``own`` where its first point is the origin and its second on the x axis."""
    way = second - first
    return first + way / abs(way) * mp.mpc(own.real, own.imag)


def case(k: int) -> Case:
    """The k-th mechanism: three kinds, and a dyad on every second of the last ones."""
    rng = np.random.default_rng(7000 + k)
    r = float(rng.uniform(0.02, 0.1))
    rod = r * float(rng.uniform(2.2, 4.5))
    sliding = k % 4 == 1
    own = complex(rod * rng.uniform(0.1, 1.2), rod * rng.choice([-1, 1]) * rng.uniform(0.1, 0.8))
    links: list[dict[str, Any]] = [
        {"number": 1, "points": {"O": [0, 0], "A": [r, 0]}},
        {"number": 2, "points": {"A": [0, 0], "B": [rod, 0], "K": [own.real, own.imag]}},
    ]
    frame: dict[str, Any] = {"O": [0, 0]}
    if sliding:
        off = r * float(rng.uniform(-0.6, 0.6)) * (k % 8 > 3)
        frame["x"] = {"through": [0, off], "angle": "0 deg"}
        slides = {"on": "frame", "along": "x", "side": "right"}
        links.append({"number": 3, "points": {"B": [0, 0]}, "slides": slides})
    else:
        rocker, base = r * float(rng.uniform(2.0, 4.5)), r * float(rng.uniform(2.0, 4.5))
        while r + max(rod, rocker, base) > 0.92 * (rod + rocker + base - max(rod, rocker, base)):
            rocker, base = (r * float(x) for x in rng.uniform(2.0, 4.5, 2))
        frame["D"] = [base, 0]
        links[1]["side"] = "left of AD"
        links.append({"number": 3, "points": {"D": [0, 0], "B": [rocker, 0]}})

    def coupler(phi: Any) -> tuple[Any, Any, Any]:
        pin = r * mp.expj(phi)
        other, sine = on_line(pin, rod, off) if sliding else circles(pin, base, rod, rocker)
        return carried(pin, other, own), sine, pin

    drive = {
        "link": 1,
        "speed": "8 rad/s",
        "turns": "counterclockwise",
        "zero": "0 deg",
        "positions": 8,
    }
    scene = {"title": "T", "language": "en", "frame": frame, "link": links, "drive": drive}
    if k % 2 == 0 or (sliding and k % 8 > 3):
        return _with_dyad(rng, scene, lambda phi: coupler(phi)[:2], sliding=k % 4 == 2)
    scene["curvature"] = {"points": ["K"], "positions": [1]}
    return Case(scene, lambda phi: coupler(phi)[0], lambda phi: coupler(phi)[1])


def _with_dyad(
    rng: np.random.Generator, scene: dict[str, Any], coupler: Place, *, sliding: bool
) -> Case:
    """A dyad on the coupler's point K, a floating link KF with a point M; F on a rocker or on a level guide."""
    row = np.array([complex(coupler(mp.mpf(x))[0]) for x in np.linspace(0.0, 2 * np.pi, 73)])
    middle, size = complex(row.mean()), float(np.ptp(row.real) + np.ptp(row.imag))
    links, frame = scene["link"], scene["frame"]
    if sliding:
        height = float(middle.imag + size * rng.uniform(-0.5, 0.5))
        near = float(np.abs(row.imag - height).max()) * float(rng.uniform(1.5, 3.0))
        frame["y"] = {"through": [0, height], "angle": "0 deg"}
        slides = {"on": "frame", "along": "y", "side": "right"}
        last = {"number": 5, "points": {"F": [0, 0]}, "slides": slides}
    else:
        pivot = middle + size * complex(rng.uniform(0.7, 1.4), rng.uniform(-1.0, 1.0))
        apart = np.abs(row - pivot)
        near = float(apart.max()) * float(rng.uniform(0.6, 0.8))
        far = float(apart.max()) * float(rng.uniform(1.15, 1.3)) - near
        far = max(far, near - 0.6 * float(apart.min()), 0.5 * near)
        frame["E"] = [pivot.real, pivot.imag]
        last = {"number": 5, "points": {"E": [0, 0], "F": [far, 0]}}
    own = complex(near * rng.uniform(0.2, 0.9), near * rng.choice([-1, 1]) * rng.uniform(0.1, 0.7))
    fourth = {"number": 4, "points": {"K": [0, 0], "F": [near, 0], "M": [own.real, own.imag]}}
    if not sliding:
        fourth["side"] = "left of KE"
    links += [fourth, last]
    scene["curvature"] = {"points": ["M"], "positions": [1]}

    def floating(phi: Any) -> tuple[Any, Any]:
        start, sine = coupler(phi)
        end, other = on_line(start, near, height) if sliding else circles(start, pivot, near, far)
        return carried(start, end, own), sine * other

    return Case(scene, lambda phi: floating(phi)[0], lambda phi: floating(phi)[1])


def judged(k: int) -> tuple[float, float, float]:
    """How far ρ, its centre by the plans and by Bobillier are off, each of its own tolerance."""
    of = case(k)
    at = [float(x) for x in np.random.default_rng(k).uniform(0.0, 360.0, 6)]
    plans: list[Any] = ["positions", "curvature"]
    found = graphic_tmm.motion(graphic_tmm.read(of.scene), at, plans=plans, exact=True)
    (name,) = of.scene["curvature"]["points"]
    worst = [0.0, 0.0, 0.0]
    for n, degrees in enumerate(at):
        with mp.workdps(DIGITS):
            phi = mp.radians(mp.mpf(degrees))
            place, first, second = (mp.diff(of.path, phi, order) for order in range(3))
            bend = (mp.conj(first) * second).imag
            radius = abs(first) ** 3 / abs(bend)
            centre = place + first * mp.mpc(0, 1) * abs(first) ** 2 / bend
            share = abs(second) * abs(first) / abs(bend)
            sharp = 1 / of.sines(phi) ** 3
            tolerance = float(OPERATIONS * mp.mpf(2) ** -53 * share * sharp)
        rho, due = found.columns[f"rho_{name}"][n], float(radius)
        worst[0] = max(worst[0], abs(rho - due) / due / tolerance)
        size = due + abs(complex(place))
        for m, letter in enumerate((f"{name}_0", f"{name}_0′"), 1):
            off = abs(found.centres[letter][n] - complex(centre)) / size
            worst[m] = max(worst[m], off / tolerance)
    return worst[0], worst[1], worst[2]


@pytest.mark.parametrize("k", in_turn(range(40), 8))
def test_radii_are_those_of_paths_differentiated_with_many_digits(k: int) -> None:
    rho, by_plans, by_bobillier = judged(k)
    assert rho < 1.0
    assert by_plans < 1.0
    assert by_bobillier < 1.0
