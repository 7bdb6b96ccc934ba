"""What the graphs of a flywheel for a cycle are called in protocols."""

from __future__ import annotations

from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.flywheel.names import VIEWS
from graphic_tmm.chapters.flywheel.words import graph_title
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.readers.titles import Protocols
from graphic_tmm.scene.chapter import Holder


def _title(holder: Holder, view: str, language: str) -> str:
    order = CYCLE_PLAN.on(holder).order.flywheel
    title = graph_title(view, order.constant, speaking(language), given=True)
    return title if view == VIEWS["moment"] else ""


PROTOCOL = Protocols(titles=_title)
