"""Plans judged at 50 digits, against bounds that follow from the conditions of their own steps.

A step rounds a few times and magnifies what comes in by its condition κ; steps of a chain multiply. With
u = 8·ε·(steps), l the shortest leg, Ω and E the largest rates, V and A the longest vectors of the plans:

    e_p = (min(u·κ_r, 4·√u) + u·size/d)·size    a root taken of a rounding is not further off than √u;
                                                 centres d apart tell no better which way they lie
    e_r = g·e_p                                  g ≥ 1: how much further than its leg a link reaches
    e_v = g·κ_v·(u·V + (Ω + s·V/l)·e_p)          lines of the plan of velocities are turned by e_p/l
    e_ω = (2·e_v/g + Ω·e_p)/l + u·Ω
    e_a = g·κ_a·(u·A + (Ω² + E + s·A/l)·e_p + 2·Ω·e_v/g + 2·s·V·e_ω)
    e_ε = (2·e_a/g + E·e_p)/l + u·E              s = 1 where a guide turns, else 0
"""

from __future__ import annotations

from typing import Any, NamedTuple

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.findings import Finding, examine
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.operations.instruments import cylinder_axis, rocker_line
from graphic_tmm.board.values import Arc
from graphic_tmm.chapters.kinematics.closings import PinLeg
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.mechanism.records import Mechanism
from support import oracle
from support.drawn import Board, board
from support.hard_mechanisms import closed, side_at

DIGITS = 50
NAMES = ("r", "v", "a")


class Exact(NamedTuple):
    """Points (r, v, a) by (letter, link), ω and ε by link, in digits; SI."""

    points: dict[tuple[str, int], tuple[Any, Any, Any]]
    omega: dict[int, Any]
    epsilon: dict[int, Any]


class Verdict(NamedTuple):
    """Of one position: errors as shares of their bounds by name, conditions by plan, findings by kind.

    ``sizes``: the largest quantity of each name, against which an error counts.
    """

    shares: dict[str, float]
    bounds: dict[str, float]
    sizes: dict[str, float]
    conditions: tuple[float, float, float]
    findings: tuple[Finding, ...]

    @property
    def off(self) -> float:
        """The largest error of what is there, as a share of the largest quantity of its name."""
        there = (name for name, share in self.shares.items() if np.isfinite(share))
        return max((self.shares[n] * self.bounds[n] / self.sizes[n] for n in there), default=0.0)

    @property
    def kinds(self) -> set[str]:
        return {finding.kind for finding in self.findings}


def exact_of(mechanism: Mechanism, found: oracle.Rates) -> Exact:
    """Return the motion of every point of every link, in the set precision."""
    size = oracle.system_of(mechanism).size
    points, omega, epsilon = {}, {}, {}
    for row, link in enumerate((mechanism.frame, *mechanism.links)):
        (x, y, t), (vx, vy, w), (ax, ay, e) = (part[row] for part in found)
        omega[link.number], epsilon[link.number] = w, e
        for letter, z in link.points.items():
            arm = mp.mpc(z.real, z.imag) * mp.expj(t)
            r = mp.mpc(x, y) * size + arm
            v = mp.mpc(vx, vy) * size + mp.mpc(0, w) * arm
            a = mp.mpc(ax, ay) * size + mp.mpc(-w * w, e) * arm
            points[letter, link.number] = (r, v, a)
    return Exact(points, omega, epsilon)


def exactly(mechanism: Mechanism, degrees: float) -> Exact | None:
    """Return the motion of a mechanism of `hard_mechanisms`; None where it locks.

    Raises ``oracle.OracleError`` where the position stands but its velocities do not exist.
    """
    with mp.workdps(DIGITS + 5):
        phi = mp.mpf(degrees) * mp.pi / 180
        places = closed(mechanism, phi, side_at(mechanism, degrees))
        if places is None:
            return None
        system = oracle.system_of(mechanism, digits=True)
        q = np.array([[mp.mpf(0)] * 3 for _ in range(len(mechanism.links) + 1)], dtype=object)
        for row, link in enumerate(mechanism.links, 1):
            z, along = places[link.number]
            q[row] = [z.real / system.size, z.imag / system.size, mp.arg(along)]
        return exact_of(mechanism, oracle.rates(mechanism, system, q, phi))


def _given(sheet: Board, degrees: float) -> dict[Any, Any]:
    angles = np.array([[degrees]])
    return sheet.given | {sheet.positions.row[0]: angles} | standing(sheet, angles)


def _conditions(sheet: Board, reading: Any) -> tuple[float, float, float]:
    """Return the product of the conditions of the steps of each plan.

    That of a rocker's line is counted where the length from pivot to stone is.
    """
    found = {"positions": 1.0, "velocities": 1.0, "accelerations": 1.0}
    with np.errstate(all="ignore"):
        for step in sheet.log.steps:
            if step.op.condition is not None and step.op not in (rocker_line, cylinder_axis):
                value = step.op.condition(*(reading[mark] for mark in step.uses))
                found[step.it.view] *= max(1.0, float(np.ravel(value)[0]))
    r, v, a = found.values()
    return r, v, a


def _near(values: Any) -> float:
    """Return how far apart the centres of two arcs are; without end if a step does not cross arcs."""
    ends = [complex(np.ravel(v.centre)[0]) for v in values if isinstance(v, Arc)]
    return abs(ends[1] - ends[0]) if len(ends) == 2 else float("inf")


