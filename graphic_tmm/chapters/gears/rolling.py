"""Arcs laid off and measured, figures turned and reflected, curves met: what a profile is drawn with."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.geometry import TANGENT, cis, degrees, wedge
from graphic_tmm.board.grammar import ANGLE, CURVE, FREE, RAY, operation
from graphic_tmm.board.operations.graph_curves import open_graph
from graphic_tmm.board.operations.graphs import alike
from graphic_tmm.board.values import Angle, Arc, Complexes, Curve, Length, Line, Point, Reals
from graphic_tmm.language.said import said

_HALVINGS = 60
"""Halvings of a bracket: more than the 53 bits of a number."""
_SAMPLES = 16
"""Chords to an arc of a curve while a crossing is looked for."""
_PASSES = 8
"""Newton's steps: each doubles the digits, and they begin a sixteenth of an arc off at most."""


@operation(
    symbol="N1 + P1 + P2",
    fails="the arc has no radius",
    why=said(
        "The thread wound off the base circle is as long as the arc that it leaves: equal pieces of line "
        "and arc belong together."
    ),
)
def along_arc(start: Point, arc: Arc, length: Length, *, sense: int = 1) -> Point:
    """From {start} lay off along the arc {arc} the length {length}; mark {it}.

    ``sense``: 1 counter-clockwise, −1 clockwise.
    """
    turned = np.where(arc.radius == 0.0, np.nan, sense * length / arc.radius)
    return Point(arc.centre + (start - arc.centre) * np.exp(1j * turned))


@operation(
    symbol=f"{ANGLE} + N1",
    reads=True,
    why=said("The arc is the angle at its centre, in radians, times its radius."),
)
def measure_arc(start: Point, end: Point, arc: Arc, *, sense: int = 1) -> Length:
    """Measure the arc {start}{end} along {arc}.

    ``sense``: 1 if it is positive counter-clockwise, −1 if clockwise; less than half a turn.
    """
    turned = np.angle((end - arc.centre) / (start - arc.centre))
    return Length(sense * arc.radius * turned)


@operation(
    symbol=ANGLE,
    fails="a side has no length",
    why=said("By this angle the flank has to be turned to go through the point."),
)
def angle_at(centre: Point, start: Point, end: Point) -> Angle:
    """Measure the angle {start}{centre}{end}, counter-clockwise positive."""
    return Angle(degrees((end - centre) / (start - centre)))


@operation(
    symbol=f"2C1 + C3 + {RAY}",
    why=said(
        "All teeth of a wheel are alike: the next one is this one turned by the angular pitch."
    ),
)
def turn_about(of: Point, about: Point, by: Angle, *, sense: int = 1) -> Point:
    """Turn {of} about {about} by the angle {by}; mark {it}."""
    return Point(about + (of - about) * cis(sense * by))


@operation(
    symbol="2C1 + 2C2 + 2C3",
    why=said("A tooth is symmetrical about its axis: the other flank is the mirror image."),
)
def reflect(of: Point, axis: Line) -> Point:
    """Mark {it}, symmetrical to {of} about {axis}."""
    return Point(axis.at + np.conj((of - axis.at) / axis.along) * axis.along)


@operation(
    symbol=CURVE,
    across=True,
    why=said("The curve goes smoothly through the points found."),
)
def smooth_through(through: Point, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it} with the French curve.

    ``row``: how many points it passes through, from the first one.
    """
    return open_graph.run(through[:, : row - 1], through[:, row - 1 : row], row=row - 1)  # type: ignore[no-any-return]


@operation(symbol=FREE, why=said("The involute begins on the base circle."))
def beginning(curve: Curve) -> Point:
    """Mark {it}, the beginning of the curve {curve}."""
    return Point(curve.knots[:, :1])


class _Arcs(NamedTuple):
    """Arcs of a curve: where each begins and ends, and its tangents there."""

    p: Complexes
    q: Complexes
    m: Complexes
    n: Complexes

    def pick(self, at: Any) -> _Arcs:
        """The arcs of these indices."""
        return _Arcs(*(values[at] for values in self))

    def on(self, u: Any) -> Complexes:
        """The points at the parameters ``u``, 0 … 1."""
        bend, twist = 3 * (self.q - self.p) - 2 * self.m - self.n, self._twist()
        return np.asarray(self.p + u * (self.m + u * (bend + u * twist)))

    def slope(self, u: Any) -> Complexes:
        """The derivatives by the parameter."""
        bend, twist = 3 * (self.q - self.p) - 2 * self.m - self.n, self._twist()
        return np.asarray(self.m + u * (2 * bend + 3 * u * twist))

    def _twist(self) -> Complexes:
        return np.asarray(2 * (self.p - self.q) + self.m + self.n)


def _arcs(curve: Curve, trial: Any = slice(None)) -> _Arcs:
    """Return the arcs of a trial's curve, (arc,), or those of all trials, (trial, arc)."""
    p, m = curve.knots[trial], curve.tangents[trial]
    return _Arcs(p[..., :-1], p[..., 1:], m[..., :-1], m[..., 1:])


