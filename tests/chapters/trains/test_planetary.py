"""The planetary train as drawn: all four schemes against rolling contacts; the ratio read off the plan."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction as F
from typing import Any

import numpy as np
import pytest
from support import train_oracle as oracle

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import examine
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import LENGTHS
from graphic_tmm.chapters.trains.plan import Planetary, draw_planetary
from graphic_tmm.chapters.trains.task import PlanetaryTask
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.errors import StructureError

SPEED = 302.4
C7 = PlanetaryTask("ring", 0.008, SPEED, ratio=4.55, tolerance=0.003, teeth=(25, None, None))
GIVEN = {
    "ring": (25, 32, 89),
    "external-internal": (18, 48, 21, 87),
    "external-external": (18, 21, 17, 22),
    "internal-internal": (52, 22, 23, 53),
}


def drawn(order: PlanetaryTask) -> tuple[Planetary, Construction, dict[Mark, Any]]:
    draft = Draft()
    made = draw_planetary(draft, order)
    return made, draft.board.construction(), draft.given


def read(order: PlanetaryTask, hand: Hand | None = None) -> tuple[Planetary, Reading]:
    made, log, given = drawn(order)
    return made, execute(log, given) if hand is None else execute(log, given, hand=hand)


def value(reading: Reading, mark: Mark) -> float:
    return float(reading[mark][0, 0])


def order_of(scheme: str, driving: str = "1", **more: Any) -> PlanetaryTask:
    return PlanetaryTask(scheme, 0.004, SPEED, driving, teeth=GIVEN[scheme], **more)


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_random_trains_move_as_rolling_contacts_say(
    scheme: str, many: Callable[[int, int], int]
) -> None:
    """ω of all bodies and the ratio measured off the plan, to 1e-9 of the largest."""
    draw = random.Random(scheme)
    for _ in range(many(250, 30)):
        order = oracle.valid(draw, scheme)
        made, reading = read(order)
        q = F(1) if order.module_2 is None else F(order.module_2 / 0.004).limit_denominator(100)
        four = oracle.four(scheme, made.train.teeth)
        satellite, carrier = (float(u) for u in oracle.rates(scheme, four, q))
        unit = order.speed / (1.0 if order.driving == "1" else carrier)
        due = {"1": unit, "2": satellite * unit, "H": carrier * unit}
        found = {body: value(reading, mark) for body, mark in made.rates.values.items()}
        for body in due:
            assert abs(found[body] - due[body]) <= 1e-9 * abs(due[body])
        u = oracle.ratio(scheme, four, order.driving, q)
        assert u is not None
        for mark in (made.rates.drawn, made.sizes.ratio):
            assert abs(value(reading, mark) - float(u)) <= 1e-9 * abs(float(u))
        assert value(reading, made.rates.difference) <= 1e-7  # %
        a, b, _ = oracle.radii(scheme, four, q)
        speeds = {name: value(reading, mark) for name, mark in made.picture.speeds.items()}
        assert speeds["A"] == pytest.approx(unit * float(a) * 0.004, rel=1e-9)
        assert speeds["B"] == pytest.approx(carrier * unit * float(b) * 0.004, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_one_log_serves_many_trains_at_once(scheme: str) -> None:
    """Tooth numbers are given marks: 20 trains as trials of one log are 20 logs."""
    draw, single, rows = random.Random(1), [], []
    while len(rows) < 20:
        order = oracle.valid(draw, scheme)
        if order.satellites == (3,) and order.driving == "1" and order.module_2 is None:
            rows.append(order)
            made, reading = read(order)
            single.append([value(reading, mark) for mark in made.results.values()])
    made, log, given = drawn(rows[0])
    teeth = np.array([order.teeth for order in rows], dtype=float)
    for column, mark in enumerate(made.sizes.teeth.values()):
        given[mark] = teeth[:, [column]]
    speed = next(m for m in log.given if m.letter == "ω_1")
    given[speed] = np.array([[order.speed] for order in rows])
    reading = execute(log, given)
    found = [np.broadcast_to(reading[m], (20, 1))[:, 0] for m in made.results.values()]
    np.testing.assert_allclose(np.array(found[:-1]).T, np.array(single)[:, :-1], rtol=1e-9)


def test_the_windrower_as_its_document_has_it_with_three_satellites() -> None:
    made, reading = read(C7)
    found = {name: value(reading, mark) for name, mark in made.results.items()}
    assert made.train.teeth == (25, 32, 89)
    assert found["planetary_ratio"] == pytest.approx(4.56, rel=1e-15)
    assert found["planetary_ratio_drawn"] == pytest.approx(4.56, rel=1e-12)
    assert (found["planetary_z3"], found["planetary_satellites"]) == (89.0, 3.0)
    assert value(reading, made.mu) == 0.005  # drawn to 1:5, as there
    four, _ = read(replace(C7, teeth=(25, 32, 89), satellites=(4,)))
    (broken,) = (verdict for verdict in check(four.order, four.train) if not verdict.holds)
    assert broken.text == "assembly: (25 + 89)/4 = 28.5 is not whole"


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_circles_touch_where_they_should(scheme: str) -> None:
    made, reading = read(order_of(scheme))
    first, second = oracle.SENSES[scheme]
    circles = {wheel: reading[mark] for wheel, mark in made.end.circles.items()}
    axes = reading[made.end.satellites]
    assert axes.shape == (1, made.train.satellites)
    np.testing.assert_allclose(np.abs(axes), float(reading[made.end.lengths["H"]][0, 0]))
    fixed, rim = made.train.scheme.wheels[-1], made.train.scheme.wheels[-2]
    for centre, own, sense in (("1", "2", first), (fixed, rim, second)):
        r, s = circles[centre].radius, circles[own].radius
        apart = np.abs(circles[own].centre - circles[centre].centre)
        np.testing.assert_allclose(apart / np.abs(r + sense * s), 1.0, rtol=1e-12)
    a, b, c = (complex(reading[m][0, 0]) for m in made.end.points.values())
    assert (a.real, b.real, c.real) == (0.0, 0.0, 0.0)
    assert abs(a) == pytest.approx(float(circles["1"].radius[0, 0]))
    assert abs(b - axes[0, 0]) < 1e-12 * abs(b)
    assert abs(c) == pytest.approx(float(circles[fixed].radius[0, 0]))
    mu = value(reading, made.mu)
    assert mu in LENGTHS
    assert abs(a) * mu == pytest.approx(made.train.teeth[0] * 0.004 / 2)


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_the_scheme_stands_on_the_levels_of_the_circles(scheme: str) -> None:
    made, reading = read(order_of(scheme))
    wheels = made.train.scheme.wheels
    assert set(made.axial.discs) == set(wheels)
    for wheel, disc in made.axial.discs.items():
        near, far, centre = (complex(reading[m][0, 0]) for m in disc)
        radius = value(reading, made.end.lengths[wheel])
        assert abs(near - centre) == pytest.approx(radius, rel=1e-12)
        assert abs(far - centre) == pytest.approx(radius, rel=1e-12)
        assert abs(near + far - 2 * centre) < 1e-12 * abs(near)
    spots = {w: [complex(reading[m][0, 0]) for m in d] for w, d in made.axial.discs.items()}
    assert spots["1"][0] == spots["2"][0]
    # a single row's rim meshes with its far side
    meets = spots["2"][1] if scheme == "ring" else spots["3"][0]
    assert abs(meets - spots[wheels[-1]][0]) <= 1e-12 * abs(meets)


def test_the_axes_of_neighbours_as_measured_are_those_calculated() -> None:
    made, reading = read(C7)
    assert made.end.between is not None
    measured = reading[made.end.between][0] * 0.005
    (condition,) = (c for c in made.sizes.conditions if c.name == "neighbours")
    np.testing.assert_allclose(measured, value(reading, condition.left), rtol=1e-12)
    alone, _ = read(replace(C7, satellites=(1,)))
    assert alone.end.between is None


RELATIONS = {
    "=": lambda a, b: abs(a - b) <= 1e-12 * abs(b),
    ">": lambda a, b: a > b,
    "≥": lambda a, b: a >= b,
    "≤": lambda a, b: a <= b,
}


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_conditions_of_the_log_are_those_that_were_checked(scheme: str) -> None:
    order = order_of(scheme, ratio=None)
    made, reading = read(order)
    u = value(reading, made.sizes.ratio)
    made, reading = read(replace(order, ratio=u * 1.002, tolerance=0.01))
    for condition in made.sizes.conditions:
        left = value(reading, condition.left)
        if condition.relation == "whole":
            assert condition.right is None
            assert left == int(left)
        else:
            assert condition.right is not None
            assert RELATIONS[condition.relation](left, value(reading, condition.right))
    names = [verdict.condition for verdict in check(made.order, made.train)]
    assert list(dict.fromkeys(c.name for c in made.sizes.conditions)) == list(dict.fromkeys(names))
    if scheme == "ring":
        (verdict,) = (v for v in check(made.order, made.train) if v.condition == "assembly")
        (condition,) = (c for c in made.sizes.conditions if c.name == "assembly")
        assert value(reading, condition.left) == verdict.found


def test_a_pair_of_wheels_behind_the_train_multiplies_its_ratio() -> None:
    made, reading = read(replace(C7, behind=((15, 25),)))
    assert value(reading, made.results["overall_ratio"]) == pytest.approx(7.6, rel=1e-14)
    back, reading = read(replace(order_of("external-external"), behind=((20, 41),)))
    own = value(reading, back.sizes.ratio)
    assert own < 0.0
    assert value(reading, back.results["overall_ratio"]) == pytest.approx(-own * 41 / 20)
    for teeth in ((0, 25), (15, 2.5)):
        with pytest.raises(StructureError, match=r"behind = .*: a whole number"):
            read(replace(C7, behind=(teeth,)))  # type: ignore[arg-type]


def test_scales_and_pole_that_are_asked_for_are_kept() -> None:
    made, log, given = drawn(replace(C7, mu_l=0.004, mu_v=0.8, pole=35.0))
    reading = execute(log, given)
    assert given[made.picture.mu] == 0.8
    assert value(reading, made.rates.mu) == pytest.approx(0.8 / (0.004 * 35.0))
    assert value(reading, made.rates.drawn) == pytest.approx(4.56, rel=1e-12)


@pytest.mark.parametrize("driving", ["1", "H"])
@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_everything_has_room_and_nothing_is_left_undrawn(scheme: str, driving: str) -> None:
    made, log, given = drawn(order_of(scheme, driving))
    reading = execute(log, given)
    assert not [f for f in examine(log, given, [s.it for s in log.steps]) if f.kind == "undrawn"]
    longest = max(abs(value(reading, m)) for m in made.picture.readings.values())
    assert 20.0 <= longest <= 70.0
    assert max(abs(value(reading, m)) for m in made.rates.segments.values()) <= 80.0
    arm = given[made.axial.stations["H"]]
    lowest = min(complex(reading[m][0, 0]).real for m in made.picture.ends.values())
    assert lowest > arm + 20.0


def test_the_ruler_reads_segments_in_its_divisions() -> None:
    made, reading = read(C7, Hand(0.5))
    for mark in made.rates.segments.values():
        assert value(reading, mark) * 2 == round(value(reading, mark) * 2)
    assert 0.0 < value(reading, made.rates.difference) < 2.0


def test_a_standing_shaft_is_refused_before_anything_is_drawn() -> None:
    order = replace(order_of("external-external"), teeth=(20, 20, 20, 20), satellites=(2,))
    with pytest.raises(StructureError, match="a shaft stands"):
        drawn(order)