def _legs(sheet: Board, reading: Any, mechanism: Mechanism) -> tuple[float, float]:
    """Return the length of the shortest leg that turns, m, and how many times a link reaches further."""
    short, reach = float("inf"), 1.0
    for leg in (leg for c in sheet.positions.closings for leg in c.legs):
        if isinstance(leg, PinLeg):
            own = [*mechanism.by_number[leg.link].points.values()]
            length = abs(float(np.ravel(reading[leg.length])[0])) * sheet.mu[0] + 1e-300
            short = min(short, length)
            reach = max([reach, *(abs(a - b) / length for a in own for b in own)])
    return (short if np.isfinite(short) else 1.0), reach


def _bounds(
    sheet: Board, reading: Any, due: Exact, kappa: tuple[float, ...]
) -> tuple[dict[str, float], dict[str, float]]:
    """Return the bounds of all errors and the largest quantities, both by name."""
    u = 8 * EPS * len(sheet.log.steps)
    mechanism = sheet.mechanism
    own = max(abs(z) for link in mechanism.links for z in link.points.values())
    o = mechanism.frame.points[sheet.structure.origin]
    size = max(float(abs(r - mp.mpc(o))) for r, _, _ in due.points.values()) + own
    driven = [n for n in due.omega if n != mechanism.drive.link]
    rate = max(float(abs(due.omega[n])) for n in driven)
    turning = max(float(abs(due.epsilon[n])) for n in driven)
    fast = max(float(abs(v)) for _, v, _ in due.points.values()) + rate * own
    pull = max(float(abs(a)) for _, _, a in due.points.values())
    pull += (turning + rate**2) * own + 2 * (rate + abs(mechanism.drive.speed)) * fast
    arm, g = _legs(sheet, reading, mechanism)
    s = 1.0 / arm if _slides(sheet) else 0.0
    roots = [sheet.log.step(closing.root) for closing in sheet.positions.closings]
    d = min(_near([reading[m] for m in step.uses]) for step in roots if step) * sheet.mu[0] + 1e-300
    e_p = (min(u * kappa[0], 4 * u**0.5) + u * size / d) * size
    e_v = kappa[1] * (u * fast + (rate + s * fast) * e_p)
    e_w = (2 * e_v + rate * e_p) / arm + u * rate
    e_a = (rate**2 + turning + s * pull) * e_p + 2 * rate * e_v + 2 * s * arm * fast * e_w
    e_a = kappa[2] * (u * pull + e_a)
    e_e = (2 * e_a + turning * e_p) / arm + u * turning
    crank = abs(mechanism.drive.speed)
    sizes = {"r": size, "v": fast, "a": pull, "omega": max(rate, crank)}
    sizes["epsilon"] = max(turning, sizes["omega"] ** 2)
    # a translated frame: what is read is the sum of two places
    bounds = {
        "r": g * e_p + 4 * EPS * abs(o),
        "v": g * e_v,
        "a": g * e_a,
        "omega": e_w,
        "epsilon": e_e,
    }
    return bounds, sizes


def _slides(sheet: Board) -> list[int]:
    """Return the links whose guides turn: only there is a Coriolis term."""
    frame = sheet.mechanism.frame.number
    return [s.on for link in sheet.mechanism.links for s in link.slides if s.on != frame]


def judge(
    mechanism: Mechanism, degrees: float, due: Exact | None = None, *, turned: bool = False
) -> Verdict:
    """Draw a position and judge it; `due` is found by `exactly` if it is not given.

    A value that is not there counts as a share of infinity, unless a finding names why; that a position is
    drawn which does not exist counts so too, unless the figures touch.
    """
    size = oracle.system_of(mechanism).size
    mu = (size / 128, size / 128, size / 64)
    sheet = board(mechanism, turned=turned, mu=mu)
    read = sheet.read([[degrees]])
    given = _given(sheet, degrees)
    reading = execute(sheet.log, given)
    wanted = [step.it for step in sheet.log.steps]
    findings = examine(sheet.log, given, wanted)
    kappa = _conditions(sheet, reading)
    if due is None:
        try:
            due = exactly(mechanism, degrees)
        except oracle.OracleError:
            return Verdict({}, {}, {}, kappa, findings)
    if due is None:
        return Verdict({}, {}, {}, kappa, findings)
    bounds, sizes = _bounds(sheet, reading, due, kappa)
    shares = dict.fromkeys(bounds, 0.0)
    for (letter, number), motion in due.points.items():
        if number == mechanism.frame.number:
            continue
        for name, value in zip(NAMES, motion, strict=True):
            shares[name] = max(
                shares[name], _share(read[name][letter, number], value, bounds[name])
            )
    for name, row in (("omega", due.omega), ("epsilon", due.epsilon)):
        for number, value in row.items():
            at = read[name].get(number, np.zeros(1))
            shares[name] = max(shares[name], _share(at, value, bounds[name]))
    return Verdict(shares, bounds, sizes, kappa, findings)


def _share(found: Any, due: Any, bound: float) -> float:
    """Return the error as a share of its bound; without end where there is no value, or no bound."""
    z = complex(np.ravel(found)[0])
    if not (np.isfinite(z.real) and np.isfinite(z.imag) and np.isfinite(bound)):
        return float("inf")
    return float(abs(mp.mpc(z) - due) / bound)


def named(verdict: Verdict) -> bool:
    """Whether a finding names that the position cannot be drawn, or stands at the edge of it."""
    return bool(verdict.kinds & {"undrawn", "touching", "doubtful"})


def right(verdict: Verdict) -> bool:
    """Whether everything is right within its bound, or a finding names why it is not there.

    A share above 1 is never excused; one without end is, where a finding names it.
    """
    shares = list(verdict.shares.values()) or [float("inf")]
    finite = [share for share in shares if np.isfinite(share)]
    return max(finite, default=0.0) <= 1.0 and (len(finite) == len(shares) or named(verdict))
