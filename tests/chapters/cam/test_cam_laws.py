"""Laws of motion on the board against closed forms: ordinates, derivatives, scales, division of the turn."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.cams import C6, SHAPES, Made, made, motion
from support.each import each

from graphic_tmm.board.findings import examine
from graphic_tmm.chapters.cam.phases import divide
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Law,
    RockerFollower,
    RollerFollower,
)
from graphic_tmm.errors import StructureError

TRAPEZOID = Law("diagram", ((0, 0), (1 / 8, 1), (3 / 8, 1), (5 / 8, -1), (7 / 8, -1), (1, 0)))
TRIANGLES = Law("diagram", ((0, 0), (0.25, 3.0), (0.75, -3.0), (1, 0)))
JUMPS = Law("diagram", ((0, 2), (1 / 3, 2), (1 / 3, -1), (1, -1)))
SLANTED = Law("diagram", ((0, 1), (1, -1)))
DUST = 1e-9
"""What is less is no acceleration, m/rad²."""
DIAGRAMS = {"trapezoid": TRAPEZOID, "triangles": TRIANGLES, "jumps": JUMPS, "slanted": SLANTED}


@cache
def drawn(rise: Law, fall: Law, divisions: int = 12, turns: str = "counterclockwise") -> Made:
    return made(CamTask(**C6, rise_law=rise, return_law=fall, divisions=divisions, turns=turns))


def by_stretch(of: Made, which: str) -> list[tuple[np.ndarray, np.ndarray]]:
    """The cam's angles and the quantity (SI) read there, for every stretch."""
    diagrams = of.cam.diagrams
    diagram = {"S": diagrams.S, "V": diagrams.V, "A": diagrams.A}[which]
    angles = np.array(diagrams.turn.angles)
    rows = zip(diagram.readings, diagrams.stretches, strict=True)
    return [
        (angles[a : b + 1], of.reading[mark][0, a : b + 1] * of.one(diagram.axes.mu))
        for mark, (_, a, b) in rows
    ]


def due(of: Made, which: str, angles: np.ndarray) -> np.ndarray:
    """The closed form inside a stretch: at its ends from the inside."""
    inside = angles.copy()
    inside[0] += 1e-9
    inside[-1] -= 1e-9
    return motion(of.cam.order, inside)["SVA".index(which)]


LAWS = [Law(name) for name in SHAPES]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@each("which", ["S", "V", "A"])
@each("divisions", [8, 12, 30])
def test_the_ordinates_are_those_of_the_law(law: Law, which: str, divisions: int) -> None:
    found = drawn(law, law, divisions)
    for angles, values in by_stretch(found, which):
        right = due(found, which, angles)
        np.testing.assert_allclose(values, right, atol=1e-9 * np.abs(right).max())


@pytest.mark.parametrize("which", ["S", "V", "A"])
@pytest.mark.parametrize("shares", [(2.0, 1.0), (1.0, 3.0), (3.0, 2.0)])
def test_shares_of_speeding_up_may_be_unequal(which: str, shares: tuple[float, float]) -> None:
    """In the order of time, on the return too; a position stands where the one goes over into the other."""
    law = Law("constant acceleration", shares=shares)
    found = drawn(law, law)
    for angles, values in by_stretch(found, which):
        right = due(found, which, angles)
        np.testing.assert_allclose(values, right, atol=1e-9 * np.abs(right).max())
    phases = found.cam.diagrams.turn.phases
    at = [
        (found.cam.diagrams.turn.angles[phase.breaks[0]] - phase.start) / phase.extent
        for phase in phases
    ]
    assert at == pytest.approx([shares[0] / sum(shares)] * 2)


def test_shares_that_no_position_divides_and_shares_of_another_law_are_refused() -> None:
    odd = Law("constant acceleration", shares=(np.pi, 1.0))
    with pytest.raises(StructureError, match="simple shares") as found:
        divide(CamTask(**C6, rise_law=odd))
    assert "cam.shares" in str(found.value) or "cam.shares" in found.value.keys
    with pytest.raises(StructureError, match="only the law of constant acceleration has shares"):
        divide(CamTask(**C6, return_law=Law("sine", shares=(2.0, 1.0))))


@pytest.mark.parametrize("which", ["S", "V", "A"])
def test_rise_and_return_may_follow_different_laws(which: str) -> None:
    found = drawn(Law("cosine"), JUMPS)
    for angles, values in by_stretch(found, which):
        right = due(found, which, angles)
        np.testing.assert_allclose(values, right, atol=1e-9 * np.abs(right).max())


