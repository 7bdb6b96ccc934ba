"""A cam of arcs by itself: points of its contour, and a follower lowered onto it until it touches."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.arc_cam.plan import ArcCam, draw_arc_cam
from graphic_tmm.chapters.arc_cam.task import FLAT, FLAT_ROCKER, ROCKER, ROLLER, ArcTask, Flank

FINE = 40_000
"""Points of each circle."""


def drawn(order: ArcTask) -> tuple[ArcCam, Construction, Reading]:
    """A cam on a draft of its own, drawn by the exact hand."""
    draft = Draft()
    made = draw_arc_cam(draft, order)
    log = draft.board.construction()
    given = dict(draft.given) | {made.charts[k].mu: v for k, v in MU.items()}
    return made, log, execute(log, given)


MU = {"S": 0.0002, "V": 0.0005, "A": 0.001}


def contour(order: ArcTask, fine: int = FINE) -> list[np.ndarray]:
    """Polylines of the contour, nose downward, the flank of the rise on the left (it turns clockwise)."""
    round_ = np.exp(2j * np.pi * (np.arange(fine + 3) + 0.37) / fine)
    nose = -1j * order.distance
    if order.eccentric:
        return [nose + order.nose * round_]
    found = [order.base * round_, nose + order.nose * round_]
    for flank, side in ((order.rise, -1.0), (order.fall, 1.0)):
        found.append(_flank(order, flank, side, fine))
    return found


def _flank(order: ArcTask, flank: Flank, side: float, fine: int) -> np.ndarray:
    """Points of a flank; ``side``: −1 on the left. Its centre is sought by halving the angle it stands at."""
    nose, share = -1j * order.distance, np.linspace(0.0, 1.0, fine)
    if flank.radius is None:

        def gap(turn: float) -> float:
            way = side * np.exp(-1j * side * turn)
            return float((nose * np.conj(way)).real) - (order.base - order.nose)

        turn = _halved(gap, 0.0, math.pi / 2)
        way = side * np.exp(-1j * side * turn)
        return (1 - share) * order.base * way + share * (nose + order.nose * way)
    sign = 1.0 if flank.hollow else -1.0
    near, far = (flank.radius + sign * r for r in (order.base, order.nose))

    def miss(turn: float) -> float:
        return abs(sign * side * near * np.exp(-1j * sign * side * turn) - nose) - far

    turn = _halved(miss, -math.pi / 2, math.pi / 2)
    centre = sign * side * near * np.exp(-1j * sign * side * turn)
    first, last = (flank.radius * (z - centre) / abs(z - centre) for z in (0j, nose))
    return centre + first * np.exp(1j * share * np.angle(last / first))


def _halved(of, low: float, high: float) -> float:  # type: ignore[no-untyped-def]
    rising = of(high) > of(low)
    for _ in range(200):
        middle = (low + high) / 2
        if (of(middle) > 0) == rising:
            high = middle
        else:
            low = middle
    return (low + high) / 2


def place(order: ArcTask, angle: float, lines: list[np.ndarray]) -> float:
    """Where the follower stands at an angle of the cam (degrees): its height, or the angle O–O1–B (radians)."""
    sense = 1.0 if order.turns == "counterclockwise" else -1.0
    turned = [_mirrored(line, sense) * np.exp(1j * sense * math.radians(angle)) for line in lines]
    if order.follower == FLAT:
        return max(float(line.imag.max()) for line in turned)
    if order.follower == FLAT_ROCKER:
        return _tilted(order, np.concatenate(turned), sense)
    if order.follower == ROCKER:
        return _swung(order, np.concatenate(turned), sense)
    x, heights = sense * order.offset, []
    for line in turned:
        if order.roller:
            off = np.abs(line.real - x)
            there = off < order.roller
            heights += list(line.imag[there] + np.sqrt(order.roller**2 - off[there] ** 2))
        else:
            a, b = line[:-1], line[1:]
            cuts = (a.real - x) * (b.real - x) <= 0
            share = (x - a.real[cuts]) / np.where(
                b.real[cuts] == a.real[cuts], 1, b.real[cuts] - a.real[cuts]
            )
            heights += list(a.imag[cuts] + share * (b.imag[cuts] - a.imag[cuts]))
    return float(max(heights))


def _mirrored(line: np.ndarray, sense: float) -> np.ndarray:
    return -np.conj(line) if sense > 0 else line


def _swung(order: ArcTask, cloud: np.ndarray, sense: float) -> float:
    assert order.lever is not None
    assert order.centres is not None
    side = sense * (-1.0 if order.same_sense else 1.0)
    pivot = 1j * order.centres
    edge = cloud[np.abs(np.abs(cloud - pivot) - order.lever) < order.roller + 1e-3]

    def clear(angle: float) -> float:
        tip = pivot - 1j * order.lever * np.exp(-1j * side * angle)
        return float(np.abs(edge - tip).min()) - order.roller

    low, high = 0.0, math.pi
    for _ in range(60):
        middle = (low + high) / 2
        if clear(middle) > 0 and not _over(order, cloud, pivot, side, middle):
            high = middle
        else:
            low = middle
    return high


def _tilted(order: ArcTask, cloud: np.ndarray, sense: float) -> float:
    """The angle at the pivot of a flat rocker that is turned towards the cam until its face meets a point."""
    assert order.centres is not None
    side, seen = sense * (-1.0 if order.same_sense else 1.0), cloud - 1j * order.centres

    def beyond(angle: float) -> float:
        normal = -side * np.exp(-1j * side * angle)
        return float((seen * np.conj(normal)).real.max()) + order.roller

    low, high = 0.0, math.pi / 2
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if beyond(middle) > 0 else (low, middle)
    return high


def _over(order: ArcTask, cloud: np.ndarray, pivot: complex, side: float, angle: float) -> bool:
    """Whether the lever's tip stands inside the cam: nearer to its centre than the contour there."""
    tip = pivot - 1j * (order.lever or 0.0) * np.exp(-1j * side * angle)
    way = tip / abs(tip)
    near = np.abs(np.angle(cloud * np.conj(way))) < 1e-3
    return bool(abs(tip) < np.abs(cloud[near]).max()) if near.any() else True


