"""An independent judge of the plans: vector loops, Newton, and the constraint Jacobian.

Unknown are the poses (x, y, θ) of all moving links. The equations: letters that links share coincide,
a slider keeps its direction and its offset to the guide, the crank stands at the angle given. They are
differentiated by hand (J·q' = -∂C/∂t, J·q'' = -γ); `test_oracle_self` holds that against differences.
Nothing here looks at the board or at the plans: only the records of a mechanism are read.

Lengths are divided by a power of two near the mechanism's size, so metres and radians are of one order.
SI units; the crank's angle in degrees, from the sheet's x axis, counter-clockwise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import mpmath
import numpy as np
from numpy.typing import NDArray

from graphic_tmm.mechanism.records import Link, Mechanism, Slide

Pose = tuple[float, float, float]
Numbers = NDArray[Any]  # float64, or objects that are mpmath numbers


class OracleError(Exception):
    """The loops do not close, or closed somewhere else than the caller said."""


class Motion(NamedTuple):
    """A point: position (m), velocity (m/s), acceleration (m/s²), complex in the sheet's axes."""

    r: complex
    v: complex
    a: complex


class Rates(NamedTuple):
    """Poses with their first and second time derivatives, each of shape (links + 1, 3); row 0: the frame.

    Lengths in units of ``System.size``.
    """

    q: Numbers
    dq: Numbers
    ddq: Numbers


class Points(Mapping[str | tuple[str, int], Motion]):
    """Motion by letter, or by (letter, link): the point of that link which now lies at the letter."""

    def __init__(self, mechanism: Mechanism, poses: Mapping[int, tuple[Motion, Motion]]) -> None:
        self._poses = poses
        self._owner: dict[str, Link] = {}
        for link in (mechanism.frame, *mechanism.links):
            for letter in link.points:
                self._owner.setdefault(letter, link)

    def __getitem__(self, key: str | tuple[str, int]) -> Motion:
        letter, number = key if isinstance(key, tuple) else (key, self._owner[key].number)
        owner = self._owner[letter]
        at, turn = self._poses[owner.number]
        place = at.r + owner.points[letter] * turn.r
        origin, spin = self._poses[number]
        arm = place - origin.r
        return Motion(place, origin.v + arm * spin.v, origin.a + arm * spin.a)

    def __iter__(self) -> Iterator[str]:
        return iter(self._owner)

    def __len__(self) -> int:
        return len(self._owner)


@dataclass(frozen=True)
class State:
    """A solved position.

    Attributes
    ----------
    phi : the crank's angle, degrees.
    pose : by link number, (x m, y m, θ rad).
    omega, epsilon : by link number, rad/s and rad/s²; the frame's are 0.
    points : Motion by letter or (letter, link).
    rates : q, q', q'' in units of `size`, as the frame and the links stand in the mechanism.
    condition : condition number of the Jacobian (lengths in units of `size`); large near a dead centre.
    """

    mechanism: Mechanism
    phi: float
    size: float
    rates: Rates
    pose: Mapping[int, Pose]
    omega: Mapping[int, float]
    epsilon: Mapping[int, float]
    points: Points

    @cached_property
    def condition(self) -> float:
        system, q = system_of(self.mechanism, FLOAT), np.asarray(self.rates.q, dtype=float)
        return float(np.linalg.cond(equations(system, q, math.radians(self.phi), FLOAT)[1]))


class Crank(NamedTuple):
    """Index of the driving link, its fixed pivot and its driven letter."""

    index: int
    pivot: str
    driven: str


class System(NamedTuple):
    """The constraint equations of a mechanism in one arithmetic; lengths in units of `size`.

    Pins: points (px, py) of link pi and (ox, oy) of link oi coincide. Slides: link si turns with link ki,
    ahead of it by `turn`; its origin lies `rise` to the left of the line of direction `alpha` through the
    origin of link ki. The crank's own line of pins stands at `own`.
    """

    size: float
    crank: int
    own: Any
    pi: NDArray[np.intp]
    oi: NDArray[np.intp]
    px: Numbers
    py: Numbers
    ox: Numbers
    oy: Numbers
    si: NDArray[np.intp]
    ki: NDArray[np.intp]
    alpha: Numbers
    turn: Numbers
    rise: Numbers


