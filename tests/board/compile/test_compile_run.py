"""A compiled log says what the executed one says; what cannot be compiled runs as ever."""

from __future__ import annotations

import sys
import threading
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.drawn import board
from support.mechanisms import sample

from graphic_tmm.board.compile import loop
from graphic_tmm.board.compile import run as module
from graphic_tmm.board.compile.llvm import WIDTH
from graphic_tmm.board.compile.machine import machine
from graphic_tmm.board.compile.run import LEAST, Bound, bound, cores, shared
from graphic_tmm.board.execute import Reading, execute, prepare
from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.formulas import rate
from graphic_tmm.board.operations.instruments import cross, join, lay_off, measure, ray, strike
from graphic_tmm.board.record import Board, Construction, Mark
from graphic_tmm.board.values import Angle, Length, Number, Point, Side, arrays
from graphic_tmm.errors import ConstructionError

ANGLES = np.linspace(0.0, 360.0, 601)[None, :]
TOLERANCE = 1e-12
"""Of the largest number of a mark: sines, lengths and complex quotients come by other formulas."""


class Fourbar:
    """A four-bar's plan of positions with a reading; the last positions do not assemble."""

    def __init__(self, *, curve: bool = False, closed: bool = False) -> None:
        draft = Board()
        draft.open("positions")
        self.marks: dict[str, Mark] = {}
        self.given: dict[Mark, Any] = {}
        lengths = np.where(ANGLES > 350.0, 1.0, 80.0)
        for letter, kind, value in (
            ("O", Point, 0j),
            ("C", Point, 90 + 10j),
            ("φ", Angle, ANGLES),
            ("OA", Length, 30.0),
            ("AB", Length, lengths),
            ("CB", Length, 70.0),
            ("±", Side, 1.0),
            ("μ", Number, 0.002),
        ):
            self.marks[letter] = draft.take(kind, letter, "m/mm" if letter == "μ" else "")
            self.given[self.marks[letter]] = value
        scale = 1.0

        def free(start: Point, end: Point) -> Length:
            return Length(scale * np.abs(end - start))

        steps: list[tuple[Any, ...]] = [
            ("(OA)", ray, "O", "φ"),
            ("A", lay_off, "(OA)", "OA"),
            ("(A)", strike, "A", "AB"),
            ("(C)", strike, "C", "CB"),
            ("B", cross, "(A)", "(C)", "±"),
            ("(AB)", join, "A", "B"),
            ("OB", measure._replace(run=free) if closed else measure, "O", "B"),
            ("ω", rate, "OB", "μ", "OA", "μ"),
        ]
        for letter, op, *uses in steps:
            self.marks[letter] = draft.draw(op, letter, *(self.marks[name] for name in uses))
        if curve:
            self.marks["(B–B)"] = draft.draw(french_curve, "(B–B)", self.marks["B"], row=600)
        self.log: Construction = draft.construction()

    def both(self, **options: Any) -> tuple[Reading, Reading]:
        """The log executed and compiled."""
        plain = execute(self.log, self.given, fast=False, **options)
        return plain, execute(self.log, self.given, fast=True, **options)


class Counted:
    """A function, and how often it was called."""

    def __init__(self, real: Any) -> None:
        self.real, self.count = real, 0

    def __call__(self, *asked: Any) -> Any:
        self.count += 1
        return self.real(*asked)


def same(log: Construction, plain: Reading, fast: Reading, within: float = TOLERANCE) -> None:
    """All numbers are the same within a share of the largest of their mark, in the same shapes."""
    steps = [step for step in log.steps if step.it in plain]
    assert steps
    for step in steps:
        for one, other in zip(arrays(plain[step.it]), arrays(fast[step.it]), strict=True):
            assert one.shape == other.shape, step.it
            assert one.dtype == other.dtype, step.it
            drawn = np.isfinite(one)
            np.testing.assert_array_equal(drawn, np.isfinite(other), err_msg=str(step.it))
            if drawn.any():
                top = np.abs(one[drawn]).max()
                assert np.abs(one[drawn] - other[drawn]).max() <= within * top, step.it


