"""The run-up by a motor step by step, and the steady cycle to which it comes: operations across positions.

Over an interval the motor does the work of its mean moment, M_m·Δφ, which hangs on the speed that is sought:
J·ω²/2 = T + ΔA + M_m(ω)·Δφ. The parabola on the left is crossed with the motor's curve, raised and to another
scale. The mean is that of both ends; from rest, where ω grows as √φ, two thirds of it are that of the end.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import FREE, WHOLE_ROW, operation
from graphic_tmm.board.operations.graphs import HALVINGS, alike
from graphic_tmm.board.values import Curve, Length, Number, Reals
from graphic_tmm.chapters.motor.operations import FROM_REST, HALF
from graphic_tmm.chapters.motor.operations_curve import ROUNDS, Motor, crossed, motor_of
from graphic_tmm.language.said import said

_NONE_DOES = "no flywheel makes the cycle so even"
CLOSED = 1e-3
"""A run-up is steady where a turn changes the speed by less than this share."""
MOST = 200
"""Turns after which a run-up is given up."""


FASTEST = 10.0
"""Above so many ends of a characteristic no cycle is steady: the machine runs away."""
CLOSE = 1e-6
"""A speed is that of the steady cycle when a turn changes it by less than this share."""


class Interval(NamedTuple):
    """An interval: T at its beginning and what the loads do over it (J), J at its end, Δφ; all (trial, 1)."""

    energy: Reals
    gain: Reals
    inertia: Reals
    way: Reals


def _after(motor: Motor, omega: Reals, over: Interval) -> tuple[Reals, Reals]:
    """Return ω and T at the end of an interval; where the machine does not get there ω is NaN, T negative."""
    share = np.where(omega > 0.0, HALF, FROM_REST)
    now = motor.at(omega)
    known = over.energy + over.gain + (1.0 - share) * over.way * now
    part, knots = share * over.way, motor.omega
    left = Motor(
        knots,
        known + part * motor.moment - over.inertia * knots**2 / 2.0,
        part * motor.rise - over.inertia * knots * knots[:, 1:2],
    )
    here = known + part * now - over.inertia * omega**2 / 2.0
    speed = crossed(left, omega, here)
    behind = np.isnan(speed) & (
        (here > 0.0) | ((omega > knots[:, -1:]) & (left.moment[:, -1:] >= 0.0))
    )
    if behind.any():
        speed = np.where(behind, _beyond(motor, omega, known, part, over.inertia), speed)
    energy = over.inertia * speed**2 / 2.0
    # at rest the motor has the moment of its start: so much energy is missing
    missing = np.minimum(left.moment[:, :1], -1e-6 * np.abs(known))
    return speed, np.where(np.isnan(speed) & np.isfinite(omega), missing, energy)


def _beyond(motor: Motor, omega: Reals, known: Reals, part: Reals, inertia: Reals) -> Reals:
    """Return the speed above the end of the characteristic with which an interval ends that began at ω."""
    end = motor.omega[:, -1:]
    # above its end a moment is below nothing, or level
    most = np.sqrt(2.0 * (known + part * np.maximum(motor.moment[:, -1:], 0.0)).clip(0.0) / inertia)
    low, high = end + 0.0 * known, np.maximum(np.maximum(most, omega), end)
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        more = known + part * motor.beyond(middle) > inertia * middle**2 / 2.0
        low, high = np.where(more, middle, low), np.where(more, high, middle)
    return low


class Turns(NamedTuple):
    """A machine over the row: the motor, T at the beginning of each interval without it, J, Δφ."""

    motor: Motor
    gains: Reals
    inertia: Reals
    way: Reals

    def go(self, omega: Reals) -> Iterator[tuple[Reals, Reals]]:
        """Yield ω and T at each boundary behind the first."""
        energy = self.inertia[:, :1] * omega**2 / 2.0
        for k in range(self.gains.shape[1]):
            over = Interval(
                energy, self.gains[:, k : k + 1], self.inertia[:, k + 1 : k + 2], self.way
            )
            omega, energy = _after(self.motor, omega, over)
            yield omega, energy

    def turn(self, omega: Reals) -> Reals:
        """Return ω at the end of the row."""
        for after, _ in self.go(omega):
            omega = after
        return omega

    def thinned(self, stride: int) -> Turns:
        """Return the same by every so many-th position."""
        gains = self.gains.reshape(len(self.gains), -1, stride).sum(axis=2)
        return Turns(self.motor, gains, self.inertia[:, ::stride], self.way * stride)


def turns_of(values: tuple[Reals, ...], motor: Motor, row: int) -> Turns:
    """Return a machine over the row by its works, that at the end, J and the base, all in SI."""
    works, end, feet, way = alike(*values)
    works = np.concatenate([works[:, :row], end[:, :1]], axis=1)
    inertia = np.concatenate([feet[:, :row], feet[:, :1]], axis=1) if feet.shape[1] > 1 else feet
    inertia = np.broadcast_to(inertia, works.shape)
    return Turns(motor, np.diff(works, axis=1), inertia, way[:, :1] / row)


@operation(
    symbol="nE1 + nE2 + nR2",
    across=True,
    everywhere=True,
    fails=WHOLE_ROW,
    why=said(
        "Over each interval the motor does the work of its mean moment, which depends on the speed sought: the "
        "parabola of the energy is crossed with the motor's curve, step by step."
    ),
)
def run_up(
    motor: Curve, start: Number, work: Length, end: Length, inertia: Length, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_J: Number, mu_phi: Number, *, row: int,
) -> Number:  # fmt: skip
    """From {start} on cross the parabola of each position with the motor's curve {motor}: its energy {it}."""
    values = (work * mu_A, end * mu_A, inertia * mu_J, base * mu_phi)
    own = turns_of(values, motor_of(motor, mu_M, mu_omega), row)
    found = [own.inertia[:, :1] * start[:, :1] ** 2 / 2.0]
    found += [energy for _, energy in islice(own.go(start[:, :1]), row - 1)]
    behind = np.full((len(own.gains), max(work.shape[1] - row, 0)), np.nan)
    return Number(np.concatenate([*alike(*found), behind], axis=1))


