"""How accurate a cam is: the least r0, known only where its phases are divided finely."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, Reference, Value
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.task import ASKED, CAM
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

PARTS = (6, 8, 10, 12, 16, 24, 36, 48)
"""Parts of a moving phase."""
CONVERGED = 192
"""Parts of a moving phase that has converged."""


def _quantities(project: Project) -> Iterator[Quantity]:
    due = Reference(lambda scene: next((one for _, one in _by_parts(scene, (CONVERGED,))), None))
    yield Quantity("r0_min", "m", (Value(CAM_PLAN.on(project).least),), reference=due)


def _by_parts(scene: Scene, parts: Iterable[int]) -> Iterator[tuple[str, Scene]]:
    order = ASKED.of(scene)
    if order is not None:
        for n in parts:
            yield str(n), ASKED.put(scene, replace(order, divisions=n, per_turn=None))


def _divided(scene: Scene) -> Iterator[tuple[str, Scene]]:
    return _by_parts(scene, sorted({*PARTS, _own(scene)} - {0}))


def _own(scene: Scene) -> int:
    order = ASKED.of(scene)
    return order.divisions if order is not None else 0


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None:
        return scene

    def finer(mu: float | None) -> float | None:
        return None if mu is None else mu / times

    larger = replace(
        order,
        base=order.base * times,
        height=order.height * times,
        mu_S=finer(order.mu_S),
        mu_V=finer(order.mu_V),
        mu_A=finer(order.mu_A),
        mu_l=finer(order.mu_l),
        poles=(order.poles[0] * times, order.poles[1] * times),
    )
    return ASKED.put(scene, larger)


WORDS = {
    "r0_min": said("r₀ min of the cam"),
    "parts": said("parts of a phase"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(CAM,),
    axes=(Axis("parts", _divided, parts=_own, counted=said("{n} part", "{n} parts")),),
    enlarged=_enlarged,
    words=WORDS,
)
