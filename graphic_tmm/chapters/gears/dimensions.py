"""Dimensions of a pair of gears with shift, each a calculated step (m, degrees)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.energetics import share
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears import rack
from graphic_tmm.chapters.gears import ring as inside
from graphic_tmm.chapters.gears.driven_rack import (
    CLEAR,
    LOWEST,
    DrivenRack,
    calculate_axis,
    calculate_rack,
    contact_ratio_with_rack,
)
from graphic_tmm.chapters.gears.helical import NORMAL, Helix, draw_helix
from graphic_tmm.chapters.gears.rack import RackSizes
from graphic_tmm.chapters.gears.shifts import Axes, Section, calculate_axes, letter_of
from graphic_tmm.chapters.gears.task import GearTask

VIEW = "gear-dimensions"


@dataclass(frozen=True)
class RackCut:
    """What the rack does to a wheel: how deep under the pitch circle the centre of its rounding lies (m).

    ``x_min``: the least shift without undercut. ``limit``: the radius of curvature (m) at which the flank
    begins, ``free``: the least it may work at.
    """

    rack: RackSizes
    depth: Mark
    x_min: Mark
    limit: Mark
    free: Mark


@dataclass(frozen=True)
class WheelSizes:
    """One wheel (Number, m; Angle): z, x, radii, thicknesses, tip angle, limits of its teeth.

    ``x_drawn``: its shift in the section that is drawn. ``pointed``: the radius where both flanks of a tooth
    meet, ``top``: that up to which the tooth is there, r_a or this one; of a ring the base circle, if its tip
    lies inside, or where its flanks meet. ``lowest``: the radius of curvature of its lowest working point.
    ``cut``: None of a ring.
    """

    number: int
    z: Mark
    x: Mark
    x_drawn: Mark
    r: Mark
    r_b: Mark
    r_w: Mark
    r_f: Mark
    r_a: Mark
    s: Mark
    alpha_a: Mark
    s_a: Mark
    top: Mark
    lowest: Mark
    clearance: Mark
    angular_pitch: Mark
    p_w: Mark
    pointed: Mark | None = None
    cut: RackCut | None = None

    @property
    def x_min(self) -> Mark | None:
        """The least shift without undercut; None of a ring."""
        return self.cut.x_min if self.cut else None


@dataclass(frozen=True)
class GearSizes:
    """The pair (Number, m; Angle): what was given, distances, shifts, height, pitches, contact ratio ε.

    ``alpha``: of the section that is drawn. ``x_sum``: of both shifts, if it is given or follows.
    ``beyond``: of each wheel, whether the teeth of the other reach beyond its limit point N. ``ring``,
    ``rack``, ``helix``: None if there is none. With a rack there is one wheel, and ``a_w`` is the distance of
    the datum line from its axis.
    """

    order: GearTask
    m: Mark
    module: Mark
    alpha: Mark
    inv: Mark
    inv_w: Mark
    alpha_w: Mark
    a: Mark | None
    a_w: Mark
    y: Mark | None
    dy: Mark
    p: Mark
    p_b: Mark
    h: Mark
    h_w: Mark
    contact_ratio: Mark
    least_tip: Mark
    wheels: tuple[WheelSizes, ...]
    beyond: tuple[bool, ...]
    x_sum: Mark | None
    ring: inside.Ring | None
    rack: DrivenRack | None
    helix: Helix | None

    @property
    def racks(self) -> tuple[RackSizes, ...]:
        """The racks that cut the wheels, and that which a driven one is like."""
        cuts = tuple(wheel.cut.rack for wheel in self.wheels if wheel.cut)
        return cuts if self.rack is None else (*cuts, self.rack.profile)


def known(draft: Draft) -> Callable[[Mark], float]:
    """Return the value of what is calculated so far, by its mark."""
    exact = execute(draft.board.construction(), draft.given)
    return lambda mark: float(exact[mark][0, 0])


class _Pair(NamedTuple):
    """What a wheel is calculated from: both sections, the axes, Δy, the angles of mesh."""

    normal: Section
    drawn: Section
    axes: Axes
    dy: Mark
    racks: tuple[RackSizes, RackSizes]
    helix: Helix | None


def calculate_sizes(draft: Draft, order: GearTask) -> GearSizes:
    """Calculate the dimensions of both wheels, the quality of their meshing and the limits of their teeth."""
    draft.open(VIEW)
    m = draft.take(Number, letter_of(order, "m"), order.m, "m")
    alpha = draft.take(Angle, letter_of(order, "α"), order.alpha, "°")
    ha, c = _coefficients(draft, order)
    normal = drawn = Section(m, alpha, ha, c)
    helix = None if order.beta is None else draw_helix(draft, order.beta, m, alpha, ha, c)
    if helix is not None:
        drawn = Section(helix.m, helix.alpha, helix.ha, helix.c)
    racks = _racks(draft, drawn, order)
    axes_of = calculate_axis if order.racked else calculate_axes
    axes = axes_of(draft, order, normal, drawn, helix)
    y = axes.a and draft.draw(g.perceived_shift, "y", axes.a_w, axes.a, m)
    if order.delta_y is None and y is not None:
        op = inside.equalising_shift_inside if order.internal else g.equalising_shift
        dy = draft.draw(op, "Δy", *axes.x, y)
    else:
        dy = draft.take(Number, "Δy", order.delta_y or 0.0)
    p = draft.draw(g.pitch_of, letter_of(order, "p"), drawn.m, unit="m")
    p_b = draft.draw(g.times_cosine, letter_of(order, "p_{b}"), p, drawn.alpha, unit="m")
    h = h_w = None
    if ha[0] is ha[1]:
        h = draft.draw(g.tooth_height, "h", m, ha[0], c, dy, unit="m")
        h_w = draft.draw(g.working_depth, "h_{w}", m, ha[0], dy, unit="m")
    pair = _Pair(normal, drawn, axes, dy, racks, helix)
    shape = [_shape(draft, pair, k, order) for k in range(len(axes.z))]
    value = known(draft)
    tops, mate, ring = [_top(one, value) for one in shape], None, None
    if order.racked:
        mate = calculate_rack(
            draft, order, normal, axes, (p, drawn.alpha, tops[0].radius), racks[1]
        )
        limits = [_limits_on_rack(draft, pair, shape[0], mate)]
    else:
        limits = [_limits(draft, k, pair, shape, tops[1 - k], order.internal) for k in range(2)]
    value = known(draft)
    beyond = tuple(value(one["lowest"]) < 0.0 for one in limits)
    if order.internal:
        both = (axes.a_w, axes.alpha_w)
        ring = inside.check_ring(draft, both, axes.z, tuple(tops), shape[1]["r_b"], beyond[0])
    if mate is not None and not beyond[0]:
        reach = (drawn.alpha, drawn.ha[1], axes.x_drawn[0])
        ratio = draft.draw(contact_ratio_with_rack, "ε_{α}", axes.z[0], tops[0].angle, *reach)
    else:
        angles = tuple(top.angle for top in tops)
        ratio = _contact_ratio(draft, axes, angles, beyond, order.internal)
    if h is None or h_w is None:
        h = draft.draw(inside.less, "h", shape[0]["r_a"], shape[0]["r_f"], unit="m")
        h_w = draft.draw(inside.less, "h_{w}", h, limits[0]["clearance"], unit="m")
    k_tip = draft.take(Number, "k_{s}", order.least_tip)
    least = draft.draw(share, "[s_{a}]", m, k_tip, unit="m")
    wheels = tuple(
        _wheel(pair, k, *of) for k, of in enumerate(zip(shape, tops, limits, strict=True))
    )
    return GearSizes(
        order, m, drawn.m, drawn.alpha, axes.inv, axes.inv_w, axes.alpha_w, axes.a, axes.a_w, y, dy, p, p_b,
        h, h_w, ratio, least, wheels, beyond, axes.x_sum, ring, mate, helix,
    )  # fmt: skip


def _coefficients(draft: Draft, order: GearTask) -> tuple[tuple[Mark, Mark], Mark]:
    """Take the addenda of both wheels, one mark if they are the same, and the clearance."""
    if isinstance(order.ha, tuple):
        one, other = (draft.take(Number, f"h_{{a{i}}}^{{*}}", v) for i, v in enumerate(order.ha, 1))
        return (one, other), draft.take(Number, "c^{*}", order.c)
    ha = draft.take(Number, "h_{a}^{*}", order.ha)
    return (ha, ha), draft.take(Number, "c^{*}", order.c)


def _racks(draft: Draft, drawn: Section, order: GearTask) -> tuple[RackSizes, RackSizes]:
    """Calculate the rounding at the tips of the racks; a wheel's has the addendum of its mate."""

    def cutting(ha: Mark, i: str) -> RackSizes:
        rest = (drawn.c, drawn.alpha)
        rounding = draft.draw(rack.rounding, f"ρ_{{f{i}}}", drawn.m, ha, *rest, unit="m")
        depth = (ha, drawn.c, drawn.m, rounding, drawn.alpha)
        straight = draft.draw(rack.straight_depth, f"h_{{l{i}}}", *depth, unit="m")
        depth = (drawn.m, ha, drawn.c, rounding, drawn.alpha)
        offset = draft.draw(rack.rounding_offset, f"e_{{F{i}}}", *depth, unit="m")
        return RackSizes(ha, drawn.c, rounding, straight, offset)

    one, other = drawn.ha
    if one is other or order.internal:
        same = cutting(drawn.ha[_deeper(order, 0)], "")
        return same, same
    return cutting(other, "1"), cutting(one, "2")


