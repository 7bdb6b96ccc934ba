"""What follows from an engine's forces: how far the series is off the motion, whether T does the gas's work."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.chapters.engine.record import WORKS
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, greatest, result_number
from graphic_tmm.note.document import Run, Runs, Text
from graphic_tmm.readers.columns import Column

GREATEST = said("The greatest inertia force is {exact} by the plans (position {position}).")
SERIES = said("By the series of two terms it is {series} (position {position}).")

EQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "so they are equal but for what the graphs can show."
)
UNEQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "more than the graphs explain."
)
CLOSE = 5.0
"""Works that differ by no more than this, %, agree: graphs with twelve positions are no better."""


NOTHING = said(
    "In positions {positions} the pressure on the guide and the turning moment are nought: the rod lies along"
    " the cylinder."
)
GUIDE = said("The pressure on the guide is greatest in position {position}: {N}.")
ONE_WAY = said(
    "It presses one side of the guide all the time: its sense goes by the sense of turning, not by that of the "
    "piston."
)
TURNED = said(
    "In positions {positions} it turns round, as the gas is compressed at the end of the stroke."
)
MOMENT = said("The turning moment is greatest in position {position}: {M}.")
DRIVES = said("It acts in the sense of turning in all positions of the row.")
BACKWARDS = said(
    "In positions {positions} it acts against the turning, as the compressed gas resists."
)
COVER = said(
    "The acceleration of the parts that move to and fro is greatest in position {position}, {a_B}; it changes "
    "its sign between positions {before} and {after}."
)
EARLY = said("That is before the crank stands square to the cylinder: the rod is not endless.")
USUAL = said("That is between 50° and 80° from the dead centre, as experience has it.")
NOUGHT = 1e-9
"""What is less than this share of the greatest is nought."""


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what follows for guide, crank and moving parts, the inertia both ways, the works over a turn."""
    found = {column.segment: column for column in engine_columns(drawn)}
    yield from _guide(drawn, found["N"], language)
    yield from _moment(drawn, found["M"], language)
    yield from _acceleration(drawn, found["a_B"], language)
    for segment, told, key in (("P_in", GREATEST, "exact"), ("P_in_series", SERIES, "series")):
        most = greatest(drawn, found[segment], language) if segment in found else None
        if most is not None:
            put: dict[str, Run] = {key: most[0], "position": Text(most[1])}
            yield filled(speaking(language)(told), put)
    yield from _works(drawn, language)


def _signs(drawn: Drawn, column: Column) -> list[tuple[str, int]]:
    """Return the positions that are drawn with the signs of a column there; 0 where it is nought."""
    values = column.without(drawn.undrawn).first_figures[1][: drawn.project.count]
    most = max((abs(value) for value in values if value is not None), default=0.0)
    there = ((name, value) for name, value in zip(drawn.names, values, strict=False))
    return [
        (name, 0 if abs(value) <= NOUGHT * most else (1 if value > 0 else -1))
        for name, value in there
        if value is not None
    ]


def _named(signs: list[tuple[str, int]], sign: int) -> Text:
    return Text(", ".join(name for name, own in signs if own == sign))


def _guide(drawn: Drawn, column: Column, language: str) -> Iterator[Runs]:
    """Yield where the pressure on the guide is nought, where it is greatest, whether it turns round."""
    _, signs, most = speaking(language), _signs(drawn, column), greatest(drawn, column, language)
    if any(sign == 0 for _name, sign in signs):
        yield filled(_(NOTHING), {"positions": _named(signs, 0)})
    if most is None:
        return
    turned = _named(signs, -1)
    told = _(GUIDE) + " " + _(TURNED if turned.text else ONE_WAY)
    yield filled(told, {"N": most[0], "position": Text(most[1]), "positions": turned})


def _moment(drawn: Drawn, column: Column, language: str) -> Iterator[Runs]:
    """Yield where the turning moment is greatest, where it resists."""
    _, signs, most = speaking(language), _signs(drawn, column), greatest(drawn, column, language)
    if most is None:
        return
    against = _named(signs, -1)
    angle = drawn.names.index(most[1]) * 360.0 / drawn.project.count
    usual = " " + _(USUAL) if 50.0 <= angle <= 80.0 else ""
    told = _(MOMENT) + usual + " " + _(BACKWARDS if against.text else DRIVES)
    yield filled(told, {"M": most[0], "position": Text(most[1]), "positions": against})


def _acceleration(drawn: Drawn, column: Column, language: str) -> Iterator[Runs]:
    """Yield where the acceleration is greatest, and where on the way out it changes its sign."""
    signs, most = _signs(drawn, column), greatest(drawn, column, language)
    turns = [(a, b) for (a, s), (b, t) in pairwise(signs) if s * t < 0]
    if most is None or not turns:
        return
    put: dict[str, Run] = {"a_B": most[0], "position": Text(most[1])}
    put |= {"before": Text(turns[0][0]), "after": Text(turns[0][1])}
    _ = speaking(language)
    early = 4 * drawn.names.index(turns[0][1]) <= drawn.project.count
    yield filled(_(COVER) + (" " + _(EARLY) if early else ""), put)


def _works(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield whether the tangential force does the work of the gas over a turn."""
    results = engine_results(drawn)
    values = [value for name, (value, _) in single(results).items() if name in WORKS]
    if len(values) == len(WORKS) and all(map(math.isfinite, values)):
        told = EQUAL if abs(values[-1]) <= CLOSE else UNEQUAL
        put: dict[str, Run] = {
            name: result_number(drawn, results, name, language) for name in WORKS
        }
        yield filled(speaking(language)(told), put)
