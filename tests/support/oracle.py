"""An independent judge of the plans: vector loops, Newton, and the constraint Jacobian.

Unknown are the poses (x, y, θ) of all moving links. The equations: letters that links share
coincide, a slider keeps its direction and its offset to the guide, the crank stands at the angle
given. They are differentiated by hand (J·q' = -∂C/∂t, J·q'' = -γ). Nothing of the board or the
plans is used: only the records are read. SI units; inside, lengths are divided by a power of two
near the mechanism's size. The crank's angle is in degrees, from the x axis, counter-clockwise.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import mpmath  # type: ignore[import-untyped]
import numpy as np
from numpy.typing import NDArray

from graphic_tmm.mechanism.records import Link, Mechanism
from support.oracle_gears import Gears, OracleError, angles_of_wheels, crank_letters, gears_of

Pose = tuple[float, float, float]
Numbers = NDArray[Any]  # float64, or objects that are mpmath numbers
Places = NDArray[np.intp]
Turns = Mapping[int, float]  # of links by number: rad, rad/s or rad/s²


class Motion(NamedTuple):
    """A point: position (m), velocity (m/s), acceleration (m/s²), complex in the sheet's axes."""

    r: complex
    v: complex
    a: complex


class Rates(NamedTuple):
    """Poses and their time derivatives, each (links + 1, 3), row 0 the frame; lengths in sizes."""

    q: Numbers
    dq: Numbers
    ddq: Numbers


@dataclass(frozen=True)
class State:
    """A solved position.

    ``phi`` is the crank's angle (degrees), ``pose`` (x m, y m, θ rad), ``omega`` (rad/s) and
    ``epsilon`` (rad/s²) go by link number, the frame's are 0. ``points`` go by letter, or by
    (letter, link): the point of that link which now lies at the letter. ``rates`` has lengths in
    units of ``size`` (m) and rows in the order frame, links of the mechanism.
    """

    mechanism: Mechanism
    phi: float
    size: float
    rates: Rates
    pose: Mapping[int, Pose]
    omega: Turns
    epsilon: Turns
    points: Mapping[str | tuple[str, int], Motion]

    @cached_property
    def condition(self) -> float:
        """Condition number of the Jacobian (lengths in sizes); large near a dead centre."""
        system, q = system_of(self.mechanism), np.asarray(self.rates.q, dtype=float)
        return float(np.linalg.cond(equations(system, q, math.radians(self.phi))[1]))


class System(NamedTuple):
    """The constraint equations of a mechanism in one arithmetic; lengths in units of ``size``.

    Points ``arms[:2]`` of links ``pins[0]`` and ``arms[2:]`` of links ``pins[1]`` coincide. Links
    ``slides[0]`` are turned by ``turn`` against links ``slides[1]``; their origins lie ``rise`` to
    the left of the line of direction ``alpha`` through the origins of links ``slides[1]``. The line
    from the crank's pivot to its driven letter stands at ``own`` in its own axes.
    """

    size: float
    pi: Any
    crank: int
    own: Any
    pins: Places
    arms: Numbers
    slides: Places
    alpha: Numbers
    turn: Numbers
    rise: Numbers
    gears: Gears


def _cos_sin(angles: Numbers) -> tuple[Numbers, Numbers]:
    if angles.dtype != object:
        return np.cos(angles), np.sin(angles)
    cos, sin = np.frompyfunc(mpmath.cos, 1, 1), np.frompyfunc(mpmath.sin, 1, 1)
    return cos(angles), sin(angles)


def _solved(matrix: Numbers, right: Numbers) -> Numbers:
    try:
        if matrix.dtype != object and len(matrix) == len(matrix.T):
            return np.asarray(np.linalg.solve(matrix, right))
        if matrix.dtype != object:  # of a passive link: more equations, which agree
            return np.asarray(np.linalg.lstsq(matrix, right, rcond=None)[0])
        found = mpmath.lu_solve(mpmath.matrix(matrix.tolist()), mpmath.matrix(right.tolist()))
        return np.array(list(found), dtype=object)
    except (np.linalg.LinAlgError, ZeroDivisionError) as error:
        raise OracleError("the position is singular") from error


