"""A scene changed so that its sheets come out larger, or the poles of its diagrams stand farther."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.accuracy.drawing import finer
from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.chapters.cam.task import ASKED as CAM
from graphic_tmm.chapters.cam.task import CamOrder
from graphic_tmm.chapters.diagrams.plan import BASE, VIEWS
from graphic_tmm.chapters.diagrams.task import ASKED as DIAGRAMS
from graphic_tmm.chapters.diagrams.task import KinematicOrder
from graphic_tmm.chapters.engine.task import ASKED as ENGINE
from graphic_tmm.chapters.flywheel.task import ASKED as FLYWHEEL
from graphic_tmm.chapters.flywheel.task import FlywheelOrder
from graphic_tmm.chapters.forces.task import ASKED as FORCES
from graphic_tmm.chapters.gears.task import ASKED as GEARS
from graphic_tmm.chapters.indicator.task import IndicatorOrder
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.records import Scales, Scene


def enlarge(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene drawn so many times larger than it was ``made``: every μ so much finer."""
    found = scene
    if made.mechanism is not None:
        mu = {plan: scale.value / times for plan, scale in made.mechanism.scales.items()}
        scales = Scales(
            mu_l=mu.get("positions"), mu_v=mu.get("velocities"), mu_a=mu.get("accelerations")
        )
        found = replace(found, scales=scales)
        if (diagrams := DIAGRAMS.of(scene)) is not None:
            found = DIAGRAMS.put(found, _diagrams(diagrams, mu, times))
        if (flywheel := FLYWHEEL.of(scene)) is not None:
            found = FLYWHEEL.put(found, _flywheel(flywheel, mu, times))
        forces, engine = FORCES.of(scene), ENGINE.of(scene)
        if forces is not None and forces.mu is not None:
            found = FORCES.put(found, replace(forces, mu=forces.mu / times))
        if engine is not None:
            indicator = _indicator(engine.indicator, times)
            engine = replace(engine, indicator=indicator, base=engine.base * times)
            found = ENGINE.put(found, engine)
    for part in made.parts:
        own = part.scales()
        gears, cam = GEARS.of(scene), CAM.of(scene)
        if part.kind == "gears" and gears is not None:
            found = GEARS.put(found, replace(gears, mu=own["gear"].value / times))
        if part.kind == "cam" and cam is not None:
            found = CAM.put(found, _cam(cam, times))
    return found


def _cam(cam: CamOrder, times: float) -> CamOrder:
    def finer(mu: float | None) -> float | None:
        return None if mu is None else mu / times

    return replace(
        cam,
        base=cam.base * times,
        height=cam.height * times,
        mu_S=finer(cam.mu_S),
        mu_V=finer(cam.mu_V),
        mu_A=finer(cam.mu_A),
        mu_l=finer(cam.mu_l),
        poles=(cam.poles[0] * times, cam.poles[1] * times),
    )


def _indicator(order: IndicatorOrder, times: float) -> IndicatorOrder:
    mu = None if order.mu is None else order.mu / times
    return replace(order, base=order.base * times, height=order.height * times, mu=mu)


def _flywheel(order: FlywheelOrder, mu: dict[str, float], times: float) -> FlywheelOrder:
    indicator = _indicator(order.indicator, times) if order.indicator is not None else None
    pole = order.A.pole * times if order.A.pole is not None else None
    return replace(
        order,
        indicator=indicator,
        A=ScaleOrder(None if pole is not None else mu.get("work", order.A.mu), pole),
        base=order.base * times,
        mu_M=mu.get("moment", order.mu_M),
    )


def _diagrams(order: KinematicOrder, mu: dict[str, float], times: float) -> KinematicOrder:
    drawn = {}
    for symbol, view in VIEWS.items():
        one: ScaleOrder = getattr(order, symbol)
        pole = one.pole * times if one.pole is not None else None
        drawn[symbol] = ScaleOrder(None if pole is not None else mu.get(view, one.mu), pole)
    along = None if order.mu_along is None else order.mu_along / times
    base = None if order.mu_along is not None else (order.base or BASE) * times
    return replace(order, base=base, mu_along=along, S=drawn["S"], V=drawn["V"], a=drawn["a"])


def farther(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene whose diagrams, as ``made``, have their poles so many times farther."""
    order = DIAGRAMS.of(scene)
    if order is None or made.mechanism is None:
        return scene
    drawn: dict[str, ScaleOrder] = {}
    for symbol, change in finer(order.start, times).items():
        one: ScaleOrder = getattr(order, symbol)
        if one.pole is not None:
            drawn[symbol] = ScaleOrder(None, one.pole * times)
        else:
            drawn[symbol] = ScaleOrder(made.mechanism.scales[VIEWS[symbol]].value * change)
    other = (drawn.get("S", order.S), drawn.get("V", order.V), drawn.get("a", order.a))
    return DIAGRAMS.put(scene, replace(order, S=other[0], V=other[1], a=other[2]))
