"""Velocities to a free scale: those of the mechanism, whatever leg of the plate drives."""

from __future__ import annotations

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import ROOT
from support.moved_bodies import returns
from support.plates import Machine, followed, machine
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.accuracy.measure import off
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.settings import hand_named
from graphic_tmm.board.execute import prepare
from graphic_tmm.chapters.free_scale.record import FREE_SCALE_PLAN, LONGEST
from graphic_tmm.chapters.free_scale.task import FREE_SCALE
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError

CLOSE = 1e-12
"""Of the fastest, by the condition of the equations: there is no rounding by a ruler."""
CASES = [(seed, guides) for seed in range(60) for guides in (0, 1)]


def drawn(text: str, asks: str = "") -> Drawn:
    place = f'[{FREE_SCALE}]\n{asks}\n[[sheet]]\nplace = ["velocities", "free_scale"]\n'
    return drawn_of(tmm.read(f"{text}\n{place}"), exact=True)


def judge(one: Machine, work: Drawn) -> int:
    """Hold the velocities that are read against constraints of single bodies; return how many were."""
    made, reading = FREE_SCALE_PLAN.of(work), work.of(FREE_SCALE)
    assert made is not None
    assert reading is not None
    values = [float(np.ravel(reading.figure(result.value))[0]) for result in made.results]
    phi = np.radians(work.project.coordinates[made.at])
    row = followed(one)
    near = min(row, key=lambda two: abs((two[0] - phi + np.pi) % (2 * np.pi) - np.pi))
    if abs((near[0] - phi + np.pi) % (2 * np.pi) - np.pi) > 0.01:
        assert not np.isfinite(values).any()  # the plate cannot be laid there
        return 0
    q = one.bodies.settle(near[1], phi + 2 * np.pi * round((near[0] - phi) / (2 * np.pi)))
    if q is None:
        return 0
    v, _, bad = one.bodies.rates(q, 10.0)
    if bad > 1e4:
        return 0
    fastest = max(abs(complex(*v[3 * k - 3 : 3 * k - 1])) for k in one.links)
    plate = next(
        link for letter, link in one.letters if letter == "C" and ("F", link) in one.letters
    )
    for result, value in zip(made.results, values, strict=True):
        turn = one.letters[result.point, plate] * np.exp(1j * q[3 * plate - 1])
        speed = complex(*v[3 * plate - 3 : 3 * plate - 1]) + 1j * v[3 * plate - 1] * turn
        assert abs(value - abs(speed)) <= CLOSE * fastest * bad, result.point
    lengths = [value / float(np.ravel(reading.figure(made.mu))[0]) for value in values]
    assert max(lengths) <= LONGEST + 1e-9
    return 1


@pytest.mark.parametrize(("seed", "guides"), in_turn(CASES, 4))
def test_velocities_are_those_of_the_mechanism(seed: int, guides: int) -> None:
    one = machine(seed, guides=guides)
    row = followed(one)
    if not returns(row):
        with pytest.raises(TmmError, match="another of its places after a turn"):
            drawn(one.text)
        return
    whole = row[-1][0] - row[0][0] >= 4 * np.pi - 1e-6
    # elsewhere a few of the positions are there: three are enough
    judged = 0
    for at in range(0, 12, 1 if whole else 4):
        try:
            judged += judge(one, drawn(one.text, f'at = "{at}"'))
        except TmmError as refused:
            assert "all but stands" in str(refused)  # noqa: PT017
    assert judged >= 8 or not whole


def test_either_leg_of_the_frame_may_drive() -> None:
    one = machine(3)
    (plate,) = (n for letter, n in one.letters if letter == "C" and ("F", n) in one.letters)
    legs = [n for letter, n in one.letters if letter in "DE" and n != plate]
    values = []
    for link in legs:
        work = drawn(one.text, f"link = {link}\nat = 4")
        made, reading = FREE_SCALE_PLAN.of(work), work.of(FREE_SCALE)
        assert made is not None
        assert reading is not None
        assert made.link == link
        found = {r.point: float(np.ravel(reading.figure(r.value))[0]) for r in made.results}
        values.append([found[letter] for letter in "BCF"])
    assert np.allclose(values[0], values[1], rtol=1e-9, equal_nan=True)


def test_what_cannot_drive_is_named() -> None:
    text = machine(3).text
    with pytest.raises(TmmError, match="link 2 is no leg that could drive a plate from the frame"):
        drawn(text, "link = 2")
    bar = (ROOT / "sheets" / "stephenson-gear" / "scene.toml").read_text("utf-8")
    with pytest.raises(TmmError, match="no plate hangs by one leg on the crank pin"):
        drawn(bar[: bar.index("[[sheet]]")])


def test_a_leg_whose_pin_all_but_stands_is_refused() -> None:
    with pytest.raises(TmmError, match="position 5: the pin of link 3 all but stands"):
        drawn(machine(0, guides=1).text, "at = 5")


def test_by_a_student_it_is_as_true_as_the_special_point() -> None:
    """1000 drawings of the screen in two positions, in the usual size."""
    text = (ROOT / "sheets" / "swinging-screen" / "scene.toml").read_text("utf-8")
    for at in (2, 8):
        scene = tmm.read(text.replace("[free_scale]\nat = 1", f"[free_scale]\nat = {at}"))
        work, errors = drawn_of(scene, exact=True), []
        asked = [one for one in quantities(work.project) if one.places == (FREE_SCALE,)]
        assert [one.at for one in asked] == [(at,), (at,)]
        program = prepare(work.construction, [mark for one in asked for mark in one.marks])
        by_hand = program.run(work.given, hand=hand_named("student", scene, 1000))
        exact = program.run(work.given)
        for one in asked:
            due = one.read(exact, 1)
            errors.append(off(one.read(by_hand, 1000), due, float(np.abs(due).max())).error)
        first, again = (np.abs(one.read(exact, 1)) for one in asked)
        assert np.allclose(first, again, rtol=1e-9)
        assert 1.5 < errors[0] < 3.2
        assert 0.85 < errors[1] / errors[0] < 1.15


def test_a_scene_without_it_records_nothing() -> None:
    work = drawn_of(tmm.read(machine(3).text), exact=True)
    assert FREE_SCALE_PLAN.of(work) is None
    assert all(step.it.view != FREE_SCALE for step in work.construction.steps)


def test_where_the_plate_cannot_be_laid_there_are_no_velocities() -> None:
    work = drawn(machine(48).text, "at = 8")
    made, reading = FREE_SCALE_PLAN.of(work), work.of(FREE_SCALE)
    assert made is not None
    assert reading is not None
    assert all(np.isnan(reading.figure(result.value)).all() for result in made.results)