def test_three_plans_of_two_groups() -> None:
    """A crank behind a stone on a rocker: kinds 3 and 2, with their Coriolis terms and readings."""
    drawn = next(d for d in sample(60, seed=4, dyads=(2, 2)) if set(d.kinds) == {"RPR", "RRP"})
    one = board(drawn.mechanism, mu=(0.01, 0.1, 1.0))
    wanted = [*one.velocities.rates.values(), *one.accelerations.rates.values()]
    last = drawn.mechanism.links[-1]
    images = one.accelerations.images.by_letter[last.number]
    wanted += [images[letter] for letter in last.points]
    given = one.given | {one.positions.row[0]: ANGLES}
    program = prepare(one.log, wanted)
    same(one.log, program.run(given, fast=False), program.compiled().run(given), 1e-11)


def test_a_reading_rounds_alike() -> None:
    bar = Fourbar()
    plain, fast = bar.both(hand=Hand(ruler=0.5))
    same(bar.log, plain, fast)
    assert not np.array_equal(fast[bar.marks["OB"]], bar.both()[1][bar.marks["OB"]])
    halves = fast[bar.marks["OB"]][0, :500] / 0.5
    np.testing.assert_array_equal(halves, np.rint(halves))


def test_what_fails_is_undefined_there_only() -> None:
    bar = Fourbar()
    _, fast = bar.both()
    bad = np.flatnonzero(np.isnan(fast[bar.marks["B"]][0]))
    np.testing.assert_array_equal(bad, np.flatnonzero(ANGLES[0] > 350.0))


def test_trials_run_in_the_loop_too() -> None:
    bar = Fourbar()
    bar.given[bar.marks["OA"]] = np.array([[28.0], [30.0], [32.0]])
    plain, fast = bar.both()
    assert fast[bar.marks["B"]].shape == (3, ANGLES.size)
    same(bar.log, plain, fast)


def test_one_position_is_not_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    bar = Fourbar()
    bar.given |= {bar.marks["φ"]: 40.0, bar.marks["AB"]: 80.0}
    monkeypatch.setattr(loop, "function_of", None)
    plain, fast = bar.both()
    for step in bar.log.steps:
        for one, other in zip(arrays(plain[step.it]), arrays(fast[step.it]), strict=True):
            np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("hand", [HANDS["student"]._replace(trials=2), Hand(ruler=0.1, digits=4)])
