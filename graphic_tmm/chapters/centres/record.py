"""The scheme of centres as recorded, and what is found by it: ratios of angular velocities, velocities."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure,
    measure_along,
    parallel,
    square,
)
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Line, Number, Point
from graphic_tmm.chapters.centres import formulas as f
from graphic_tmm.chapters.centres import words as why
from graphic_tmm.chapters.centres.network import Centre, Network, Pair, Scheme, trial_values
from graphic_tmm.chapters.centres.task import ASKED, CENTRES, CentresTask
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.slider import Slider
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, chosen
from graphic_tmm.chapters.kinematics.task import POSITIONS, VELOCITIES
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded


@dataclass(frozen=True)
class Rotation:
    """How a link turns: ω_i/ω_1 (Number), ω_i (1/s) by the centres, and by the plan of velocities (1/s).

    ``still``: its centre on the frame lies at infinity, it translates; ``alike``: it turns as the driving link
    does; ``ends``: the lengths by which the ratio is found, ``by_point``: or the point by whose velocity ω is.
    """

    link: int
    still: bool = False
    alike: bool = False
    ratio: Mark | None = None
    omega: Mark | None = None
    plan: Mark | None = None
    ends: tuple[Mark, ...] = ()
    by_point: str = ""


@dataclass(frozen=True)
class PointSpeed:
    """The velocity of a point: by its ``distance`` from the centre of its link, m/s; as of the plan."""

    letter: str
    link: int
    value: Mark
    distance: Mark
    plan: Mark | None


@dataclass(frozen=True)
class Centres:
    """The scheme of centres.

    ``places``: the positions asked for (indices); ``points``: by those of the plan of positions, as carried
    over; ``centres``: in the order in which they were found, ``lost``: the pairs whose centre no line tells;
    ``driver``: the link by which ratios are told, 0 where there are none.
    """

    order: CentresTask
    mu: Mark
    places: tuple[int, ...]
    links: tuple[int, ...]
    frame: int
    points: dict[Mark, Mark]
    centres: tuple[Centre, ...]
    lost: tuple[Pair, ...]
    driver: int
    rotations: tuple[Rotation, ...]
    speeds: tuple[PointSpeed, ...]

    def of(self, first: int, second: int) -> Centre | None:
        """Return the centre of two links; None where no line tells it."""
        return next((one for one in self.centres if {*one.links} == {first, second}), None)

    @property
    def figures(self) -> Iterator[tuple[str, Mark]]:
        """The ratios, angular velocities and velocities that the centres give, as machines call them."""
        for one in self.rotations:
            if one.ratio is not None:
                yield f"u{one.link}{self.driver}", one.ratio
            if one.omega is not None and not one.alike and one.omega.view == CENTRES:
                yield f"omega{one.link}", one.omega
        yield from ((f"v{one.letter}", one.value) for one in self.speeds)


CENTRES_PLAN: Recorded[Centres] = Recorded(CENTRES)


def record(bench: Bench) -> Centres | None:
    """Draw the scheme of centres.

    Raises
    ------
    StructureError
        If a position is named that does not exist.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    draft, plans = bench.draft, KINEMATICS_PLAN.on(bench)
    places = chosen(order.positions, bench.names, CENTRES)
    bench.tell(CENTRES, places)
    values = _drawn(draft)
    mechanism = plans.mechanism
    links = (mechanism.frame, *mechanism.drawn)
    size = max(abs(spot) for link in links for spot in link.points.values()) or 1.0
    draft.open(CENTRES)
    mu = draft.scale("μ_{lP}", "m/mm")
    values[mu] = values[draft.mu_l] = np.ones((1, 1))
    draft.lay_out()
    numbers, frame = sorted(plans.positions.bodies), mechanism.frame.number
    network = Network(draft, numbers, frame, values, places, size)
    scheme = Scheme(draft, plans, network, mu)
    for body in plans.positions.bodies.values():
        for letter in body.link.points:
            scheme.point(body.marks[letter])
    scheme.primary()
    network.close()
    _by_velocities(scheme, turned=bench.scene.turned)
    finder = _Finder(scheme, turned=bench.scene.turned)
    rotations = finder.rotations()
    speeds = tuple(finder.speeds(rotations))
    return Centres(
        order, mu, places, tuple(numbers), frame, scheme.points, tuple(network.centres.values()),
        tuple(network.missing), finder.driver, tuple(rotations), speeds,
    )  # fmt: skip