class Arithmetic(NamedTuple):
    """What differs between float64 and mpmath."""

    number: Callable[[Any], Any]
    cos: Callable[[Numbers], Numbers]
    sin: Callable[[Numbers], Numbers]
    atan2: Callable[[Any, Any], Any]
    solve: Callable[[Numbers, Numbers], Numbers]
    pi: Callable[[], Any]
    dtype: type


def _solve_float(matrix: Numbers, right: Numbers) -> Numbers:
    try:
        found: Numbers = np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError as error:
        raise OracleError("the position is singular") from error
    return found


def _solve_digits(matrix: Numbers, right: Numbers) -> Numbers:
    try:
        found = mpmath.lu_solve(mpmath.matrix(matrix.tolist()), mpmath.matrix(right.tolist()))
    except ZeroDivisionError as error:
        raise OracleError("the position is singular") from error
    return np.array(list(found), dtype=object)


FLOAT = Arithmetic(
    float, np.cos, np.sin, math.atan2, _solve_float, lambda: math.pi, np.dtype(float).type
)
DIGITS = Arithmetic(
    mpmath.mpf,
    np.frompyfunc(mpmath.cos, 1, 1),
    np.frompyfunc(mpmath.sin, 1, 1),
    mpmath.atan2,
    _solve_digits,
    lambda: +mpmath.pi,
    object,
)


def crank_of(mechanism: Mechanism) -> Crank:
    """Find the crank's fixed pivot and its driven letter.

    Driven is the first other letter shared with a moving link; of a crank that shares none (it only
    carries a guide) the first other letter it has.
    """
    numbers = [link.number for link in mechanism.links]
    index = numbers.index(mechanism.drive.link)
    crank = mechanism.links[index]
    pivots = [letter for letter in crank.points if letter in mechanism.frame.points]
    if len(pivots) != 1:
        raise OracleError(f"link {crank.number} shares {len(pivots)} letters with the frame, not 1")
    others = [letter for letter in crank.points if letter != pivots[0]]
    shared = [
        letter
        for letter in others
        if any(letter in link.points for link in mechanism.links if link is not crank)
    ]
    if not others:
        raise OracleError(f"link {crank.number} has no letter but its pivot")
    return Crank(index + 1, pivots[0], (shared or others)[0])


def _size(mechanism: Mechanism) -> float:
    spans = [
        abs(a - b)
        for link in (mechanism.frame, *mechanism.links)
        for a in link.points.values()
        for b in link.points.values()
    ]
    return math.ldexp(1.0, math.frexp(max(spans))[1])


def system_of(mechanism: Mechanism, arithmetic: Arithmetic) -> System:
    """Write down the constraint equations; raises OracleError unless they are as many as the unknowns."""
    links = (mechanism.frame, *mechanism.links)
    place = {link.number: index for index, link in enumerate(links)}
    size = _size(mechanism)
    pins: list[tuple[int, int, complex, complex]] = []
    for letter in dict.fromkeys(letter for link in links for letter in link.points):
        first, *rest = [i for i, link in enumerate(links) if letter in link.points]
        pins += [(i, first, links[i].points[letter], links[first].points[letter]) for i in rest]
    slides: list[tuple[int, int, Slide]] = [
        (i, place[slide.on], slide) for i, link in enumerate(links) for slide in link.slides
    ]
    rows, unknowns = 2 * (len(pins) + len(slides)) + 1, 3 * len(mechanism.links)
    if rows != unknowns:
        raise OracleError(f"{rows} equations for {unknowns} unknowns")

    def numbers(values: list[float]) -> Numbers:
        return np.array([arithmetic.number(value) for value in values], dtype=arithmetic.dtype)

    def places(values: list[int]) -> NDArray[np.intp]:
        return np.array(values, dtype=np.intp)

    degree = arithmetic.pi() / 180
    alpha = numbers([slide.guide.angle for *_, slide in slides]) * degree
    turn = alpha + numbers([slide.angle for *_, slide in slides]) * degree
    through_x = numbers([slide.guide.through.real / size for *_, slide in slides])
    through_y = numbers([slide.guide.through.imag / size for *_, slide in slides])
    rise = numbers([slide.offset / size for *_, slide in slides])
    rise = rise + through_y * arithmetic.cos(alpha) - through_x * arithmetic.sin(alpha)
    crank = crank_of(mechanism)
    # parts are taken apart before they are subtracted: floats are exact, their difference need not be
    pivot, driven = (links[crank.index].points[letter] for letter in (crank.pivot, crank.driven))
    number = arithmetic.number
    own = arithmetic.atan2(
        number(driven.imag) - number(pivot.imag), number(driven.real) - number(pivot.real)
    )
    return System(
        size,
        crank.index,
        own,
        places([i for i, *_ in pins]),
        places([k for _, k, *_ in pins]),
        numbers([p.real / size for *_, p, _ in pins]),
        numbers([p.imag / size for *_, p, _ in pins]),
        numbers([p.real / size for *_, p in pins]),
        numbers([p.imag / size for *_, p in pins]),
        places([i for i, *_ in slides]),
        places([k for _, k, _ in slides]),
        alpha,
        turn,
        rise,
    )


