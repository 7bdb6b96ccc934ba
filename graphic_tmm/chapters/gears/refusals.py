"""What cannot be a gear pair at all, said with a remedy; a poor pair is told by checks."""

from __future__ import annotations

import math
from collections.abc import Callable

from graphic_tmm.board.record import Mark
from graphic_tmm.bounds import POSITIVE, OrderError
from graphic_tmm.chapters.gears.dimensions import GearSizes, WheelSizes
from graphic_tmm.chapters.gears.task import GearOrder
from graphic_tmm.scene.declare import bound_of


def refuse_order(order: GearOrder) -> None:
    """Refuse what is wrong before anything is calculated.

    Raises
    ------
    OrderError
        If teeth are not whole or too few, or a size is not what it can be.
    """
    for key in ("z1", "z2", "x1", "x2", "alpha", "ha", "c", "steps"):
        _bounded(key, getattr(order, key))
    for station in order.stations:
        _bounded("stations", station)
    for key, value in (
        ("delta_y", order.delta_y),
        ("m", order.m),
        ("mu_l", order.mu),
        ("mu_theta", order.mu_sliding),
    ):
        if value is not None:
            _bounded(key, value)
    POSITIVE.refuse("gears", "least_tip", order.least_tip)


def _bounded(key: str, value: object) -> None:
    """Refuse a value outside the bounds of a key."""
    bound_of(GearOrder, key).refuse("gears", key, value)


def refuse_sizes(sizes: GearSizes, value: Callable[[Mark], float]) -> None:
    """Refuse a pair that its dimensions show to be none; ``value``: of a calculated mark.

    Raises
    ------
    OrderError
        If there is no working angle, or a wheel has no teeth.
    """
    order = sizes.order
    if not (value(sizes.rack.rounding) >= 0.0 and value(sizes.rack.offset) >= -1e-12 * order.m):
        raise OrderError(
            "gears",
            "ha",
            f"the rack's tooth comes to a point above the depth ha + c = {order.ha + order.c:g}: "
            f"take a smaller ha or c, or an alpha below {order.alpha:g}°",
        )
    if not value(sizes.alpha_w) > 0.0:
        angle = math.radians(order.alpha)
        least = -(math.tan(angle) - angle) * (order.z1 + order.z2) / (2.0 * math.tan(angle))
        raise OrderError(
            "gears",
            "x1",
            f"the wheels have no working angle (inv α_w = {value(sizes.inv_w):.4g}): "
            f"x1 + x2 = {order.x1 + order.x2:g} must be greater than {least:.4g}",
        )
    for wheel in sizes.wheels:
        _refuse_wheel(wheel, order, value)


def _refuse_wheel(wheel: WheelSizes, order: GearOrder, value: Callable[[Mark], float]) -> None:
    i = wheel.number
    root, tip, base = (value(mark) / order.m for mark in (wheel.r_f, wheel.r_a, wheel.r_b))
    if not root > 0.0:
        raise OrderError(
            "gears",
            f"x{i}",
            f"wheel {i} has no body: its root circle has the radius {root:.3g}·m; raise x{i} or z{i}",
        )
    if not tip > base:
        raise OrderError(
            "gears",
            f"x{i}",
            f"the tip circle of wheel {i} (radius {tip:.4g}·m) lies inside its base circle "
            f"({base:.4g}·m): raise x{i}, or give a smaller delta_y",
        )
    if not tip > root:
        raise OrderError(
            "gears",
            f"x{i}",
            f"the tip circle of wheel {i} (radius {tip:.4g}·m) lies inside its root circle "
            f"({root:.4g}·m): give a smaller delta_y",
        )
    end = value(wheel.pointed) / order.m
    if not end > max(root, base):
        raise OrderError(
            "gears",
            f"x{i}",
            f"x{i} = {(order.x1, order.x2)[i - 1]:g} leaves wheel {i} no tooth: "
            f"its flanks meet at the radius {end:.4g}·m, below {max(root, base):.4g}·m, where they begin; "
            f"take a smaller one",
        )
