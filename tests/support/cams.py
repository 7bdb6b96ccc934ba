"""Oracles of cams: laws in closed form, contact of follower and profile; a cam brought to numbers."""

from __future__ import annotations

from collections.abc import Callable
from itertools import takewhile
from typing import Any, NamedTuple

import numpy as np
import shapely

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import standard
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.plan import Cam, draw_cam
from graphic_tmm.chapters.cam.profile import Contour
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Law,
    RockerFollower,
    RollerFollower,
)

C6: dict[str, Any] = {
    "stroke": 0.028, "rise": 100.0, "upper_dwell": 20.0, "fall": 90.0, "lower_dwell": 150.0,
}  # fmt: skip
"""The cam of the windrower's project."""
EXACT_R0 = 0.0490264
"""Its least r0, m: the largest of S′/tan 30° − S over a dense return, see `least_central`."""


class Made(NamedTuple):
    """A cam with its log, what was given and all numbers."""

    cam: Cam
    log: Construction
    given: dict[Mark, Any]
    reading: Reading

    def one(self, mark: Mark) -> float:
        return float(self.reading[mark][0, 0])


def made(order: CamTask) -> Made:
    """Draw a cam; scales that may be chosen become standard ones."""
    draft = Draft()
    cam = draw_cam(draft, order)
    log, given = draft.board.construction(), dict(draft.given)
    free = [chart for chart in cam.charts if chart.chosen]
    given |= {chart.mu: 1.0 for chart in free}
    found = execute(log, given, [mark for chart in free for mark in chart.ordinates])
    for chart in free:
        rows = [np.abs(found[mark]) for mark in chart.ordinates]
        high = max(float(np.max(row, initial=0.0, where=np.isfinite(row))) for row in rows)
        given[chart.mu] = chart.wanted or standard(high, chart.room)
    return Made(cam, log, given, execute(log, given))


Shape = Callable[[np.ndarray], np.ndarray]
SHAPES: dict[str, tuple[Shape, Shape, Shape]] = {
    "sine": (
        lambda u: u - np.sin(2 * np.pi * u) / (2 * np.pi),
        lambda u: 1 - np.cos(2 * np.pi * u),
        lambda u: 2 * np.pi * np.sin(2 * np.pi * u),
    ),
    "cosine": (
        lambda u: (1 - np.cos(np.pi * u)) / 2,
        lambda u: np.pi * np.sin(np.pi * u) / 2,
        lambda u: np.pi**2 * np.cos(np.pi * u) / 2,
    ),
    "constant acceleration": (
        lambda u: np.where(u < 0.5, 2 * u**2, 1 - 2 * (1 - u) ** 2),
        lambda u: np.where(u < 0.5, 4 * u, 4 * (1 - u)),
        lambda u: np.where(u < 0.5, 4.0, -4.0),
    ),
    "constant velocity": (
        lambda u: np.where(
            u < 1 / 6, 3.6 * u**2, np.where(u > 5 / 6, 1 - 3.6 * (1 - u) ** 2, 1.2 * u - 0.1)
        ),
        lambda u: np.minimum(1.2, 7.2 * np.minimum(u, 1 - u)),
        lambda u: np.where(u < 1 / 6, 7.2, np.where(u > 5 / 6, -7.2, 0.0)),
    ),
    "3-4-5": (
        lambda u: 10 * u**3 - 15 * u**4 + 6 * u**5,
        lambda u: 30 * u**2 - 60 * u**3 + 30 * u**4,
        lambda u: 60 * u - 180 * u**2 + 120 * u**3,
    ),
}
"""Displacement, velocity and acceleration of a rise of 1 over a share 0 … 1."""