def _deeper(order: GearTask, k: int) -> int:
    """Return whose addendum a wheel has room for: its mate's, in a ring of shorter teeth the longer one."""
    one, other = order.addenda
    return 0 if k or (order.internal and one > other) else 1


def _shape(draft: Draft, pair: _Pair, k: int, order: GearTask) -> dict[str, Mark]:
    """Calculate the radii and thicknesses of a wheel."""
    (m, _, ha, c), (wide, alpha, *_), i = pair.normal, pair.drawn, k + 1
    x, r, shift = pair.axes.x[k], pair.axes.r[k], pair.axes.x_drawn[k]
    root, tip, thick = how = _RING if order.internal and k else _WHEEL
    r_b = draft.draw(g.times_cosine, f"r_{{b{i}}}", r, alpha, unit="m")
    r_w = r
    if not order.racked:
        r_w = draft.draw(g.over_cosine, f"r_{{w{i}}}", r_b, pair.axes.alpha_w, unit="m")
    r_f = draft.draw(root, f"r_{{f{i}}}", r, m, ha[_deeper(order, k)], c, x, unit="m")
    r_a = draft.draw(tip, f"r_{{a{i}}}", r, m, ha[k], x, pair.dy, unit="m")
    s = draft.draw(thick, letter_of(order, "s", i), wide, shift, alpha, unit="m")
    found = {"r_b": r_b, "r_w": r_w, "r_f": r_f, "r_a": r_a, "s": s}
    found |= (_ringed if how is _RING else _cut)(draft, pair, k, order, found)
    found["angular_pitch"] = draft.draw(g.angular_pitch, f"τ_{i}", pair.axes.z[k])
    found["p_w"] = draft.draw(g.arc_of_pitch, f"p_{{w{i}}}", r_w, pair.axes.z[k], unit="m")
    return found


