"""What cannot be a gear pair at all, said with a remedy; a poor pair is told by checks."""

from __future__ import annotations

import math
from collections.abc import Callable

from graphic_tmm.board.record import Mark
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.gear_orders import GearOrder
from graphic_tmm.plans.gear_dimensions import GearSizes, WheelSizes

LEAST_TEETH = 5
"""With fewer teeth no flank is left between the root and the tip that could drive."""
STEPS = (4, 60)
"""The fewest and the most steps by which a flank is rolled."""
WIDEST = 45.0
"""The profile angle stays below this, degrees."""


def refuse_order(order: GearOrder) -> None:
    """Refuse what is wrong before anything is calculated.

    Raises
    ------
    StructureError
        If teeth are not whole or too few, or a size is not what it can be.
    """
    for name, z in (("z1", order.z1), ("z2", order.z2)):
        _refuse_teeth(name, z)
    _refuse_steps(order.steps)
    scales = {"mu": order.mu, "mu_sliding": order.mu_sliding}
    positive = {"m": order.m, "ha": order.ha, "least_tip": order.least_tip}
    for name, value in (positive | {k: mu for k, mu in scales.items() if mu is not None}).items():
        if not (value > 0.0 and math.isfinite(value)):
            raise StructureError(f"gear: {name} = {value:g} is not greater than 0")
    if not (order.c >= 0.0 and math.isfinite(order.c)):
        raise StructureError(f"gear: c = {order.c:g} is less than 0: 0.25 is usual")
    if not 0.0 < order.alpha < WIDEST:
        raise StructureError(
            f"gear: alpha = {order.alpha:g}° is not between 0° and {WIDEST:g}°: 20° is usual"
        )
    for name, value in (("x1", order.x1), ("x2", order.x2), ("delta_y", order.delta_y or 0.0)):
        if not math.isfinite(value):
            raise StructureError(f"gear: {name} = {value:g} is not a number")
    for station in order.stations:
        if not (station > 0.0 and math.isfinite(station)):
            raise StructureError(f"gear: the station {station:g} mm does not lie beyond N1")


def _refuse_teeth(name: str, z: float) -> None:
    if isinstance(z, bool) or not math.isfinite(z) or z != int(z):
        raise StructureError(f"gear: {name} = {z} is not a whole number of teeth")
    if z < LEAST_TEETH:
        raise StructureError(f"gear: {name} = {z} is too few teeth: take {LEAST_TEETH} at least")


def _refuse_steps(steps: int) -> None:
    least, most = STEPS
    if not least <= steps <= most or steps != int(steps):
        raise StructureError(
            f"gear: {steps} steps to roll a flank: take a whole number of them, from {least} to {most}"
        )


def refuse_sizes(sizes: GearSizes, value: Callable[[Mark], float]) -> None:
    """Refuse a pair that its dimensions show to be none; ``value``: of a calculated mark.

    Raises
    ------
    StructureError
        If there is no working angle, or a wheel has no teeth.
    """
    order = sizes.order
    if not (value(sizes.rack.rounding) >= 0.0 and value(sizes.rack.offset) >= -1e-12 * order.m):
        raise StructureError(
            f"gear: the rack's tooth comes to a point above the depth ha + c = {order.ha + order.c:g}: "
            f"take a smaller ha or c, or an alpha below {order.alpha:g}°"
        )
    if not value(sizes.alpha_w) > 0.0:
        angle = math.radians(order.alpha)
        least = -(math.tan(angle) - angle) * (order.z1 + order.z2) / (2.0 * math.tan(angle))
        raise StructureError(
            f"gear: the wheels have no working angle (inv α_w = {value(sizes.inv_w):.4g}): "
            f"x1 + x2 = {order.x1 + order.x2:g} must be greater than {least:.4g}"
        )
    for wheel in sizes.wheels:
        _refuse_wheel(wheel, order, value)


def _refuse_wheel(wheel: WheelSizes, order: GearOrder, value: Callable[[Mark], float]) -> None:
    i = wheel.number
    root, tip, base = (value(mark) / order.m for mark in (wheel.r_f, wheel.r_a, wheel.r_b))
    if not root > 0.0:
        raise StructureError(
            f"gear: wheel {i} has no body: its root circle has the radius {root:.3g}·m; raise x{i} or z{i}"
        )
    if not tip > base:
        raise StructureError(
            f"gear: the tip circle of wheel {i} (radius {tip:.4g}·m) lies inside its base circle "
            f"({base:.4g}·m): raise x{i}, or give a smaller delta_y"
        )
    if not tip > root:
        raise StructureError(
            f"gear: the tip circle of wheel {i} (radius {tip:.4g}·m) lies inside its root circle "
            f"({root:.4g}·m): give a smaller delta_y"
        )
    end = value(wheel.pointed) / order.m
    if not end > max(root, base):
        raise StructureError(
            f"gear: x{i} = {(order.x1, order.x2)[i - 1]:g} leaves wheel {i} no tooth: "
            f"its flanks meet at the radius {end:.4g}·m, below {max(root, base):.4g}·m, where they begin; "
            f"take a smaller one"
        )