def shapes(law: Law) -> tuple[Shape, Shape, Shape]:
    """Return the closed forms of a law; of a diagram by exact integration of its straight lines."""
    if law.shares != (1.0, 1.0):
        up = law.shares[0] / (law.shares[0] + law.shares[1])
        return (
            lambda u: np.where(u < up, u**2 / up, 1 - (1 - u) ** 2 / (1 - up)),
            lambda u: np.where(u < up, 2 * u / up, 2 * (1 - u) / (1 - up)),
            lambda u: np.where(u < up, 2 / up, -2 / (1 - up)),
        )
    if law.name != "diagram":
        return SHAPES[law.name]
    x, a = np.array(law.points).T
    step = np.diff(x)
    v = np.concatenate([[0.0], np.cumsum(step * (a[1:] + a[:-1]) / 2)])
    s = np.concatenate([[0.0], np.cumsum(step * v[:-1] + step**2 * (2 * a[:-1] + a[1:]) / 6)])

    def of(order: int) -> Shape:
        def value(u: np.ndarray) -> np.ndarray:
            k = np.clip(np.searchsorted(x, u, side="right") - 1, 0, step.size - 1)
            t, slope = u - x[k], (a[k + 1] - a[k]) / np.where(step[k] > 0, step[k], 1)
            parts = (
                s[k] + v[k] * t + a[k] * t**2 / 2 + slope * t**3 / 6,
                v[k] + a[k] * t + slope * t**2 / 2,
                a[k] + slope * t,
            )
            return np.asarray(parts[order] / s[-1])

        return value

    return of(0), of(1), of(2)


class Stage(NamedTuple):
    """A phase of the turn: where it begins and how long it is (degrees), the follower's places, its law."""

    start: float
    extent: float
    before: float
    after: float
    law: Law | None


def stages(order: CamTask) -> list[Stage]:
    """Return the phases of a cam, dwells among them; heights from the lowest place."""
    h = order.stroke
    rows = [
        (order.rise, h, order.rise_law),
        (order.upper_dwell, 0.0, None),
        (order.fall, -h, order.return_law),
        (order.lower_dwell, 0.0, None),
    ]
    if order.phases:
        rows = [
            (one.rise, one.stroke, one.law) if one.rise is not None
            else (one.dwell, 0.0, None) if one.dwell is not None
            else (one.fall, -(one.stroke or 0.0), one.law)
            for one in order.phases
        ]  # fmt: skip
    ends = np.concatenate([[0.0], np.cumsum([row[0] for row in rows])])
    high = np.concatenate([[0.0], np.cumsum([row[1] for row in rows])])
    high -= high.min()
    return [
        Stage(ends[k], row[0], high[k], high[k + 1], row[2]) for k, row in enumerate(rows) if row[0]
    ]