def test_a_hand_that_slips_draws_the_very_same(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    bar = Fourbar()
    monkeypatch.setattr(loop, "function_of", None)
    plain, fast = bar.both(hand=hand)
    for step in bar.log.steps:
        for one, other in zip(arrays(plain[step.it]), arrays(fast[step.it]), strict=True):
            np.testing.assert_array_equal(one, other)


def test_what_cannot_be_compiled_runs_between_the_loops() -> None:
    """A step across positions, and one whose function is bound to its surroundings."""
    bar = Fourbar(curve=True, closed=True)
    plain, fast = bar.both(block=100)
    same(bar.log, plain, fast, 1e-10)
    curve = fast[bar.marks["(B–B)"]]
    np.testing.assert_array_equal(curve.knots, fast[bar.marks["B"]][:, :600])


def test_one_position_more_than_a_width_and_one_less() -> None:
    bar = Fourbar()
    for count in (2, WIDTH - 1, WIDTH, WIDTH + 1, 3 * WIDTH - 1):
        bar.given |= {bar.marks["φ"]: ANGLES[:, :count], bar.marks["AB"]: 80.0}
        same(bar.log, *bar.both())


@pytest.mark.parametrize("threads", [2, 3, 7])
def test_threads_change_no_byte(threads: int) -> None:
    bar = Fourbar()
    bar.given[bar.marks["OA"]] = np.array([[28.0], [32.0]])
    one, other = (execute(bar.log, bar.given, fast=True, threads=n) for n in (1, threads))
    for step in bar.log.steps:
        for a, b in zip(arrays(one[step.it]), arrays(other[step.it]), strict=True):
            assert a.tobytes() == b.tobytes()


def test_positions_have_the_same_bytes_whoever_stands_beside_them() -> None:
    bar = Fourbar()
    _, whole = bar.both()
    bar.given |= {bar.marks[name]: bar.given[bar.marks[name]][:, 100:113] for name in ("φ", "AB")}
    _, some = bar.both()
    for name in ("A", "B", "ω"):
        np.testing.assert_array_equal(some[bar.marks[name]], whole[bar.marks[name]][:, 100:113])


def test_a_loop_is_made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    bar = Fourbar()
    first = prepare(bar.log).run(bar.given, fast=True)
    monkeypatch.setattr(loop, "function_of", None)
    again = prepare(bar.log).run({**bar.given, bar.marks["OA"]: 31.0}, fast=True)
    assert not np.array_equal(first[bar.marks["A"]], again[bar.marks["A"]])


def test_a_log_of_the_same_steps_has_the_same_loop(monkeypatch: pytest.MonkeyPatch) -> None:
    """And one that does something else has not."""
    first, other = Fourbar(), Fourbar()
    due = prepare(first.log).run(first.given, fast=True)
    noted = Counted(loop.loop_of)
    monkeypatch.setattr(loop, "loop_of", noted)
    found = prepare(other.log).run(other.given, fast=True)
    assert noted.count == 0
    for letter in ("A", "B", "ω"):
        mark = other.marks[letter]
        assert found[mark].tobytes() == due[first.marks[letter]].tobytes()
    prepare(Fourbar(closed=True).log).run(first.given, fast=True)
    # one before the step that cannot be noted, one behind it
    assert noted.count == 2


def test_what_was_never_wanted_is_not_left_behind() -> None:
    bar = Fourbar()
    found = execute(bar.log, bar.given, [bar.marks["B"]], fast=True)
    assert set(found.values) == {bar.marks["B"].slot}


def test_without_llvmlite_the_remedy_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    machine.cache_clear()
    try:
        monkeypatch.setitem(sys.modules, "llvmlite", None)
        monkeypatch.setitem(sys.modules, "llvmlite.binding", None)
        with pytest.raises(ConstructionError, match=r'pip install "graphic-tmm\[fast\]"'):
            prepare(Fourbar().log).compiled()
    finally:
        machine.cache_clear()


pytest.importorskip("llvmlite")
COUNT = 53
PLACES = (np.linspace(0.0, 9.0, COUNT) ** 2 + 1j * np.linspace(5.0, -3.0, COUNT))[None, :]


class Plan:
    """A point that moves, one that stands, what is read between them, and what stands still."""

    def __init__(self, *, curve: bool = False) -> None:
        draft = Board()
        draft.open("plan")
        self.p, self.q, self.r = (draft.take(Point, letter) for letter in "PQR")
        self.mu = draft.take(Number, "μ", "m/mm")
        self.length = draft.take(Length, "l")
        self.given: dict[Mark, Any] = {
            self.p: PLACES,
            self.q: np.array([[3.0 - 2.0j]]),
            self.r: np.array([[4.0 + 1.0j]]),
            self.mu: np.array([[0.02]]),
            self.length: np.array([[7.0]]),
        }
        self.line = draft.draw(join, "(PQ)", self.p, self.q)
        self.far = draft.draw(lay_off, "S", self.line, self.length)
        self.read = draft.draw(measure, "PS", self.q, self.far)
        self.omega = draft.draw(rate, "ω", self.read, self.mu, self.length, self.mu)
        self.still = draft.draw(measure, "QR", self.q, self.r)
        if curve:
            draft.draw(french_curve, "(P)", self.far, row=COUNT - 1)
        self.log = draft.construction()
        self.asked = [mark.slot for mark in (self.omega, self.far, self.still, self.read)]

    def values(self, given: dict[Mark, Any]) -> dict[int, Any]:
        return {mark.slot: value for mark, value in given.items()}

    def bound(
        self, hand: Hand = EXACT, asked: list[int] | None = None, **more: Any
    ) -> Bound | None:
        values = self.values(self.given) | more.get("values", {})
        (calls, _), *_ = prepare(self.log).strata
        return bound(calls, values, hand, self.asked if asked is None else asked)


@pytest.mark.parametrize("hand", [EXACT, Hand(ruler=0.5)])
@pytest.mark.parametrize("count", [2, WIDTH - 1, WIDTH, WIDTH + 1, COUNT])
def test_it_leaves_what_the_log_leaves(count: int, hand: Hand) -> None:
    """A point, which enters as two rows; numbers; one that is the same at all positions, asked for too."""
    plan = Plan()
    loop = plan.bound(hand)
    assert loop is not None
    place = PLACES[:, -count:]
    found = loop.run(count, [feed.of({plan.p.slot: place})[0] for feed in loop.feeds])
    assert len(loop.feeds) == 2
    due = prepare(plan.log).run({**plan.given, plan.p: place}, hand=hand, fast=True)
    for slot, one in zip(plan.asked, found, strict=True):
        np.testing.assert_array_equal(one, np.broadcast_to(due.values[slot][0], (count,)))
        assert one.dtype == due.values[slot].dtype
        assert one.shape == (count,)
    assert found[2].strides == (0,)
    assert not found[2].flags.writeable


def test_one_position_is_worked_as_one_of_many() -> None:
    plan = Plan()
    loop = plan.bound()
    assert loop is not None
    whole = loop.run(COUNT, [PLACES.real[0], PLACES.imag[0]])
    one = loop.run(1, [PLACES.real[0, 30:31], PLACES.imag[0, 30:31]])
    for all_, alone in zip(whole, one, strict=True):
        assert alone.tobytes() == all_[30:31].tobytes()


def test_what_is_no_one_loop_is_not_bound() -> None:
    """A curve behind it is none of its calls; trials, a line asked for, a row of one number are no one loop."""
    plan = Plan()
    assert Plan(curve=True).bound() is not None
    assert plan.bound(asked=[plan.line.slot]) is None
    assert plan.bound(asked=[plan.p.slot]) is None
    assert plan.bound(values={plan.length.slot: np.array([[7.0], [8.0]])}) is None
    assert plan.bound(values={plan.p.slot: PLACES[:, :1]}) is None


@given(count=st.integers(8, 5000), least=st.integers(1, 8), threads=st.integers(1, 9))
def test_every_position_is_worked_once(count: int, least: int, threads: int) -> None:
    parts: list[tuple[int, int]] = []
    shared(lambda start, stop: parts.append((start, stop)), count, least, threads)
    assert sorted(at for part in parts for at in range(*part)) == list(range(count))
    assert len(parts) == min(threads, count // least)
    assert min(stop - start for start, stop in parts) >= least


def test_parts_are_worked_at_the_same_time() -> None:
    meeting = threading.Barrier(3, timeout=30)
    shared(lambda start, stop: meeting.wait() and None, 30, 1, 3)


def test_a_fault_of_a_part_is_told() -> None:
    def work(start: int, stop: int) -> None:
        if start:
            raise ValueError("the second part")

    with pytest.raises(ValueError, match="the second part"):
        shared(work, 30, 1, 2)


def test_few_positions_are_not_shared_by_themselves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "cores", lambda: 4)
    parts: list[tuple[int, int]] = []
    shared(lambda start, stop: parts.append((start, stop)), 2 * LEAST - 1, 8, None)
    assert len(parts) == 1
    shared(lambda start, stop: parts.append((start, stop)), 3 * LEAST, 8, None)
    assert len(parts) == 4


@pytest.mark.parametrize("name", ["NUMBA_NUM_THREADS", "OMP_NUM_THREADS"])
def test_the_environment_limits_the_threads(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for one in ("NUMBA_NUM_THREADS", "OMP_NUM_THREADS"):
        monkeypatch.delenv(one, raising=False)
    free = cores()
    assert free >= 1
    for told, due in (("1", 1), ("100000", free), ("0", free), ("4,2", free), ("", free)):
        monkeypatch.setenv(name, told)
        assert cores() == due
