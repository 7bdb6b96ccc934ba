"""The calculated sizes of a planetary train and the conditions on its teeth, each a step of the log."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.formulas import pitch_radius
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.trains import formulas as t
from graphic_tmm.chapters.trains import words as why
from graphic_tmm.chapters.trains.bevel_formulas import draw_mean_radius
from graphic_tmm.chapters.trains.motion import Motion, motion_of
from graphic_tmm.chapters.trains.rows import closing_rows, draw_closing, draw_teeth
from graphic_tmm.chapters.trains.task import PlanetaryTask, Scheme, Train
from graphic_tmm.chapters.trains.tooth_conditions import has_least_ring, in_two_rows, shifted
from graphic_tmm.language.said import said


class Condition(NamedTuple):
    """A condition as calculated: its name, what stands left and right of its relation (Number).

    ``relation``: "=", "≠" (broken), ">", "≥", "≤", or "whole" (then ``right`` is None).
    """

    name: str
    left: Mark
    relation: str
    right: Mark | None


@dataclass(frozen=True)
class Dimensions:
    """The sizes of a train as marks (Number).

    ``teeth``, ``radii`` (m): by the wheel; ``tips`` (m): tip diameters of the satellites' rims, by the wheel.
    ``axes``: from the main axis to that of a satellite, of bevel wheels to B of it, m. ``ratio``: driving
    over driven by Willis, None of a differential. ``closing``: how wheels turn that close one, and both members
    that they join, by the first; ``outside``: their teeth.
    """

    teeth: Mapping[str, Mark]
    satellites: Mark
    radii: Mapping[str, Mark]
    tips: Mapping[str, Mark]
    axes: Mark
    ratio: Mark | None
    closing: Mapping[str, Mark]
    outside: Mapping[str, Mark]
    conditions: tuple[Condition, ...]


@formula(
    holds="{own} ≠ 0",
    fails="the wheels have no distance",
    why=said(
        "Cut with a shift the wheels mesh at another distance of axes; the circles that roll grow as it does."
    ),
)
def working_radius(radius: Number, axes: Number, own: Number) -> Number:
    """{radius}·{axes}/{own}"""


def calculate_train(draft: Draft, order: PlanetaryTask, train: Train) -> Dimensions:
    """Calculate radii, distances of axes, the ratio and every condition."""
    scheme = train.scheme
    name = "m_m" if scheme.bevel else "m"
    first = draft.take(Number, name if scheme.rows == 1 else "m_I", order.module, "m")
    second = first
    if scheme.rows == 2:
        second = draft.take(Number, "m_{II}", order.module_2 or order.module, "m")
    z = {
        wheel: draft.take(Number, f"z_{wheel}", float(count))
        for wheel, count in zip(scheme.wheels, train.teeth, strict=True)
    }
    k = draft.take(Number, "k", float(train.satellites))
    modules = dict(zip(scheme.rims, (first, second), strict=False))
    radii = {
        wheel: draft.draw(
            pitch_radius, f"r_{wheel}", modules[scheme.mesh(wheel).rim], z[wheel], unit="m"
        )
        for wheel in scheme.wheels
    }
    motion = motion_of(order)
    if scheme.bevel:
        axes = draw_mean_radius(draft, scheme, radii)
        ratio = _ratio(draft, motion, scheme, z) if motion.fixed else None
        found = _assembly(draft, scheme, z, k)
        return Dimensions(z, k, radii, {}, axes, ratio, {}, {}, found)
    axes, *again = (
        _axes(draft, letter, mesh.sense, modules[mesh.rim], z[mesh.wheel], z[mesh.rim])
        for letter, mesh in zip(("a_w", "a′_w", "a″_w"), scheme.meshes, strict=False)
    )
    ratio = _ratio(draft, motion, scheme, z) if motion.fixed and again else None
    teeth, turned = dict[str, Mark](), dict[str, Mark]()
    if motion.closing is not None:
        rows = closing_rows(order, scheme, motion.closing)
        teeth, unit = draw_teeth(draft, rows), draft.take(Number, f"u_{motion.closing.joint}", 1.0)
        turned = draw_closing(draft, rows, teeth, motion.closing, unit)
        ratio = _ratio_of_closed(draft, motion, scheme, z, turned)
    alike = "="
    if scheme.rows == 2 and shifted(order, scheme, in_two_rows(scheme, train.teeth)).all():
        alike = "≠"
        for wheel in scheme.meshes[-1][:2]:
            own = (radii[wheel], axes, again[0])
            radii[wheel] = draft.draw(working_radius, f"r_{{w{wheel}}}", *own, unit="m")
    ha = draft.take(Number, "h_{a}^{*}", order.ha)
    tips = {
        rim: draft.draw(t.tip_diameter, f"d_{{a{rim}}}", module, z[rim], ha, unit="m")
        for rim, module in modules.items()
    }
    conditions = (
        *_wanted(draft, order, ratio),
        *(Condition("coaxial", axes, alike, other) for other in again),
        *_neighbours(draft, train, axes, k, tips),
        *_assembly(draft, scheme, z, k),
        *_undercut(draft, order, scheme, z),
        *_interference(draft, order, scheme, z, ha, modules),
    )
    return Dimensions(z, k, radii, tips, axes, ratio, turned, teeth, conditions)


def _axes(draft: Draft, letter: str, sense: int, module: Mark, centre: Mark, rim: Mark) -> Mark:
    op = t.axes_outside if sense > 0 else t.axes_inside
    return draft.draw(op, letter, module, centre, rim, unit="m")


def draw_held(
    draft: Draft, scheme: Scheme, z: Mapping[str, Mark], over: str, under: str, letter: str = ""
) -> Mark:
    """Calculate the ratio of a central wheel to another with the carrier held."""
    one, other = scheme.mesh(over), scheme.mesh(under)
    letter = letter or f"U_{{{over}{under}}}^{{H}}"
    if one.rim == other.rim:
        return draft.draw(t.held_row, letter, z[over], z[under])
    op = t.held_opposed if one.sense * other.sense < 0 else t.held_alike
    return draft.draw(op, letter, z[over], z[one.rim], z[other.rim], z[under])


def _ratio(draft: Draft, motion: Motion, scheme: Scheme, z: Mapping[str, Mark]) -> Mark:
    """Calculate driving over driven by the formula of Willis."""
    if "H" not in scheme.members:
        return _ratio_of_three(draft, motion, scheme, z)
    last, fixed = motion.last, motion.fixed
    over, under = {last: ("1", "H"), "1": (last, "H"), "H": ("1", last)}[fixed]
    letter = f"U_{{{over}{under}}}"
    if fixed == "H":
        found = draw_held(draft, scheme, z, over, under, letter)
    else:
        own = (
            [*z.values()]
            if fixed == last
            else [z[k] for k in ("2143" if scheme.rows == 2 else "321")]
        )
        reason = "" if fixed == last else why.FIRST_STANDS
        if scheme.rows == 1:
            found = draft.draw(t.ratio_of_row, letter, own[0], own[-1], why=reason)
        else:
            op = t.ratio_opposed if scheme.opposed else t.ratio_alike
            found = draft.draw(op, letter, *own, why=reason)
    return found if motion.first == over else draft.draw(t.inverse_ratio, motion.ratio, found)


def _ratio_of_three(draft: Draft, motion: Motion, scheme: Scheme, z: Mapping[str, Mark]) -> Mark:
    """Calculate driving over driven of three central wheels: each of both over the carrier, by Willis."""
    to_carrier = [
        draft.draw(
            t.ratio_to_carrier,
            f"U_{{{wheel}H}}^{{{motion.fixed}}}",
            draw_held(draft, scheme, z, wheel, motion.fixed),
        )
        for wheel in (motion.first, motion.driven)
    ]
    return draft.draw(t.ratio_of_ratios, motion.ratio, *to_carrier)


def third_rate(
    draft: Draft,
    scheme: Scheme,
    z: Mapping[str, Mark],
    sought: str,
    given: Mapping[str, Mark],
    letter: str,
) -> Mark:
    """Calculate how a third member turns, by Willis, from two that are given."""
    last = scheme.meshes[-1].wheel
    held = draw_held(draft, scheme, z, "1", last)
    op = {"1": t.rate_of_first, "H": t.rate_of_carrier}.get(sought, t.rate_of_last)
    known = [given[name] for name in ("1", last, "H") if name != sought]
    return draft.draw(op, letter, held, *known, unit=known[0].unit)


def _ratio_of_closed(
    draft: Draft, motion: Motion, scheme: Scheme, z: Mapping[str, Mark], turned: Mapping[str, Mark]
) -> Mark:
    """Calculate driving over driven of a closed differential: of three members two turn as wheels join them."""
    if motion.driven in turned:
        return third_rate(draft, scheme, z, motion.first, turned, motion.ratio)
    found = third_rate(draft, scheme, z, motion.driven, turned, f"u_{motion.driven}")
    return draft.draw(t.inverse_ratio, motion.ratio, found)


def _wanted(draft: Draft, order: PlanetaryTask, ratio: Mark | None) -> tuple[Condition, ...]:
    if order.ratio is None or ratio is None:
        return ()
    due = draft.take(Number, "U", order.ratio)
    miss = draft.draw(t.miss_of_ratio, "ΔU", ratio, due, unit="%")
    allowed = draft.take(Number, "ΔU_{max}", 100.0 * order.tolerance, "%")
    return (Condition("ratio", miss, "≤", allowed),)


def _neighbours(
    draft: Draft, train: Train, axes: Mark, k: Mark, tips: Mapping[str, Mark]
) -> tuple[Condition, ...]:
    """Calculate from axis to axis of neighbours; a single satellite has none."""
    if train.satellites == 1:
        return ()
    between = draft.draw(t.neighbouring_axes, "e", axes, k, unit="m")
    return tuple(Condition("neighbours", between, ">", tip) for tip in tips.values())


def _assembly(
    draft: Draft, scheme: Scheme, z: Mapping[str, Mark], k: Mark
) -> tuple[Condition, ...]:
    """Calculate the number of the assembly of each pair of meshes; a single mesh goes together anyhow."""
    found = []
    for pair, letter in zip(scheme.pairs, ("N", "N′"), strict=False):
        wheels = [z[wheel] for wheel in pair.wheels]
        if len(pair.meshes) == 1:
            continue
        if pair.rows == 1:
            number = draft.draw(t.assembly_of_row, letter, wheels[0], wheels[2], k)
        else:
            name = f"D_{{{pair.rims[0]}{pair.rims[1]}}}" if "D" in scheme.spots else "D"
            divisor = draft.draw(t.common_divisor, name, wheels[1], wheels[2])
            op = t.assembly_opposed if pair.opposed else t.assembly_alike
            number = draft.draw(op, letter, *wheels, k, divisor)
        found.append(Condition("assembly", number, "whole", None))
    return tuple(found)


def _undercut(
    draft: Draft, order: PlanetaryTask, scheme: Scheme, z: Mapping[str, Mark]
) -> tuple[Condition, ...]:
    least = draft.take(Number, "z_{min}", float(order.limits.least))
    rings = {ring for ring, _ in rings_of(scheme)}
    return tuple(Condition("undercut", z[w], "≥", least) for w in z if w not in rings)


def _interference(
    draft: Draft,
    order: PlanetaryTask,
    scheme: Scheme,
    z: Mapping[str, Mark],
    ha: Mark,
    modules: Mapping[str, Mark],
) -> tuple[Condition, ...]:
    """Calculate what keeps tips of rings off the roots of satellites; ``modules``: by the rim."""
    least = draft.take(Number, "Δz_{min}", float(order.limits.difference))
    alpha, made = draft.angle("α", order.alpha), []
    for ring, rim in rings_of(scheme):
        between = draft.draw(t.tooth_difference, f"Δz_{{{ring}{rim}}}", z[ring], z[rim])
        made.append(Condition("interference", between, "≥", least))
        if has_least_ring(float(draft.given[z[rim]]), order.alpha, order.ha):  # type: ignore[arg-type]
            clear = draft.draw(t.least_ring, f"z_{{{ring}min}}", z[rim], alpha, ha)
            made.append(Condition("interference", z[ring], "≥", clear))
            continue
        m = modules[rim]
        tip = draft.draw(t.tip_of_ring, f"r_{{a{ring}}}", m, z[ring], ha, unit="m")
        base = draft.draw(t.base_radius, f"r_{{b{ring}}}", m, z[ring], alpha, unit="m")
        along = draft.draw(t.along_action, "l_N", m, z[ring], z[rim], alpha, unit="m")
        starts = draft.draw(t.least_tip_of_ring, f"r_{{a{ring}min}}", base, along, unit="m")
        made.append(Condition("interference", tip, "≥", starts))
    return tuple(made)


def rings_of(scheme: Scheme) -> tuple[tuple[str, str], ...]:
    """Return the rings of a scheme, each with the satellites' rim inside it."""
    return tuple((mesh.wheel, mesh.rim) for mesh in scheme.meshes if mesh.ring)