@each("name", DIAGRAMS)
@each("which", ["S", "V", "A"])
@each("divisions", [8, 16])
def test_straight_accelerations_are_integrated_exactly(
    name: str, which: str, divisions: int
) -> None:
    """With positions at the corners and between them a parabola of speeds is drawn exactly."""
    law = DIAGRAMS[name]
    found = drawn(law, law, divisions)
    assert all(b - a >= 2 for _, a, b in found.cam.diagrams.stretches)
    for angles, values in by_stretch(found, which):
        right = due(found, which, angles)
        np.testing.assert_allclose(values, right, atol=1e-9 * np.abs(right).max())


def test_corners_between_positions_are_met_by_the_ordinates_in_the_middle_of_the_intervals() -> (
    None
):
    """A corner inside an interval: the area there is off by at most a triangle, jump of slope · Δ²/8."""
    odd = Law("diagram", ((0, 0), (0.23, 1), (0.77, -1), (1, 0)))
    found = drawn(odd, odd, 12)
    h, n = found.cam.order.stroke, 12
    lift = (0.23 + 0.27) * 0.5 - 0.23**2 / 6  # more than what such a diagram rises by
    slope = 1 / 0.23 + 1 / 0.27
    bound = 2 * slope / (8 * n**2) * h / lift
    for angles, values in by_stretch(found, "S"):
        assert np.abs(values - due(found, "S", angles)).max() < bound
    ends = by_stretch(found, "S")
    assert ends[0][1][-1] == pytest.approx(h, rel=1e-12)
    assert ends[-1][1][-1] == pytest.approx(0.0, abs=1e-12 * h)


@pytest.mark.slow
@pytest.mark.parametrize("name", [*SHAPES, *DIAGRAMS])
def test_each_diagram_is_the_derivative_of_the_one_before(name: str) -> None:
    """The smooth curves, differentiated where they are drawn, give the next diagram at the positions.

    Without end conditions a spline's slope is off by Δ⁴·|f⁗| at most; 30 divisions, |f⁗| ≤ (2π)⁴ of the range.
    """
    law = DIAGRAMS.get(name, Law(name))
    found = drawn(law, law, 30)
    diagrams = found.cam.diagrams
    for source, to in ((diagrams.S, diagrams.V), (diagrams.V, diagrams.A)):
        slope = found.one(source.axes.mu) / found.one(diagrams.base.mu)
        for curve, mark, (_, a, b) in zip(
            source.curves, to.readings, diagrams.stretches, strict=True
        ):
            tangents = found.reading[curve].tangents[0]
            values = tangents.imag / tangents.real * slope
            right = found.reading[mark][0, a : b + 1] * found.one(to.axes.mu)
            most = max(np.abs(right).max(), DUST)  # an even motion has no acceleration
            bound = (2 * np.pi) ** 4 / 30**3 * most
            inside = slice(2, -2) if b - a > 6 else slice(None)
            assert np.abs(values - right).max() < bound
            assert np.abs(values - right)[inside].max(initial=0.0) < bound / 10


def test_scales_are_those_of_the_document() -> None:
    found = made(CamTask(**C6, height=50.0))
    assert found.one(found.cam.diagrams.S.axes.mu) == pytest.approx(0.00056)
    assert found.one(found.cam.diagrams.V.axes.mu) == pytest.approx(0.00056)
    own = made(CamTask(**C6, mu_S=0.0005, mu_V=0.001, mu_A=0.002))
    read = [
        found_.one(d.axes.mu)
        for found_, d in ((own, own.cam.diagrams.S), (own, own.cam.diagrams.V))
    ]
    assert read == [0.0005, 0.001]
    assert own.one(own.cam.diagrams.A.axes.mu) == 0.002
    top = own.reading[own.cam.diagrams.S.reading][0, own.cam.diagrams.turn.rise.last]
    assert top == pytest.approx(56.0)


def test_the_scales_of_an_integral_follow_from_the_stroke_the_last_first() -> None:
    found = drawn(TRIANGLES, SLANTED)
    base = found.one(found.cam.diagrams.base.mu)
    for integral in found.cam.diagrams.integrals:
        mu = {which: found.one(mark) for which, mark in integral.scales.items()}
        assert mu["V"] == pytest.approx(mu["S"] / (base * 30.0))
        assert mu["A"] == pytest.approx(mu["V"] / (base * 30.0))


