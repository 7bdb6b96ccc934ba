"""The replacing linkage on each arc: its plans of velocities and accelerations while the cam turns evenly.

On an arc the cam OK and a rod KB move the follower as crank and rod of a linkage do: k goes round O, b round k
and along the follower's way (of a lever, round its pivot). A straight flank is a slot of the cam, in which B
slides away from the cam's point Q under it; a flat face is a slot of the follower, in which K slides (a Scotch
yoke). Directions are those of the contour, about which the frame goes round, so the square takes them from
there. The cam's angular velocity is put to 1: vectors are v/ω = dS/dφ and a/ω² = d²S/dφ², in m.

At a change of arcs the follower has one velocity and two accelerations: those before and behind it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import coriolis, normal, rate, rescaled
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point, Reals
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam import words as why
from graphic_tmm.chapters.arc_cam.contour import Arc
from graphic_tmm.chapters.arc_cam.formulas import on_arc, while_on
from graphic_tmm.chapters.arc_cam.geometry import ARCS, SAME
from graphic_tmm.chapters.arc_cam.plan import ArcCam
from graphic_tmm.chapters.arc_cam.task import CHANGES

VELOCITIES, ACCELERATIONS = "arc cam velocities", "arc cam accelerations"
Pick = Callable[[Reals], Reals]


class Vectors(NamedTuple):
    """A plan of an arc: points from its pole on, as crank, rod or slot, and follower lead to them.

    ``crank``: k, ``fixed`` if it is the same in all positions; ``own``: behind the normal part, or that of
    Coriolis, None without one; ``lever``: behind the normal part of a lever; ``end``: b. ``letters`` of these
    four. Of velocities, ``part``: kb along its line, ``swing``: pb square to a lever with a slot (Length).
    """

    crank: Mark
    own: Mark | None
    lever: Mark | None
    end: Mark
    letters: tuple[str, str, str, str]
    fixed: bool
    part: Mark | None = None
    swing: Mark | None = None


class Linkage(NamedTuple):
    """What replaces the cam on one arc: both its plans."""

    velocities: Vectors
    accelerations: Vectors


class Plans(NamedTuple):
    """Both plans: their poles, scale factors (m by a radian, or its square, a mm), linkages by the arcs' names.

    ``asked``: the positions (indices) in which they are drawn; ``names``: of all positions.
    ``rows``: how what is given of each position follows from the share of the angle of work.
    ``first``: dS/dφ (m; of a lever 1); ``second``: d²S/dφ² before a change of arcs and behind it.
    """

    poles: tuple[Mark, Mark]
    scales: tuple[Mark, Mark]
    linkages: dict[str, Linkage]
    first: Mark
    second: tuple[Mark, Mark]
    asked: tuple[int, ...]
    names: tuple[str, ...]
    rows: Mapping[Mark, Pick]


class _Bars(NamedTuple):
    """The linkage as it stands on the contour: crank OK and its length, normal or slot, length of the rod.

    ``image``: the letter of the crank's end on a plan of vectors; ``pin``: K; ``way`` of what follows.
    """

    image: tuple[str, str]
    crank: Mark
    length: Mark
    along: Mark
    rod: Mark | None
    pin: Mark
    way: _Way


class _Way(NamedTuple):
    """The line that the follower's point moves along; of a lever that of its arm, and how long this is."""

    line: Mark
    arm: Mark | None = None


def draw_plans(draft: Draft, made: ArcCam, names: tuple[str, ...]) -> Plans:
    """Draw both plans in every position: on the base circle the follower stands."""
    changes = (np.array(made.lie.changes) - made.lie.changes[0]) / made.lie.work
    shares = np.array(made.angles) / made.lie.work
    draft.open(VELOCITIES)
    poles = [draft.take(Point, "p", 0j)]
    scales = [draft.scale("μ_{v/ω}", "(m/rad)/mm")]
    draft.lay_out(poles[0])
    plans = _Plans(draft, made, poles, scales)
    bars, velocities = plans.bars_of, dict[str, Vectors]()
    for k, name in enumerate(ARCS):
        start, end = changes[k : k + 2]
        on = partial(_between, start - SAME, end + SAME, off=np.nan)
        if end - start > SAME and np.isfinite(on(shares)).any():
            draft.say(name)
            bars[name] = plans.bars(made.contour.arcs[name], plans.take(on))
            velocities[name] = plans.velocities(bars[name], str(k + 1))
    spans = {name: (changes[ARCS.index(name)], changes[ARCS.index(name) + 1]) for name in bars}
    if made.lie.whole:
        spans = dict.fromkeys(bars, (-np.inf, np.inf))
    pick = {
        by: {name: partial(_between, start - by, end - by) for name, (start, end) in spans.items()}
        for by in (-SAME, SAME)
    }
    first = plans.read(velocities, pick[-SAME], "S′_{K}")
    draft.open(ACCELERATIONS)
    poles.append(draft.take(Point, "π", 0j))
    scales.append(draft.scale("μ_{a/ω²}", "(m/rad²)/mm"))
    draft.lay_out(poles[1])
    accelerations = {}
    for name, one in bars.items():
        draft.say(name)
        index = str(ARCS.index(name) + 1)
        accelerations[name] = plans.accelerations(one, velocities[name], index)
    before, behind = (
        plans.read(accelerations, pick[by], letter)
        for by, letter in ((-SAME, "S″_{K}"), (SAME, "S″_{K+}"))
    )
    linkages = {n: Linkage(velocities[n], accelerations[n]) for n in bars}
    return Plans(
        (poles[0], poles[1]),
        (scales[0], scales[1]),
        linkages,
        first,
        (before, behind),
        tuple(_drawn_at(made, names)),
        names,
        plans.rows,
    )