def _size(links: tuple[Link, ...]) -> float:
    own = [list(link.points.values()) for link in links]
    return math.ldexp(1.0, math.frexp(max(abs(a - b) for p in own for a in p for b in p))[1])


def system_of(mechanism: Mechanism, *, digits: bool = False) -> System:
    """Write down the equations (more of a passive link); OracleError if fewer than the unknowns.

    In float64, or with mpmath numbers in the precision that is set.
    """
    links = (mechanism.frame, *mechanism.links)
    place, size = {link.number: index for index, link in enumerate(links)}, _size(links)
    pins: list[tuple[int, int]] = []
    arms: list[tuple[float, ...]] = []
    for letter in dict.fromkeys(letter for link in links for letter in link.points):
        first, *rest = [i for i, link in enumerate(links) if letter in link.points]
        o = links[first].points[letter] / size
        for i, p in ((i, links[i].points[letter] / size) for i in rest):
            pins.append((i, first))
            arms.append((p.real, p.imag, o.real, o.imag))
    slides = [(i, slide) for i, link in enumerate(links) for slide in link.slides]
    rows, unknowns = 2 * (len(pins) + len(slides)) + 1, 3 * len(mechanism.links)
    rows += len(mechanism.meshes)
    if rows < unknowns:
        raise OracleError(f"{rows} equations for {unknowns} unknowns")

    def numbers(values: Sequence[float]) -> Numbers:
        return np.array([mpmath.mpf(v) for v in values]) if digits else np.array(values, float)

    pi, atan2 = (+mpmath.pi, mpmath.atan2) if digits else (math.pi, math.atan2)
    alpha = numbers([slide.guide.angle for _, slide in slides]) * (pi / 180)
    turn = alpha + numbers([slide.angle for _, slide in slides]) * (pi / 180)
    gx = numbers([slide.guide.through.real / size for _, slide in slides])
    gy = numbers([slide.guide.through.imag / size for _, slide in slides])
    rise = numbers([slide.offset / size for _, slide in slides])  # from `through`, at first
    cos, sin = _cos_sin(alpha)
    crank = mechanism.by_number[mechanism.drive.link]
    pivot, driven = (crank.points[letter] for letter in crank_letters(mechanism))
    dx, dy = numbers([driven.real, driven.imag]) - numbers([pivot.real, pivot.imag])
    on = np.array([(i, place[slide.on]) for i, slide in slides], dtype=np.intp).reshape(-1, 2).T
    both, offsets = np.array(pins, dtype=np.intp).T, rise + gy * cos - gx * sin
    own, points = atan2(dy, dx), np.array([numbers(arm) for arm in arms]).T
    gears = gears_of(mechanism, place, numbers, pi)
    return System(size, pi, place[crank.number], own, both, points, on, alpha, turn, offsets, gears)


def _vectors(system: System, q: Numbers) -> tuple[Numbers, ...]:
    """Both arms of every pin, every guide's direction u, slider's origin from its guide's link."""
    (i, k), (px, py, ox, oy), (si, ki), (x, y, t) = system.pins, system.arms, system.slides, q.T
    cos, sin = _cos_sin(t)
    a = (cos[i] * px - sin[i] * py, sin[i] * px + cos[i] * py)
    b = (cos[k] * ox - sin[k] * oy, sin[k] * ox + cos[k] * oy)
    u = _cos_sin(t[ki] + system.alpha)
    return *a, *b, *u, x[si] - x[ki], y[si] - y[ki]


