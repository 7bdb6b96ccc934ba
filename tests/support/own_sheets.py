"""Photographs of a student's own sheet: his μ, turn, places, letters, heads, squares, frame; right and wrong.

Nothing of the package is used: mechanisms are plane geometry, strokes are strewn as graphite
(`support.photographed.pencil`), seen by a camera of known place (`support.photographed.shooting`). A kind of
sheet is a mechanism of tests/cases/check with one mistake, or none; what a student goes on with is what he has.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from support.own_boards import MACHINES, A, Board, Mu, V
from support.photographed.ink import Inked
from support.photographed.pencil import Pencil, drawn
from support.photographed.shooting import Light, Marks, jpeg, shot, soiled
from support.photographed.taking import Conditions, aimed, turned

SIZES = {"A1": (841.0, 594.0), "A4": (210.0, 297.0)}
WRONGLY = 2.0
"""A point that the mistake moves farther, mm, was drawn wrongly."""


@dataclass(frozen=True, eq=False)
class Kind:
    """A kind of sheet. ``mu``: times the scene's, by plan; ``turn``: of the velocities, degrees."""

    machine: str = "sc"
    wrong: str = ""
    size: str = "A1"
    mu: Mu = field(default_factory=lambda: {V: 1.0, A: 1.0})
    turn: float = 0.0
    frame: str = "frame"
    heads: float = 3.5
    rings: bool = False
    squares: float = 0.0
    pencil: Pencil = field(default_factory=Pencil)
    light: Light = field(default_factory=Light)
    tilt: tuple[float, float] = (12.0, 90.0)
    wide: int = 4000
    stains: int = 0


class Truth(NamedTuple):
    """A point as drawn: mm from its pole in the student's own mm, not turned; how far the mistake moves it.

    ``plain``: whether pencil shows it by itself, no other point near.
    """

    spot: complex
    off: float
    plain: bool


Key = tuple[str, str, str]
"""Plan, letter, position."""


class Sheet(NamedTuple):
    """A photograph of an own sheet and the truth.

    ``corners``: of the frame, ``edges``: of the paper (px, as `flatten` counts them);
    ``plans``: p and a of each plan, px; ``mu``: the student's, SI per mm.
    """

    kind: Kind
    jpeg: bytes
    size: tuple[float, float]
    frame: tuple[float, float, float, float]
    corners: np.ndarray
    edges: np.ndarray
    plans: dict[tuple[str, str], tuple[complex, complex]]
    points: dict[Key, Truth]
    mu: Mu


class Paper(NamedTuple):
    size: tuple[float, float]
    frame: tuple[float, float, float, float]


GLYPHS = (
    ((0, 0, 1, 2, 2, 0), (0.5, 1, 1.5, 1)),
    ((0, 2, 0, 0, 1, 0, 1, 1, 0, 1),),
    ((1, 1, 0, 1, 0, 0, 1, 0),),
    ((1, 1, 0.2, 1, 0.2, 0.5, 0.9, 0.5, 0.9, 0, 0, 0),),
    ((0, -0.8, 0, 1, 1, 1, 1, 0, 0, 0),),
    ((0, 0, 0, 1, 0.5, 1, 1, 0.8, 1, 0),),
)
"""Strokes of some small letters, x and y by turns."""


