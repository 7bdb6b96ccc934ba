"""What cannot be a gear pair at all, said with a remedy; a poor pair is told by checks."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NoReturn

from graphic_tmm.board.bounds import POSITIVE, TaskError
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.dimensions import GearSizes, WheelSizes
from graphic_tmm.chapters.gears.task import RING, GearTask
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.declare import bound_of


def refuse_order(order: GearTask) -> None:
    """Refuse what is wrong before anything is calculated.

    Raises
    ------
    TaskError
        If teeth are not whole or too few, or a size is not what it can be.
    """
    for key in ("z1", "alpha", "c", "steps"):
        _bounded(key, getattr(order, key))
    if not order.racked and not RING.holds(order.z2):
        _bounded("z2", order.z2)
    for addendum in order.addenda:
        _bounded("ha", addendum)
    for station in order.stations:
        _bounded("stations", station)
    for key, value in (
        ("x1", order.x1),
        ("x2", order.x2),
        ("distance", order.distance),
        ("x_sum", order.x_sum),
        ("beta", order.beta),
        ("width", order.width),
        ("speed", order.speed),
        ("delta_y", order.delta_y),
        ("m", order.m),
        ("mu_l", order.mu),
        ("a_w", order.axes),
        ("mu_theta", order.mu_sliding),
    ):
        if value is not None:
            _bounded(key, value)
    if order.mu is not None and order.axes is not None:
        says = said("mu_l is given, too: leave one of the two out, a_w as drawn gives μ_l")
        raise TaskError("gears", "a_w", says)
    if order.distance is not None and order.x_sum is not None:
        says = said("x_sum is given, too: leave one of the two out, the distance gives the sum")
        raise TaskError("gears", "distance", says)
    _refuse_rack(order)
    fixed = order.distance is not None or order.x_sum is not None
    if fixed and order.x1 is not None and order.x2 is not None:
        key = "x_sum" if order.distance is None else "distance"
        says = said("x1 and x2 are both given, too: leave one out, it follows from {key}", key=key)
        raise TaskError("gears", key, says)
    POSITIVE.refuse("gears", "least_tip", order.least_tip)


def _refuse_rack(order: GearTask) -> None:
    """Refuse what a rack has not, and its shift given twice."""
    if not order.racked:
        return
    for key, value in (("x2", order.x2), ("x_sum", order.x_sum), ("delta_y", order.delta_y)):
        if value is not None:
            says = said("a rack has none: leave it out; x1 or the distance shifts its wheel")
            raise TaskError("gears", key, says)
    if order.chart:
        says = said("a wheel on a rack has one shift and no chart of two: leave it out")
        raise TaskError("gears", "chart", says)
    if order.distance is not None and order.x1 is not None:
        says = said("x1 is given, too: leave one of the two out, the distance gives the shift")
        raise TaskError("gears", "distance", says)


def _bounded(key: str, value: object) -> None:
    """Refuse a value outside the bounds of a key."""
    bound_of(GearTask, key).refuse("gears", key, value)


def refuse_sizes(sizes: GearSizes, value: Callable[[Mark], float]) -> None:
    """Refuse a pair that its dimensions show to be none; ``value``: of a calculated mark.

    Raises
    ------
    TaskError
        If there is no working angle, or a wheel has no teeth.
    """
    order = sizes.order
    mates = (max(order.addenda),) if order.internal else order.addenda[::-1]
    for rack, addendum in zip(sizes.racks, mates, strict=True):
        if value(rack.rounding) >= 0.0 and value(rack.offset) >= -1e-12 * order.m:
            continue
        raise TaskError(
            "gears",
            "ha",
            said(
                "the rack's tooth comes to a point above the depth ha + c = {c:g}: take a smaller "
                "ha or c, or an alpha below {alpha:g}°",
                c=addendum + order.c,
                alpha=order.alpha,
            ),
        )
    if not value(sizes.alpha_w) > 0.0:
        _refuse_angle(sizes, value)
    for wheel in sizes.wheels:
        i, x, bound = wheel.number, value(wheel.x), bound_of(GearTask, f"x{wheel.number}")
        if not bound.holds(x):
            wanted = bound.wanted
            _refuse(
                i,
                order,
                said("x{i} = {x:.4g} follows: {wanted} is wanted", i=i, x=x, wanted=wanted),
            )
    for wheel in sizes.wheels:
        _refuse_wheel(wheel, order, value)


def _refuse_angle(sizes: GearSizes, value: Callable[[Mark], float]) -> None:
    """Refuse a pair that does not mesh at any angle."""
    order = sizes.order
    if order.distance is not None:
        raise TaskError(
            "gears",
            "distance",
            said(
                "at {distance:.5g} mm the base circles leave no line of action: the distance must be greater "
                "than {least:.5g} mm",
                distance=1000.0 * order.distance,
                least=1000.0
                * value(sizes.a or sizes.a_w)
                * math.cos(math.radians(value(sizes.alpha))),
            ),
        )
    x1, x2 = (value(wheel.x) for wheel in sizes.wheels)
    z1, z2 = order.teeth
    told, both, teeth = "x1 + x2", x1 + x2, z1 + z2
    if order.internal:
        told, both, teeth = "x2 − x1", x2 - x1, z2 - z1
    raise TaskError(
        "gears",
        "x2" if order.internal else "x1",
        said(
            "the wheels have no working angle (inv α_w = {inv:.4g}): {sum} = {x:g} must be "
            "greater than {least:.4g}",
            inv=value(sizes.inv_w),
            sum=told,
            x=both,
            least=-value(sizes.inv) * teeth / (2.0 * math.tan(math.radians(order.alpha))),
        ),
    )


def refuse_ring(order: GearTask) -> None:
    """Refuse a ring that has no room for its wheel."""
    z1, z2 = order.teeth[0], order.teeth[-1]
    if order.internal and z2 <= z1:
        says = said(
            "a ring of {ring} teeth has no room for a wheel of {wheel}: give it more",
            ring=z2,
            wheel=z1,
        )
        raise TaskError("gears", "z2", says)


def _cause(i: int, order: GearTask) -> str:
    """Return the key that gives the shift of a wheel."""
    if (order.x1, order.x2)[i - 1] is not None:
        return f"x{i}"
    return next((key for key in ("distance", "x_sum") if getattr(order, key) is not None), f"x{i}")


def _refuse(i: int, order: GearTask, wrong: str, remedy: str = "") -> NoReturn:
    """Refuse a wheel by the key of its shift; where it follows the remedy is there."""
    if (key := _cause(i, order)) != f"x{i}":
        remedy = said("give another {key}", key=key)
    raise TaskError("gears", key, joined("; ", (wrong, remedy)))


def _refuse_wheel(wheel: WheelSizes, order: GearTask, value: Callable[[Mark], float]) -> None:
    """Refuse a wheel that has no teeth."""
    i = wheel.number
    if wheel.pointed is None:
        return  # a wheel that has teeth leaves the ring some, too
    root, tip, base = (value(mark) / order.m for mark in (wheel.r_f, wheel.r_a, wheel.r_b))
    if not root > 0.0:
        wrong = said(
            "wheel {i} has no body: its root circle has the radius {root:.3g}·m", i=i, root=root
        )
        _refuse(i, order, wrong, said("raise x{i} or z{i}", i=i))
    if not tip > base:
        wrong = said(
            "the tip circle of wheel {i} (radius {tip:.4g}·m) lies inside its base circle ({base:.4g}·m)",
            i=i,
            tip=tip,
            base=base,
        )
        _refuse(i, order, wrong, said("raise x{i}, or give a smaller delta_y", i=i))
    if not tip > root:
        wrong = said(
            "the tip circle of wheel {i} (radius {tip:.4g}·m) lies inside its root circle ({root:.4g}·m)",
            i=i,
            tip=tip,
            root=root,
        )
        _refuse(i, order, wrong, said("give a smaller delta_y"))
    end = value(wheel.pointed) / order.m
    if not end > max(root, base):
        wrong = said(
            "x{i} = {x:g} leaves wheel {i} no tooth: its flanks meet at the radius {end:.4g}·m, below "
            "{max:.4g}·m, where they begin",
            i=i,
            x=value(wheel.x),
            end=end,
            max=max(root, base),
        )
        _refuse(i, order, wrong, said("take a smaller one"))