def _cut(
    draft: Draft, pair: _Pair, k: int, order: GearTask, shape: dict[str, Mark]
) -> dict[str, Mark]:
    """Calculate the tip of a wheel, where its teeth are pointed, and what the rack leaves of them."""
    (wide, alpha, *_), tool, axes, i = pair.drawn, pair.racks[k], pair.axes, k + 1
    (r_b, _, _, r_a, s), r, shift = shape.values(), axes.r[k], axes.x_drawn[k]
    alpha_a = draft.draw(g.tip_angle, f"α_{{a{i}}}", r_b, r_a)
    thin = (r_a, s, r, alpha, alpha_a)
    s_a = draft.draw(g.tip_thickness, letter_of(order, "s_{a}", i), *thin, unit="m")
    inv_p = draft.draw(g.pointed_involute, f"inv α_{{p{i}}}", s, r, alpha)
    alpha_p = draft.draw(g.angle_of_involute, f"α_{{p{i}}}", inv_p)
    pointed = draft.draw(g.over_cosine, f"r_{{p{i}}}", r_b, alpha_p, unit="m")
    deep = (tool.ha, pair.drawn.c, shift, wide, tool.rounding)
    depth = draft.draw(rack.rounding_depth, f"d_{{F{i}}}", *deep, unit="m")
    least = "x_{min}" if pair.helix is None else "x_{t min}"
    flat = (tool.straight, wide, axes.z[k], alpha)
    x_min = draft.draw(rack.least_shift, f"{least[:-1]}{i}}}", *flat)
    if pair.helix is not None:
        name = letter_of(order, "x_{min}", i)
        x_min = draft.draw(g.over_cosine, name, x_min, pair.helix.beta, why=NORMAL)
    ends = (r, alpha, tool.straight, shift, wide)
    limit = draft.draw(rack.limit_curvature, f"ρ_{{l{i}}}", *ends, unit="m")
    return {
        "alpha_a": alpha_a, "s_a": s_a, "pointed": pointed, "alpha_p": alpha_p, "depth": depth,
        "x_min": x_min, "limit": limit,
    }  # fmt: skip


def _ringed(
    draft: Draft, pair: _Pair, k: int, order: GearTask, shape: dict[str, Mark]
) -> dict[str, Mark]:
    """Calculate the tip of a ring's teeth; they end on the base circle, or where their flanks meet before."""
    (r_b, _, _, r_a, s), (_, alpha, *_) = shape.values(), pair.drawn
    value, rest = known(draft), (s, pair.axes.r[k], alpha)
    top = r_b if value(r_a) < value(r_b) else r_a
    alpha_a = draft.draw(g.tip_angle, "α_{a2}", r_b, top)
    name = letter_of(order, "s_{a}", 2)
    s_a = draft.draw(inside.ring_thickness_at, name, top, *rest, alpha_a, unit="m")
    found = {"alpha_a": alpha_a, "s_a": s_a, "top": top}
    if known(draft)(s_a) < 0.0:
        inv_p = draft.draw(inside.pointed_ring_involute, "inv α_{p2}", *rest)
        found["alpha_p"] = draft.draw(g.angle_of_involute, "α_{p2}", inv_p)
        found["top"] = draft.draw(g.over_cosine, "r_{p2}", r_b, found["alpha_p"], unit="m")
    return found


