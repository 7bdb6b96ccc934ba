"""The gear pair of the windrower to the last digit; contact ratio, sliding, checks, scales, a ruler."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import numpy as np
import pytest
from support.each import each
from support.teeth import Pair, dense, pair

from graphic_tmm.board.execute import execute
from graphic_tmm.board.findings import examine
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.values import arrays
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.chapters.gears.teeth import STATIONS

WINDROWER = GearTask(
    15, 25, 0.008, 0.83, 0.445, mu=0.0004217, stations=(23.5, 47.0, 94.0, 141.0, 164.5)
)
EPS = float(np.finfo(float).eps)


def results(order: GearTask) -> dict[str, float]:
    of = pair(order)
    return {name: value for name, (value, _) in of.results().items()}


EXACT = {
    "alpha_w": (26.9604, 4), "a_w": (168.6833, 4), "y": (1.08542, 5), "delta_y": (0.18958, 5),
    "r1": (60.0, 4), "r2": (100.0, 4), "r_b1": (56.3816, 4), "r_b2": (93.9693, 4),
    "r_w1": (63.2562, 4), "r_w2": (105.4271, 4), "r_f1": (56.64, 4), "r_f2": (93.56, 4),
    "r_a1": (73.1233, 4), "r_a2": (110.0433, 4), "s1": (17.3999, 4), "s2": (15.1578, 4),
    "h": (16.4833, 4), "contact_ratio": (1.1581, 4), "contact_ratio_drawn": (1.1581, 4),
}  # fmt: skip
TABLE = {"r_a1": (73.12, 3), "r_a2": (110.04, 3), "h": (16.48, 3), "contact_ratio": (1.1576, 4)}
PLAIN = ("alpha_w", "y", "delta_y", "contact_ratio", "contact_ratio_drawn")


@pytest.mark.parametrize(("delta_y", "due"), [(None, EXACT), (0.19, TABLE)])
def test_the_windrowers_gears_to_the_last_digit(
    delta_y: float | None, due: dict[str, tuple[float, int]]
) -> None:
    found = results(replace(WINDROWER, delta_y=delta_y))
    for name, (value, digits) in due.items():
        own = found[name] * (1.0 if name in PLAIN else 1000.0)
        assert round(own, digits) == value, name


def test_the_tips_of_the_windrowers_gears() -> None:
    found = results(WINDROWER)
    assert round(found["s_a1"] / 0.008, 4) == 0.4452
    assert round(found["s_a2"] / 0.008, 4) == 0.7867


def exact(order: GearTask) -> dict[str, float]:
    """The pair by formulas of its own, 40 digits."""
    with mpmath.workdps(40):
        mp = mpmath.mpf
        alpha, m = mpmath.radians(mp(order.alpha)), mp(order.m)
        z, x = (order.z1, order.z2), (mp(order.x1 or 0.0), mp(order.x2 or 0.0))

        def inv(a: mpmath.mpf) -> mpmath.mpf:
            return mpmath.tan(a) - a

        due = inv(alpha) + 2 * (x[0] + x[1]) / (z[0] + z[1]) * mpmath.tan(alpha)
        alpha_w = mpmath.findroot(
            lambda a: inv(a) - due, (mp("0.05"), mp("1.2")), solver="anderson"
        )
        a_w = m * sum(z) / 2 * mpmath.cos(alpha) / mpmath.cos(alpha_w)
        dy = x[0] + x[1] - (a_w / m - mp(sum(z)) / 2)
        r_b = [m * n / 2 * mpmath.cos(alpha) for n in z]
        r_a = [m * (mp(n) / 2 + order.ha + s - dy) for n, s in zip(z, x, strict=True)]
        reach = [mpmath.sqrt(a**2 - b**2) for a, b in zip(r_a, r_b, strict=True)]
        ab = sum(reach) - a_w * mpmath.sin(alpha_w)
        ratio = ab / (mpmath.pi * m * mpmath.cos(alpha))
        found = {
            "alpha_w": mpmath.degrees(alpha_w),
            "a_w": a_w,
            "delta_y": dy,
            "contact_ratio": ratio,
        }
        return {name: float(value) for name, value in found.items()}


@each("seed", range(12))
def test_any_pair_by_formulas_of_its_own_and_the_drawn_contact_ratio(seed: int) -> None:
    rng = np.random.default_rng(seed)
    z1, z2 = (int(z) for z in rng.integers(20, 200, 2))
    x1, x2 = (float(x) for x in rng.uniform(-0.1, 0.8, 2))
    order = GearTask(
        z1, z2, float(rng.uniform(1e-3, 2e-2)), x1, x2, alpha=float(rng.choice([20, 25]))
    )
    of, due = pair(order), exact(order)
    found = of.results()
    for name, value in due.items():
        # inv α_w loses the digits that tan² α_w takes; Δy those of a difference of numbers like z
        assert found[name][0] == pytest.approx(value, rel=1e-13, abs=200 * EPS * (z1 + z2)), name
    # two cuts of the tip circles with the line of action, well conditioned
    assert found["contact_ratio_drawn"][0] == pytest.approx(due["contact_ratio"], rel=1e-10)
    assert abs(found["contact_ratio_difference"][0]) < 1e-8
    arc = due["contact_ratio"] * np.pi * order.m * np.cos(np.radians(order.alpha))
    arc /= np.cos(np.radians(due["alpha_w"]))
    for k in (1, 2):  # by the flank turned to a and to b: a spline through its points
        assert found[f"arc_of_engagement{k}"][0] == pytest.approx(arc, abs=1e-4 * order.m)


def test_with_a_ruler_the_drawn_contact_ratio_is_right_to_half_a_percent() -> None:
    of = pair(WINDROWER, hand=Hand(0.5))
    found = of.results()
    # 64.86 mm reads 65.0, 56.00 mm reads 56.0
    assert found["contact_ratio_drawn"][0] == 65.0 / 56.0
    assert abs(found["contact_ratio_difference"][0]) < 0.5


def test_the_line_of_action_lies_as_calculated() -> None:
    of = pair(WINDROWER)
    line = of.gear.line
    assert of.real(line.angle) == pytest.approx(of.real(of.gear.sizes.alpha_w), abs=1e-12)
    assert round(of.real(line.length), 2) == 181.35
    assert round(of.real(line.to_pole), 2) == 68.01
    limits, pole = [of.one(mark) for mark in line.limits], of.one(line.pole)
    for k, limit in enumerate(limits):
        circles = line.circles[k]
        radius = limit - of.one(circles.centre)
        assert abs(radius) * of.mm == pytest.approx(
            1000 * of.real(of.gear.sizes.wheels[k].r_b), rel=1e-13
        )
        assert abs((radius.conjugate() * (pole - limit)).real) < 1e-9  # the line touches
    tips = [
        abs(of.one(end) - of.one(line.circles[1 - k].centre)) for k, end in enumerate(line.ends)
    ]
    due = [1000 * of.real(of.gear.sizes.wheels[1 - k].r_a) / of.mm for k in range(2)]
    np.testing.assert_allclose(tips, due, rtol=1e-13)


def test_a_pair_of_teeth_leaves_as_another_enters() -> None:
    of = pair(WINDROWER)
    a, b = (of.one(mark) for mark in of.gear.line.ends)
    first, second = (of.one(mark) for mark in of.gear.contact.pair)
    pitch = 1000 * of.real(of.gear.sizes.p_b) / of.mm
    assert abs(second - a) == pytest.approx(pitch)
    assert abs(b - first) == pytest.approx(pitch)
    assert abs(first - a) == pytest.approx(abs(b - a) - pitch)


@pytest.mark.parametrize("k", [0, 1])
def test_flanks_turned_to_the_ends_touch_there(k: int) -> None:
    of = pair(WINDROWER)
    engaged, line = of.gear.contact.wheels[k], of.gear.line
    for mark, end in zip((engaged.entering, engaged.leaving), line.ends, strict=True):
        knots = of.reading[mark].knots[0]
        assert np.abs(knots - of.one(end)).min() < 40.0
        spots = of.reading[mark]
        assert np.abs(dense(spots) - of.one(end)).min() < 0.2  # chords of the sampled curve
    low, centre = of.one(engaged.lowest), of.one(of.gear.wheels[k].circles.centre)
    assert abs(low - centre) == pytest.approx(abs(of.one(line.ends[k]) - centre), rel=1e-13)


SLIDING = (
    (-3.030, -0.715, 0.442, 0.828, 0.939),
    (0.752, 0.417, -0.793, -4.82, -15.27),
)


def test_the_windrowers_specific_sliding() -> None:
    of = pair(WINDROWER)
    further = of.gear.sliding.further
    assert further is not None
    for due, mark in zip(SLIDING, further.sliding, strict=True):
        found = of.row(mark, 5)
        digits = [2 if abs(v) > 4 else 3 for v in due]
        assert tuple(round(float(v), d) for v, d in zip(found, digits, strict=True)) == due


def test_sliding_is_the_ratio_of_speeds_along_the_flanks() -> None:
    of = pair(WINDROWER)
    sliding, length = of.gear.sliding, of.real(of.gear.line.length)
    for k, branch in enumerate(sliding.branches):
        x = of.row(branch.x, STATIONS)
        # a contact x from N1 runs along flank 1 with ω1·x and along flank 2 with ω2·(N1N2 − x)
        speeds = 25.0 * x, 15.0 * (length - x)
        own, other = speeds[k], speeds[1 - k]
        found = of.row(branch.sliding, STATIONS)
        np.testing.assert_allclose(found, (own - other) / own, atol=1e-13)
        assert found[0] == pytest.approx(-sliding.floor)
        assert found[-1] == 1.0
        near = of.row(branch.near, STATIONS)
        np.testing.assert_allclose(near[1:] / near[:-1], near[1] / near[0])
        assert near[-1] == length
    assert [of.real(m) for m in sliding.pole.sliding] == pytest.approx([0.0, 0.0], abs=1e-14)


def test_the_curves_of_sliding_stand_over_their_stations() -> None:
    of = pair(WINDROWER)
    sliding, mu = of.gear.sliding, of.real(of.gear.sliding.chart.mu)
    length = of.real(of.gear.line.length)
    for k, branch in enumerate(sliding.branches):
        spots = dense(of.reading[branch.curve])
        near = spots.real if k == 0 else length - spots.real
        due = 1 - (0.6, 1 / 0.6)[k] * (length - near) / near
        # a tenth of a millimetre: both coordinates are exponentials, 12 arcs, and a cubic spline follows them
        assert np.abs(spots.imag * mu - due).max() < 0.1 * mu
    ends = [[of.real(m) for m in end.sliding] for end in sliding.ends.values()]
    np.testing.assert_allclose(ends, [[-0.788, 0.441], [0.615, -1.594]], atol=5e-4)


FAULTS = {
    "undercut": GearTask(12, 40, 0.008),
    "pointed tooth": GearTask(8, 40, 0.008, 0.9, -0.2),
    "tip thickness": GearTask(10, 40, 0.008, 0.75, 0.0),
    "interference": GearTask(17, 200, 0.008, 0.05, 0.0, ha=1.0, delta_y=-0.2),
    "clearance": GearTask(20, 30, 0.008, 1.0, 1.0, delta_y=0.0),
    "contact ratio": GearTask(10, 12, 0.008, 1.0, 1.2),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_has_its_name(name: str) -> None:
    of = pair(FAULTS[name])
    assert name in {fault for fault, _ in of.failed()}
    told = next(v for v in of.verdicts() if v.name == name and not v.holds)
    assert told.value < told.least


def test_a_good_pair_passes_every_check() -> None:
    assert not pair(WINDROWER).failed()


@pytest.mark.parametrize("z", [6, 9, 13, 16])
def test_a_shift_at_its_limit_is_not_undercut_and_less_is(z: int) -> None:
    least = float(1 - mpmath.mpf(z) / 2 * mpmath.sin(mpmath.radians(20)) ** 2)
    at, below = (pair(GearTask(z, 40, 0.008, least - d)) for d in (0.0, 1e-6))
    assert ("undercut", 1) not in at.failed()
    assert ("undercut", 1) in below.failed()
    for of in (at, below):
        start = of.one(of.gear.wheels[0].teeth[1].right.start)
        base = 1000 * of.real(of.gear.sizes.wheels[0].r_b) / of.mm
        assert abs(start) == pytest.approx(base, abs=1e-6)


@pytest.mark.slow
def test_nothing_is_left_undrawn() -> None:
    of = pair(WINDROWER)
    assert not examine(of.log, of.given, [step.it for step in of.log.steps])


def test_scales_are_the_orders_or_standard_ones() -> None:
    def mus(of: Pair) -> tuple[float, float]:
        return of.real(of.gear.line.mu), of.real(of.gear.sliding.chart.mu)

    free = replace(WINDROWER, mu=None, stations=())
    assert mus(pair(free)) == (0.0004, 0.05)  # 2.5 : 1, four down to 80 mm
    assert mus(pair(replace(WINDROWER, mu_sliding=0.1))) == (0.0004217, 0.1)
    assert mus(pair(replace(free, m=0.002)))[0] == 0.0001  # 10 : 1
    assert mus(pair(replace(free, m=0.02)))[0] == 0.001  # 1 : 1


def test_a_scale_changes_the_drawing_only() -> None:
    one, other = (pair(replace(WINDROWER, mu=mu, stations=())) for mu in (0.0004, 0.001))
    for mark, same in zip(
        (one.gear.contact.drawn, one.gear.contact.wheels[0].real),
        (other.gear.contact.drawn, other.gear.contact.wheels[0].real),
        strict=True,
    ):
        assert one.real(mark) == pytest.approx(other.real(same), rel=1e-11)


def test_trials_run_together_as_alone() -> None:
    one = pair(replace(WINDROWER, stations=()))
    gear, given, log = one.gear, one.given, one.log
    scales = np.array([[0.0004], [0.0005]])
    both = execute(log, {**given, gear.line.mu: scales})
    for trial, mu in enumerate(scales):
        alone = execute(log, {**given, gear.line.mu: mu[0]})
        for step in log.steps:
            for own, due in zip(arrays(both[step.it]), arrays(alone[step.it]), strict=True):
                np.testing.assert_array_equal(own[min(trial, own.shape[0] - 1)], due[0])
