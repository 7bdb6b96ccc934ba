"""Accelerations of two plates by substitution: the same as by the special point, and less true by hand."""

from __future__ import annotations

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import ROOT
from support.plates import followed
from support.squares import square
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.accuracy.measure import off
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.settings import hand_named
from graphic_tmm.board.execute import prepare
from graphic_tmm.chapters.substitution.record import FIRST, LONGEST, SUBSTITUTION_PLAN
from graphic_tmm.chapters.substitution.task import SUBSTITUTION
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError

KINDS: tuple[dict[str, bool], ...] = (
    {},
    {"before": True},
    {"behind": True},
    {"before": True, "behind": True},
)
CASES = [(seed, seed % len(KINDS)) for seed in range(60)]
CLOSE = 1e-9
"""Of the largest, times the condition: two plans of some forty lines each, with no rounding by a ruler."""


def drawn(text: str, asks: str = "") -> Drawn:
    place = f'[{SUBSTITUTION}]\n{asks}\n[[sheet]]\nplace = ["accelerations", "{SUBSTITUTION}"]\n'
    return drawn_of(tmm.read(f"{text}\n{place}"), exact=True)


def class_four() -> str:
    text = (ROOT / "sheets" / "class-four" / "scene.toml").read_text("utf-8")
    return text[: text.index("[effects]")].partition("[substitution]")[0]


@pytest.mark.parametrize(("seed", "kind"), in_turn(CASES, 12))
def test_accelerations_are_those_by_the_special_point(seed: int, kind: int) -> None:
    """ε of all four links and a of their pins, wherever the first link does not lie along the second plate."""
    one = square(seed, **KINDS[kind])
    try:
        work = drawn(one.text)
    except TmmError:  # it comes back elsewhere after a turn
        assert len(followed(one.machine)) < 700
        return
    made = SUBSTITUTION_PLAN.of(work)
    assert made is not None
    links = (*one.plates, *one.joining)
    pairs = [(pin.special, pin.substituted) for pin in made.pins]
    rates = [(made.usual.rates[link], made.motion.rates[link]) for link in links]
    closing, judged = made.closing, 0
    ends = [made.closing.legs[1].pivot, *closing.points]
    read = prepare(work.construction, [m for two in (*pairs, *rates) for m in two] + ends).run(
        work.given
    )
    D, _, C, _, _ = (read[mark][0] for mark in ends)
    with np.errstate(all="ignore"):
        B, second = read[closing.points[0]][0], C - D
        turn = np.abs(((C - B) * second.conjugate()).imag) / np.abs((C - B) * second)
    for usual, substituted in (*pairs, *rates):
        first, again = (np.broadcast_to(read[m], (1, turn.size))[0] for m in (usual, substituted))
        largest = np.nanmax(np.abs(first), initial=0.0)
        for k in np.flatnonzero(turn > 1e-3):
            judged += bool(np.isfinite(again[k]))
            if np.isfinite(first[k]):
                apart = abs(abs(again[k]) - abs(first[k]))
                assert apart <= CLOSE / turn[k] ** 2 * largest, (usual.letter, k)
    assert judged


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('speed = "120 rpm"', 'speed = 0\nacceleration = "5 rad/s^2"'),
        ('speed = "120 rpm"', 'speed = "120 rpm"\nacceleration = "5 rad/s^2"'),
        ("[plans]", '[plans]\nvelocities = "turned"'),
    ],
)
def test_at_rest_gaining_speed_and_by_a_turned_plan_it_is_the_same(old: str, new: str) -> None:
    assert old in class_four()
    work = drawn(class_four().replace(old, new))
    made = SUBSTITUTION_PLAN.of(work)
    assert made is not None
    marks = [mark for pin in made.pins for mark in (pin.special, pin.substituted)]
    read = prepare(work.construction, marks).run(work.given)
    for pin in made.pins:
        first, again = (np.abs(read[mark]) for mark in (pin.special, pin.substituted))
        assert np.isfinite(first).all()
        assert np.allclose(first, again, rtol=0, atol=CLOSE * first.max()), pin.letter


def test_by_a_student_the_special_point_is_truer() -> None:
    """1000 drawings of the sheets of class-four: why that is the way by which plans are drawn."""
    work, trials = drawn(class_four()), 1000
    asked = [one for one in quantities(work.project) if one.places == (SUBSTITUTION,)]
    program = prepare(work.construction, [mark for one in asked for mark in one.marks])
    by_hand = program.run(work.given, hand=hand_named("student", work.scene, trials))
    exact, errors = program.run(work.given), []
    for one in asked:
        due = one.read(exact, 1)
        errors.append(off(one.read(by_hand, trials), due, float(np.abs(due).max())).error)
    special, substituted = errors
    assert 1.4 < special < 1.8
    assert 1.1 < substituted / special < 1.3


def test_no_vector_with_the_pivots_held_is_too_long() -> None:
    work = drawn(square(0).text)
    made = SUBSTITUTION_PLAN.of(work)
    assert made is not None
    marks = [
        step.it for step in work.construction.steps if step.it.view == "substitution velocities"
    ]
    points = [mark for mark in marks if mark.name in "bcef"]
    assert len(points) == 4
    read = prepare(work.construction, [*points, made.first]).run(work.given)
    assert max(float(np.nanmax(np.abs(read[mark]))) for mark in points) <= LONGEST + 1e-9
    assert float(read[made.first].max()) <= FIRST


def test_where_there_is_no_group_of_class_four_it_is_refused() -> None:
    text = (ROOT / "sheets" / "swinging-screen" / "scene.toml").read_text("utf-8")
    bare = text[: text.index("[effects]")]
    with pytest.raises(TmmError, match=r"no two plates that two links join \(class IV\)"):
        drawn(bare)
    with pytest.raises(TmmError, match="there is no position 17"):
        drawn(square(0).text, "at = 17")


def test_a_scene_without_it_records_nothing() -> None:
    work = drawn_of(tmm.read(square(0).text), exact=True)
    assert SUBSTITUTION_PLAN.of(work) is None
    assert all("substitution" not in step.it.view for step in work.construction.steps)
