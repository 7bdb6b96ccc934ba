"""What the tables of a scene say, read without the package: bodies, drives, loads; SI and degrees."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

UNITS = {
    "m": 1.0, "mm": 1e-3, "m/s": 1.0, "mm/s": 1e-3, "m/s2": 1.0, "m/s^2": 1.0, "deg": 1.0,
    "rad/s": 1.0, "1/s": 1.0, "rad/s2": 1.0, "rad/s^2": 1.0, "rpm": math.pi / 30, "N": 1.0, "kN": 1e3,
    "N*m": 1.0, "s": 1.0, "kg": 1.0, "t": 1e3, "kg*m^2": 1.0,
}  # fmt: skip


def si(told: Any) -> float:
    """A number, or a text with its unit; degrees stay degrees."""
    if isinstance(told, str):
        number, unit = told.split()
        return float(number) * UNITS[unit]
    return float(told)


@dataclass(frozen=True)
class Body:
    """A link: its points and guides (m; the guides' degrees) in its own axes, its slides, what it weighs."""

    number: int
    points: Mapping[str, complex]
    guides: Mapping[str, tuple[complex, float]]
    slides: Sequence[Mapping[str, Any]] = ()
    mass: float | None = None
    inertia: float | None = None
    centre: str | None = None


def _point(told: Sequence[Any]) -> complex:
    return complex(si(told[0]), si(told[1]))


def _guides(told: Mapping[str, Any]) -> dict[str, tuple[complex, float]]:
    return {
        name: (_point(g.get("through", [0, 0])), si(g.get("angle", 0.0)))
        for name, g in told.items()
    }


def _body(told: Mapping[str, Any]) -> Body:
    slides = told.get("slides", [])
    return Body(
        told["number"],
        {letter: _point(place) for letter, place in told.get("points", {}).items()},
        _guides(told.get("guides", {})),
        [slides] if isinstance(slides, dict) else slides,
        si(told["mass"]) if "mass" in told else None,
        si(told["J"]) if "J" in told else None,
        told.get("centre"),
    )


class Words:
    """The tables of a scene as they are meant."""

    def __init__(self, scene: Mapping[str, Any]) -> None:
        frame = scene["frame"]
        points = {k: _point(p) for k, p in frame.items() if isinstance(p, list)}
        guides = _guides({k: g for k, g in frame.items() if isinstance(g, dict)})
        fixed = Body(frame.get("number", 0), points, guides)
        self.bodies = [fixed, *map(_body, scene["link"])]
        self.standing: dict[str, list[int]] = {}
        for k, body in enumerate(self.bodies):
            for letter in body.points:
                self.standing.setdefault(letter, []).append(k)
        drives = scene["drive"]
        self.drives: list[Mapping[str, Any]] = [drives] if isinstance(drives, dict) else drives
        effects = scene.get("effects", {})
        self.gravity, self.inertia = effects.get("gravity", False), effects.get("inertia", False)
        self.loads: Sequence[Mapping[str, Any]] = scene.get("load", [])
        self.springs: Sequence[Mapping[str, Any]] = scene.get("spring", [])
        self.balance: str = scene.get("forces", {}).get("balance", "force")

    def guide(self, body: int, name: str) -> tuple[complex, float]:
        """A guide of a body, by its name or two letters: a point of it and its direction."""
        owner = self.bodies[body]
        if name in owner.guides:
            return owner.guides[name]
        first, other = (owner.points[letter] for letter in name)
        return first, math.degrees(cmath.phase(other - first))