def lowest(order: ArcTask) -> float:
    """Where the follower stands on the base circle."""
    reach = order.base + order.roller
    if order.follower == FLAT:
        return order.base
    if order.follower == FLAT_ROCKER:
        assert order.centres is not None
        return math.asin(reach / order.centres)
    if order.follower == ROCKER:
        assert order.lever is not None
        assert order.centres is not None
        a, b = order.lever, order.centres
        return math.acos((a * a + b * b - reach * reach) / (2 * a * b))
    return math.sqrt(reach**2 - order.offset**2)


KINDS = ("central", "offset", "edge", "flat", "against", "along", "tilted", "tilted along")
FLATS = ("flat", "tilted", "tilted along")
"""Kinds with a flat face: on convex flanks only."""
FLANKS = ("convex", "straight", "hollow", "unlike", "sharp")


def random_order(draw: random.Random, kind: str, flank: str) -> ArcTask:
    """A cam that the follower goes round."""
    base = draw.uniform(0.018, 0.025)
    nose = 0.0 if flank == "sharp" else draw.uniform(0.25, 0.5) * base
    distance = base - nose + draw.uniform(0.4, 0.7) * base
    touching = (distance + base + nose) / 2
    rise = Flank(touching * draw.uniform(1.3, 3.0))
    fall = rise
    if flank == "straight":
        rise = fall = Flank(None)
    elif flank == "hollow":
        rise = fall = Flank(draw.uniform(2.5, 5.0) * base, True)
    elif flank == "unlike":
        fall = Flank(touching * draw.uniform(1.3, 3.0))
    turns = draw.choice(("clockwise", "counterclockwise"))
    order = ArcTask(base, distance, nose, rise, fall, turns=turns, parts=24)
    roller = draw.uniform(0.4, 0.8) * base
    if kind == "flat":
        return replace(order, follower=FLAT)
    if kind.startswith("tilted"):
        face = draw.choice((0.0, draw.uniform(0.1, 0.4) * base))
        size = {"roller": face, "centres": 3.6 * base, "same_sense": kind.endswith("along")}
        return replace(order, follower=FLAT_ROCKER, **size)
    if kind in ("against", "along"):
        size = {"lever": 3.0 * base, "centres": 3.6 * base, "same_sense": kind == "along"}
        return replace(order, follower=ROCKER, roller=roller, **size)
    if kind == "edge":
        return replace(order, follower=ROLLER)
    offset = draw.uniform(-0.3, 0.3) * base if kind == "offset" else 0.0
    return replace(order, follower=ROLLER, roller=roller, offset=offset)