def own_sheet(kind: Kind, seed: int) -> Sheet:
    """Return a photograph of a sheet of some kind."""
    rng = np.random.default_rng([seed, 33])
    machine = MACHINES[kind.machine]
    size = SIZES[kind.size]
    frame = _frame(kind, size)
    mu = {plan: machine.mu[plan] * kind.mu[plan] for plan in (V, A)}
    wanted = [(V, k) for k in range(8)] + [(A, k) for k in machine.accelerated]
    if kind.size == "A4":
        wanted = [(V, machine.accelerated[0]), (A, machine.accelerated[0])]
    ink = list(_ruled(kind, size, frame))
    points: dict[Key, Truth] = {}
    poles: dict[tuple[str, str], tuple[complex, complex]] = {}
    boards = {}
    for plan, k in wanted:
        board, wrong, due = Board(rng), Board(None), Board(None)
        for one, how in ((board, kind.wrong), (wrong, kind.wrong), (due, "")):
            machine.draw(one, plan, k * np.pi / 4, mu, how)
        boards[plan, k] = board, wrong, due
    for (plan, k), origin in _laid(kind, boards, size, rng).items():
        board, wrong, due = boards[plan, k]
        turn = np.exp(1j * np.radians(kind.turn)) if plan == V else 1.0
        ink += strokes(board, origin, turn, kind, rng)
        poles[plan, str(k)] = origin, origin + turn * board.points["a"]
        for letter, z in board.points.items():
            if letter:
                off = abs(wrong.points[letter] - due.points[letter])
                truth = Truth(z, off, _plain(letter, board))
                points[plan, letter, str(k)] = truth
    lead = drawn(ink, size, kind.pencil, seed)
    how = Conditions(kind.pencil, tilt=kind.tilt, light=kind.light, wide=kind.wide)
    whole = (-3.0, -3.0, size[0] + 3.0, size[1] + 3.0)
    camera = aimed(Paper(size, whole), how)  # type: ignore[arg-type]
    dirt = soiled(lead, size, Marks(kind.squares, kind.stains, kind.stains), seed)
    image = shot(camera, dirt, kind.light, seed)

    def seen(some: list[complex]) -> np.ndarray:
        return turned(camera.seen(np.array(some)), 0, camera.columns, camera.rows)

    corners, edges = (seen(_corners(box)) for box in (frame, (0.0, 0.0, *size)))
    clicks = {at: tuple(seen(list(two))) for at, two in poles.items()}
    return Sheet(
        kind, jpeg(image, kind.light.quality), size, frame, corners, edges, clicks, points, mu
    )  # type: ignore[arg-type]


def _corners(box: tuple[float, float, float, float]) -> list[complex]:
    left, bottom, right, top = box
    return [complex(x, y) for x, y in ((left, bottom), (right, bottom), (right, top), (left, top))]


def _frame(kind: Kind, size: tuple[float, float]) -> tuple[float, float, float, float]:
    """Return the frame, mm; the paper itself where none is drawn."""
    wide, high = size
    if kind.frame == "none":
        return 0.0, 0.0, wide, high
    if kind.frame == "ten":
        return 10.0, 10.0, wide - 10, high - 10
    return 20.0, 5.0, wide - 5, high - 5


def _plain(letter: str, board: Board) -> bool:
    """Whether pencil shows a point by itself: no other one (or the pole) is within 3 mm."""
    at = board.points[letter]
    return all(abs(at - z) > 3.0 for other, z in board.points.items() if other != letter)


def _ruled(kind: Kind, size: tuple[float, float], frame: tuple[float, float, float, float]):
    """Yield the frame, and a small stamp of the student's own kind."""
    if kind.frame == "none":
        return
    left, bottom, right, _ = frame
    corners = _corners(frame)
    for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
        yield Inked(np.array([a, b]), "thick", "frame")
    wide, high = min(90.0, (right - left) / 3), 15.0
    stamp = [
        right - wide + 1j * bottom,
        right - wide + 1j * (bottom + high),
        right + 1j * (bottom + high),
    ]
    for a, b in itertools.pairwise(stamp):
        yield Inked(np.array([a, b]), "main", "frame")


def _laid(kind: Kind, boards: dict, size: tuple[float, float], rng: np.random.Generator) -> dict:
    """Return the pole of every plan, at random places of a grid in random order."""
    boxes = {}
    for at, (board, *_) in boards.items():
        turn = np.exp(1j * np.radians(kind.turn)) if at[0] == V else 1.0
        spots = turn * np.array([z for two in board.lines for z in two[:2]])
        boxes[at] = spots.real.min(), spots.imag.min(), spots.real.max(), spots.imag.max()
    wide = max(b[2] - b[0] for b in boxes.values()) + 14
    high = max(b[3] - b[1] for b in boxes.values()) + 14
    left, bottom, right, top = 25.0, 24.0, size[0] - 12, size[1] - 12
    columns = max(int((right - left) / wide), 1)
    rows = max(int((top - bottom) / high), 1)
    assert columns * rows >= len(boxes), (kind, columns, rows)
    cells = rng.permutation(columns * rows)[: len(boxes)]
    poles = {}
    order = list(boxes)
    rng.shuffle(order)
    for cell, at in zip(cells, order, strict=True):
        at = tuple(at)
        plan, k = at[0], int(at[1])
        row, column = divmod(int(cell), columns)
        room = (right - left) / columns, (top - bottom) / rows
        b = boxes[plan, k]
        slack = [(room[0] - (b[2] - b[0])) / 2, (room[1] - (b[3] - b[1])) / 2]
        aside = [rng.uniform(-0.4, 0.4) * max(s - 5, 0) for s in slack]
        x = left + column * room[0] + slack[0] - b[0] + aside[0]
        y = bottom + row * room[1] + slack[1] - b[1] + aside[1]
        poles[plan, k] = complex(x, y)
    return poles