@operation(
    symbol="E1 + E2 + R2",
    across=True,
    fails=WHOLE_ROW,
    why=said(
        "The last interval ends at the end of the base, where the links stand as at its beginning."
    ),
)
def run_up_end(
    motor: Curve, of: Number, work: Length, end: Length, inertia: Length, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_J: Number, mu_phi: Number, *, row: int,
) -> Number:  # fmt: skip
    """From the last of {of} on cross the parabola once more with the motor's curve {motor}: {it}."""
    values = (work * mu_A, end * mu_A, inertia * mu_J, base * mu_phi)
    own, energy = turns_of(values, motor_of(motor, mu_M, mu_omega), row), of[:, row - 1 : row]
    omega = np.sqrt(np.maximum(2.0 * energy / own.inertia[:, row - 1 : row], 0.0))
    over = Interval(energy, own.gains[:, row - 1 : row], own.inertia[:, row : row + 1], own.way)
    after = _after(own.motor, np.where(energy >= 0.0, omega, np.nan), over)[1]
    return Number(after)


def _steady(own: Turns, omega: Reals) -> Reals:
    """Return the speed with which the row begins and ends, sought from a speed on by Steffensen's rule."""
    omega = np.broadcast_to(omega, (own.gains.shape[0], 1))
    before = first = omega
    for _ in range(ROUNDS):
        first = own.turn(omega)
        second = own.turn(first)
        bend = second - 2.0 * first + omega
        even = np.abs(bend) <= 1e-12 * np.abs(omega)
        better = omega - (first - omega) ** 2 / np.where(even, 1.0, bend)
        before, omega = omega, np.where(even | ~(better > 0.0), second, better)
        # each round squares what is off
        if not (np.abs(omega - before) > CLOSE * omega).any():
            break
    found = np.where(np.abs(first - before) < CLOSE * omega, omega, np.nan)
    # what drives a machine ever faster hardly changes its speed in a turn, either
    level = own.motor.rise[:, -1:] == 0.0
    return np.where(found > np.where(level, 1.0, FASTEST) * own.motor.omega[:, -1:], np.nan, found)


def _idle(motor: Motor) -> Reals:
    """Return the speed without load, up to a knot."""
    top = motor.omega.shape[1] - 1 - np.argmax(motor.moment[:, ::-1] > 0.0, axis=1)[:, None]
    return np.take_along_axis(motor.omega, top, axis=1)


@operation(
    symbol=FREE,
    across=True,
    fails=WHOLE_ROW,
    why=said(
        "A cycle is steady that ends with the speed with which it began: turn after turn it comes to it."
    ),
)
def steady_speed(
    motor: Curve, work: Length, end: Length, inertia: Length, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_J: Number, mu_phi: Number, *, row: int,
) -> Number:  # fmt: skip
    """Go over the row again and again by the motor's curve {motor}, to the speed {it} that comes back."""
    values = (work * mu_A, end * mu_A, inertia * mu_J, base * mu_phi)
    own = turns_of(values, motor_of(motor, mu_M, mu_omega), row)
    return Number(_steady(own, _idle(own.motor)))