@operation(
    symbol=FREE,
    fails="the curve does not reach the arc",
    why=said("There the flank ends at its circle."),
)
def curve_meets_arc(curve: Curve, arc: Arc) -> Point:
    """Where the curve {curve} first meets the arc {arc}, mark {it}."""
    centres, radii = np.broadcast_arrays(arc.centre, arc.radius)
    knots, tangents, centres, radii = alike(curve.knots, curve.tangents, centres, radii)
    return Point(_reach(_arcs(Curve(knots, tangents, curve.closed)), centres, radii))


def _reach(arcs: _Arcs, centres: Complexes, radii: Reals) -> Complexes:
    """Return where arcs of curves first reach circles: a knot, or by halving the arc that crosses.

    ``arcs``: (trial, arc), each trial's of one curve; ``centres``, ``radii``: (trial, circle).
    """
    knots = np.concatenate([arcs.p, arcs.q[:, -1:]], axis=1)[:, :, None]
    centre, radius = centres[:, None, :], radii[:, None, :]
    away = np.abs(knots - centre)
    gap = away - radius
    outside, slack = gap >= 0.0, TANGENT * (np.abs(knots) + away + radius)
    there = np.isfinite(knots[:, 1:]) & np.isfinite(knots[:, :-1]) & np.isfinite(radius)
    changes = (outside[:, 1:] != outside[:, :-1]) & there
    at = np.argmax(changes, axis=1)
    own = _Arcs(*(np.take_along_axis(values, at, axis=1) for values in arcs))
    begins = np.take_along_axis(outside, at[:, None, :], axis=1)[:, 0]
    low, high = np.zeros(at.shape), np.ones(at.shape)
    for _ in range(_HALVINGS):
        u = (low + high) / 2.0
        still = (np.abs(own.on(u) - centres) >= radii) == begins
        low, high = np.where(still, u, low), np.where(still, high, u)
    crosses = changes.any(axis=1)
    crossed = np.where(crosses, own.on((low + high) / 2.0), np.nan)
    stands = np.abs(gap) <= slack
    knot, last = np.argmax(stands, axis=1), np.where(crosses, at + 1, gap.shape[1])
    spot = np.take_along_axis(knots[:, :, 0], knot, axis=1)
    return np.where(stands.any(axis=1) & (knot <= last), spot, crossed)


@operation(
    symbol=FREE,
    fails="the curves do not meet",
    why=said("There one curve goes over into the other."),
)
def curves_cross(first: Curve, second: Curve) -> Point:
    """Where the curves {first} and {second} cross, mark {it}: the first such place along {first}."""
    trials = max(first.knots.shape[0], second.knots.shape[0])
    each = [[_arcs(one, k % len(one.knots)) for one in (first, second)] for k in range(trials)]
    spots = [_crossing(*two) for two in each]
    return Point(np.array(spots, dtype=np.complex128)[:, None])


def _crossing(first: _Arcs, second: _Arcs) -> complex:
    """Return the first crossing of two chains of arcs: that of their chords, then Newton's steps."""
    share = np.linspace(0.0, 1.0, _SAMPLES + 1)[None, :]
    spots = [arcs.pick((slice(None), None)).on(share) for arcs in (first, second)]
    (a, da), (b, db) = ((s[:, :-1].ravel(), np.diff(s, axis=1).ravel()) for s in spots)
    between, sine = b[None, :] - a[:, None], wedge(da[:, None], db[None, :])
    s, t = wedge(between, db[None, :]) / sine, wedge(between, da[:, None]) / sine
    hit = (s >= 0.0) & (s <= 1.0) & (t >= 0.0) & (t <= 1.0)
    if not hit.any():
        return complex(np.nan, np.nan)
    i, j = np.unravel_index(int(np.argmax(hit)), hit.shape)
    u, v = (i % _SAMPLES + s[i, j]) / _SAMPLES, (j % _SAMPLES + t[i, j]) / _SAMPLES
    one, other = first.pick(i // _SAMPLES), second.pick(j // _SAMPLES)
    for _ in range(_PASSES):
        gap, along, across = other.on(v) - one.on(u), one.slope(u), other.slope(v)
        sine = wedge(along, across)
        u, v = u + wedge(gap, across) / sine, v + wedge(gap, along) / sine
    return complex(one.on(u))