def equations(system: System, q: Numbers, phi: Any) -> tuple[Numbers, Numbers]:
    """Residuals, shape (3n,), and Jacobian, shape (3n, 3n), at the poses q, shape (n + 1, 3).

    Rows: the x of all pins, their y, the slides' angles, the slides' offsets, the wheels, the crank.
    """
    (i, k), (si, ki), (x, y, t) = system.pins, system.slides, q.T
    ax, ay, bx, by, ux, uy, dx, dy = _vectors(system, q)
    crank = np.atleast_1d(t[system.crank] + system.own - phi)
    turned = t[si] - t[ki] - system.turn
    angles = np.concatenate([turned, system.gears.residual(t), crank])
    full = 2 * system.pi
    angles = angles - full * np.rint(np.asarray(angles / full, dtype=float)).astype(int)
    pins = (x[i] + ax - x[k] - bx, y[i] + ay - y[k] - by)
    sliding = len(si)
    offsets = ux * dy - uy * dx - system.rise
    residual = np.concatenate([*pins, angles[:sliding], offsets, angles[sliding:]])
    jacobian = np.zeros((len(residual), q.size), dtype=q.dtype)
    row = np.arange(len(i))
    jacobian[row, 3 * i], jacobian[row, 3 * k] = 1, -1
    jacobian[row, 3 * i + 2], jacobian[row, 3 * k + 2] = -ay, by
    row = row + len(i)
    jacobian[row, 3 * i + 1], jacobian[row, 3 * k + 1] = 1, -1
    jacobian[row, 3 * i + 2], jacobian[row, 3 * k + 2] = ax, -bx
    row = 2 * len(i) + np.arange(len(si))
    jacobian[row, 3 * si + 2], jacobian[row, 3 * ki + 2] = 1, -1
    row = row + len(si)
    jacobian[row, 3 * si], jacobian[row, 3 * ki] = -uy, uy
    jacobian[row, 3 * si + 1], jacobian[row, 3 * ki + 1] = ux, -ux
    jacobian[row, 3 * ki + 2] = -(ux * dx + uy * dy)
    system.gears.enter(jacobian, 2 * (len(i) + len(si)))
    jacobian[-1, 3 * system.crank + 2] = 1
    return residual, jacobian[:, 3:]


def quadratic(system: System, q: Numbers, dq: Numbers) -> Numbers:
    """γ, shape (3n,): the terms of the twice differentiated equations that are free of q''."""
    (i, k), (si, ki), (vx, vy, w) = system.pins, system.slides, dq.T
    ax, ay, bx, by, ux, uy, dx, dy = _vectors(system, q)
    along, wk = ux * (vx[si] - vx[ki]) + uy * (vy[si] - vy[ki]), w[ki]
    pins = (w[k] * w[k] * bx - w[i] * w[i] * ax, w[k] * w[k] * by - w[i] * w[i] * ay)
    offsets = -2 * wk * along - wk * wk * (ux * dy - uy * dx)
    rolled = 0 * w[system.gears.first]
    return np.concatenate([*pins, 0 * wk, offsets, rolled, 0 * w[[system.crank]]])


def newton(system: System, phi: Any, start: Numbers, close: float = 1e-9) -> Numbers:
    """Poses that close the loops, found from ``start``; done when a step is below ``close``."""
    q: Numbers = np.array(start)
    for _ in range(60):
        residual, jacobian = equations(system, q, phi)
        step = _solved(jacobian, -residual)
        longest = float(max(abs(step)))
        if not math.isfinite(longest):
            break
        q[1:] += step.reshape(-1, 3) / max(longest, 1.0)
        if longest < close:
            return q
    raise OracleError(f"the loops do not close at {math.degrees(float(phi)):.6g} degrees")


def rates(mechanism: Mechanism, system: System, q: Numbers, phi: Any) -> Rates:
    """Derive q' and q'' from the Jacobian; of the equations only the crank's knows the time."""
    _, jacobian = equations(system, q, phi)
    dq, ddq = 0 * q, 0 * q
    right = 0 * jacobian[:, 0]
    right[-1] = mechanism.drive.speed
    dq[1:] = _solved(jacobian, right).reshape(-1, 3)
    right = -quadratic(system, q, dq)
    right[-1] = mechanism.drive.acceleration
    ddq[1:] = _solved(jacobian, right).reshape(-1, 3)
    return Rates(q, dq, ddq)


