"""What a task that finds lengths gives: rows of the tables of given data."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.readers.task_sheet import SIZE, Given, given_speed
from graphic_tmm.scene.declare import keys_of
from graphic_tmm.scene.length_task import Task
from graphic_tmm.scene.records import Scene

SYMBOLS = {
    "K_v": ("K_v", ""),
    "stroke": ("S", SIZE),
    "v_m": ("v_m", "m/s"),
    "e": ("e", SIZE),
    "lambda": ("λ", ""),
    "pressure": ("[α]", "°"),
    "psi": ("ψ", "°"),
    "OB": ("l_{OB}", SIZE),
    "OA": ("l_{OA}", SIZE),
    "AB": ("l_{AB}", SIZE),
    "BC": ("l_{BC}", SIZE),
    "OC": ("l_{OC}", SIZE),
    "transmission": ("[γ]", "°"),
    "power": ("p", ""),
    "y": ("y", ""),
    "tolerance": ("[Δ]", SIZE),
}
"""The symbol and the unit of what is given by a key."""
ROWS = {
    "angles": ("α", "°"),
    "crank": ("φ", "°"),
    "rocker": ("ψ", "°"),
    "dwell": ("φ", "°"),
    "x": ("x", ""),
    "values": ("y", ""),
}
"""The letters of what is given position by position, and its unit."""
POINTS = ("A", "M", "E")
"""Keys that give places of a point."""


def given_by_task(scene: Scene) -> Iterator[Given]:
    """Yield what the task of a scene gives; lengths of links only where no mechanism tells them anyway."""
    given = scene.task.given if scene.task is not None else {}
    for name in keys_of(Task):
        value = given.get(name)
        if value is None:
            continue
        if name in SYMBOLS:
            symbol, unit = SYMBOLS[name]
            if scene.mechanism is None or not symbol.startswith("l_"):
                yield Given(symbol, value, unit)
        elif name == "n":
            yield given_speed("1", value)
        elif name in POINTS:
            spots = value if isinstance(value, tuple) else (value,)
            for k, spot in enumerate(spots, 1):
                of = f"{name}{k}" if len(spots) > 1 else name
                yield Given(f"X_{{{of}}}", spot.real, SIZE)
                yield Given(f"Y_{{{of}}}", spot.imag, SIZE)
        else:
            letter, unit = ROWS[name]
            ends = "ab" if name == "dwell" else "123" if len(value) > 2 else "0n"
            for end, one in zip(ends, value, strict=True):
                yield Given(f"{letter}_{end}", one, unit)
