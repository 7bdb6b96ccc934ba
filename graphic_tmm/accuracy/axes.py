"""The axes of accuracy: what of a scene can be varied, one thing at a time, about its own setting.

An axis that a scene does not call for has no values: without diagrams there is no pole, without friction no
pass.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

from graphic_tmm.accuracy.settings import EACH_SLIP, GRID, OWN, Setting, at_count, named
from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.chapters.cam.task import ASKED as CAM
from graphic_tmm.chapters.diagrams.task import ASKED as DIAGRAMS_ASKED
from graphic_tmm.chapters.diagrams.task import KinematicOrder
from graphic_tmm.chapters.engine.task import ASKED as ENGINE_ASKED
from graphic_tmm.chapters.engine.task import EngineOrder
from graphic_tmm.chapters.flywheel.task import ASKED as FLYWHEEL_ASKED
from graphic_tmm.chapters.forces.task import ASKED as FORCES_ASKED
from graphic_tmm.chapters.gears.task import ASKED as GEARS
from graphic_tmm.scene.records import Scene

COUNTS = (4, 6, 8, 10, 12, 14, 16, 18, 24, 36, 48)
"""Numbers of positions that every hand draws."""
LONG = (96, 192, 384, 768, 1536, 3072)
"""Numbers of positions for the exact hand alone."""
RULERS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
"""Divisions of the ruler, mm."""
SIZES = (0.5, 1.0, 2.0, 4.0)
"""How many times as large the drawing is; 2: every μ twice as fine, and four times the paper."""
POLES = (0.5, 1.0, 2.0)
TRIALS = (10, 30, 100, 300, 1000)
"""Numbers of drawings, up to ten times as many as are asked for."""
PASSES = (2, 3, 4, 6, 8)
STEPS = (4, 6, 8, 12, 16, 24, 48)
"""Steps of a rolling."""
PARTS = (6, 8, 10, 12, 16, 24, 36, 48)
"""Parts of a moving phase of a cam."""


class Place(NamedTuple):
    """A setting on an axis: the axis, the value there as text, ``only``: the quantities that it bears upon."""

    axis: str
    value: str
    setting: Setting
    only: tuple[str, ...] | None = None


DIAGRAMS = ("V_diagram", "a_diagram")
FLYWHEEL = ("J_fly", "J_fly_energy_mass")
BALANCE = ("P_bal", "M_bal")


def grid(own: Setting, trials: int) -> Iterator[Place]:
    """Yield the number of positions (of parts of a cam, of steps of a rolling) by hands."""
    hands = [(name, named(name, own.scene, trials)) for name in GRID]
    if (own.hand, own.who) not in hands:
        hands.append((own.hand, own.who))
    for axis, divided in rows(own.scene):
        for value, scene in divided:
            exact_only = axis == "positions" and int(value) in LONG
            for name, who in hands[:1] if exact_only else hands:
                yield Place(axis, value, replace(own, scene=scene).by(name, who))


def rows(scene: Scene) -> Iterator[tuple[str, list[tuple[str, Scene]]]]:
    """Yield the axes along which a drawing is divided finer, and the scenes on them."""
    shown = scene.called
    if scene.mechanism is not None and shown - {"cam", "gears", "planetary"}:
        counts = sorted({*COUNTS, *LONG, scene.row.count})
        found = [(str(n), at_count(scene, n)) for n in counts]
        yield "positions", [(value, one) for value, one in found if one is not None]
    if (cam := CAM.of(scene)) is not None:
        parts = sorted({*PARTS, cam.divisions})
        divided = [(str(n), replace(cam, divisions=n, per_turn=None)) for n in parts]
        yield "parts", [(value, CAM.put(scene, order)) for value, order in divided]
    if (gears := GEARS.of(scene)) is not None:
        steps = sorted({*STEPS, gears.steps})
        rolled = [(str(n), replace(gears, steps=n)) for n in steps]
        yield "steps", [(value, GEARS.put(scene, order)) for value, order in rolled]


def singly(own: Setting, trials: int) -> Iterator[Place]:
    """Yield the settings that differ from the scene's own in one thing."""
    for axis in (_slips, _rulers, _sizes, _methods, _starts, _poles, _passes, _rods, _series):
        yield from axis(own, trials)
    student = HANDS["student"]._replace(seed=own.scene.seed)
    for n in (n for n in TRIALS if n <= 10 * trials):
        yield Place("trials", str(n), own.by("student", student._replace(trials=n)))