@operation(
    symbol=FREE,
    across=True,
    fails="there is no steady cycle",
    why=said("Without a flywheel the steady cycle is so uneven."),
)
def unevenness_without(
    motor: Curve, work: Length, end: Length, inertia: Number, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_phi: Number, *, row: int,
) -> Number:  # fmt: skip
    """Of the steady cycle with {inertia} by the motor {motor} calculate how uneven it is: {it}."""
    values = (work * mu_A, end * mu_A, inertia, base * mu_phi)
    own = turns_of(values, motor_of(motor, mu_M, mu_omega), row)
    first = _steady(own, _idle(own.motor))
    return Number(uneven([first, *(omega for omega, _ in own.go(first))]))


@formula(
    holds="{alone} > {delta}",
    fails="no flywheel is needed: the cycle is even enough without one",
    why=said("So many times more even the flywheel has to make the cycle."),
)
def more_even(delta: Number, alone: Number) -> Number:
    """{alone}/{delta}"""


@operation(
    symbol=FREE,
    across=True,
    fails=_NONE_DOES,
    why=said(
        "A larger moment of inertia changes its speed less: what is added to that of the links is sought with "
        "which the steady cycle has the given δ."
    ),
)
def inertia_for(
    motor: Curve, delta: Number, work: Length, end: Length, inertia: Number, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_phi: Number, *, row: int,
) -> Number:  # fmt: skip
    """Seek {it} that with {inertia} makes the steady cycle by the motor {motor} as uneven as {delta}."""
    values = (work * mu_A, end * mu_A, inertia, base * mu_phi)
    own, due = turns_of(values, motor_of(motor, mu_M, mu_omega), row), 1.0 / delta[:, :1]
    start = _idle(own.motor)

    def even(more: Reals) -> Reals:
        nonlocal start
        run = own._replace(inertia=own.inertia + more)
        first = _steady(run, start)
        start = np.where(np.isfinite(first), first, start)
        return 1.0 / uneven([first, *(omega for omega, _ in run.go(first))])

    low = np.zeros_like(due + own.way)
    alone = even(low)
    step = np.max(own.inertia, axis=1, keepdims=True) * due / alone
    high, there, here = step, alone, even(step)
    for _ in range(ROUNDS):
        rise = np.where(here == there, 1.0, here - there)
        new = np.maximum(high + (due - here) * (high - low) / rise, 0.0)
        low, there, high, here = high, here, new, even(new)
        if not (np.abs(here - due) > 1e-9 * due).any():
            break
    close = (np.abs(here - due) < 1e-6 * due) & (alone < due)
    return Number(np.where(close, high, np.nan))


def uneven(speeds: Sequence[Reals]) -> Reals:
    """Return the coefficient of irregularity of speeds, (ω_max − ω_min)/ω_m; each (trial, 1)."""
    every = np.concatenate(alike(*speeds), axis=1)
    most, least = every.max(axis=1, keepdims=True), every.min(axis=1, keepdims=True)
    return np.asarray(2.0 * (most - least) / (most + least))


@operation(
    symbol=FREE,
    across=True,
    fails=WHOLE_ROW,
    why=said("By so much, of their mean, the greatest and the least speed differ."),
)
def unevenness(of: Number, end: Number, *, row: int) -> Number:
    """Of the speeds {of} and {end} calculate {it}, (ω_max − ω_min)/ω_m."""
    return Number(uneven([of[:, :row], end[:, :1]]))


@operation(
    symbol=FREE,
    across=True,
    fails=WHOLE_ROW,
    why=said("Turn after turn the machine gains speed, until it loses in a turn what it gains."),
)
def turns_to_run_up(
    motor: Curve, start: Number, work: Length, end: Length, inertia: Length, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_J: Number, mu_phi: Number,
    *, row: int, stride: int, cycles: int,
) -> Number:  # fmt: skip
    """From {start} on by {motor} count the cycles {it} until one changes the speed by less than 0.1 %."""
    values = (work * mu_A, end * mu_A, inertia * mu_J, base * mu_phi)
    own = turns_of(values, motor_of(motor, mu_M, mu_omega), row).thinned(stride)
    omega = np.broadcast_to(start[:, :1], (own.gains.shape[0], 1))
    found = np.full(omega.shape, np.nan)
    long = own.gains.shape[1] // cycles
    each = [
        own._replace(gains=own.gains[:, k : k + long], inertia=own.inertia[:, k : k + long + 1])
        for k in range(0, long * cycles, long)
    ]
    for k in range(MOST):
        after = each[k % cycles].turn(omega)
        found = np.where(
            np.isnan(found) & (np.abs(after - omega) < CLOSED * after), float(k), found
        )
        omega = after
        if not (np.isnan(found) & np.isfinite(omega)).any():
            break
    return Number(found)


@formula(why=said("A cycle takes so many turns."))
def turns_of_cycles(cycles: Number, turns: Number) -> Number:
    """{cycles}·{turns}"""
