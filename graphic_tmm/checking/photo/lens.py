"""What a lens does to a photograph: straight lines bowed outward (a barrel) or inward, told by one number.

A ray seen at `off` from the middle of the photograph a pinhole shows at `off · (1 + share · |off / radius|²)`:
the polynomial goes from what is seen to what is straight, so that a place that was clicked needs no equation. A
photograph that is cut out has its middle elsewhere, and its lens is taken out in part.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals

MOST = 0.1
"""No lens is believed to bow more, as a share at the half width: fisheyes need another law."""
_STEPS = 8
"""Newton's steps for the place at which a ray is seen; from 10 % off four reach the last place."""
_NEAR = 1e-9
"""As a share of the half width: a place is found when its ray is so near."""


class Lens(NamedTuple):
    """The middle of a photograph, px, half its width, px, and by what share the lens bows lines there."""

    middle: complex
    radius: float
    share: float = 0.0

    def straight(self, seen: Any) -> Complexes:
        """Return where a pinhole would show what is seen at some places, px (any shape)."""
        off = np.asarray(seen, np.complex128) - self.middle
        found: Complexes = self.middle + off * (1 + self.share * abs(off / self.radius) ** 2)
        return found

    def seen(self, straight: Any) -> Complexes:
        """Return where is seen what a pinhole would show at some places, px; NaN where no ray is seen."""
        off = np.asarray(straight, np.complex128) - self.middle
        if self.share == 0.0:
            return self.middle + off
        due = abs(off) / self.radius
        far = due.copy()
        with np.errstate(all="ignore"):
            for _ in range(_STEPS):
                slope = 1 + 3 * self.share * far**2
                far = far - (far + self.share * far**3 - due) / np.where(slope > 0, slope, np.nan)
            found = abs(far + self.share * far**3 - due) < _NEAR
            part = np.where(due > 0, far / due, 1.0)
        return np.where(found, self.middle + off * part, complex(np.nan, np.nan))

    def reduced(self, factor: int) -> Lens:
        """Return the lens of the photograph whose dots are the means of ``factor`` × ``factor``."""
        half = complex(0.5, 0.5)
        return Lens((self.middle + half) / factor - half, self.radius / factor, self.share)


def pinhole(image: NDArray[np.uint8]) -> Lens:
    """Return the lens that bows nothing, of a photograph (rows, columns, 3)."""
    rows, columns = image.shape[:2]
    return Lens(complex((columns - 1) / 2, (rows - 1) / 2), columns / 2)


def straightening(lens: Lens, lines: Iterable[tuple[Complexes, Reals]]) -> Lens:
    """Return the lens that makes lines straight: a line is the places seen, px, (points,), and their weights.

    Least squares: what is left of a line beside its own straight one depends on the share by a factor. With
    fewer than two lines the lens stays as it is.
    """
    bows = [bow_of(lens, seen, weights) for seen, weights in lines]
    square = sum(float((weights * by**2).sum()) for weights, _, by in bows)
    if len(bows) < 2 or square <= 0.0:
        return lens
    product = sum(float((weights * off * by).sum()) for weights, off, by in bows)
    return lens._replace(share=float(np.clip(-product / square, -MOST, MOST)))


def bow_of(lens: Lens, seen: Complexes, weights: Reals) -> tuple[Reals, Reals, Reals]:
    """Return a line's weights, how far its points are from straight, px, and what a share of 1 adds to that."""
    way = seen[-1] - seen[0]
    way /= abs(way)
    turned = (seen - seen[0]) / way
    off = seen - lens.middle
    by = off * abs(off / lens.radius) ** 2 / way
    return (
        weights,
        left_of_line(turned.real, turned.imag, weights),
        left_of_line(turned.real, by.imag, weights),
    )


def left_of_line(along: Reals, across: Reals, weights: Reals) -> Reals:
    """Return what is left of ``across`` beside its weighted line of least squares over ``along``."""
    whole = weights.sum()
    x = along - (weights * along).sum() / whole
    y = across - (weights * across).sum() / whole
    slope = (weights * x * y).sum() / max((weights * x**2).sum(), np.finfo(float).tiny)
    left: Reals = y - slope * x
    return left