def motion(order: CamTask, degrees: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return S, dS/dφ, d²S/dφ² in closed form (SI, per radian)."""
    phi = np.mod(degrees, 360.0)
    found = [np.zeros_like(phi), np.zeros_like(phi), np.zeros_like(phi)]
    for one in stages(order):
        u = (phi - one.start) / one.extent
        inside = (u >= 0) & (u <= 1)
        lift = one.after - one.before
        for k in range(3):
            value = np.zeros_like(phi)
            if one.law is not None:
                value = lift * shapes(one.law)[k](np.clip(u, 0, 1)) / np.radians(one.extent) ** k
            found[k] = np.where(inside, value + (one.before if k == 0 else 0.0), found[k])
    return found[0], found[1], found[2]


def outline(made_: Made, contour: Contour, *, fine: int = 96) -> np.ndarray:
    """Return a closed profile as drawn as points about the cam's centre, m: arcs of curves, arcs of dwells."""
    reading, cam = made_.reading, made_.cam
    t = np.linspace(0.0, 1.0, fine, endpoint=False)[:, None]
    parts: list[np.ndarray] = []
    rows = zip(contour.curves, cam.diagrams.stretches, strict=True)
    every = stages(cam.order)
    moving = [k for k, one in enumerate(every) if one.law is not None]
    for mark, (phase, _, last) in rows:
        (controls,) = bezier(reading[mark])
        a, b, c, d = controls[0:-1:3], controls[1::3], controls[2::3], controls[3::3]
        spots = (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d
        parts.append(spots.T.ravel())
        if last != phase.last:
            continue
        own = moving[cam.diagrams.turn.phases.index(phase)] + 1
        behind = takewhile(lambda one: one.law is None, [*every[own:], *every])
        if dwell := sum(one.extent for one in behind):
            told = next(
                f.marks for f in made_.log.figures if mark in f.marks and f.kind == "contour"
            )
            circle = reading[told[(told.index(mark) + 1) % len(told)]]
            end = controls[-1]
            turns = contour.sense * np.radians(np.linspace(0.0, dwell, 40 * fine, endpoint=False))
            parts.append(circle.radius[0, 0] * end / abs(end) * np.exp(1j * turns))
    return np.concatenate(parts) * made_.one(cam.profile.mu)


def polygon(points: np.ndarray) -> shapely.Polygon:
    made_ = shapely.Polygon(np.stack([points.real, points.imag], axis=1))
    assert made_.is_valid
    return made_


def touching(
    gap: Callable[[np.ndarray], np.ndarray], low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    """Return where a rising gap becomes 0, by halving."""
    for _ in range(40):
        middle = (low + high) / 2
        free = gap(middle) > 0
        low, high = np.where(free, low, middle), np.where(free, middle, high)
    return (low + high) / 2


def roller_places(
    profile: shapely.Polygon,
    radius: float,
    place: Callable[[np.ndarray], np.ndarray],
    most: np.ndarray,
) -> np.ndarray:
    """Return how far a roller stands from its start when it rests on a profile.

    ``place``: the roller's centre in the cam's own axes for a displacement of each position; ``most``: the
    largest displacements tried; the least is minus a tenth of it.
    """
    corners = shapely.get_coordinates(profile.exterior)
    sides = shapely.STRtree(shapely.linestrings(np.stack([corners[:-1], corners[1:]], axis=1)))
    shapely.prepare(profile)

    def gap(s: np.ndarray) -> np.ndarray:
        z = place(s)
        spots = shapely.points(z.real, z.imag)
        away = sides.query_nearest(spots, return_distance=True, all_matches=False)[1]
        return np.asarray(np.where(shapely.contains(profile, spots), -away, away) - radius)

    return touching(gap, -0.1 * most, most)


def place_of(made_: Made, degrees: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Return the roller's centre in the cam's axes for displacements at angles of the cam, by trigonometry."""
    cam = made_.cam
    r0, sense, follower = made_.one(cam.r0), cam.sense, cam.order.follower
    turn = np.exp(-1j * sense * np.radians(degrees))
    if isinstance(follower, RollerFollower):
        e = follower.offset
        start = np.sqrt(r0**2 - e**2)
        return lambda s: (sense * e + 1j * (start + s)) * turn
    assert isinstance(follower, RockerFollower)
    a, lever = follower.centres, follower.lever
    start = np.arccos((a**2 + lever**2 - r0**2) / (2 * a * lever))
    rocks = sense if follower.same_sense else -sense
    assert cam.profile.feet is not None
    pivot = made_.reading[cam.profile.feet][0, 0]
    pivot *= np.exp(1j * sense * np.radians(cam.diagrams.turn.angles[0]))  # where the turn begins
    pivot *= a / abs(pivot)  # where the sheet begins is free
    return lambda s: pivot * (1 - lever / a * np.exp(1j * rocks * (start + s))) * turn


def displaced(made_: Made, degrees: np.ndarray) -> np.ndarray:
    """Return how far the follower stands from its start when the working profile is turned under it (SI)."""
    cam = made_.cam
    points = outline(made_, cam.profile.working)
    profile = polygon(points)
    if isinstance(cam.order.follower, FlatRockerFollower):
        return swung(made_, degrees)[0]
    if isinstance(cam.order.follower, FlatFollower):
        turn = np.exp(1j * cam.sense * np.radians(degrees))
        return np.array([float(np.max((points * z).imag)) for z in turn]) - made_.one(cam.r0)
    radius = made_.one(cam.roller.radius) if cam.roller is not None else 0.0  # of a knife edge
    most = np.full(degrees.shape, 1.2 * cam.order.stroke)
    return roller_places(profile, radius, place_of(made_, degrees), most)


def swung(made_: Made, degrees: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return by which angle a lever with a flat face stands above its start on the working profile, and where.

    The face is lowered until the first point of the profile meets it; the second is how far that point is from
    the foot of the pivot on the face, m.
    """
    cam, follower = made_.cam, made_.cam.order.follower
    assert isinstance(follower, FlatRockerFollower)
    assert cam.profile.feet is not None
    a, d, sense = follower.centres, follower.face, cam.sense
    rocks = sense if follower.same_sense else -sense
    pivot = made_.reading[cam.profile.feet][0, 0]
    pivot *= np.exp(1j * sense * np.radians(cam.diagrams.turn.angles[0]))  # where the turn begins
    pivot *= a / abs(pivot)
    points = outline(made_, cam.profile.working)
    start = np.arcsin((made_.one(cam.r0) + d) / a)
    angles, places = [], []
    for turn in np.exp(1j * sense * np.radians(degrees)):
        ray = (points * turn - pivot) / -pivot  # along the line of the centres, from the pivot
        reach = a * np.abs(ray)
        lift = rocks * np.angle(ray) + np.arcsin(d / reach)
        first = int(np.argmax(lift))
        angles.append(lift[first] - start)
        places.append(np.sqrt(reach[first] ** 2 - d**2))
    return np.array(angles), np.array(places)


def pressure_angles(order: CamTask, r0: float, degrees: np.ndarray) -> np.ndarray:
    """Return the pressure angle (degrees) of a roller follower in closed form, positive towards the rise.

    The angle between the velocity of the roller's centre and the common normal, which is square to the roller's
    path in the cam's own axes; found from velocities, not from the S–dS/dφ diagram.
    """
    s, v, _ = motion(order, degrees)
    follower = order.follower
    if isinstance(follower, RollerFollower):
        start = np.sqrt(r0**2 - follower.offset**2)
        centre, own = follower.offset + 1j * (start + s), 1j * np.ones_like(s)
        velocity = 1j * v
    else:
        assert isinstance(follower, RockerFollower)
        a, lever = follower.centres, follower.lever
        start = np.arccos((a**2 + lever**2 - r0**2) / (2 * a * lever))
        rocks = 1 if follower.same_sense else -1
        arm = -lever * np.exp(1j * rocks * (start + s))
        centre, own = a + arm, 1j * rocks * arm / lever
        velocity = own * lever * v
    relative = velocity - 1j * centre  # as seen from a cam that turns counter-clockwise by 1 rad/s
    normal = 1j * relative
    normal *= np.sign((normal * np.conj(own)).real)
    return np.asarray(np.degrees(np.angle(normal / own)))


def least_radius(order: CamTask, step: float = 0.02) -> float:
    """Return the least r0 (m) at which no pressure angle passes its limit; NaN if there is none.

    The first of 400 radii that fits on a coarse turn, then halving on a dense one.
    """
    limits = order.pressure, order.pressure_return or order.pressure
    follower, low, high = order.follower, 1e-6, 0.3
    if isinstance(follower, RollerFollower):
        low = abs(follower.offset) * (1 + 1e-12) + 1e-6
    if isinstance(follower, RockerFollower):
        low = abs(follower.centres - follower.lever) * (1 + 1e-9) + 1e-6
        high = (follower.centres + follower.lever) * (1 - 1e-9)

    def fits(r0: float, phi: np.ndarray) -> bool:
        alpha = pressure_angles(order, r0, phi)
        return bool(alpha.max() <= limits[0] and alpha.min() >= -limits[1])

    tried = np.linspace(low, high, 400)
    # a constant acceleration has its corner in the middle of a phase, an eased velocity at both sixths
    corners = [
        one.start + one.extent * share
        for one in stages(order)
        if one.law
        for share in (1 / 6, 1 / 2, 5 / 6, one.law.split, *(share for share, _ in one.law.points))
    ]
    coarse, dense = (np.append(np.arange(0.0, 360.0, t), corners) for t in (1.0, step))
    first = next((k for k, r0 in enumerate(tried) if fits(r0, coarse) and fits(r0, dense)), None)
    if first is None:
        return float("nan")
    low, high = tried[max(first - 1, 0)], tried[first]
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (low, middle) if fits(middle, dense) else (middle, high)
    return float(high)


def curvatures(order: CamTask, r0: float, degrees: np.ndarray) -> np.ndarray:
    """Return the curvature (1/m) of the theoretical profile by differences; positive if convex."""
    t = 1e-4

    def at(shift: float) -> np.ndarray:
        phi = degrees + np.degrees(shift)
        s, _, _ = motion(order, phi)
        follower = order.follower
        if isinstance(follower, RollerFollower):
            z = follower.offset + 1j * (np.sqrt(r0**2 - follower.offset**2) + s)
        else:
            assert isinstance(follower, RockerFollower)
            a, lever = follower.centres, follower.lever
            start = np.arccos((a**2 + lever**2 - r0**2) / (2 * a * lever))
            rocks = 1 if follower.same_sense else -1
            z = a - lever * np.exp(1j * rocks * (start + s))
        return np.asarray(z * np.exp(-1j * np.radians(phi)))

    first, second = (at(t) - at(-t)) / (2 * t), (at(t) - 2 * at(0.0) + at(-t)) / t**2
    return np.asarray(-(np.conj(first) * second).imag / np.abs(first) ** 3)