def _between(start: float, end: float, shares: Reals, off: float = 0.0) -> Reals:
    return np.where((shares > start) & (shares < end), 1.0, off)


class _Plans:
    """Both plans while they are drawn: each with its pole and its scale factor, the last of them open."""

    def __init__(self, draft: Draft, made: ArcCam, poles: list[Mark], scales: list[Mark]) -> None:
        self.draft, self.made, self.poles, self.scales = draft, made, poles, scales
        self.flat, self.bars_of = made.order.flat, dict[str, _Bars]()
        self.shares, self.rows = np.array(made.angles) / made.lie.work, dict[Mark, Pick]()
        follower = made.follower
        if follower.pivots is None:
            self.way = _Way(follower.guides)
        else:
            arm = draft.draw(join, "(O_1B)", follower.pivots, follower.points)
            long = draft.draw(measure, "O_1B", follower.pivots, follower.points)
            self.way = _Way(arm, long)

    def take(self, pick: Pick) -> Mark:
        """Take what is given of every position."""
        at = self.draft.take(Number, "σ", pick(self.shares)[None, :])
        self.rows[at] = pick
        return at

    def bars(self, arc: Arc, at: Mark) -> _Bars:
        """Draw the replacing linkage on an arc; ``at``: 1 in its positions, missing elsewhere."""
        draw, origin = self.draft.draw, self.made.contour.origin
        pin, rod = arc.centre, arc.reach
        if pin is None:
            assert arc.way is not None
            pin, along, rod = self.made.follower.points, arc.way, None
        letter, _, number = pin.name.lower().partition("_")
        image = ("q", "") if arc.centre is None else (letter, number and f"_{number}")
        pin = draw(while_on, f"{pin.name}′", pin, at, free=True)
        way = self.way
        if self.flat and way.arm is not None:
            along, rod = draw(parallel, "(f)", pin, way.line, why=why.YOKE), None
            way = self._lever_to(pin)
        elif self.flat:
            along, rod = draw(square, "(f)", pin, way.line, sense=1, why=why.YOKE), None
        elif arc.centre is not None:
            along = draw(join, f"({arc.centre.name}B)", pin, self.made.follower.points)
        crank = draw(join, f"(O{pin.name})", origin, pin, why=why.LINKAGE)
        long = draw(measure, f"O{pin.name}", origin, pin)
        return _Bars(image, crank, long, along, rod, pin, way)

    def _lever_to(self, pin: Mark) -> _Way:
        """Draw the line from the lever's pivot to the point that slides in its slot."""
        pivots = self.made.follower.pivots
        assert pivots is not None
        line = self.draft.draw(join, f"(O_1{pin.name})", pivots, pin, why=why.YOKE)
        return _Way(line, self.draft.draw(measure, f"O_1{pin.name}", pivots, pin))

    def _crank(self, bars: _Bars, letter: str, line: Mark) -> Mark:
        """Lay the crank's vector off on its line."""
        mu, pole = self.scales[-1], self.poles[-1]
        length = self.draft.draw(
            rescaled, f"{pole.name}{letter}", bars.length, self.made.contour.mu, mu, why=why.CRANK
        )
        return self.draft.draw(lay_off, letter, line, length, free=True, why=why.CRANK)

    def velocities(self, bars: _Bars, index: str) -> Vectors:
        """Draw the plan of velocities on an arc."""
        draw, pole, way = self.draft.draw, self.poles[0], bars.way
        turned = draw(square, "(pk)", pole, bars.crank, sense=self.made.sense)
        crank = self._crank(bars, "".join(bars.image), turned)
        across = parallel if bars.rod is None else square
        line = draw(across, f"({crank.name}b)", crank, bars.along, sense=1, why=why.TURNS_OR_SLIDES)
        op = parallel if way.arm is None else square
        moves = draw(op, "(pb)", pole, way.line, sense=1, why=why.MOVES)
        end = draw(meet, f"b_{index}", line, moves, free=True, why=why.BOTH)
        part, swing = draw(measure_along, f"{crank.name}b", crank, end, line), None
        if self.flat and way.arm is not None:
            swing = draw(measure_along, f"pb_{index}", pole, end, moves)
        letters, fixed = ("".join(bars.image), "", "", "b"), bars.rod is not None or self.flat
        return Vectors(crank, None, None, end, letters, fixed, part, swing)

    def accelerations(self, bars: _Bars, known: Vectors, index: str) -> Vectors:
        """Draw the plan of accelerations on an arc whose velocities are ``known``."""
        draw, pole, (mu_v, mu_a) = self.draft.draw, self.poles[1], self.scales
        mu_l, way = self.made.contour.mu, bars.way
        inward = draw(parallel, "(πk′)", pole, bars.crank, sense=-1)
        crank, own = self._crank(bars, "′".join(bars.image), inward), None
        assert known.part is not None
        start, op = crank, parallel
        if bars.rod is not None:
            size = draw(normal, f"{crank.name}n", known.part, mu_v, bars.rod, mu_l, mu_a)
            back = draw(parallel, f"(k′n_{index})", crank, bars.along, sense=-1, why=why.ROD)
            start, op = draw(lay_off, f"n_{index}", back, size, free=True, why=why.ROD), square
        elif way.arm is not None or not self.flat:
            if known.swing is None:
                turns, sense = self.draft.constant("", 1.0, ""), self.made.sense
            else:
                assert way.arm is not None
                turns = draw(rate, "ψ′", known.swing, mu_v, way.arm, mu_l, unit="rad")
                sense = 1
            size = draw(coriolis, f"{crank.name}k", turns, known.part, mu_v, mu_a)
            turned = draw(square, f"({crank.name}k)", crank, bars.along, sense=sense)
            start = draw(lay_off, f"k_{index}", turned, size, free=True)
        own = start if start is not crank else None
        line = draw(op, f"(n_{index}b′)", start, bars.along, sense=1, why=why.TURNS_OR_SLIDES)
        foot, lever = pole, None
        if way.arm is not None:
            part = draw(measure, f"pb_{index}", self.poles[0], known.end)
            size = draw(normal, "πm", part, mu_v, way.arm, mu_l, mu_a)
            inward = draw(parallel, "(πm)", pole, way.line, sense=-1, why=why.LEVER)
            lever = foot = draw(lay_off, f"m_{index}", inward, size, free=True, why=why.LEVER)
        across = parallel if way.arm is None else square
        moves = draw(across, "(πb′)", foot, way.line, sense=1, why=why.MOVES)
        end = draw(meet, f"b′_{index}", line, moves, free=True, why=why.BOTH)
        letters = ("′".join(bars.image), "k" if bars.rod is None else "n", "m", "b′")
        return Vectors(crank, own, lever, end, letters, known.fixed)

    def _slotted(self, pick: Mapping[str, Pick]) -> _Way:
        """Put together the lines from a lever's pivot to what slides in its slot, arc by arc."""
        pin = self.made.follower.points
        for k, (name, one) in enumerate(self.bars_of.items(), start=1):
            at = self.take(pick[name])
            letter = "K" if k == len(pick) else f"K_{{1–{k}}}"
            pin = self.draft.draw(on_arc, letter, one.pin, pin, at, free=True)
        return self._lever_to(pin)

    def read(self, found: dict[str, Vectors], pick: Mapping[str, Pick], letter: str) -> Mark:
        """Put the arcs together, and read what the follower does; on the base circle both ends are the pole.

        ``pick``: by arc, what is 1 in the positions in which it is taken.
        """
        draw, pole, way = self.draft.draw, self.poles[-1], self.way
        start = end = pole
        if self.flat and way.arm is not None:
            way = self._slotted(pick)
        whole = "b" if pole is self.poles[0] else "b′"
        last = [*found][-1]
        for k, (name, one) in enumerate(found.items(), start=1):
            at = self.take(pick[name])
            until = "" if name == last else f"_{{1–{k}}}"
            end = draw(on_arc, f"{whole}{until}", one.end, end, at, free=True)
            if one.lever is not None:
                start = draw(on_arc, f"m{until}", one.lever, start, at, free=True)
        segment = f"{start.name}{whole}"
        mu, mu_l = self.scales[-1], self.made.contour.mu
        if way.arm is None:
            part = draw(measure_along, segment, start, end, way.line)
            return draw(f.transfer, letter, part, mu, unit="m")
        left = self.made.sense * (-1 if self.made.order.same_sense else 1)
        line = draw(square, f"({segment})", start, way.line, sense=-left)
        part = draw(measure_along, segment, start, end, line)
        return draw(rate, letter.replace("S", "ψ"), part, mu, way.arm, mu_l, unit="rad")


def _drawn_at(made: ArcCam, names: Sequence[str]) -> list[int]:
    """Return the positions (indices) whose plans are drawn; a change of arcs may be one of the row."""
    asked = made.order.accelerations
    turned = np.array(made.angles) + made.lie.changes[0]
    at = [i for i, name in enumerate(CHANGES, start=1) if name in asked]
    on = {k for i in at for k in np.flatnonzero(np.abs(turned - made.lie.changes[i]) < 1e-6)}
    return [k for k, name in enumerate(names) if k in on or name in asked or asked == ("all",)]