def _wrapped(angle: Numbers, full: Any) -> Numbers:
    return angle - full * np.rint(np.asarray(angle / full, dtype=float)).astype(int)


def equations(
    system: System, q: Numbers, phi: Any, arithmetic: Arithmetic
) -> tuple[Numbers, Numbers]:
    """Residuals, shape (3n,), and Jacobian, shape (3n, 3n), at the poses q, shape (n + 1, 3).

    Rows: the x of all pins, their y, the slides' angles, the slides' offsets, the crank.
    """
    s, (x, y, t) = system, q.T
    cos, sin = arithmetic.cos(t), arithmetic.sin(t)
    ax, ay = cos[s.pi] * s.px - sin[s.pi] * s.py, sin[s.pi] * s.px + cos[s.pi] * s.py
    bx, by = cos[s.oi] * s.ox - sin[s.oi] * s.oy, sin[s.oi] * s.ox + cos[s.oi] * s.oy
    ux, uy = arithmetic.cos(t[s.ki] + s.alpha), arithmetic.sin(t[s.ki] + s.alpha)
    dx, dy = x[s.si] - x[s.ki], y[s.si] - y[s.ki]
    full = 2 * arithmetic.pi()
    residual = np.concatenate(
        [
            x[s.pi] + ax - x[s.oi] - bx,
            y[s.pi] + ay - y[s.oi] - by,
            _wrapped(t[s.si] - t[s.ki] - s.turn, full),
            ux * dy - uy * dx - s.rise,
            _wrapped(t[[s.crank]] + s.own - phi, full),
        ]
    )
    pins, slides = len(s.pi), len(s.si)
    jacobian = np.zeros((len(residual), q.size), dtype=q.dtype)
    row = np.arange(pins)
    jacobian[row, 3 * s.pi], jacobian[row, 3 * s.oi] = 1, -1
    jacobian[row, 3 * s.pi + 2], jacobian[row, 3 * s.oi + 2] = -ay, by
    row = row + pins
    jacobian[row, 3 * s.pi + 1], jacobian[row, 3 * s.oi + 1] = 1, -1
    jacobian[row, 3 * s.pi + 2], jacobian[row, 3 * s.oi + 2] = ax, -bx
    row = 2 * pins + np.arange(slides)
    jacobian[row, 3 * s.si + 2], jacobian[row, 3 * s.ki + 2] = 1, -1
    row = row + slides
    jacobian[row, 3 * s.si], jacobian[row, 3 * s.ki] = -uy, uy
    jacobian[row, 3 * s.si + 1], jacobian[row, 3 * s.ki + 1] = ux, -ux
    jacobian[row, 3 * s.ki + 2] = -(ux * dx + uy * dy)
    jacobian[-1, 3 * s.crank + 2] = 1
    return residual, jacobian[:, 3:]


def quadratic(system: System, q: Numbers, dq: Numbers, arithmetic: Arithmetic) -> Numbers:
    """γ, shape (3n,): the terms of the twice differentiated equations without q''."""
    s, (x, y, t), (vx, vy, w) = system, q.T, dq.T
    cos, sin = arithmetic.cos(t), arithmetic.sin(t)
    wa, wb = w[s.pi] * w[s.pi], w[s.oi] * w[s.oi]
    ax, ay = cos[s.pi] * s.px - sin[s.pi] * s.py, sin[s.pi] * s.px + cos[s.pi] * s.py
    bx, by = cos[s.oi] * s.ox - sin[s.oi] * s.oy, sin[s.oi] * s.ox + cos[s.oi] * s.oy
    ux, uy = arithmetic.cos(t[s.ki] + s.alpha), arithmetic.sin(t[s.ki] + s.alpha)
    dx, dy = x[s.si] - x[s.ki], y[s.si] - y[s.ki]
    along = ux * (vx[s.si] - vx[s.ki]) + uy * (vy[s.si] - vy[s.ki])
    wk = w[s.ki]
    return np.concatenate(
        [
            wb * bx - wa * ax,
            wb * by - wa * ay,
            0 * wk,
            -2 * wk * along - wk * wk * (ux * dy - uy * dx),
            0 * w[[s.crank]],
        ]
    )


