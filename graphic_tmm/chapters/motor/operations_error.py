"""By how much a motion is off for the number of its positions: works and steps over some of them."""

from __future__ import annotations

from itertools import islice

import numpy as np

from graphic_tmm.board.grammar import CURVE, FREE, WHOLE_ROW, operation
from graphic_tmm.board.operations.graph_curves import taut_graph
from graphic_tmm.board.operations.graphs import alike
from graphic_tmm.board.values import Curve, Length, Number, Point, Reals
from graphic_tmm.chapters.motor.operations_curve import motor_of
from graphic_tmm.chapters.motor.operations_run import turns_of
from graphic_tmm.language.said import said

SLOW = 0.2
"""Below this share of the greatest speed an error is told of so much: near rest any is large of its own."""


@operation(
    symbol=CURVE,
    across=True,
    why=said("What every so many-th ordinate tells shows how much hangs on their number."),
)
def rough_graph(through: Point, over: Length, *, row: int, stride: int) -> Curve:
    """Through some of {through} draw the curve {it}, closed over {over}, as if there were no others."""
    found: Curve = taut_graph.run(Point(through[:, :row:stride]), over, row=row // stride)
    return found


def _areas(curve: Curve, row: int) -> Reals:
    """Return what lies below a closed graph up to the end of each interval."""
    x, y, rise = (
        part[:, 1 : row + 2] for part in (curve.knots.real, curve.knots.imag, curve.tangents.imag)
    )
    mean = (y[:, 1:] + y[:, :-1]) / 2.0 + (rise[:, :-1] - rise[:, 1:]) / 12.0
    return np.cumsum(np.diff(x, axis=1) * mean, axis=1)


def _reached(energies: Reals, row: int, stride: int) -> Reals:
    """Return the energies at every so many-th position that the machine reaches, at others NaN."""
    there = np.cumprod(~(energies[:, :row] < 0.0), axis=1, dtype=bool)
    return np.where(there, energies[:, :row], np.nan)[:, stride::stride]


def _largest(shares: Reals) -> Number:
    """Return the largest of those that are known; none where nothing was compared."""
    known = np.isfinite(shares).any(axis=1, keepdims=True)
    most = np.nanmax(np.where(known, shares, 0.0), axis=1, keepdims=True)
    return Number(np.where(known, most, np.nan))


@operation(
    symbol=FREE,
    across=True,
    fails=WHOLE_ROW,
    why=said(
        "The works of both curves differ by some times what the finer one is off; ω by half as much as T."
    ),
)
def error_of_works(
    fine: Curve, rough: Curve, of: Number, mu_M: Number, mu_phi: Number, *, row: int, stride: int
) -> Number:
    """From the works below {fine} and {rough}, as shares of {of}, ω errs by {it} %."""
    apart = _areas(fine, row)[:, stride - 1 :: stride] - _areas(rough, row // stride)
    energy = _reached(of, row, stride)
    most = np.nanmax(energy, axis=1, keepdims=True, initial=0.0)
    size = np.where(most > 0.0, np.maximum(energy, SLOW**2 * most), np.nan)
    apart, size = alike(apart[:, :-1] * mu_M[:, :1] * mu_phi[:, :1], size)
    share = 100.0 * np.abs(apart) / (2.0 * size) / (stride**2 - 1.0)
    return _largest(share)


@operation(
    symbol=FREE,
    across=True,
    fails=WHOLE_ROW,
    why=said(
        "Wider steps err by the square of their width more; from rest, where ω grows as a root, by their width."
    ),
)
def error_of_steps(
    motor: Curve, start: Number, work: Length, end: Length, inertia: Length, base: Length,
    mu_M: Number, mu_omega: Number, mu_A: Number, mu_J: Number, mu_phi: Number, of: Number,
    *, row: int, stride: int,
) -> Number:  # fmt: skip
    """Go from {start} by {motor} over several intervals at a time: from that and {of}, ω errs by {it} %."""
    values = (work * mu_A, end * mu_A, inertia * mu_J, base * mu_phi)
    own = turns_of(values, motor_of(motor, mu_M, mu_omega), row)
    run = islice(own.thinned(stride).go(start[:, :1]), row // stride - 1)
    rough, heavy = (
        np.concatenate(alike(*(omega for omega, _ in run)), axis=1),
        own.inertia[:, stride:row:stride],
    )
    omega = np.sqrt(2.0 * _reached(of, row, stride) / heavy)
    most = np.nanmax(omega, axis=1, keepdims=True, initial=0.0)
    size = np.where(most > 0.0, np.maximum(omega, SLOW * most), np.nan)
    wider = np.where(start[:, :1] > 0.0, stride**2 - 1.0, stride - 1.0)
    share = 100.0 * np.abs(rough - omega) / size / wider
    return _largest(share)