def strokes(board: Board, origin: complex, turn: complex, kind: Kind, rng: np.random.Generator):
    """Yield the strokes of a plan: lines, heads, rings, letters."""
    word = int(rng.integers(1, 1 << 30))
    for p, q, style in board.lines:
        a, b = origin + turn * p, origin + turn * q
        if abs(b - a) < 0.3:
            continue
        pen = "main" if style == "vector" else "thin"
        yield Inked(np.array([a, b]), pen, "plan", of=frozenset({1}))
        if style == "vector" and kind.heads and abs(b - a) > 2 * kind.heads:
            way = (b - a) / abs(b - a)
            for side in (-1, 1):
                wing = b - way * kind.heads * np.exp(1j * np.radians(12 * side))
                yield Inked(np.array([b, wing]), "main", "plan")
    for letter, z in board.points.items():
        at = origin + turn * z
        if kind.rings:
            yield Inked(at + 0.8 * np.exp(2j * np.pi * np.arange(17) / 16), "main", "plan")
        place = at + 5.0 * np.exp(1j * rng.uniform(0, 2 * np.pi))
        for _ in range(max(len(letter), 1)):
            word += 1
            for stroke in GLYPHS[rng.integers(len(GLYPHS))]:
                xy = np.array(stroke).reshape(-1, 2)
                yield Inked(place + 1.6 * (xy[:, 0] + 1j * xy[:, 1]), "letters", "plan", word=word)
            place += 2.6


def _kinds() -> list[Kind]:
    """Return forty kinds of sheets; a third of them wrong, a quarter A4."""
    found: list[Kind] = []
    rng = np.random.default_rng(77)
    names = [(n, w) for n, m in MACHINES.items() for w in m.wrong]
    rng.shuffle(names)
    wrong = iter(names)
    round_mu = (0.8, 1.0, 1.25, 1.6, 2.0)
    for k in range(48):
        a4 = k % 4 == 3
        machine, how = next(wrong) if k % 3 == 0 else (("sc", "fb", "rpr")[k // 2 % 3], "")
        mu = {p: float(rng.choice(round_mu[1:] if p == A else round_mu)) for p in (V, A)}
        if k % 5 == 4:
            mu = {p: float(rng.uniform(0.85, 1.9)) for p in (V, A)}
        light = (rng.uniform(0.22, 0.35), rng.uniform(0.4, 0.7))
        found.append(
            Kind(
                str(machine),
                str(how),
                "A4" if a4 else "A1",
                mu,
                turn=90.0 if k % 8 == 5 and not how else 0.0,
                frame=("frame", "ten", "none")[k % 7 % 3],
                heads=float(rng.choice([0.0, 2.5, 3.5, 5.0])),
                rings=bool(rng.random() < 0.4),
                squares=float(rng.uniform(0.4, 0.9)) if k % 6 == 2 else 0.0,
                pencil=Pencil(light, (rng.uniform(0.35, 0.55), rng.uniform(0.6, 0.95)), past=0.4),
                light=Light(
                    fall=rng.uniform(0.6, 0.95), noise=rng.uniform(2, 6), blur=rng.uniform(0.5, 1.0)
                ),
                tilt=(float(rng.uniform(3, 20)), float(rng.uniform(0, 360))),
                stains=int(rng.integers(0, 3)),
                wide=4000 if not a4 else 2800,
            )
        )
    return found


KINDS = tuple(_kinds())