def _drawn(draft: Draft) -> dict[Mark, Any]:
    """Return points and lines of both plans in the positions of the row."""
    log, views = draft.board.construction(), (POSITIONS, VELOCITIES)
    marks = [step.it for step in log.steps if step.it.view in views and not step.op.across]
    marks = [mark for mark in marks if mark.kind in (Point, Line, Number)]
    marks += [mark for mark in log.given if mark.view in views and mark.kind in (Point, Number)]
    return trial_values(draft, marks)


def _by_velocities(scheme: Scheme, *, turned: bool) -> None:
    """Find centres that no two lines tell: P_i0 by velocities, then whatever follows of them."""
    network, images = scheme.network, scheme.velocities.images
    for link in network.links[:-1]:
        lacks = network.of(link, network.frame) is None and images.turns(link)
        if lacks and network.by_normals(link, scheme.images(link), images.pole, turned=turned):
            network.close()
    if network.missing:
        network.by_rates(scheme.velocities)
        network.close()


class _Finder:
    """What is found by the centres."""

    def __init__(self, scheme: Scheme, *, turned: bool) -> None:
        plans, self.turned = scheme.plans, turned
        self.plans = plans
        self.draft, self.network, self.scheme = scheme.draft, scheme.network, scheme
        self.velocities = scheme.velocities
        self.pair = plans.pairs[0]
        alone = len(plans.pairs) == 1 and isinstance(self.pair, Crank | Slider)
        self.driver = self.pair.link if alone else 0
        self.frame = self.network.frame

    @property
    def speed(self) -> Mark:
        """What is given of the drive."""
        return self.velocities.speeds[self.pair.link]

    def rotations(self) -> list[Rotation]:
        """Return how each link turns that is no driven crank."""
        found = list[Rotation]()
        cranks = [pair.link for pair in self.plans.pairs if isinstance(pair, Crank)]
        for link in self.network.links[:-1]:
            own = self.network.of(link, self.frame)
            if own is not None and link not in cranks:
                rate = self.velocities.rates.get(link)
                found.append(replace(self._rotation(link, own), plan=rate))
        for k, one in enumerate(found):
            if one.omega is None and not one.still:
                same = next((other for other in found if self._alike(one.link, other.link)), one)
                found[k] = replace(same, link=one.link, plan=one.plan)
        return found

    def _alike(self, first: int, second: int) -> bool:
        """Whether two links slide on each other, so that they turn alike."""
        common = self.network.of(first, second)
        return common is not None and common.far

    def _rotation(self, link: int, own: Centre) -> Rotation:
        if own.far:
            return Rotation(link, still=True)
        common = self.network.of(self.driver, link) if self.driver else None
        base = self.network.of(self.driver, self.frame) if self.driver else None
        if common is None or base is None:
            return self._by_point(link, own)
        if common.far and not base.far:
            return Rotation(link, alike=True, omega=self._turning(None))
        if common.far or own.mark in (base.mark, common.mark):
            return self._by_point(link, own)
        draw = self.network.draw
        if base.far:
            assert isinstance(self.pair, Slider)
            guide = self.pair.path(self.plans.positions, self.draft.uses)
            way = f"{own.mark.name}{common.mark.name}"
            line = draw(square, f"({way})", own.mark, guide, sense=-1)
            long = draw(measure_along, way, own.mark, common.mark, line, why=why.TO_COMMON)
            omega = draw(f.rate_by_slider, f"ω_{link}", self.speed, long, unit="1/s")
            return Rotation(link, omega=omega, ends=(long,))
        known = self._of_three(own, self.driver) or self._of_three(common, self.frame)
        line = known or self.network.line(base, own)
        names = [f"{common.mark.name}{k.mark.name}" for k in (base, own)]
        ends = tuple(
            draw(measure_along, name, common.mark, k.mark, line, why=why.TO_COMMON)
            for name, k in zip(names, (base, own), strict=True)
        )
        ratio = draw(f.rates_by_centres, f"u_{{{link}{self.driver}}}", *ends)
        return Rotation(link, ratio=ratio, omega=self._turning(ratio, link), ends=ends)

    def _of_three(self, centre: Centre, link: int) -> Mark | None:
        """Return the line by which a centre was found that goes over a link: three centres lie on it."""
        if link in centre.over and len(centre.lines) == len(centre.over):
            return centre.lines[centre.over.index(link)]
        return None

    def _turning(self, ratio: Mark | None, link: int = 0) -> Mark:
        """Return ω of a link by its ratio; of one that turns as the driving link does what is given of that."""
        if ratio is None:
            return self.speed
        op = f.rate_by_ratio if self.plans.sense > 0 else f.rate_by_ratio_clockwise
        return self.network.draw(op, f"ω_{link}", ratio, self.speed, unit="1/s")

    def _by_point(self, link: int, own: Centre) -> Rotation:
        """Find ω by the velocity of a point of the link, the farthest from its centre, from the plan."""
        there = {k: m for k, m in self._readings(link).items() if k != own.mark}
        if not there:
            return Rotation(link)
        point = max(there, key=lambda k: self._apart(own.mark, k))
        name, draw = f"{own.mark.name}{point.name}", self.network.draw
        ray = self.network.ray(self.velocities.images.pole, self.scheme.images(link)[point])
        op, sense = (square, self.plans.sense) if self.turned else (parallel, 1)
        way = draw(op, f"(v_{point.name})", point, ray, sense=sense, why=why.ALONG_VELOCITY)
        distance = draw(arm, name, own.mark, way, why=why.RADIUS)
        omega = draw(f.rate_by_point, f"ω_{link}", there[point], distance, unit="1/s")
        return Rotation(link, omega=omega, ends=(distance,), by_point=point.name)

    def _readings(self, link: int) -> dict[Mark, Mark]:
        """Return by the points of a link in the scheme the lengths that the plan of velocities has for them."""
        pole, board, found = self.velocities.images.pole, self.draft.board, dict[Mark, Mark]()
        for point, image in self.scheme.images(link).items():
            if (read := board.length(pole, image)) is not None:
                found[point] = read
            elif image != pole and board.step(image).op is lay_off:
                found[point] = board.uses(image)[1]
        return found

    def speeds(self, rotations: list[Rotation]) -> Iterator[PointSpeed]:
        """Yield the velocities of the named points, each by the nearest centre of a link that it is of."""
        bodies, there = self.plans.positions.bodies, {*self.plans.mechanism.frame.points}
        if isinstance(self.pair, Crank) and self.driver:
            there |= {*bodies[self.driver].link.points}
        every = [(one, letter) for one in rotations for letter in bodies[one.link].link.points]
        for one, letter in sorted(every, key=lambda k: self._distance(*k)):
            if letter in {*there, one.by_point}:
                continue
            own = self.network.of(one.link, self.frame)
            point = self.scheme.point(bodies[one.link].marks[letter])
            if own is not None and (found := self._speed(one, own, point, letter)) is not None:
                there.add(letter)
                yield PointSpeed(letter, one.link, *found, self._readings(one.link).get(point))

    def _distance(self, one: Rotation, letter: str) -> float:
        """Return how far a point is from the centre of its link, in the middle of the positions."""
        marks = self.plans.positions.bodies[one.link].marks
        own = self.network.finite(one.link, self.frame)
        return self._apart(own, self.scheme.point(marks[letter])) if own is not None else 0.0

    def _apart(self, first: Mark, second: Mark) -> float:
        values = self.network.values
        apart = np.abs(values[first] - values[second])[0]
        there = apart[np.isfinite(apart)]
        return float(np.median(there)) if there.size else math.inf

    def _speed(
        self, one: Rotation, own: Centre, point: Mark, letter: str
    ) -> tuple[Mark, Mark] | None:
        """Find the velocity of a point of a link; of one that translates as that of P_1i."""
        center, omega = own.mark, one.omega
        if one.still:
            common = self.network.finite(self.driver, one.link) if self.driver else None
            base = self.network.finite(self.driver, self.frame) if self.driver else None
            if common is None or base is None or common == base:
                return None
            center, point, omega = base, common, self.speed
        if omega is None or center == point:
            return None
        known = self.draft.board.length(center, point)
        name = f"{center.name}{point.name}"
        distance = known or self.network.draw(measure, name, center, point, why=why.RADIUS)
        value = self.network.draw(f.speed_about, f"v_{letter}", omega, distance, unit="m/s")
        return value, distance


PLAN = Plan(needs=lambda scene: {VELOCITIES: True}, record=record)
