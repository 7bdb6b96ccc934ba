"""Dimensions of a pair of spur gears with shift, each a calculated step (m, degrees)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.energetics import added, share
from graphic_tmm.board.operations.formulas import pitch_radius
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears import rack
from graphic_tmm.chapters.gears.task import GearTask

VIEW = "gear-dimensions"


@dataclass(frozen=True)
class RackSizes:
    """The basic rack (Number, m): ha, c (of the module), rounding ρ, depth h and offset of its centre."""

    ha: Mark
    c: Mark
    rounding: Mark
    straight: Mark
    offset: Mark


@dataclass(frozen=True)
class WheelSizes:
    """One wheel (Number, m; Angle): z, x, radii, thicknesses, tip angle, limits of its teeth.

    ``pointed``: the radius where both flanks of a tooth meet, ``top``: that up to which the tooth is there, r_a
    or this one. ``limit``: the radius of curvature (m) at which
    the flank begins, ``lowest``: that of its lowest working point, ``free``: the least this may be.
    ``depth``: how deep under the pitch circle the centre of the rack's rounding lies (m).
    """

    number: int
    z: Mark
    x: Mark
    r: Mark
    r_b: Mark
    r_w: Mark
    r_f: Mark
    r_a: Mark
    s: Mark
    alpha_a: Mark
    s_a: Mark
    pointed: Mark
    top: Mark
    depth: Mark
    x_min: Mark
    limit: Mark
    lowest: Mark
    free: Mark
    clearance: Mark
    angular_pitch: Mark
    p_w: Mark


@dataclass(frozen=True)
class GearSizes:
    """The pair (Number, m; Angle): what was given, distances, shifts, height, pitches, contact ratio ε.

    ``beyond``: of each wheel, whether the teeth of the other reach beyond its limit point N.
    """

    order: GearTask
    m: Mark
    alpha: Mark
    rack: RackSizes
    inv: Mark
    inv_w: Mark
    alpha_w: Mark
    a: Mark
    a_w: Mark
    y: Mark
    dy: Mark
    p: Mark
    p_b: Mark
    h: Mark
    h_w: Mark
    contact_ratio: Mark
    least_tip: Mark
    wheels: tuple[WheelSizes, WheelSizes]
    beyond: tuple[bool, bool]


def known(draft: Draft) -> Callable[[Mark], float]:
    """Return the value of what is calculated so far, by its mark."""
    exact = execute(draft.board.construction(), draft.given)
    return lambda mark: float(exact[mark][0, 0])


def calculate_sizes(draft: Draft, order: GearTask) -> GearSizes:
    """Calculate the dimensions of both wheels, the quality of their meshing and the limits of their teeth."""
    draft.open(VIEW)
    m = draft.take(Number, "m", order.m, "m")
    alpha = draft.take(Angle, "α", order.alpha, "°")
    tool = _rack(draft, order, m, alpha)
    z = [draft.take(Number, f"z_{i}", float(n)) for i, n in ((1, order.z1), (2, order.z2))]
    x = [draft.take(Number, f"x_{i}", v) for i, v in ((1, order.x1), (2, order.x2))]
    r = [draft.draw(pitch_radius, f"r_{k + 1}", m, z[k], unit="m") for k in range(2)]
    inv = draft.draw(g.involute, "inv α", alpha)
    inv_w = draft.draw(g.working_involute, "inv α_{w}", *x, alpha, *z)
    alpha_w = draft.draw(g.angle_of_involute, "α_{w}", inv_w)
    a = draft.draw(added, "a", *r, unit="m")
    a_w = draft.draw(g.working_distance, "a_{w}", a, alpha, alpha_w, unit="m")
    y = draft.draw(g.perceived_shift, "y", a_w, a, m)
    if order.delta_y is None:
        dy = draft.draw(g.equalising_shift, "Δy", *x, y)
    else:
        dy = draft.take(Number, "Δy", order.delta_y)
    p = draft.draw(g.pitch_of, "p", m, unit="m")
    p_b = draft.draw(g.times_cosine, "p_{b}", p, alpha, unit="m")
    h = draft.draw(g.tooth_height, "h", m, tool.ha, tool.c, dy, unit="m")
    h_w = draft.draw(g.working_depth, "h_{w}", m, tool.ha, dy, unit="m")
    shape = [
        _shape(draft, k + 1, (m, alpha, alpha_w, dy), tool, (z[k], x[k], r[k])) for k in range(2)
    ]
    value = known(draft)
    tops = [_top(one, value) for one in shape]
    limits = [_limits(draft, k, (a_w, alpha_w), shape, tops[1 - k]) for k in range(2)]
    value = known(draft)
    beyond = (value(limits[0]["lowest"]) < 0.0, value(limits[1]["lowest"]) < 0.0)
    tips = (tops[0].angle, tops[1].angle)
    ratio = _contact_ratio(draft, (z[0], z[1]), tips, alpha_w, beyond)
    k_tip = draft.take(Number, "k_{s}", order.least_tip)
    least = draft.draw(share, "[s_{a}]", m, k_tip, unit="m")
    wheels = [
        WheelSizes(k + 1, z[k], x[k], r[k], **shape[k], top=tops[k].radius, **limits[k])
        for k in range(2)
    ]
    return GearSizes(
        order, m, alpha, tool, inv, inv_w, alpha_w, a, a_w, y, dy, p, p_b, h, h_w, ratio, least,
        (wheels[0], wheels[1]), beyond,
    )  # fmt: skip


def _rack(draft: Draft, order: GearTask, m: Mark, alpha: Mark) -> RackSizes:
    """Take the coefficients of the basic rack and calculate the rounding of its tip."""
    ha, c = draft.take(Number, "h_{a}^{*}", order.ha), draft.take(Number, "c^{*}", order.c)
    rounding = draft.draw(rack.rounding, "ρ_{f}", m, ha, c, alpha, unit="m")
    straight = draft.draw(rack.straight_depth, "h_{l}", ha, c, m, rounding, alpha, unit="m")
    offset = draft.draw(rack.rounding_offset, "e_{F}", m, ha, c, rounding, alpha, unit="m")
    return RackSizes(ha, c, rounding, straight, offset)


def _shape(
    draft: Draft,
    i: int,
    pair: tuple[Mark, Mark, Mark, Mark],
    tool: RackSizes,
    wheel: tuple[Mark, Mark, Mark],
) -> dict[str, Mark]:
    """Calculate the radii and thicknesses of a wheel; ``pair``: m, α, α_w, Δy; ``wheel``: z, x, r."""
    (m, alpha, alpha_w, dy), (z, x, r) = pair, wheel
    r_b = draft.draw(g.times_cosine, f"r_{{b{i}}}", r, alpha, unit="m")
    r_w = draft.draw(g.over_cosine, f"r_{{w{i}}}", r_b, alpha_w, unit="m")
    r_f = draft.draw(g.root_radius, f"r_{{f{i}}}", r, m, tool.ha, tool.c, x, unit="m")
    r_a = draft.draw(g.tip_radius, f"r_{{a{i}}}", r, m, tool.ha, x, dy, unit="m")
    s = draft.draw(g.tooth_thickness, f"s_{i}", m, x, alpha, unit="m")
    alpha_a = draft.draw(g.tip_angle, f"α_{{a{i}}}", r_b, r_a)
    s_a = draft.draw(g.tip_thickness, f"s_{{a{i}}}", r_a, s, r, alpha, alpha_a, unit="m")
    inv_p = draft.draw(g.pointed_involute, f"inv α_{{p{i}}}", s, r, alpha)
    alpha_p = draft.draw(g.angle_of_involute, f"α_{{p{i}}}", inv_p)
    pointed = draft.draw(g.over_cosine, f"r_{{p{i}}}", r_b, alpha_p, unit="m")
    depth = draft.draw(
        rack.rounding_depth, f"d_{{F{i}}}", tool.ha, tool.c, x, m, tool.rounding, unit="m"
    )
    x_min = draft.draw(rack.least_shift, f"x_{{min{i}}}", tool.straight, m, z, alpha)
    limit = draft.draw(rack.limit_curvature, f"ρ_{{l{i}}}", r, alpha, tool.straight, x, m, unit="m")
    tau = draft.draw(g.angular_pitch, f"τ_{i}", z)
    p_w = draft.draw(g.arc_of_pitch, f"p_{{w{i}}}", r_w, z, unit="m")
    return {
        "r_b": r_b, "r_w": r_w, "r_f": r_f, "r_a": r_a, "s": s, "alpha_a": alpha_a, "s_a": s_a,
        "pointed": pointed, "alpha_p": alpha_p, "depth": depth, "x_min": x_min, "limit": limit,
        "angular_pitch": tau, "p_w": p_w,
    }  # fmt: skip


class _Top(NamedTuple):
    """Up to where a tooth is there: the radius (m), the profile angle."""

    radius: Mark
    angle: Mark


def _top(shape: dict[str, Mark], value: Callable[[Mark], float]) -> _Top:
    """Return where a tooth ends: on its tip circle, or below it where its flanks meet."""
    apex = shape.pop("alpha_p")
    if value(shape["s_a"]) < 0.0:
        return _Top(shape["pointed"], apex)
    return _Top(shape["r_a"], shape["alpha_a"])


def _contact_ratio(
    draft: Draft,
    z: tuple[Mark, Mark],
    tips: tuple[Mark, Mark],
    alpha_w: Mark,
    beyond: tuple[bool, bool],
) -> Mark:
    """Calculate the contact ratio: from tip to tip, or from a limit point beyond which a tip reaches."""
    if all(beyond):
        return draft.draw(g.contact_of_limits, "ε_{α}", *z, alpha_w)
    for k in range(2):
        if beyond[k]:
            return draft.draw(g.contact_from_limit, "ε_{α}", z[k], tips[k])
    return draft.draw(g.contact_ratio, "ε_{α}", z[0], tips[0], z[1], tips[1], alpha_w)


def _limits(
    draft: Draft, k: int, pair: tuple[Mark, Mark], shape: list[dict[str, Mark]], top: _Top
) -> dict[str, Mark]:
    """Calculate where a wheel's flank works lowest, how low it may, and the clearance at its root.

    ``top``: of the other wheel's teeth.
    """
    (a_w, alpha_w), own, r_b = pair, shape[k], shape[1 - k]["r_b"]
    lowest = draft.draw(
        rack.lowest_curvature, f"ρ_{{p{k + 1}}}", a_w, alpha_w, r_b, top.angle, unit="m"
    )
    free = draft.draw(rack.not_negative, f"[ρ_{{p{k + 1}}}]", own["limit"], unit="m")
    clearance = draft.draw(g.tip_clearance, f"c_{k + 1}", a_w, top.radius, own["r_f"], unit="m")
    return {"lowest": lowest, "free": free, "clearance": clearance}
