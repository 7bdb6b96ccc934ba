"""Lengths found from tasks, kind by kind: vector loops give the tasks back, a grid tells where none are."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from support.examples import most

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.synthesis import KINDS, lengths_found
from graphic_tmm.mechanism.synthesis_functions import pairs_of_function

CASES = most(40)
"""Random tasks of each kind."""
EXACT = 1e-9


def zero(of: Callable[[float], float], low: float, high: float) -> float:
    """Where a function changes its sign, by halving down to the last bit."""
    rises = of(high) > 0.0
    for _ in range(200):
        middle = (low + high) / 2.0
        if middle in (low, high):
            break
        low, high = (low, middle) if (of(middle) > 0.0) == rises else (middle, high)
    return (low + high) / 2.0


def turning(rate: Callable[[float], float], count: int = 720) -> list[float]:
    """The angles of the crank at which what it drives stands still."""
    row = np.linspace(0.0, math.tau, count + 1) + 0.123
    rates = [rate(at) for at in row]
    return [
        zero(rate, a, b)
        for a, b, p, q in zip(row, row[1:], rates, rates[1:], strict=False)
        if (p > 0.0) != (q > 0.0)
    ]


def ratio(ends: list[float]) -> float:
    """K_v by the angles between both ends of the stroke."""
    assert len(ends) == 2
    way = (ends[1] - ends[0]) % math.tau
    return max(way, math.tau - way) / min(way, math.tau - way)


def slider(r: float, l: float, e: float) -> tuple[float, float]:  # noqa: E741
    """The stroke and K_v of a slider-crank, by its loop."""

    def at(phi: float) -> float:
        return r * math.cos(phi) + math.sqrt(l**2 - (r * math.sin(phi) + e) ** 2)

    def rate(phi: float) -> float:
        high = r * math.sin(phi) + e
        return -r * math.sin(phi) - high * r * math.cos(phi) / math.sqrt(l**2 - high**2)

    ends = turning(rate)
    return abs(at(ends[0]) - at(ends[1])), ratio(ends)


def rocker_pin(a: float, b: float, c: float, d: float, phi: float, side: float) -> complex:
    """Where B of a four-bar stands, O at 0, C at d."""
    pin = cmath.rect(a, phi)
    way = d - pin
    far = abs(way)
    along = (b * b - c * c + far * far) / (2.0 * far)
    return pin + way / far * complex(along, side * math.sqrt(max(b * b - along * along, 0.0)))


def four_bar(a: float, b: float, c: float, d: float) -> tuple[float, float, float]:
    """Swing (degrees), K_v and least angle of transmission of a crank-rocker, by its loop."""

    def swing(phi: float) -> float:
        return cmath.phase(rocker_pin(a, b, c, d, phi, 1.0) - d)

    def rate(phi: float) -> float:
        # B moves square to BC; its velocity along the coupler is that of A
        pin, end = cmath.rect(a, phi), rocker_pin(a, b, c, d, phi, 1.0)
        rod, rocker = end - pin, end - d
        return ((1j * pin) * rod.conjugate()).real / ((1j * rocker) * rod.conjugate()).real

    ends = turning(rate)
    angle = cmath.phase(cmath.exp(1j * (swing(ends[0]) - swing(ends[1]))))
    least = 180.0
    for phi in np.linspace(0.0, math.tau, 721):
        end = rocker_pin(a, b, c, d, float(phi), 1.0)
        pin = cmath.rect(a, float(phi))
        between = abs(math.degrees(cmath.phase((pin - end) / (d - end))))
        least = min(least, between, 180.0 - between)
    return abs(math.degrees(angle)), ratio(ends), least


def found(kind: str, **given: Any) -> dict[str, float] | None:
    try:
        return lengths_found(kind, given)
    except StructureError:
        return None


def test_the_published_slider_crank() -> None:
    lengths = lengths_found("slider-crank", {"stroke": 0.1, "K_v": 1.2, "e": 0.03})
    assert {name: round(1000.0 * one, 3) for name, one in lengths.items()} == {
        "OA": 47.795,
        "AB": 113.722,
        "e": 30.0,
    }


def test_a_slider_crank_gives_stroke_and_ratio_back() -> None:
    rng, done = np.random.default_rng(1), 0
    while done < CASES:
        stroke, K_v = rng.uniform(0.02, 0.5), rng.uniform(1.02, 2.5)
        lengths = found("slider-crank", stroke=stroke, K_v=K_v, e=stroke * rng.uniform(0.02, 1.5))
        if lengths is None:
            continue
        done += 1
        again = slider(lengths["OA"], lengths["AB"], lengths["e"])
        assert again == pytest.approx((stroke, K_v), rel=EXACT)


def by_grid(stroke: float, e: float) -> np.ndarray:
    """K_v of slider-cranks with this stroke and offset, from the shortest rods that turn to long ones."""
    ratios = []
    for over in np.geomspace(1e-5, 100.0, 400):
        # of a rod l = r + e·(1 + over) that just turns: r by the stroke
        def rest(r: float, over: float = float(over)) -> float:
            rod = r + e * (1.0 + over)
            return math.sqrt((rod + r) ** 2 - e**2) - math.sqrt((rod - r) ** 2 - e**2) - stroke

        r = zero(rest, 1e-9 * stroke, stroke)
        rod = r + e * (1.0 + float(over))
        seen = math.asin(e / (rod - r)) - math.asin(e / (rod + r))
        ratios.append((math.pi + seen) / (math.pi - seen))
    return np.array(ratios)


def test_no_slider_crank_is_refused_that_a_grid_finds_and_none_made_that_it_does_not() -> None:
    rng, refused, made = np.random.default_rng(2), 0, 0
    for _ in range(CASES):
        stroke, K_v, e = (
            0.1,
            float(rng.uniform(1.02, 3.2)),
            float(0.1 * 10 ** rng.uniform(-1.5, 0.5)),
        )
        ratios = by_grid(stroke, e)
        there = bool(ratios.min() < K_v < ratios.max())
        if abs(K_v / ratios.max() - 1.0) < 0.02 or K_v < ratios.min():
            continue  # where the grid itself is too coarse to tell
        lengths = found("slider-crank", stroke=stroke, K_v=K_v, e=e)
        assert (lengths is not None) == there
        refused, made = refused + (lengths is None), made + there
    assert min(refused, made) >= max(1, CASES // 10)


def test_the_limits_of_a_slider_crank_are_those_that_do() -> None:
    with pytest.raises(StructureError, match=r"e is less than S/tan θ = 340\.6 mm") as error:
        lengths_found("slider-crank", {"stroke": 0.1, "K_v": 1.2, "e": 0.5})
    assert "K_v is less than 1.1341" in str(error.value)
    assert error.value.keys == ("task.e",)
    assert found("slider-crank", stroke=0.1, K_v=1.2, e=0.3405)
    assert found("slider-crank", stroke=0.1, K_v=1.134, e=0.5)
    assert not found("slider-crank", stroke=0.1, K_v=1.1342, e=0.5)
    assert not found("slider-crank", stroke=0.1, K_v=3.0, e=1e-6)


def test_a_slider_crank_by_speed_and_ratio() -> None:
    rng, done = np.random.default_rng(3), 0
    while done < CASES:
        v_m, n, times = rng.uniform(0.5, 12), rng.uniform(5, 600), rng.uniform(1.05, 8)
        due = math.pi * v_m / n
        e = due * rng.uniform(0.0, 1.2)
        lengths = found("slider-crank", v_m=v_m, n=n, **{"lambda": times}, e=e)
        if lengths is None:
            assert e > due * (times**2 - 1.0) / (4.0 * times)
            continue
        done += 1
        assert lengths["AB"] == pytest.approx(times * lengths["OA"], rel=1e-12)
        stroke, _ = slider(lengths["OA"], lengths["AB"], e)
        assert stroke == pytest.approx(due, rel=EXACT)
        # the slider goes twice over its stroke in a turn
        assert 2.0 * stroke * n / math.tau == pytest.approx(v_m, rel=EXACT)


def test_a_slider_crank_by_its_pressure_angle() -> None:
    lengths = lengths_found("slider-crank", {"stroke": 0.1, "pressure": 20.0})
    steepest = max(
        math.degrees(math.asin(lengths["OA"] * math.sin(phi) / lengths["AB"]))
        for phi in np.linspace(0.0, math.pi, 1001)
    )
    assert steepest == pytest.approx(20.0, rel=1e-12)
    assert slider(lengths["OA"], lengths["AB"], 0.0)[0] == pytest.approx(0.1, rel=EXACT)


def test_a_slider_crank_with_an_offset_by_its_pressure_angle() -> None:
    rng = np.random.default_rng(13)
    for _ in range(CASES):
        due, aslant = float(rng.uniform(0.02, 0.5)), float(rng.uniform(3, 85))
        e = due * float(10 ** rng.uniform(-2, 0.7))
        lengths = lengths_found("slider-crank", {"stroke": due, "pressure": aslant, "e": e})
        r, rod = lengths["OA"], lengths["AB"]
        row = np.linspace(0.0, math.tau, 1441)  # the crank square to the guide is one of these
        steepest = np.max(np.abs(np.arcsin((r * np.sin(row) + e) / rod)))
        assert math.degrees(steepest) == pytest.approx(aslant, rel=1e-12)
        assert slider(r, rod, e)[0] == pytest.approx(due, rel=1e-7)
    without = lengths_found("slider-crank", {"stroke": 0.1, "pressure": 20.0})
    little = lengths_found("slider-crank", {"stroke": 0.1, "pressure": 20.0, "e": 1e-9})
    assert little["OA"] == pytest.approx(without["OA"], rel=1e-6)


def four(lengths: dict[str, float]) -> tuple[float, float, float, float]:
    return lengths["OA"], lengths["AB"], lengths["BC"], lengths["OC"]


def test_a_crank_rocker_gives_swing_and_ratio_back() -> None:
    rng, done = np.random.default_rng(4), 0
    while done < CASES:
        psi, K_v = rng.uniform(15, 110), rng.uniform(1.03, 1.8)
        lengths = found("crank-rocker", psi=psi, K_v=K_v, BC=0.1, OC=0.1 * rng.uniform(0.3, 3))
        if lengths is None:
            continue
        done += 1
        swing, again, _ = four_bar(*four(lengths))
        assert (swing, again) == pytest.approx((psi, K_v), rel=EXACT)


def test_a_crank_rocker_by_its_transmission() -> None:
    rng, done = np.random.default_rng(5), 0
    while done < max(2, CASES // 8):
        psi, K_v, wanted = rng.uniform(20, 70), rng.uniform(1.05, 1.4), rng.uniform(15, 45)
        lengths = found("crank-rocker", psi=psi, K_v=K_v, BC=0.1, transmission=wanted)
        if lengths is None:
            continue
        done += 1
        assert four_bar(*four(lengths)) == pytest.approx((psi, K_v, wanted), rel=EXACT)


def test_a_crank_rocker_whose_locus_is_about_its_pivot() -> None:
    """With θ = ψ/2 all places of O are as far from C as B: the transmission chooses one, OC cannot."""
    rng = np.random.default_rng(15)
    for _ in range(max(2, CASES // 8)):
        psi, wanted = float(rng.uniform(20, 70)), float(rng.uniform(5, 25))
        task = {"psi": psi, "K_v": (360 + psi) / (360 - psi), "BC": 0.1}
        lengths = lengths_found("crank-rocker", {**task, "transmission": wanted})
        assert four_bar(*four(lengths)) == pytest.approx((psi, task["K_v"], wanted), rel=EXACT)
        assert lengths["OC"] == pytest.approx(0.1, rel=1e-12)
        for frame in (0.1, 0.1 * (1 + 1e-12)):
            with pytest.raises(StructureError, match="anywhere on a circle about C") as error:
                lengths_found("crank-rocker", {**task, "OC": frame})
            assert error.value.keys == ("task.OC",)
    # near it, each frame is of one place again
    near = lengths_found("crank-rocker", {"psi": 60, "K_v": 1.4001, "BC": 0.1, "transmission": 30})
    assert four_bar(*four(near)) == pytest.approx((60.0, 1.4001, 30.0), rel=EXACT)


def crank_rockers(psi: float, K_v: float, d: float) -> Iterator[tuple[float, float]]:
    """Yield crank and K_v by a grid: rocker 1, swing ψ; dead centres by the cosine rule."""

    def states(a: float, b: float) -> tuple[float, float] | None:
        low, high = b - a, b + a
        short, *_, long_ = sorted((a, b, 1.0, d))
        if not (short == a and short + long_ < (a + b + 1.0 + d) / 2.0):
            return None
        at_rocker = [math.acos((1 + d * d - x * x) / (2 * d)) for x in (low, high)]
        at_frame = [math.acos((x * x + d * d - 1) / (2 * d * x)) for x in (low, high)]
        theta = math.degrees(at_frame[1] - at_frame[0])
        return math.degrees(at_rocker[1] - at_rocker[0]), (180 + abs(theta)) / (180 - abs(theta))

    row = np.linspace(0.01, d + 1.0, 600)
    for a in np.linspace(0.005, 0.995, 200) * min(1.0, d):
        swings = [states(float(a), float(b)) for b in row]
        for one, other in pairwise(swings):
            if one and other and (one[0] < psi) != (other[0] < psi):
                share = (psi - one[0]) / (other[0] - one[0])
                yield float(a), one[1] + share * (other[1] - one[1])


@pytest.mark.slow
def test_no_crank_rocker_is_refused_that_a_grid_finds_and_none_made_that_it_does_not() -> None:
    rng, refused, made = np.random.default_rng(6), 0, 0
    for _ in range(24):
        psi, K_v = float(rng.uniform(20, 110)), float(rng.uniform(1.05, 1.8))
        d = float(rng.uniform(0.3, 2.5))
        every = [one for _, one in crank_rockers(psi, K_v, d)]
        around = [
            found("crank-rocker", psi=psi, K_v=K_v, BC=1.0, OC=d * k) for k in (0.97, 1.0, 1.03)
        ]
        if len({one is None for one in around}) > 1:
            continue  # too near to a limit for the grid
        there = bool(every) and min(every) < K_v < max(every)
        assert (around[1] is not None) == there, (psi, K_v, d)
        refused, made = refused + (not there), made + there
    assert min(refused, made) >= 4


def test_the_limits_of_a_crank_rocker_are_those_that_do() -> None:
    task = {"psi": 40.0, "K_v": 1.2, "BC": 0.1}
    with pytest.raises(StructureError, match="one has") as error:
        lengths_found("crank-rocker", {**task, "OC": 1.2})
    assert error.value.keys == ("task.OC",)
    low, high = (float(x) for x in str(error.value).split("OC = ")[1].split(" mm")[0].split("…"))
    for frame, there in (
        (low * 1.001, True),
        (high * 0.999, True),
        (low * 0.99, False),
        (high * 1.01, False),
    ):
        assert (found("crank-rocker", **task, OC=frame / 1000.0) is not None) == there
    with pytest.raises(StructureError, match=r"while K_v is less than 4\.\d+"):
        lengths_found("crank-rocker", {**task, "K_v": 4.5, "OC": 0.12})
    with pytest.raises(StructureError, match=r"at best") as error:
        lengths_found("crank-rocker", {**task, "transmission": 80.0})
    best = float(str(error.value).split("transmission is ")[1].split("°")[0])
    assert found("crank-rocker", **task, transmission=best - 0.01)
    assert not found("crank-rocker", **task, transmission=best + 0.05)


def test_a_coupler_goes_through_its_three_places() -> None:
    rng = np.random.default_rng(7)
    for _ in range(CASES):
        A = [complex(*rng.uniform(-0.1, 0.1, 2)) for _ in range(3)]
        angles, rod = rng.uniform(-180, 180, 3).tolist(), float(rng.uniform(0.02, 0.2))
        lengths = lengths_found("coupler", {"A": A, "angles": angles, "AB": rod})
        origin, pivot = (complex(lengths[f"x{k}"], lengths[f"y{k}"]) for k in "OC")
        size = max(*map(abs, A), abs(origin), abs(pivot))
        for a, angle in zip(A, angles, strict=True):
            b = a + cmath.rect(rod, math.radians(angle))
            assert abs(a - origin) == pytest.approx(lengths["OA"], abs=EXACT * size)
            assert abs(b - pivot) == pytest.approx(lengths["BC"], abs=EXACT * size)


@pytest.mark.parametrize("kind", ["angles", "function"])
def test_crank_and_rocker_stand_at_their_pairs_of_angles(kind: str) -> None:
    rng = np.random.default_rng(8)
    for _ in range(CASES):
        given: dict[str, Any] = {"OA": float(rng.uniform(0.02, 0.2)), "OC": 0.1}
        if kind == "angles":
            given["crank"] = rng.uniform(0, 360, 3).tolist()
            given["rocker"] = rng.uniform(0, 180, 3).tolist()
            pairs = given["crank"], given["rocker"]
        else:
            given |= {"x": [1.0, float(rng.uniform(1.5, 4))], "power": float(rng.uniform(-2, 3))}
            given |= {"crank": [10.0, 100.0], "rocker": [30.0, float(rng.uniform(60, 140))]}
            pairs = pairs_of_function(given)
        lengths = lengths_found(kind, given)
        a, b, c, d = four(lengths)
        size = max(b, c, d)
        # of both ways to close each position one keeps the rocker's angle from its pointer
        kept = []
        for phi, psi in zip(*pairs, strict=True):
            ends = [rocker_pin(a, b, c, d, math.radians(phi), side) for side in (1.0, -1.0)]
            kept.append([(end - d) * cmath.rect(1.0, -math.radians(psi)) for end in ends])
        off = min(max(min(abs(p - q) for q in row) for row in kept) for p in kept[0])
        assert off < EXACT * size * max(1.0, size / 0.1)


EMPTY = {"crank": [0.0, 9.0], "rocker": [0.0, 9.0], "OA": 1.0, "OC": 2.0}


@pytest.mark.parametrize(
    ("kind", "given", "key"),
    [
        ("coupler", {"A": [0j, 1j], "angles": [0.0, 1.0, 2.0], "AB": 1.0}, "task.A"),
        ("angles", {"crank": [0.0], "rocker": [0.0, 1.0, 2.0], "OA": 1.0, "OC": 1.0}, "task.crank"),
        ("function", {**EMPTY, "x": [2.0, 2.0], "power": 1.0}, "task.x"),
        ("function", {**EMPTY, "x": [1.0, 2.0], "power": 0.0}, "task.power"),
        ("function", {**EMPTY, "crank": [5.0, 5.0], "x": [1.0, 2.0], "power": 1.0}, "task.crank"),
        ("function", {**EMPTY, "rocker": [5.0, 5.0], "x": [1.0, 2.0], "power": 1.0}, "task.rocker"),
    ],
)  # fmt: skip
def test_what_is_no_task_is_refused(kind: str, given: dict[str, Any], key: str) -> None:
    with pytest.raises(StructureError) as error:
        lengths_found(kind, given)
    assert error.value.keys == (key,)


def test_every_kind_finds_what_it_says() -> None:
    tasks: dict[str, dict[str, Any]] = {
        "rocker": {"K_v": 1.45, "stroke": 0.095, "OB": 0.48},
        "slider-crank": {"stroke": 0.1, "K_v": 1.2, "e": 0.03},
        "crank-rocker": {"psi": 40.0, "K_v": 1.2, "BC": 0.1, "OC": 0.12},
        "coupler": {"A": [0j, 0.03 + 0.02j, 0.05 + 0.06j], "angles": [10.0, 30.0, 70.0], "AB": 0.08},
        "angles": {"crank": [30.0, 60.0, 90.0], "rocker": [40.0, 60.0, 75.0], "OA": 0.04, "OC": 0.1},
        "function": {**EMPTY, "x": [1.0, 2.0], "power": 1.5},
        "cylinder": {"stroke": 0.1, "psi": 40.0},
        "dwell": {
            "OA": 0.04, "AB": 0.11, "BC": 0.11, "OC": 0.13, "M": 0.095 + 0.075j,
            "dwell": [120.0, 200.0], "tolerance": 3e-4, "E": 0.16 + 0.15j,
        },
    }  # fmt: skip
    assert tasks.keys() == KINDS.keys()
    for kind, given in tasks.items():
        assert frozenset(given) in KINDS[kind].ways
        assert tuple(lengths_found(kind, given)) == KINDS[kind].finds