def _state(mechanism: Mechanism, phi_deg: float, size: float, found: Rates) -> State:
    rows = (np.asarray(part, dtype=float).tolist() for part in found)
    q, dq, ddq = (dict(zip(mechanism.by_number, part, strict=True)) for part in rows)
    points: dict[str | tuple[str, int], Motion] = {}
    for owner in mechanism.by_number.values():
        x, y, turn = q[owner.number]
        for letter, own in owner.points.items():
            place = complex(x, y) * size + own * cmath.rect(1.0, turn)
            for n in q:
                arm = place - complex(*q[n][:2]) * size
                v = complex(*dq[n][:2]) * size + 1j * dq[n][2] * arm
                a = complex(*ddq[n][:2]) * size + (1j * ddq[n][2] - dq[n][2] ** 2) * arm
                points[letter, n] = Motion(place, v, a)
            points.setdefault(letter, points[letter, owner.number])
    pose = {n: (x * size, y * size, turn) for n, (x, y, turn) in q.items()}
    omega, epsilon = {n: dq[n][2] for n in q}, {n: ddq[n][2] for n in q}
    return State(mechanism, phi_deg, size, found, pose, omega, epsilon, points)


def _array(mechanism: Mechanism, start: Mapping[int, Pose], size: float) -> Numbers:
    rows = [(0.0, 0.0, 0.0), *(start[link.number] for link in mechanism.links)]
    return np.array([(x / size, y / size, t) for x, y, t in rows])


def solve_fast(mechanism: Mechanism, phi_deg: float, start: Mapping[int, Pose]) -> State:
    """Solve a position in float64 (about a millisecond), from poses near to it."""
    system, phi = system_of(mechanism), math.radians(phi_deg)
    q = newton(system, phi, _array(mechanism, start, system.size))
    return _state(mechanism, phi_deg, system.size, rates(mechanism, system, q, phi))


def solve_digits(
    mechanism: Mechanism, phi: Callable[[], Any], start: Mapping[int, Pose], *, dps: int = 30
) -> Rates:
    """Solve with ``dps`` digits and keep them: mpmath numbers, lengths in units of the size.

    ``phi`` is called within that precision and gives the crank's angle in rad.
    """
    quick = system_of(mechanism)
    begin = _array(mechanism, start, quick.size)
    with mpmath.workdps(dps + 5):
        system, angle = system_of(mechanism, digits=True), phi()
        with suppress(OracleError):  # too near a singular position: all the way in digits
            begin = newton(quick, float(angle), begin)
        lifted = np.array([mpmath.mpf(v) for v in begin.ravel().tolist()], dtype=object)
        q = newton(system, angle, lifted.reshape(-1, 3), 10.0 ** (-dps / 2 - 2))
        return rates(mechanism, system, q, angle)


def solve(
    mechanism: Mechanism, phi_deg: float, start: Mapping[int, Pose], *, dps: int = 30
) -> State:
    """Solve a position with ``dps`` digits, from poses (x m, y m, θ rad) by link number near to it.

    Which assembly is found depends on the start only; raises OracleError if none is.
    """
    found = solve_digits(mechanism, lambda: phi_deg * mpmath.pi / 180, start, dps=dps)
    return _state(mechanism, phi_deg, _size((mechanism.frame, *mechanism.links)), found)


def _turned(link: Link, points: Mapping[str, complex], size: float) -> float | None:
    """Angle of a link, from two or more of its points where known (best fit); else None."""
    known = [letter for letter in link.points if letter in points]
    if len(known) < 2:
        return None
    own, seen = (np.array([source[letter] for letter in known]) for source in (link.points, points))
    fit = complex(np.sum(np.conj(own - own.mean()) * (seen - seen.mean())))
    return math.atan2(fit.imag, fit.real) if abs(fit) > (1e-6 * size) ** 2 else None


