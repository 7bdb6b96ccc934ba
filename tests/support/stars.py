"""Pistons around one crank, in scenes and in closed form: a judge of travels, forces and moments."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
STEP = 1e-5
"""Of numerical derivatives by the angle, radians."""


@dataclass(frozen=True)
class Star:
    """A crank of length ``r`` (m) whose rods of length ``rod`` drive pistons along guides at angles (degrees).

    ``offsets``: of each guide, m to its left; ``cranks``: how far each pin is ahead of the first, degrees;
    ``master``: where a further rod hangs on the first (along it and square to it, m), its length, the angle
    of its guide.
    """

    angles: tuple[float, ...]
    r: float = 0.05
    rod: float = 0.2
    offsets: tuple[float, ...] = ()
    cranks: tuple[float, ...] = ()
    master: tuple[float, float, float, float] | None = None

    def along(self, k: int, phi: Reals) -> Reals:
        """Return how far piston ``k`` stands along its guide at crank angles (radians)."""
        if self.master is not None and k == len(self.angles):
            x, y, rod, angle = self.master
            pin, head = self._pin(0, phi), self._head(0, phi)
            hung = pin + (x + 1j * y) * (head - pin) / self.rod
            return self._slid(hung, rod, angle, 0.0)
        offset = self.offsets[k] if self.offsets else 0.0
        return self._slid(self._pin(k, phi), self.rod, self.angles[k], offset)

    def speed(self, k: int, phi: Reals, omega: float) -> Reals:
        """Return how fast it goes along its guide, m/s."""
        return (self.along(k, phi + STEP) - self.along(k, phi - STEP)) / (2 * STEP) * omega

    def shares(self, k: int, phi: Reals, *, outer: bool = True) -> Reals:
        """Return its travel from its outer dead centre, or from the inner one, as a share of the stroke."""
        every = self.along(k, np.linspace(0.0, 2 * np.pi, 200_001))
        low, high = every.min(), every.max()
        there = self.along(k, phi)
        return (high - there if outer else there - low) / (high - low)

    def _pin(self, k: int, phi: Reals) -> NDArray[np.complex128]:
        ahead = np.radians(self.cranks[k]) if self.cranks else 0.0
        return self.r * np.exp(1j * (phi + ahead))

    def _head(self, k: int, phi: Reals) -> NDArray[np.complex128]:
        way = np.exp(1j * np.radians(self.angles[k]))
        offset = self.offsets[k] if self.offsets else 0.0
        return (self.along(k, phi) + 1j * offset) * way

    @staticmethod
    def _slid(pin: NDArray[np.complex128], rod: float, angle: float, offset: float) -> Reals:
        local = pin * np.exp(-1j * np.radians(angle))
        return np.asarray(local.real + np.sqrt(rod**2 - (local.imag - offset) ** 2))

    def text(self, drive: str) -> str:
        """Return its scene; pistons of 1 kg are B, C, D, E on links 3, 5, 7, 9, guides x, y, z, w."""
        pins = self.cranks or (0.0,) * len(self.angles)
        own = ["A", *"KMN"[: len(pins) - 1]]
        letters = [own[pins.index(ahead)] for ahead in pins]
        every = [*self.angles, *([self.master[3]] if self.master else [])]
        frame = ""
        for guide, angle, off in zip("xyzw", every, [*self.offsets, *[0.0] * 4], strict=False):
            through = _pair(1j * off * np.exp(1j * np.radians(angle)))
            frame += f'{guide} = {{ through = {through}, angle = "{angle} deg" }}\n'
        points = {"O": 0j}
        for letter, ahead in zip(letters, pins, strict=True):
            points[letter] = self.r * np.exp(1j * np.radians(ahead))
        crank = ", ".join(f"{k} = {_pair(z)}" for k, z in points.items())
        found = [
            f'title = "T"\nlanguage = "en"\n[frame]\nO = [0, 0]\n{frame}',
            f"[[link]]\nnumber = 1\npoints = {{ {crank} }}\n",
        ]
        for k, guide in zip(range(len(every)), "xyzw", strict=False):
            pin = letters[k] if k < len(letters) else "H"
            piston, rod = "BCDE"[k], self.rod if k < len(letters) else self.master[2]  # type: ignore[index]
            more = ""
            if k == 0 and self.master:
                more = f", H = [{self.master[0]}, {self.master[1]}]"
            found.append(
                f"[[link]]\nnumber = {2 * k + 2}\npoints = {{ {pin} = [0, 0], {piston} = [{rod}, 0]{more} }}\n"
                f"[[link]]\nnumber = {2 * k + 3}\npoints = {{ {piston} = [0, 0] }}\n"
                f'slides = {{ on = "frame", along = "{guide}", side = "+" }}\n'
                f'mass = 1\ncentre = "{piston}"\n'
            )
        return "".join(found) + "[drive]\nlink = 1\n" + drive


def _pair(z: complex) -> str:
    return f"[{float(z.real)!r}, {float(z.imag)!r}]"
