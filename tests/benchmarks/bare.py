"""Hand-written kinematics of three mechanisms: what a person writes who wants these numbers and no plan.

Each function is plain arithmetic on the crank's angle, so it serves numpy (arrays, in blocks) and numba (a loop
over positions) alike. No trace of the board: other formulas, real coordinates, one cosine and one sine.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

OMEGA = 10.0
OC, OA, AB, CB = 0.3, 0.1, 0.28, 0.22
CRANK, ROD, OFF = 0.08, 0.25, 0.01
R, OB, BC = 0.13657, 0.48, 0.16694


def four_bar(phi: Any) -> tuple[Any, ...]:
    """Return x, y, v, a of B (left of A to C), the rates of the coupler and of the rocker."""
    ax, ay = OA * np.cos(phi), OA * np.sin(phi)
    dx, dy = OC - ax, -ay
    square = dx * dx + dy * dy
    foot = 0.5 + (AB * AB - CB * CB) / (2.0 * square)
    height = np.sqrt(AB * AB / square - foot * foot)
    bx, by = foot * dx - height * dy, foot * dy + height * dx
    cx, cy = bx - dx, by - dy
    area = bx * cy - by * cx
    vx, vy = -OMEGA * ay, OMEGA * ax
    w2, w3 = (vx * cx + vy * cy) / -area, (vx * bx + vy * by) / -area
    qx = -OMEGA * OMEGA * ax - w2 * w2 * bx + w3 * w3 * cx
    qy = -OMEGA * OMEGA * ay - w2 * w2 * by + w3 * w3 * cy
    e2, e3 = (qx * cx + qy * cy) / -area, (qx * bx + qy * by) / -area
    x, y = ax + bx, ay + by
    return (
        x, y, -w3 * cy, w3 * cx, -e3 * cy - w3 * w3 * cx, e3 * cx - w3 * w3 * cy, w2, w3, e2, e3,
    )  # fmt: skip


def slider_crank(phi: Any) -> tuple[Any, ...]:
    """Return x, v, a of the slider and the rates of the rod; the slider's line lies OFF above the crank."""
    ax, ay = CRANK * np.cos(phi), CRANK * np.sin(phi)
    ry = OFF - ay
    rx = np.sqrt(ROD * ROD - ry * ry)
    w = -OMEGA * ax / rx
    e = (OMEGA * OMEGA * ay + w * w * ry) / rx
    return ax + rx, -OMEGA * ay - w * ry, -OMEGA * OMEGA * ax - e * ry - w * w * rx, w, e


def rocker(phi: Any) -> tuple[Any, ...]:
    """Return x, y, v, a of the rocker's end C, x, v, a of the knife D, the rates of rocker and rod."""
    ax, ay = R * np.cos(phi), R * np.sin(phi)
    zy = ay + OB
    d = np.sqrt(ax * ax + zy * zy)
    ux, uy = ax / d, zy / d
    vx, vy = -OMEGA * ay, OMEGA * ax
    w3, slid = (vy * ux - vx * uy) / d, vx * ux + vy * uy
    e3 = (OMEGA * OMEGA * (ax * uy - ay * ux) - 2.0 * w3 * slid) / d
    cx, cy = -BC * ux, -BC * uy
    square = w3 * w3
    vcx, vcy = -w3 * cy, w3 * cx
    acx, acy = -e3 * cy - square * cx, e3 * cx - square * cy
    ry = -1.25 * BC - cy
    rx = np.sqrt(BC * BC - ry * ry)
    w4 = -vcy / rx
    e4 = (w4 * w4 * ry - acy) / rx
    return (
        cx, cy - OB, vcx, vcy, acx, acy,
        cx + rx, vcx - w4 * ry, acx - e4 * ry - w4 * w4 * rx, w3, w4, e3, e4,
    )  # fmt: skip


class Bare(NamedTuple):
    """A hand-written mechanism: its function of the crank's angle and how many numbers that returns."""

    name: str
    form: Callable[[Any], tuple[Any, ...]]
    width: int


BARE = (
    Bare("four-bar", four_bar, 10),
    Bare("slider-crank", slider_crank, 5),
    Bare("six-bar rocker", rocker, 13),
)


def blocked(form: Callable[[Any], tuple[Any, ...]], phi: Any, out: Any, block: int) -> None:
    """Fill ``out`` (quantity, position) by numpy, in blocks of positions that stay in cache."""
    for start in range(0, phi.size, block):
        part = slice(start, start + block)
        for row, column in zip(out, form(phi[part]), strict=True):
            row[part] = column


def looped(form: Callable[[Any], tuple[Any, ...]]) -> Callable[[Any, Any], None]:
    """Return a loop over positions compiled by numba: fills ``out`` (position, quantity)."""
    import numba

    scalar = numba.njit(error_model="numpy")(form)

    @numba.njit(error_model="numpy")
    def loop(phi: Any, out: Any) -> None:
        for i in range(phi.size):
            found = scalar(phi[i])
            for k, number in enumerate(found):
                out[k, i] = number

    return loop
