"""Curves that do not close, and tangents to them, are drawn by a page as by Python."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.scripts import run

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.graph_curves import (
    graph_of_stretch,
    open_graph,
    open_graph_of_middles,
)
from graphic_tmm.board.operations.graphs import touching
from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.board.values import Complexes
from graphic_tmm.page.practice.pack import written_module

PROGRAM = """
import "./practice/written.js";
import { BOARD } from "./practice/board.js";
const known = (x) => (x === null ? NaN : typeof x !== "object" ? x : Array.isArray(x) ? x.map(known) :
  Object.fromEntries(Object.entries(x).map(([key, own]) => [key, known(own)])));
tell(BOARD.log.drawn(...known(asked)));
"""


def by_page(op: Operation, *values: Any) -> Any:
    """Return what the page's own text of an operation leaves."""
    script = RowScript()
    return run(
        PROGRAM,
        list(values),
        written=written_module(script, {}, {"drawn": script.add_rows(op.run)}),
    )


def plain(points: Complexes) -> Any:
    rows = ([None if np.isnan(z) else (z.real, z.imag) for z in row] for row in points.tolist())
    return [[dict(zip(("re", "im"), z or (None, None), strict=True)) for z in row] for row in rows]


def places(told: Any) -> Complexes:
    """Return points of a page; what is missing is told as nothing."""
    known = (
        z if z is not None and z["re"] is not None else {"re": np.nan, "im": np.nan}
        for z in told[0]
    )
    return np.array([[complex(z["re"], z["im"]) for z in known]])


def points(count: int) -> Complexes:
    x = np.arange(float(count))
    return (10.0 * x + 1j * (30.0 * np.sin(1.3 * x) + x**2))[None, :]


@pytest.mark.parametrize("count", [2, 3, 4, 9])
def test_open_graphs_are_those_of_python(count: int) -> None:
    drawn, end = points(count)[:, :-1], points(count)[:, -1:]
    cases: list[tuple[Operation, list[Complexes], list[int]]] = [
        (open_graph, [drawn, end], [count - 1]),
        (graph_of_stretch, [points(count + 2)], [1, count]),
        (open_graph_of_middles, [points(count)], [count]),
    ]
    for op, values, choice in cases:
        due = op.run(*values, **dict(zip(op.choices, choice, strict=True)))
        told = by_page(op, *map(plain, values), *choice)
        for part in ("knots", "tangents"):
            np.testing.assert_allclose(places(told[part]), getattr(due, part), rtol=0, atol=1e-12)


def test_a_run_of_points_has_a_curve_of_its_own() -> None:
    """Where a point is missing both sides are natural splines."""
    drawn = points(9)
    drawn[0, 3] = np.nan + 1j * np.nan
    due = graph_of_stretch.run(drawn, first=0, last=8)
    told = by_page(graph_of_stretch, plain(drawn), 0, 8)
    np.testing.assert_allclose(places(told["tangents"]), due.tangents, rtol=0, atol=1e-12)


def test_tangents_are_those_of_python() -> None:
    curve = open_graph.run(points(9)[:, :-1], points(9)[:, -1:], row=8)
    feet = np.array([[5.0, 33.0, 71.5]], dtype=complex)
    due = touching.run(curve, feet)
    own = {"knots": plain(curve.knots), "tangents": plain(curve.tangents), "closed": False}
    told = by_page(touching, own, plain(feet))
    np.testing.assert_allclose(places(told["at"]), due.at, rtol=0, atol=1e-12)
    np.testing.assert_allclose(places(told["along"]), due.along, rtol=0, atol=1e-12)
