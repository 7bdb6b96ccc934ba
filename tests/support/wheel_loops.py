"""Mechanisms with wheels as scenes, and their loops in closed form, derived by mpmath: nothing of the plans."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from mpmath import mp, mpf  # type: ignore[import-untyped]

mp.dps = 30
Loop = Callable[[Any], dict[Any, Any]]
"""The crank's angle (rad) -> places of points by letter (m), angles of links by number (rad)."""


class FiveBar(NamedTuple):
    """A crank a and a follower d about fixed pivots f apart, in mesh, with a dyad b, c between their pins."""

    a: float
    b: float
    c: float
    d: float
    f: float
    teeth: tuple[int, int]
    internal: bool = False
    phase: float = 0.0
    side: int = 1
    speed: float = 10.0
    gain: float = 0.0

    @property
    def ratio(self) -> Any:
        sign = 1 if self.internal else -1
        return sign * mpf(self.teeth[0]) / self.teeth[1]

    @property
    def scene(self) -> str:
        side = "left" if self.side > 0 else "right"
        return f"""
title = "T"
language = "en"
[frame]
O = [0, 0]
D = [{self.f!r}, 0]
[[link]]
number = 1
points = {{ O = [0, 0], A = [{self.a!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{self.b!r}, 0] }}
[[link]]
number = 3
points = {{ C = [0, 0], B = [{self.c!r}, 0] }}
side = "{side} of AC"
[[link]]
number = 4
points = {{ D = [0, 0], C = [{self.d!r}, 0] }}
[[mesh]]
links = [1, 4]
centres = ["O", "D"]
teeth = [{self.teeth[0]}, {self.teeth[1]}]
internal = {str(self.internal).lower()}
phase = {self.phase!r}
[drive]
link = 1
speed = {self.speed!r}
acceleration = {self.gain!r}
accelerations = "all"
"""

    def loop(self, phi: Any) -> dict[Any, Any]:
        follower = self.ratio * phi + mp.radians(mpf(self.phase))
        A, C = self.a * mp.expj(phi), self.f + self.d * mp.expj(follower)
        chord = C - A
        share = (mpf(self.b) ** 2 + abs(chord) ** 2 - mpf(self.c) ** 2) / (2 * self.b * abs(chord))
        B = A + self.b * chord / abs(chord) * mp.expj(self.side * mp.acos(share))
        return {"A": A, "B": B, "C": C, 2: mp.arg(B - A), 3: mp.arg(B - C), 4: follower}


class Planet(NamedTuple):
    """An arm a, a planet on it that rolls on a standing wheel; its pin, b off, drives a rod c and a slider."""

    a: float
    b: float
    c: float
    teeth: tuple[int, int]
    internal: bool = True
    phase: float = 0.0
    speed: float = 10.0
    gain: float = 0.0

    @property
    def scene(self) -> str:
        return f"""
title = "T"
language = "en"
[frame]
number = 5
O = [0, 0]
x = {{ through = [0, 0], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{self.a!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{self.b!r}, 0] }}
[[link]]
number = 3
points = {{ B = [0, 0], C = [{self.c!r}, 0] }}
[[link]]
number = 4
points = {{ C = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "+" }}
[[mesh]]
links = [5, 2]
centres = ["O", "A"]
teeth = [{self.teeth[0]}, {self.teeth[1]}]
internal = {str(self.internal).lower()}
phase = {self.phase!r}
[drive]
link = 1
speed = {self.speed!r}
acceleration = {self.gain!r}
accelerations = "all"
"""

    def loop(self, phi: Any) -> dict[Any, Any]:
        ratio = (1 if self.internal else -1) * mpf(self.teeth[0]) / self.teeth[1]
        planet = (1 - ratio) * phi + mp.radians(mpf(self.phase))
        A = self.a * mp.expj(phi)
        B = A + self.b * mp.expj(planet)
        C = B.real + mp.sqrt(mpf(self.c) ** 2 - B.imag**2)
        return {"A": A, "B": B, "C": mp.mpc(C), 2: planet, 3: mp.arg(C - B)}


def rates(loop: Loop, degrees: float, speed: float, gain: float) -> dict[Any, tuple[Any, Any, Any]]:
    """Return every quantity of a loop with its first and second time derivatives."""
    phi = mp.radians(mpf(degrees))
    found = {}
    for name, value in loop(phi).items():
        first, second = (
            mp.diff(lambda x, name=name: _smooth(loop, name, x, phi), phi, n) for n in (1, 2)
        )
        found[name] = value, first * speed, second * mpf(speed) ** 2 + first * gain
    return found


def _smooth(loop: Loop, name: Any, x: Any, phi: Any) -> Any:
    """An angle without a leap near a place."""
    value = loop(x)[name]
    if isinstance(name, str):
        return value
    base = loop(phi)[name]
    return base + mp.arg(mp.expj(value - base))
