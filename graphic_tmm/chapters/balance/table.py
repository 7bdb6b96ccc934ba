"""The columns and the results of the balance of a mechanism, and its plan in protocols."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.chapters.balance.task import (
    BALANCE,
    COUNTERWEIGHTS,
    FORCE,
    INERTIA,
    MASSES,
    MOMENT,
)
from graphic_tmm.chapters.balance.words import WEIGHT
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, ordinates
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import Holder


def balance_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the shaking force and its moment by positions, without and with counterweights."""
    made, count = BALANCE_PLAN.on(drawn), len(drawn.names)
    for one in made.wholes:
        rows = ordinates(drawn.reading, one.length, made.mu, count)
        segment = segment_name(one.length.letter)
        yield Column(BALANCE, segment, one.length.name, "N", *rows, quantity=one.value.name)
    for one in made.wholes:
        rows = ordinates(drawn.reading, one.ordinate, made.chart.mu, count)
        letter = one.moment.name
        yield Column(BALANCE, segment_name(letter), letter, "N·m", *rows)


def balance_marks(drawn: Drawn) -> Mapping[str, Mark]:
    """Return the marks of the results of the balance."""
    made = BALANCE_PLAN.on(drawn)
    found = {"shaking_max": made.bare.most, "shaking_moment": made.bare.greatest}
    if made.weighted is not None and made.removed is not None:
        found["shaking_max_balanced"] = made.weighted.most
        found["shaking_moment_balanced"] = made.weighted.greatest
        found["shaking_removed"] = made.removed
    for one in made.weights:
        found[f"{WEIGHT}mass_{one.link}"] = one.mass
        found[f"{WEIGHT}radius_{one.link}"] = one.radius
    return found


def balance_results(drawn: Drawn) -> Results:
    """Return the largest shaking force and moment, and what counterweights take away."""
    return results_of(drawn, balance_marks(drawn))


TABLE = Tabled(columns=balance_columns, results=balance_results, marks=balance_marks)


def _views(project: Project) -> dict[str, list[str]]:
    made = BALANCE_PLAN.on(project)
    weights = [COUNTERWEIGHTS] if made.weights else []
    found = [MASSES, *(one.polygon.view for one in made.unbalances)] if made.unbalances else []
    return {BALANCE: [*found, *weights, INERTIA, FORCE, MOMENT]}


def vectors_of(drawn: Drawn, language: str) -> str:
    """Return the vector equation of the shaking force, plain text."""
    made = BALANCE_PLAN.on(drawn)
    return f"Φ = {' + '.join(plain(symbol(one, language)) for one, _, _ in made.sides)}"


def _equations(drawn: Drawn, view: str, language: str) -> list[str]:
    return [vectors_of(drawn, language)] if view == FORCE else []


def moment_title(holder: Holder, language: str) -> str:
    """Return what the graph of the moment is called."""
    about = BALANCE_PLAN.on(holder).about
    return speaking(language)(captions("en")[MOMENT], point=about)


def _title(holder: Holder, view: str, language: str) -> str:
    return plain(moment_title(holder, language)) if view == MOMENT else ""


PROTOCOL = Protocols(views=_views, equations=_equations, titles=_title)
