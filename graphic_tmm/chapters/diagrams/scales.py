"""How large kinematic diagrams may be; the scale factors of their base and graphs, and how they were chosen."""

from __future__ import annotations

from collections.abc import Container

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.formulas import (
    row_per_mm,
    time_of_row,
    time_per_mm,
    turn_per_mm,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, nearest_standard
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN, way_and_speed
from graphic_tmm.chapters.diagrams.task import ASKED, BASE_VIEW, DIAGRAMS, VIEWS, chain, wanted_base
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger, value_of
from graphic_tmm.fitting.scales import ScaleFactors, scale_of
from graphic_tmm.fitting.sizes import Sizing, graph_size
from graphic_tmm.project import Project

GRAPHS = graph_size(DIAGRAMS)
SIZES = Sizing(
    graphs=GRAPHS.name, sizes=(GRAPHS,), depends={DIAGRAMS: lambda scene, role: (GRAPHS.name,)}
)


def _named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return the scale of the base."""
    mu = DIAGRAMS_PLAN.on(project).base.mu
    return {BASE_VIEW: scale_of(mu, reading)}


SCALES = ScaleFactors(
    scales=lambda fitting: fitting.stretched(
        DIAGRAMS, [("diagrams.base", view, roles.BASE) for view in (VIEWS["S"], VIEWS["V"])]
    ),
    named=_named,
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record the choice where the scene asks for standard ones; else that of graphs as such is told."""
    made, order = DIAGRAMS_PLAN.on(drawn), ASKED.of(drawn.scene)
    if order is None or not order.standard:
        return
    along = made.base.mu
    length = wanted_base(order)
    if length is not None:
        ledger.of(along.view)
        wanted = ledger.draft.take(Length, "[L]", length)
        plans = KINEMATICS_PLAN.on(drawn)
        if not plans.closed:
            row, *speed = way_and_speed(ledger.quantity, plans)
            if order.over == "time":
                row = ledger.calculated(time_of_row, "t", row, *speed, unit="s")
            exact = ledger.draft.draw(row_per_mm, f"{along.name}′", row, wanted, unit=along.unit)
        elif order.over == "time":
            assert drawn.scene.mechanism is not None
            drive = drawn.scene.mechanism.drive
            uses = (ledger.speed(str(drive.link), drive.speed), wanted)
            exact = ledger.draft.draw(time_per_mm, f"{along.name}′", *uses, unit=along.unit)
        else:
            exact = ledger.draft.draw(turn_per_mm, f"{along.name}′", wanted, unit=along.unit)
        _nearest(ledger, along, exact)
    for one in chain(order):
        mu, source = (made.charts[symbol].mu for symbol in (one.symbol, one.source))
        if source.slot not in ledger.chosen:
            ledger.of(VIEWS[one.source])
            ledger.given(source, value_of(drawn, source))
        ledger.of(VIEWS[one.symbol])
        pole = getattr(order, one.symbol).pole
        wanted = ledger.draft.take(Length, f"[H_{one.symbol}]", pole)
        known = ledger.chosen[source.slot], ledger.chosen[along.slot]
        exact = ledger.draft.draw(one.formula, f"{mu.name}′", *known, wanted, unit=mu.unit)
        _nearest(ledger, mu, exact)


def _nearest(ledger: Ledger, mu: Mark, exact: Mark) -> None:
    found = ledger.draft.draw(nearest_standard, mu.name, exact, unit=mu.unit)
    ledger.enter(mu, found)


CHOICE = Choice(choose=choose)