@pytest.mark.parametrize(
    ("phases", "count"),
    [
        ((100, 20, 90, 150), 26),
        ((120, 0, 120, 120), 25),
        ((180, 0, 180, 0), 25),
        ((90, 180, 90, 0), 26),
    ],
)
def test_the_turn_is_divided(phases: tuple[float, ...], count: int) -> None:
    turn = divide(CamTask(0.02, *phases))
    assert turn.positions == count
    assert turn.angles[0] == 0.0
    assert turn.angles[turn.rise.last] == phases[0]
    assert turn.angles[turn.fall.first] == phases[0] + phases[1]
    assert turn.angles[-1] == pytest.approx(360.0 - phases[3])
    assert (np.diff(turn.angles) > 0).all()


def test_parts_of_the_turn_go_to_its_phases() -> None:
    turn = divide(CamTask(0.02, 100, 20, 90, 150, per_turn=36))
    assert (turn.rise.parts, turn.fall.parts) == (10, 9)
    jumping = Law("constant acceleration")
    even = divide(CamTask(0.02, 100, 20, 90, 150, jumping, jumping, per_turn=36))
    assert (even.rise.parts, even.fall.parts) == (10, 10)
    assert even.fall.stretches == ((11, 16), (16, 21))


@pytest.mark.slow
def test_a_cam_that_can_be_drawn_leaves_nothing_undrawn() -> None:
    for law in (*LAWS, TRAPEZOID):
        found = drawn(law, law)
        marks = [step.it for step in found.log.steps]
        told = [f for f in examine(found.log, found.given, marks) if f.kind == "undrawn"]
        assert not told, (law.name, told[0].step.it, told[0].positions)


NONSENSE = [
    ({"rise": 200.0}, "360"),
    ({"rise": -10.0, "lower_dwell": 260.0}, "rise = -10: a number greater than 0"),
    ({"rise": 0.0, "lower_dwell": 250.0}, "greater than 0"),
    ({"lower_dwell": 100.0}, "150"),
    ({"rise": float("nan")}, "rise = nan: a number greater than 0"),
    ({"stroke": -0.028}, "stroke"),
    ({"stroke": 0.0}, "stroke"),
    ({"r0": -0.05}, "r0"),
    ({"roller": -0.001}, "roller"),
    ({"pressure": 90.0}, "pressure = 90: .* less than 90"),
    ({"pressure_return": 0.0}, "pressure_return = 0: .* greater than 0"),
    ({"turns": "left"}, "clockwise"),
    ({"divisions": 3}, "whole number"),
    ({"divisions": 7.5}, "whole number"),
    ({"per_turn": 1000}, "whole number"),
    ({"share_of_r0": 1.2}, "share_of_r0"),
    ({"base": 0.0}, "base"),
    ({"mu_A": -1.0}, "mu_ddS = -1: "),
    ({"poles": (30.0, 0.0)}, "H = 0: "),
    ({"rise_law": Law("parabola")}, "take one of"),
    ({"rise_law": Law("sine", ((0, 1), (1, -1)))}, "points belong"),
    ({"rise_law": Law("diagram", ((0, 1),))}, "two points"),
    ({"rise_law": Law("diagram", ((0, 1), (0.9, -1)))}, "from share 0 to share 1"),
    ({"rise_law": Law("diagram", ((0, 1), (0.5, 1), (0.4, -1), (1, -1)))}, "from share 0"),
    ({"rise_law": Law("diagram", ((0, 1), (0.5, 1), (1, -1)))}, "areas"),
    ({"rise_law": Law("diagram", ((0, -1), (1, 1)))}, "wrong way"),
    ({"return_law": Law("diagram", ((0, 0.0), (1, 0.0)))}, "areas"),
    ({"rise_law": Law("diagram", ((0, 1), (0.511, 1), (0.511, -1.12), (1, -1.12)))}, "areas"),
    ({"rise_law": Law("diagram", ((0, 1), (1, 1)))}, "areas"),
    ({"follower": RollerFollower(0.06), "r0": 0.05}, "offset 60 mm is not less than r0 = 50 mm"),
    ({"follower": RockerFollower(-0.08, 0.1)}, "lever"),
    ({"follower": RockerFollower(0.08, 0.1), "stroke": 3.5}, "turns over"),
    ({"follower": RockerFollower(0.08, 0.1), "stroke": 0.3, "r0": 0.2}, "between 20 and 180 mm"),
    ({"follower": FlatFollower(-0.01)}, "least_curvature = -0.01: .* not less than 0"),
]


@each("change, says", NONSENSE)
def test_nonsense_is_refused_with_a_remedy(change: dict[str, object], says: str) -> None:
    with pytest.raises(StructureError, match=says):
        made(CamTask(**{**C6, **change}))  # type: ignore[arg-type]