def _slips(own: Setting, trials: int) -> Iterator[Place]:
    student = HANDS["student"]
    for name in EACH_SLIP:
        alone: dict[str, object] = {name: getattr(student, name)}
        who = Hand(seed=own.scene.seed)._replace(**alone)  # type: ignore[arg-type]
        who = who._replace(trials=trials if who.slips else 1)
        yield Place("slip", name, own.by(f"student, {name}", who))


def _rulers(own: Setting, trials: int) -> Iterator[Place]:
    for division in RULERS:
        who = own.who._replace(ruler=division)
        yield Place("ruler", f"{division:g}", own.by(own.hand, who))


def _sizes(own: Setting, trials: int) -> Iterator[Place]:
    for times in SIZES:
        yield Place("size", f"{times:g}", replace(own, enlarged=times))


def _diagrams(own: Setting) -> KinematicOrder | None:
    return DIAGRAMS_ASKED.of(own.scene)


def _ordered(own: Setting, order: KinematicOrder) -> Setting:
    return replace(own, scene=DIAGRAMS_ASKED.put(own.scene, order))


def _methods(own: Setting, trials: int) -> Iterator[Place]:
    order = _diagrams(own)
    for method in ("chords", "tangents") if order is not None else ():
        if order is not None:
            yield Place("method", method, _ordered(own, replace(order, method=method)), DIAGRAMS)


def _starts(own: Setting, trials: int) -> Iterator[Place]:
    """Yield what is taken from the plans; poles told for the scene's own start do not hold for the other."""
    order = _diagrams(own)
    if order is None:
        return
    for start in ("displacement", "velocity"):
        other = order
        if start != order.start:
            other = replace(order, start=start, S=ScaleOrder(), V=ScaleOrder(), a=ScaleOrder())
        yield Place("start", start, _ordered(own, other), DIAGRAMS)


def _poles(own: Setting, trials: int) -> Iterator[Place]:
    kinematic = _diagrams(own) is not None
    flywheel = FLYWHEEL_ASKED.of(own.scene)
    for times in POLES if kinematic or flywheel is not None else ():
        only = (*(DIAGRAMS if kinematic else ()), *(FLYWHEEL if flywheel is not None else ()))
        yield Place("pole", f"{times:g}", replace(own, pole=times), only)


def _passes(own: Setting, trials: int) -> Iterator[Place]:
    forces = FORCES_ASKED.of(own.scene)
    if forces is None or forces.friction is None:
        return
    for n in PASSES:
        order = replace(forces, friction=replace(forces.friction, passes=n))
        yield Place(
            "passes", str(n), replace(own, scene=FORCES_ASKED.put(own.scene, order)), BALANCE
        )


def _engines(
    own: Setting, axis: str, change: Callable[[EngineOrder], list[tuple[str, EngineOrder]]]
) -> Iterator[Place]:
    engine = ENGINE_ASKED.of(own.scene)
    if engine is None:
        return
    for value, order in change(engine):
        yield Place(
            axis, value, replace(own, scene=ENGINE_ASKED.put(own.scene, order)), ("M_engine",)
        )


def _rods(own: Setting, trials: int) -> Iterator[Place]:
    """Yield the rod's mass as the scene shares it, and by the lever rule; the error is that of two masses."""

    def change(order: EngineOrder) -> list[tuple[str, EngineOrder]]:
        lever = ("lever rule", replace(order, share=None, mass=None))
        told = order.share is not None or order.mass is not None
        return [("scene", order), lever] if told else [lever]

    yield from _engines(own, "rod", change)


def _series(own: Setting, trials: int) -> Iterator[Place]:
    """Yield the inertia force by the plan of accelerations, and by the series of two terms."""

    def change(order: EngineOrder) -> list[tuple[str, EngineOrder]]:
        return [("plan", replace(order, series=False)), ("series", replace(order, series=True))]

    yield from _engines(own, "inertia", change)


def own_setting(scene: Scene, hand: str | None, trials: int) -> Setting:
    """Return a scene's own setting, drawn by its own hand or by another that is named.

    A scene's hand that has the ruler of its name is called by that name.
    """
    who = named(hand or OWN, scene, trials)
    alike = (name for name in GRID if named(name, scene, trials) == who)
    return Setting(scene, hand or next(alike, OWN), who)