def newton(
    system: System, phi: Any, start: Numbers, arithmetic: Arithmetic, *, close: float, most: int
) -> Numbers:
    """Poses that close the loops, from `start`; done when a step is below `close` (lengths in sizes)."""
    q = np.array(start, dtype=arithmetic.dtype)
    for _ in range(most):
        residual, jacobian = equations(system, q, phi, arithmetic)
        step = arithmetic.solve(jacobian, -residual)
        longest = float(max(abs(step)))
        if not math.isfinite(longest):
            break
        q[1:] += step.reshape(-1, 3) * arithmetic.number(min(1.0, 1.0 / max(longest, 1.0)))
        if longest < close:
            return q
    raise OracleError(f"the loops do not close at {float(phi) * 180 / math.pi:.6g} degrees")


def rates(
    mechanism: Mechanism, system: System, q: Numbers, phi: Any, arithmetic: Arithmetic
) -> Rates:
    """Derive q' and q'' at closed loops from the Jacobian; of the equations only the crank's knows time."""
    _, jacobian = equations(system, q, phi, arithmetic)
    dq, ddq = np.zeros_like(q), np.zeros_like(q)
    right = 0 * jacobian[:, 0]
    right[-1] = arithmetic.number(mechanism.drive.speed)
    dq[1:] = arithmetic.solve(jacobian, right).reshape(-1, 3)
    right = -quadratic(system, q, dq, arithmetic)
    right[-1] = arithmetic.number(mechanism.drive.acceleration)
    ddq[1:] = arithmetic.solve(jacobian, right).reshape(-1, 3)
    return Rates(q, dq, ddq)


def poses_array(mechanism: Mechanism, start: Mapping[int, Pose], size: float) -> Numbers:
    """Poses by link number as an array of shape (links + 1, 3), lengths in units of `size`."""
    rows = [(0.0, 0.0, 0.0), *(start[link.number] for link in mechanism.links)]
    return np.array([(x / size, y / size, t) for x, y, t in rows])


def _state(mechanism: Mechanism, phi_deg: float, system: System, found: Rates) -> State:
    size = system.size
    exact = Rates(*(np.asarray(part, dtype=float) for part in found))
    numbers = [mechanism.frame.number, *(link.number for link in mechanism.links)]
    spins: dict[int, tuple[Motion, Motion]] = {}
    for number, q, dq, ddq in zip(numbers, *exact, strict=True):
        origin = Motion(*(complex(p[0], p[1]) * size for p in (q, dq, ddq)))
        turn = complex(math.cos(q[2]), math.sin(q[2]))
        spins[number] = (origin, Motion(turn, 1j * dq[2], 1j * ddq[2] - dq[2] ** 2))
    return State(
        mechanism,
        phi_deg,
        size,
        found,
        {
            n: (float(x) * size, float(y) * size, float(t))
            for n, (x, y, t) in zip(numbers, exact.q, strict=True)
        },
        {n: float(row[2]) for n, row in zip(numbers, exact.dq, strict=True)},
        {n: float(row[2]) for n, row in zip(numbers, exact.ddq, strict=True)},
        Points(mechanism, spins),
    )


def solve_fast(mechanism: Mechanism, phi_deg: float, start: Mapping[int, Pose]) -> State:
    """Solve a position in float64 (about a millisecond), from poses near to it."""
    system, phi = system_of(mechanism, FLOAT), math.radians(phi_deg)
    begin = poses_array(mechanism, start, system.size)
    q = newton(system, phi, begin, FLOAT, close=1e-9, most=60)
    return _state(mechanism, phi_deg, system, rates(mechanism, system, q, phi, FLOAT))


