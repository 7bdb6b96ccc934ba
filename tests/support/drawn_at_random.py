"""Scenes of random mechanisms that go all round, for budgets: slider-cranks, four-bars, six links.

Lengths are drawn so that the crank turns (by Grashof's rule, or the rod is longer than crank and offset); some
have diagrams of the slider, some forces; hands in turn. `errors`: how far a scene is off by fresh drawings.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.drawing import Pinned, References, draw, pinned
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.ways import wanted
from graphic_tmm.board.execute import execute
from graphic_tmm.drawn import hand_of
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

HANDS = ("student", "careful", "exact")
FILE = Path("random.toml")
FORMATS = ("A1", "A2", "A3", "auto")


class Random(NamedTuple):
    """What a scene is of, and it."""

    kind: str
    scene: Scene


def scenes(count: int, seed: int = 34) -> Iterator[Random]:
    pick = random.Random(seed)
    for k in range(count):
        kind = ("slider", "four-bar", "six links")[k % 3]
        hand = HANDS[(k // 3 + k) % 3]
        extra = ("", "diagrams", "forces")[k // 3 % 3]
        if kind == "four-bar" and extra == "diagrams":
            extra = ""
        text = _text(pick, kind, hand, extra, FORMATS[k % 4])
        yield Random(" ".join(filter(None, (kind, extra, hand))), judged(text.encode(), FILE))


def _text(pick: random.Random, kind: str, hand: str, extra: str, form: str) -> str:
    r = round(pick.uniform(0.03, 0.12), 3)
    rows = ['title = "Drawn at random"', 'language = "en"', "[frame]", "O = [0, 0]"]
    links = [_link(1, {"O": 0.0, "A": r}, pick)]
    slider = {"slider": "B", "six links": "D"}.get(kind, "")
    if kind == "slider":
        e = round(pick.uniform(-0.5, 0.5) * r, 3)
        rod = round(r * pick.uniform(2.6, 5.0) + abs(e), 3)
        rows.append(f"x = {{ through = [0, {e}], angle = 0.0 }}")
        links += [_link(2, {"A": 0.0, "B": rod}, pick), _slider(3, "B", pick)]
    else:
        base, b, c = _rocker(pick, r)
        tilt = pick.uniform(-0.4, 0.4)
        spot = f"[{base * np.cos(tilt):.4f}, {base * np.sin(tilt):.4f}]"
        rows.append(f"C = {spot}")
        links.append(_link(2, {"A": 0.0, "B": b}, pick))
        third = _link(3, {"C": 0.0, "B": c}, pick)
        links[-1] += '\nside = "left of AC"'
        links.append(third)
        if kind == "six links":
            rod = round(3.0 * c, 3)
            rows.append(
                f"x = {{ through = [0, {base * np.sin(tilt) + 0.8 * c:.4f}], angle = 0.0 }}"
            )
            links += [_link(4, {"B": 0.0, "D": rod}, pick), _slider(5, "D", pick)]
    positions = pick.choice((8, 12, 12, 24))
    at = sorted(pick.sample(range(positions), 2))
    speed = round(pick.uniform(5.0, 40.0), 1)
    rows += [*links, "[drive]", "link = 1", f"speed = {speed}", f"positions = {positions}"]
    rows += [f"accelerations = [{at[0]}, {at[1]}]", "first = 0"]
    places = [["positions", "velocities", "accelerations"]]
    if extra == "diagrams":
        rows += [
            "[diagrams]",
            f'point = "{slider}"',
            f'start = "{pick.choice(("displacement", "velocity"))}"',
        ]
        places.append(["diagrams"])
    if extra == "forces":
        rows += [
            "[effects]",
            "gravity = true",
            "inertia = true",
            "[forces]",
            f"positions = [{at[0]}]",
        ]
        places.append(["forces"])
    rows += ["[hand]", f'name = "{hand}"']
    for order in places:
        listed = ", ".join(f'"{place}"' for place in order)
        rows += ["[[sheet]]", f'format = "{form}"', f"place = [{listed}]"]
    return "\n".join(rows)


def _link(number: int, points: dict[str, float], pick: random.Random) -> str:
    told = ", ".join(f"{letter} = [{x}, 0]" for letter, x in points.items())
    middle = max(points.values()) / 2.0
    rows = ["[[link]]", f"number = {number}", f"points = {{ {told}, S{number} = [{middle}, 0] }}"]
    rows += [f"mass = {pick.uniform(0.5, 5.0):.2f}", f'centre = "S{number}"']
    return "\n".join([*rows, f"J = {pick.uniform(0.001, 0.02):.4f}"])


def _slider(number: int, letter: str, pick: random.Random) -> str:
    return "\n".join(
        (
            "[[link]]",
            f"number = {number}",
            f"points = {{ {letter} = [0, 0] }}",
            'slides = { on = "frame", along = "x", side = "right" }',
            f"mass = {pick.uniform(0.5, 5.0):.2f}",
            f'centre = "{letter}"',
        )
    )


def _rocker(pick: random.Random, r: float) -> tuple[float, float, float]:
    """Return base, coupler and rocker of a crank r that goes round, well off its change points."""
    while True:
        base, b, c = (round(r * pick.uniform(2.0, 4.5), 3) for _ in range(3))
        angles = [(b * b + c * c - (base + s * r) ** 2) / (2 * b * c) for s in (-1, 1)]
        if all(abs(cosine) < 0.9 for cosine in angles):
            return base, b, c


def errors(
    scene: Scene, seed: int, trials: int = 1000, scales: Pinned | None = None
) -> dict[str, float]:
    """By quantity on the sheets what nine readings of ten keep within, % of the largest of the turn.

    ``scales``: scale factors other than the scene's own.
    """
    full = at_all_positions(scene)
    scales = pinned(make(scene, exact=True)) if scales is None else scales
    references, found = References(full, scales), {}
    who = hand_of(scene)
    who = who._replace(seed=seed, trials=trials if who.slips else 1)
    for drawing in draw(full, scales):
        asked = [q for q in quantities(drawing) if wanted(scene, q)]
        marks = [mark for q in asked for mark in q.marks]
        drawn = execute(drawing.construction, drawing.given, marks, hand=who)
        for q in asked:
            due, largest = references.of(q, drawing), references.largest(q, drawing)
            if due is None or not largest > 0.0:
                continue
            off = np.abs(q.read(drawn, who.trials) - due)[:, np.isfinite(due[0])]
            off = np.where(np.isnan(off), np.inf, off)
            found[q.name] = 100.0 * float(np.quantile(off, 0.9)) / largest
    return found
