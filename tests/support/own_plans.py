"""Three plans of a student's own making side by side, seen straight from above: no photograph, no frame."""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.own_sheet.clicked import ClickedPlan
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.paper.ruled import Box
from support.own_boards import MACHINES, A, Board, V
from support.own_sheets import WRONGLY, Kind, strokes
from support.photographed.pencil import DOTS, Pencil, drawn

SIZE = (420.0, 200.0)
HIGH = 4
Key = tuple[str, str, str]


class OwnDrawn(NamedTuple):
    """What is drawn, the plans as clicked, where points stand (mm from the pole), which are wrong.

    ``grey``: the picture itself, `HIGH` dots to the mm.
    """

    flat: Flat
    clicked: list[ClickedPlan]
    spots: dict[Key, complex]
    wrong: set[Key]
    grey: np.ndarray


@functools.cache
def own_plans(kind: Kind, seed: int = 1) -> OwnDrawn:
    """Draw velocities 1 and accelerations 1 and 3 of a mechanism; p and a of each are clicked."""
    machine, rng = MACHINES[kind.machine], np.random.default_rng(seed)
    mu = {plan: machine.mu[plan] * kind.mu[plan] for plan in (V, A)}
    lines, clicked, spots, wrong = [], [], {}, set()
    for n, (plan, k) in enumerate([(V, 1), (A, 1), (A, 3)]):
        board, mistaken, due = Board(rng), Board(None), Board(None)
        for one, how in ((board, kind.wrong), (mistaken, kind.wrong), (due, "")):
            machine.draw(one, plan, k * np.pi / 4, mu, how)
        turn = np.exp(1j * np.radians(kind.turn)) if plan == V else 1.0
        middle = turn * np.mean([z for two in board.lines for z in two[:2]])
        origin = complex(70 + 140 * n, 100) - middle
        lines += strokes(board, origin, turn, kind, rng)
        slips = 0.2 * (rng.standard_normal(2) + 1j * rng.standard_normal(2))
        first = origin + turn * board.points["a"] + slips[1]
        clicked.append(ClickedPlan(plan, str(k), origin + slips[0], first))
        for letter, z in board.points.items():
            if letter:
                spots[plan, letter, str(k)] = z
                if abs(mistaken.points[letter] - due.points[letter]) > WRONGLY:
                    wrong.add((plan, letter, str(k)))
    return _seen(lines, seed, rng, clicked, spots, wrong)


@functools.cache
def own_positions(times: float, seed: int = 1) -> OwnDrawn:
    """Draw all positions of the four-bar upon one another, so many times as large; O and A are clicked."""
    rng, mu, pivot = np.random.default_rng(seed), 0.002 / times, 150 + 60j
    kind, rocker = Kind("fb", rings=True, heads=0.0), 0.3 / mu
    lines, clicked, spots = [], [], {}
    for k in range(8):
        slip = 0.25 * (rng.standard_normal(4) + 1j * rng.standard_normal(4))
        a = 0.08 * np.exp(1j * k * np.pi / 4)
        base = 0.3 - a
        foot = (0.26**2 - 0.18**2 + abs(base) ** 2) / 2 / abs(base)
        b = a + base / abs(base) * (foot + 1j * np.sqrt(0.26**2 - foot**2))
        e = a + (0.15 + 0.1j) / 0.26 * (b - a)
        board = Board(rng)
        board.points |= {"A": a / mu + slip[0], "B": b / mu + slip[1], "E": e / mu + slip[2]}
        board.points["C"] = complex(rocker)
        sides = ("", "A"), ("A", "B"), ("B", "C"), ("A", "E"), ("B", "E")
        board.lines = [(board.points[p], board.points[q], "link") for p, q in sides]
        lines += strokes(board, pivot, 1.0, kind, rng)
        spots |= {("positions", x, str(k)): board.points[x] for x in "ABCE"}
        clicked.append(ClickedPlan("positions", str(k), pivot, pivot + board.points["A"] + slip[3]))
    return _seen(lines, seed, rng, clicked, spots, set())


def _seen(lines, seed: int, rng: np.random.Generator, clicked, spots, wrong) -> OwnDrawn:
    lead = drawn(lines, SIZE, Pencil(), seed)
    step = DOTS // HIGH
    rows, columns = (side // step for side in lead.shape)
    mean = lead.reshape(rows, step, columns, step).mean(axis=(1, 3))
    image = 235 - 0.7 * mean + rng.normal(0, 3, mean.shape)
    grey = np.clip(image, 0, 255).astype(np.uint8)[::-1]
    flat = Flat(np.repeat(grey[..., None], 3, axis=2), Box(0.0, 0.0, *SIZE), float(HIGH))
    return OwnDrawn(flat, clicked, spots, wrong, grey)