_WHEEL = (g.root_radius, g.tip_radius, g.tooth_thickness)
_RING = (inside.ring_root, inside.ring_tip, inside.ring_thickness)
"""By which formulas root and tip radius and thickness of a tooth follow."""


class _Top(NamedTuple):
    """Up to where a tooth is there: the radius (m), the profile angle."""

    radius: Mark
    angle: Mark


def _top(shape: dict[str, Mark], value: Callable[[Mark], float]) -> _Top:
    """Return where a tooth ends: on its tip circle, or before, where its flanks meet or its involute ends."""
    top, apex = shape.pop("top", shape["r_a"]), shape.pop("alpha_p", None)
    if apex is not None and value(shape["s_a"]) < 0.0:
        return _Top(shape.get("pointed", top), apex)
    return _Top(top, shape["alpha_a"])


def _contact_ratio(
    draft: Draft, axes: Axes, tips: tuple[Mark, ...], beyond: tuple[bool, ...], internal: bool
) -> Mark:
    """Calculate the contact ratio: from tip to tip, or from a limit point beyond which a tip reaches."""
    z = axes.z
    if all(beyond) and len(z) == 2:
        return draft.draw(g.contact_of_limits, "ε_{α}", *z, axes.alpha_w)
    for k, cut_off in enumerate(beyond):
        if cut_off:
            return draft.draw(g.contact_from_limit, "ε_{α}", z[k], tips[k])
    op = inside.contact_ratio_inside if internal else g.contact_ratio
    return draft.draw(op, "ε_{α}", z[0], tips[0], z[1], tips[1], axes.alpha_w)


def _limits(
    draft: Draft, k: int, pair: _Pair, shape: list[dict[str, Mark]], top: _Top, internal: bool
) -> dict[str, Mark]:
    """Calculate where a wheel's flank works lowest, how low it may, and the clearance at its root.

    ``top``: of the other wheel's teeth.
    """
    own, axes, i = shape[k], pair.axes, k + 1
    how = (inside.lowest_inside, inside.farthest_inside)[k] if internal else rack.lowest_curvature
    reach = (axes.a_w, axes.alpha_w, shape[1 - k]["r_b"], top.angle)
    found = {"lowest": draft.draw(how, f"ρ_{{p{i}}}", *reach, unit="m")}
    if "limit" in own:
        found["free"] = draft.draw(rack.not_negative, f"[ρ_{{p{i}}}]", own["limit"], unit="m")
    gap = (top.radius, own["r_f"])
    if internal:
        gap = (shape[1]["r_a"], own["r_f"]) if k == 0 else gap[::-1]
    clear = inside.clearance_inside if internal else g.tip_clearance
    found["clearance"] = draft.draw(clear, f"c_{i}", axes.a_w, *gap, unit="m")
    return found


def _limits_on_rack(
    draft: Draft, pair: _Pair, own: dict[str, Mark], mate: DrivenRack
) -> dict[str, Mark]:
    """Calculate where the flank works lowest, how low it may, the clearance at the root of the wheel."""
    reach = (pair.axes.r[0], pair.drawn.alpha, mate.h_a, pair.axes.x_drawn[0], pair.drawn.m)
    return {
        "lowest": draft.draw(rack.limit_curvature, "ρ_{p1}", *reach, unit="m", why=LOWEST),
        "free": draft.draw(rack.not_negative, "[ρ_{p1}]", own["limit"], unit="m"),
        "clearance": draft.draw(inside.less, "c_1", mate.tip, own["r_f"], unit="m", why=CLEAR),
    }


def _wheel(
    pair: _Pair, k: int, shape: dict[str, Mark], top: _Top, limits: dict[str, Mark]
) -> WheelSizes:
    """Put together what was calculated of a wheel."""
    cut, axes = None, pair.axes
    if "limit" in shape:
        depth, x_min, limit = (shape.pop(name) for name in ("depth", "x_min", "limit"))
        cut = RackCut(pair.racks[k], depth, x_min, limit, limits.pop("free"))
    return WheelSizes(
        k + 1, axes.z[k], axes.x[k], axes.x_drawn[k], axes.r[k], **shape, **limits, top=top.radius,
        cut=cut,
    )  # fmt: skip
