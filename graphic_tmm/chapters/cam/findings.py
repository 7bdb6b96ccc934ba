"""Where a finished cam passes its limits, with the angle of the cam: pressure angle, roller, convexity."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam import words_drum, words_plate
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.laws.table import FEW, ROUGH, table_of
from graphic_tmm.chapters.cam.plan import CAM_PLAN, Cam
from graphic_tmm.chapters.cam.refusals import SLACK
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.chapters.cam.task import FlatFollower
from graphic_tmm.chapters.cam.task_motion import BY_TABLE, size_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

PROTRACTOR = 0.05
"""Degrees: 0.1 mm on a ray of 100 mm. A pressure angle that is over by less cannot be told from the limit."""
RULER = 1e-4
"""A length that is over by less than this share of itself (0.01 mm in 100) cannot be told from its limit."""

FORCE = 5e-3
"""A force below this share of the largest is less than a ruler tells on its diagram (0.2 mm of 40)."""

_WORDS = {
    **words_drum.FINDINGS,
    **words_plate.FINDINGS,
    "pressure": said(
        "the pressure angle reaches {value:.4g}° at φ = {angle:.4g}°, {limit:g}° are allowed: r0 = "
        "{r0:.4g} mm is too small, take {least:.4g} mm at least"
    ),
    "path": said(
        "the pressure angle reaches {value:.4g}° at φ = {angle:.4g}°, {limit:g}° are allowed: no "
        "larger r0 helps, change the distance of the centres or the offset"
    ),
    "no centre": said(
        "wherever the cam stands at this distance from the lever's pivot, the pressure angle at φ "
        "= {angle:.4g}° passes {limit:g}°: increase the distance of the centres, the phase or the "
        "pressure angle allowed"
    ),
    "roller by r0": said(
        "the roller's radius {value:.4g} mm is larger than {limit:.4g} mm, the allowed share of r0"
    ),
    "roller by curvature": said(
        "the roller's radius {value:.4g} mm is larger than {limit:.4g} mm, the allowed share of "
        "the least radius of curvature, at φ = {angle:.4g}°"
    ),
    "undercut": said(
        "the roller of {value:.4g} mm cuts the profile away at φ = {angle:.4g}°, where its radius "
        "of curvature is {limit:.4g} mm: take a smaller roller or a larger r0"
    ),
    "sharp": said(
        "the radius of curvature of the theoretical profile falls to {value:.4g} mm at φ = {angle:.4g}°, "
        "{limit:.4g} mm are the least: take a larger r0 than {r0:.4g} mm"
    ),
    "hollow": said(
        "the radius of curvature under the flat face falls to {value:.4g} mm at φ = {angle:.4g}°, "
        "{limit:.4g} mm are the least: r0 = {r0:.4g} mm is too small, take {least:.4g} mm at least"
    ),
    "foot": said(
        "the contact passes the foot of the pivot on the face: at φ = {angle:.4g}° it stands at x = "
        "{value:.4g} mm, and no force there holds the lever: increase the distance of the centres"
    ),
    "lift-off": said(
        "the follower lifts off the cam at φ = {angle:.4g}°, where the force of contact falls to "
        "{value:.4g} N: take a spring of a larger preload or rate, or turn the cam slower"
    ),
    "reserve": said(
        "at φ = {angle:.4g}° the spring has {value:.4g} less than its reserve of {limit:g} wants: take a "
        "larger preload or rate"
    ),
    "hollow lever": said(
        "the radius of curvature under the flat face falls to {value:.4g} mm at φ = {angle:.4g}°, "
        "{limit:.4g} mm are the least: no larger r0 helps, increase the distance of the centres or "
        "the phase"
    ),
}
"""By kind of finding."""


_CHANGED = {
    "rise": (
        said(
            "the jump of the acceleration at the share {share:.4g} of the rise is drawn at {place:.4g}, where "
            "a position stands: a ruler does not tell them apart"
        ),
        said(
            "the areas of the acceleration diagram of the rise are equal but for {percent:.2g} %: its "
            "ordinates below the axis are multiplied by {factor:.5g}, so that the follower stops"
        ),
    ),
    "return": (
        said(
            "the jump of the acceleration at the share {share:.4g} of the return is drawn at {place:.4g}, "
            "where a position stands: a ruler does not tell them apart"
        ),
        said(
            "the areas of the acceleration diagram of the return are equal but for {percent:.2g} %: its "
            "ordinates that brake are multiplied by {factor:.5g}, so that the follower stops"
        ),
    ),
}
"""By phase: of a jump that was moved, of areas that were made equal."""
_OF_PHASE = said("phase {number}: {says}")


def changes(cam: Cam, language: str) -> Iterator[str]:
    """Yield, as sentences, how acceleration diagrams were changed that had been read off paper."""
    _ = speaking(language)
    for phase in cam.diagrams.turn.phases:
        jump, areas = _CHANGED[phase.name]
        factor, told = phase.changed.factor, list[str]()
        for share, place in phase.changed.moved:
            if abs(place - share) > SLACK:
                told.append(_(jump, share=share, place=place))
        if factor != 1.0:
            told.append(_(areas, percent=100.0 * abs(factor - 1.0), factor=factor))
        for says in told:
            yield says if phase.lone else _(_OF_PHASE, number=phase.number, says=says)


SLOPES = {False: ("dS/dφ", "d²S/dφ²"), True: ("dS/ds_c", "d²S/ds_c²")}
"""What the derivatives of a cam are called that turns, and of one that slides."""
_TABLE = {
    "few": said(
        "the table of phase {k} has {steps} steps: between its lines nobody knows the acceleration, give {few} "
        "steps at least"
    ),
    "begins": said(
        "by its table the follower begins phase {k} with the velocity {slope} = {speed:.3g} (SI): a hard "
        "shock, which {second} does not show; ease the table there"
    ),
    "ends": said(
        "by its table the follower ends phase {k} with the velocity {slope} = {speed:.3g} (SI): a hard "
        "shock, which {second} does not show; ease the table there"
    ),
    "noise": said(
        "the acceleration of the table of phase {k} changes its sign {waves} times: that is noise of its "
        "figures, give more digits of them or fewer lines"
    ),
    "rough": said(
        "the table of phase {k} is rounded to {digit}: by that alone {second} may be off by {percent:.0f} % of "
        "its largest, give more digits or fewer lines"
    ),
}
"""Of a law given by a table."""


def of_tables(cam: Cam, language: str) -> Iterator[str]:
    """Yield, as sentences, what tables of displacements leave open: few lines, a shock, noise, rounding."""
    _ = speaking(language)
    slope, second = SLOPES[cam.order.slides]
    for phase in cam.diagrams.turn.phases:
        if phase.law.name != BY_TABLE:
            continue
        table, k = table_of(phase.law), phase.number
        long = phase.extent if cam.order.slides else np.radians(phase.extent)
        mean = (phase.motion.stroke or 0.0) / long
        if table.steps < FEW:
            yield _(_TABLE["few"], k=k, steps=table.steps, few=FEW)
        ends = list(zip(table.speeds, table.shocks, strict=True))[:: phase.sign]
        for way, (speed, shock) in zip(("begins", "ends"), ends, strict=True):
            if shock:
                speed = phase.sign * speed * mean
                yield _(_TABLE[way], k=k, speed=speed, slope=slope, second=second)
        if table.waves > 2:
            yield _(_TABLE["noise"], k=k, waves=table.waves)
        elif table.rough > ROUGH:
            digit = size_of(table.digit * (phase.motion.stroke or 0.0), cam.order.rocks)
            percent = 100.0 * min(table.rough, 1.0)
            yield _(_TABLE["rough"], k=k, digit=digit, percent=percent, second=second)


class CamFinding(NamedTuple):
    """A limit that is passed: what, at which angle of the cam (degrees, NaN for all), value and limit.

    ``value`` and ``limit`` in degrees for a pressure angle, else in mm; ``r0`` and its least value in mm.
    """

    kind: str
    angle: float
    value: float
    limit: float
    r0: float
    least: float

    def says(self, language: str) -> str:
        """Return the finding as a sentence of a language: the least radius rounded up, and more than r0."""
        digit = 10.0 ** (np.floor(np.log10(self.r0)) - 3.0)
        least = max(np.ceil(self.least / digit - RULER), np.round(self.r0 / digit) + 1.0) * digit
        return speaking(language)(_WORDS[self.kind], **{**self._asdict(), "least": float(least)})


def cam_findings(reading: Reading, cam: Cam) -> tuple[CamFinding, ...]:
    """Return the limits that a cam passes, in the order in which they are checked."""

    def value_at(mark: Mark) -> float:
        return float(reading[mark][0, 0])

    sizes = (1000.0 * value_at(cam.r0), 1000.0 * value_at(cam.least))
    follower, spring = cam.order.follower, _spring(reading, cam, value_at, sizes)
    if isinstance(follower, FlatFollower | FlatRockerFollower):
        foot = _foot(cam, value_at, sizes)
        return (*_hollow(cam, follower, value_at, sizes), *(foot or spring))
    found = (
        *_pressure(reading, cam, value_at, sizes),
        *_sharp(cam, value_at, sizes),
        *_roller(cam, value_at, sizes),
        *spring,
    )
    if not cam.order.developed:
        return found
    if cam.order.slides:  # places of the cam are m
        found = tuple(
            one._replace(kind=f"plate {one.kind}", angle=1000.0 * one.angle) for one in found
        )
        return found
    return tuple(one._replace(kind=f"drum {one.kind}") for one in found)


def _spring(
    reading: Reading, cam: Cam, one: Callable[[Mark], float], sizes: tuple[float, float]
) -> tuple[CamFinding, ...]:
    """A follower that lifts off, or else a spring with less than its reserve."""
    if cam.spring is None or cam.order.spring is None:
        return ()
    most, least = cam.spring.contact.extremes
    if one(least.value) < -FORCE * abs(one(most.value)):
        place = one(least.angle)
        return (CamFinding("lift-off", place, one(least.value), 0.0, *sizes),)
    rows = np.array([reading.figure(mark)[0] for mark in cam.spring.left])
    over = np.where(np.isfinite(rows), rows, np.inf).min(axis=0)
    k, largest = int(np.argmin(over)), np.nanmax(np.abs(reading.figure(cam.spring.force)))
    if over[k] < -FORCE * largest:
        place, reserve = cam.diagrams.turn.angles[k], cam.order.spring.reserve
        return (CamFinding("reserve", place, -float(over[k]), reserve, *sizes),)
    return ()


def _hollow(
    cam: Cam,
    face: FlatFollower | FlatRockerFollower,
    one: Callable[[Mark], float],
    sizes: tuple[float, float],
) -> tuple[CamFinding, ...]:
    """A profile too sharp under the face: a larger r0 helps as far as the pivot leaves room for one."""
    (flattest,) = cam.curvature.extremes
    rho, limit, (r0, least) = 1000.0 * one(flattest.value), 1000.0 * face.least, sizes
    if rho >= limit - RULER * r0:
        return ()
    if r0 >= least:  # it was drawn too small, through too few positions
        least = r0 + 1.0
    room = 1000.0 * (face.centres - face.face) if isinstance(face, FlatRockerFollower) else np.inf
    kind = "hollow" if least < room else "hollow lever"
    return (CamFinding(kind, one(flattest.angle), rho, limit, r0, least),)


def _foot(
    cam: Cam, one: Callable[[Mark], float], sizes: tuple[float, float]
) -> tuple[CamFinding, ...]:
    """A contact that passes the foot of the pivot: no force there turns the lever the way it is to go."""
    if cam.contact is None:
        return ()
    _, nearest = cam.contact.extremes
    if not one(nearest.value) <= 0.0:
        return ()
    return (CamFinding("foot", one(nearest.angle), 1000.0 * one(nearest.value), 0.0, *sizes),)


def _sharp(
    cam: Cam, one: Callable[[Mark], float], sizes: tuple[float, float]
) -> tuple[CamFinding, ...]:
    (sharpest,) = cam.curvature.extremes
    rho, least = 1000.0 * one(sharpest.value), 1000.0 * cam.order.least_rho
    if least == 0.0 or rho >= least * (1.0 - RULER):
        return ()
    return (CamFinding("sharp", one(sharpest.angle), rho, least, *sizes),)


def _pressure(
    reading: Reading, cam: Cam, one: Callable[[Mark], float], sizes: tuple[float, float]
) -> tuple[CamFinding, ...]:
    assert cam.pressure is not None
    limits = (cam.order.pressure, cam.order.pressure_return or cam.order.pressure)
    found = []
    if isinstance(cam.path, Lever):
        turn = cam.diagrams.turn
        for mark, way, limit in zip(cam.path.chart.ordinates, turn.ways, limits, strict=True):
            gone = [k for k in turn.among(way) if not np.isfinite(reading[mark][0, k])]
            if gone:
                place = turn.angles[gone[len(gone) // 2]]
                found.append(CamFinding("no centre", place, float("nan"), limit, *sizes))
    r0, least = sizes
    kind = "pressure" if r0 < least or cam.order.developed else "path"
    for extreme, limit, sign in zip(cam.pressure.extremes, limits, (1, -1), strict=False):
        if sign * one(extreme.value) > limit + PROTRACTOR:
            place, angle = one(extreme.angle), abs(one(extreme.value))
            if cam.order.developed and least <= r0:
                # it was read too small: the steeper the path the smaller the drum
                least = float(r0 * np.tan(np.radians(angle)) / np.tan(np.radians(limit)))
            found.append(CamFinding(kind, place, angle, limit, r0, least))
    return tuple(found)


def _roller(
    cam: Cam, one: Callable[[Mark], float], sizes: tuple[float, float]
) -> tuple[CamFinding, ...]:
    if cam.roller is None:
        return ()
    (sharpest,) = cam.curvature.extremes
    angle, rho = one(sharpest.angle), 1000.0 * one(sharpest.value)
    radius = 1000.0 * one(cam.roller.radius)
    by_r0 = 1000.0 * one(cam.roller.by_r0) if cam.roller.by_r0 is not None else np.inf
    by_rho, found = 1000.0 * one(cam.roller.by_curvature), []
    if radius > by_r0 * (1.0 + RULER):
        found.append(CamFinding("roller by r0", float("nan"), radius, by_r0, *sizes))
    if radius >= rho:
        found.append(CamFinding("undercut", angle, radius, rho, *sizes))
    elif radius > by_rho * (1.0 + RULER):
        found.append(CamFinding("roller by curvature", angle, radius, by_rho, *sizes))
    return tuple(found)


def _limits(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield what was changed of diagrams read off paper, and the limits that a cam passes."""
    made = CAM_PLAN.on(drawn)
    yield from changes(made, language)
    yield from of_tables(made, language)
    yield from (finding.says(language) for finding in cam_findings(drawn.reading, made))


WARNINGS = Warned(_limits)
