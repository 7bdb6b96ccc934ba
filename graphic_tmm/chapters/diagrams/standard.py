"""Standard scale factors in place of those that a base and pole distances lead to; these then follow from them.

A student wishes for a base of 80 mm and a pole distance of 20 mm, finds the scale factors that they give, takes
the nearest standard ones and calculates both lengths anew.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import scale_of_derivative, scale_of_integral
from graphic_tmm.board.scales import nearest
from graphic_tmm.chapters.diagrams.task import KinematicTask
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said

BASE = 120.0
"""Length of the base where the task does not say, mm."""


class Chained(NamedTuple):
    """A diagram found from another by a pole: both symbols, and the formula of its scale factor."""

    symbol: str
    source: str
    formula: Operation


def chain(order: KinematicTask) -> Iterator[Chained]:
    """Yield the diagrams that are found from others by a pole distance that the order tells."""
    found = [Chained("V", "S", scale_of_derivative), Chained("a", "V", scale_of_derivative)]
    if order.start == "velocity":
        found = [found[1], Chained("S", "V", scale_of_integral)]
    yield from (one for one in found if getattr(order, one.symbol).pole is not None)


def wanted_base(order: KinematicTask) -> float | None:
    """Return the length of the base that is wished for, mm; None where its scale is told."""
    return None if order.mu_along is not None else order.base or BASE


def settled(order: KinematicTask, speed: float) -> KinematicTask:
    """Return the order with standard scale factors, if it wants them; ``speed``: of the crank, 1/s.

    Raises
    ------
    StructureError
        If a pole distance is told, and not the scale of the diagram that rays are drawn for.
    """
    if not order.standard:
        return order
    length = wanted_base(order)
    if length is not None:
        turn = 2.0 * math.pi / (abs(speed) if order.over == "time" else 1.0)
        order = replace(order, base=None, mu_along=nearest(turn / length))
    for one in chain(order):
        source: ScaleOrder = getattr(order, one.source)
        drawn: ScaleOrder = getattr(order, one.symbol)
        if source.mu is None:
            raise StructureError(
                said(
                    "standard: {drawn} leads to a standard scale only where that of the diagram before is "
                    "told: write {key}, too",
                    drawn=f"H_{one.symbol}",
                    key=f"mu_{one.source}",
                ),
                "diagrams.standard",
                head="diagrams",
            )
        exact = float(one.formula.run(source.mu, order.mu_along, drawn.pole))
        scale: dict[str, Any] = {one.symbol: ScaleOrder(nearest(exact), None)}
        order = replace(order, **scale)
    return order