def solve_digits(
    mechanism: Mechanism,
    phi: Callable[[], Any],
    start: Mapping[int, Pose],
    *,
    dps: int = 30,
) -> tuple[System, Rates]:
    """Solve with `dps` digits; `phi` is called within that precision and gives the crank's angle in rad.

    The numbers of System and Rates are mpmath numbers, lengths in units of ``System.size``.
    """
    quick = system_of(mechanism, FLOAT)
    begin = poses_array(mechanism, start, quick.size)
    with mpmath.workdps(dps + 5):
        system, angle = system_of(mechanism, DIGITS), phi()
        try:
            begin = newton(quick, float(angle), begin, FLOAT, close=1e-9, most=60)
        except OracleError:  # too near a singular position for float64: all the way in digits
            pass
        lifted = np.array([[mpmath.mpf(float(v)) for v in row] for row in begin], dtype=object)
        q = newton(system, angle, lifted, DIGITS, close=10.0 ** (-dps / 2 - 2), most=60)
        return system, rates(mechanism, system, q, angle, DIGITS)


def solve(
    mechanism: Mechanism, phi_deg: float, start: Mapping[int, Pose], *, dps: int = 30
) -> State:
    """Solve a position with `dps` digits, from poses (x m, y m, θ rad) near to it by link number.

    Which assembly is found depends on the start only; raises OracleError if the loops do not close.
    """
    system, found = solve_digits(
        mechanism, lambda: mpmath.mpf(phi_deg) * mpmath.pi / 180, start, dps=dps
    )
    return _state(mechanism, phi_deg, system, found)


def follow(state: State, phi_deg: float, *, step: float = 2.0) -> State:
    """Turn the crank from a solved position to another in steps of at most `step` degrees, float64.

    Each step starts from a prediction along the velocities, so the assembly is kept as long as the
    mechanism does not pass near a singular position; raises OracleError where it does not close.
    """
    mechanism, (_, dq, _) = state.mechanism, state.rates
    system = system_of(mechanism, FLOAT)
    q, dq = (np.asarray(part, dtype=float) for part in (state.rates.q, dq))
    count = max(1, math.ceil(abs(phi_deg - state.phi) / step))
    phi = math.radians(state.phi)
    for angle in np.radians(np.linspace(state.phi, phi_deg, count + 1)[1:]):
        begin = q + dq * ((angle - phi) / mechanism.drive.speed)
        phi = float(angle)
        q = newton(system, phi, begin, FLOAT, close=1e-9, most=60)
        if float(np.max(np.abs(q - begin))) > 0.5:
            raise OracleError(f"lost the assembly near {math.degrees(phi):.6g} degrees")
        dq = rates(mechanism, system, q, phi, FLOAT).dq
    phi = math.radians(phi_deg)
    return _state(mechanism, phi_deg, system, rates(mechanism, system, q, phi, FLOAT))


def _turned(link: Link, points: Mapping[str, complex], size: float) -> float | None:
    """Angle of a link, from two or more of its points where known (best fit); else None."""
    own = np.array([link.points[letter] for letter in link.points if letter in points])
    seen = np.array([points[letter] for letter in link.points if letter in points])
    if len(own) < 2:
        return None
    fit = complex(np.sum(np.conj(own - own.mean()) * (seen - seen.mean())))
    return math.atan2(fit.imag, fit.real) if abs(fit) > (1e-6 * size) ** 2 else None


def _tangent(link: Link, slide: Slide, guide: Link, points: Mapping[str, complex]) -> float | None:
    """Angle of the guide's owner where slider and owner have one known point each: by the side."""
    mine = [letter for letter in link.points if letter in points]
    other = [letter for letter in guide.points if letter in points]
    if not mine or not other or slide.side is None:
        return None
    chord = points[mine[0]] - points[other[0]]
    tilt = complex(math.cos(math.radians(slide.angle)), math.sin(math.radians(slide.angle)))
    alpha = math.radians(slide.guide.angle)
    back = complex(math.cos(alpha), -math.sin(alpha))
    rise = slide.offset + (link.points[mine[0]] * tilt).imag
    rise += ((slide.guide.through - guide.points[other[0]]) * back).imag
    sine = min(1.0, max(-1.0, rise / abs(chord)))
    ahead = math.asin(sine) if slide.side.sign > 0 else math.pi - math.asin(sine)
    return math.atan2(chord.imag, chord.real) - ahead - alpha


