"""The calculated sizes of a planetary train and the conditions on its teeth, each a step of the log."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import pitch_radius
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.planetary import formulas as t
from graphic_tmm.chapters.planetary import words as why
from graphic_tmm.chapters.planetary.motion import Motion, motion_of
from graphic_tmm.chapters.planetary.task import PlanetaryTask, Scheme, Train
from graphic_tmm.chapters.planetary.tooth_conditions import has_least_ring


class Condition(NamedTuple):
    """A condition as calculated: its name, what stands left and right of its relation (Number).

    ``relation``: "=", ">", "≥", "≤", or "whole" (then ``right`` is None).
    """

    name: str
    left: Mark
    relation: str
    right: Mark | None


@dataclass(frozen=True)
class Dimensions:
    """The sizes of a train as marks (Number).

    ``teeth``, ``radii`` (m): by the wheel; ``tips`` (m): tip diameters of the satellites' rims, by the wheel.
    ``axes``: from the main axis to that of a satellite, m. ``ratio``: driving over driven by Willis,
    None of a differential.
    """

    teeth: Mapping[str, Mark]
    satellites: Mark
    radii: Mapping[str, Mark]
    tips: Mapping[str, Mark]
    axes: Mark
    ratio: Mark | None
    conditions: tuple[Condition, ...]


def calculate_train(draft: Draft, order: PlanetaryTask, train: Train) -> Dimensions:
    """Calculate radii, distances of axes, the ratio and every condition."""
    scheme = train.scheme
    first = draft.take(Number, "m" if scheme.rows == 1 else "m_I", order.module, "m")
    second = first
    if scheme.rows == 2:
        second = draft.take(Number, "m_{II}", order.module_2 or order.module, "m")
    z = {
        wheel: draft.take(Number, f"z_{wheel}", float(count))
        for wheel, count in zip(scheme.wheels, train.teeth, strict=True)
    }
    k = draft.take(Number, "k", float(train.satellites))
    radii = {
        wheel: draft.draw(
            pitch_radius, f"r_{wheel}", first if wheel in "12" else second, z[wheel], unit="m"
        )
        for wheel in scheme.wheels
    }
    rim = "2" if scheme.rows == 1 else "3"
    fixed = scheme.wheels[-1]
    axes = _axes(draft, "a_w", scheme.first, first, z["1"], z["2"])
    again = _axes(draft, "a′_w", scheme.second, second, z[fixed], z[rim])
    motion = motion_of(order)
    ratio = _ratio(draft, motion, scheme, z) if motion.fixed else None
    ha = draft.take(Number, "h_{a}^{*}", order.ha)
    tips = {
        wheel: draft.draw(t.tip_diameter, f"d_{{a{wheel}}}", module, z[wheel], ha, unit="m")
        for wheel, module in dict((("2", first), (rim, second))).items()
    }
    conditions = (
        *_wanted(draft, order, ratio),
        Condition("coaxial", axes, "=", again),
        *_neighbours(draft, train, axes, k, tips),
        Condition("assembly", _assembly(draft, scheme, z, k), "whole", None),
        *_undercut(draft, order, scheme, z),
        *_interference(draft, order, scheme, z, ha, {"2": first, rim: second}),
    )
    return Dimensions(z, k, radii, tips, axes, ratio, conditions)


def _axes(draft: Draft, letter: str, sense: int, module: Mark, centre: Mark, rim: Mark) -> Mark:
    op = t.axes_outside if sense > 0 else t.axes_inside
    return draft.draw(op, letter, module, centre, rim, unit="m")


def draw_held(draft: Draft, scheme: Scheme, z: Mapping[str, Mark], letter: str) -> Mark:
    """Calculate the ratio of wheel 1 to the last wheel with the carrier held."""
    if scheme.rows == 1:
        return draft.draw(t.held_row, letter, z["1"], z["3"])
    return draft.draw(t.held_opposed if scheme.opposed else t.held_alike, letter, *z.values())


def _ratio(draft: Draft, motion: Motion, scheme: Scheme, z: Mapping[str, Mark]) -> Mark:
    """Calculate driving over driven by the formula of Willis."""
    last, fixed = scheme.wheels[-1], motion.fixed
    over, under = {last: ("1", "H"), "1": (last, "H"), "H": ("1", last)}[fixed]
    letter = f"U_{{{over}{under}}}"
    if fixed == "H":
        found = draw_held(draft, scheme, z, letter)
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


def _assembly(draft: Draft, scheme: Scheme, z: Mapping[str, Mark], k: Mark) -> Mark:
    if scheme.rows == 1:
        return draft.draw(t.assembly_of_row, "N", z["1"], z["3"], k)
    divisor = draft.draw(t.common_divisor, "D", z["2"], z["3"])
    op = t.assembly_opposed if scheme.opposed else t.assembly_alike
    return draft.draw(op, "N", *z.values(), k, divisor)


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
    rim = "2" if scheme.rows == 1 else "3"
    first = (("1", "2"),) if scheme.first < 0 else ()
    return (*first, *(((scheme.wheels[-1], rim),) if scheme.second < 0 else ()))