def _angles(
    mechanism: Mechanism, points: Mapping[str, complex], known: Turns, size: float
) -> dict[int, float]:
    angles = dict(known)
    for link in mechanism.links:
        if (angle := _turned(link, points, size)) is not None:
            angles.setdefault(link.number, angle)
    pairs = [(a, s) for a in mechanism.by_number.values() for s in a.slides]
    for link, slide in pairs * len(pairs):
        ahead = math.radians(slide.guide.angle + slide.angle)
        if slide.on in angles:
            angles.setdefault(link.number, angles[slide.on] + ahead)
        elif link.number in angles:
            angles[slide.on] = angles[link.number] - ahead
    angles = angles_of_wheels(mechanism, angles)
    missing = sorted(set(mechanism.by_number) - set(angles))
    if missing:
        raise OracleError(f"the points do not tell how links {missing} are turned")
    return angles


def poses_from_points(
    mechanism: Mechanism, phi_deg: float, points: Mapping[str, complex], angles: Turns | None = None
) -> dict[int, Pose]:
    """Poses that fit approximate places (m) of named points; unknown letters raise OracleError.

    Angles come from ``angles`` (rad), from two known points of a link, else from its sliding pair;
    origins from least squares of points and loops. A link of a single known point needs a sliding
    pair to a link of known angle, or its angle.
    """
    links = mechanism.by_number.values()
    strange = sorted(set(points) - {letter for link in links for letter in link.points})
    if strange or not np.all(np.isfinite(list(points.values()))):
        raise OracleError(f"letters on no link: {strange}, or points that are not numbers")
    system, phi = system_of(mechanism), math.radians(phi_deg)
    known = {mechanism.frame.number: 0.0, mechanism.drive.link: phi - system.own}
    turns = _angles(mechanism, points, known | dict(angles or {}), system.size)
    q = np.array([(0.0, 0.0, turns[link.number]) for link in links])
    residual, jacobian = equations(system, q, phi)
    # the equations are linear in the origins once the angles are known; one row a known coordinate
    linear = jacobian.reshape(len(residual), -1, 3)[:, :, :2].reshape(len(residual), -1)
    rows, right = [*linear], [*-residual]
    for i, link in enumerate(mechanism.links):
        for letter in (letter for letter in link.points if letter in points):
            place = points[letter] - link.points[letter] * cmath.rect(1.0, turns[link.number])
            rows += [*np.eye(linear.shape[1])[[2 * i, 2 * i + 1]]]
            right += [place.real / system.size, place.imag / system.size]
    origins = np.linalg.lstsq(np.array(rows), np.array(right), rcond=None)[0].reshape(-1, 2)
    return {
        link.number: (x * system.size, y * system.size, turns[link.number])
        for link, (x, y) in zip(mechanism.links, origins.tolist(), strict=True)
    }


def solve_from_points(
    mechanism: Mechanism,
    phi_deg: float,
    points: Mapping[str, complex],
    angles: Turns | None = None,
    tolerance: float = 1e-3,
) -> State:
    """Solve near approximate places (m) of named points, and see that it is the position meant.

    In float64 (for digits, go on with `solve` from the pose found). Raises OracleError where the
    loops do not close, or where a point has to move by more than ``tolerance`` of the size from the
    place given (or a link to turn by more than 0.05 rad).
    """
    start = poses_from_points(mechanism, phi_deg, points, angles)
    state = solve_fast(mechanism, phi_deg, start)
    for letter in sorted(points):
        if not (moved := abs(state.points[letter].r - points[letter])) <= tolerance * state.size:
            raise OracleError(f"{letter} lies {moved:.3g} m from its given place at {phi_deg:.6g}")
    for number, (*_, angle) in start.items():
        turned = math.remainder(state.pose[number][2] - angle, 2 * math.pi)
        if not abs(turned) <= 0.05:
            raise OracleError(f"link {number} stands {turned:.3g} rad off the places given")
    return state