def _angles(
    mechanism: Mechanism, phi: float, points: Mapping[str, complex], system: System
) -> dict[int, float]:
    angles = {mechanism.frame.number: 0.0, mechanism.drive.link: phi - float(system.own)}
    for link in mechanism.links:
        if link.number not in angles:
            turned = _turned(link, points, system.size)
            if turned is not None:
                angles[link.number] = turned
    pairs = [(a, s) for a in (mechanism.frame, *mechanism.links) for s in a.slides]
    for _ in range(2 * len(pairs)):
        for link, slide in pairs:
            ahead = math.radians(slide.guide.angle + slide.angle)
            if slide.on in angles:
                angles.setdefault(link.number, angles[slide.on] + ahead)
            elif link.number in angles:
                angles[slide.on] = angles[link.number] - ahead
        if len(angles) == len(mechanism.links) + 1:
            return angles
        for link, slide in pairs:
            if slide.on not in angles and link.number not in angles:
                angle = _tangent(link, slide, mechanism.by_number[slide.on], points)
                if angle is not None:
                    angles[slide.on] = angle
                    break
    missing = [link.number for link in mechanism.links if link.number not in angles]
    if missing:
        raise OracleError(f"the points do not tell how links {missing} are turned")
    return angles


def poses_from_points(
    mechanism: Mechanism, phi_deg: float, points: Mapping[str, complex]
) -> dict[int, Pose]:
    """Poses that fit approximate places (m) of named points; unknown letters raise OracleError.

    Angles: from two known points of a link, else from its sliding pair, else from the side of a sliding
    pair between two links of one known point each. Places: least squares of all points and loops.
    """
    links = (mechanism.frame, *mechanism.links)
    strange = sorted(set(points) - {letter for link in links for letter in link.points})
    if strange or not all(np.isfinite(list(points.values()))):
        raise OracleError(f"letters not on any link: {strange}, or points that are not numbers")
    system, phi = system_of(mechanism, FLOAT), math.radians(phi_deg)
    angles = _angles(mechanism, phi, points, system)
    q = np.array([(0.0, 0.0, angles[link.number]) for link in links])
    residual, jacobian = equations(system, q, phi, FLOAT)
    columns = [c for c in range(jacobian.shape[1]) if c % 3 < 2]
    rows, right = [*jacobian[:, columns]], [*-residual]
    # the equations are linear in the origins once the angles are known; add a row a known coordinate
    for i, link in enumerate(mechanism.links):
        turn = complex(math.cos(angles[link.number]), math.sin(angles[link.number]))
        for letter in set(link.points) & set(points):
            place = (points[letter] - link.points[letter] * turn) / system.size
            rows += [*np.eye(len(columns))[[2 * i, 2 * i + 1]]]
            right += [place.real, place.imag]
    origins = np.linalg.lstsq(np.array(rows), np.array(right), rcond=None)[0].reshape(-1, 2)
    return {
        link.number: (float(x) * system.size, float(y) * system.size, angles[link.number])
        for link, (x, y) in zip(mechanism.links, origins, strict=True)
    }


def solve_from_points(
    mechanism: Mechanism,
    phi_deg: float,
    points: Mapping[str, complex],
    *,
    tolerance: float = 1e-3,
    dps: int | None = None,
) -> State:
    """Solve near approximate places (m) of named points, and see that the solution is the one meant.

    Raises OracleError where the loops do not close, or where a point had to move by more than `tolerance`
    of the mechanism's size (or a link to turn by more than 0.05 rad) from what was given. float64, or
    with `dps` digits.
    """
    start = poses_from_points(mechanism, phi_deg, points)
    if dps is None:
        state = solve_fast(mechanism, phi_deg, start)
    else:
        state = solve(mechanism, phi_deg, start, dps=dps)
    for letter in sorted(points):
        moved = abs(state.points[letter].r - points[letter])
        if not moved <= tolerance * state.size:
            raise OracleError(f"{letter} lies {moved:.3g} m from the place given at {phi_deg:.6g}")
    for number, (*_, angle) in start.items():
        turned = math.remainder(state.pose[number][2] - angle, 2 * math.pi)
        if not abs(turned) <= 0.05:
            raise OracleError(f"link {number} is turned by {turned:.3g} from the places given")
    return state
