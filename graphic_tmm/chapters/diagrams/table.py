"""The columns of kinematic diagrams, beside what the plans give."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.flywheel.table import _rows
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, row_of


def chart_columns(
    project: Project, reading: Reading, planned: Reading | None
) -> tuple[Column, ...]:
    """Return the columns of the diagrams: what they give, what the plans give, the difference in %.

    The difference is told in % of the largest that the plan gives.
    ``planned``: the numbers of the plan of accelerations, at its positions.
    """
    kinematic, count = project.kinematic, len(project.names)
    if kinematic is None:
        return ()
    everywhere, made = range(count), []
    for symbol, chart in kinematic.charts.items():
        rows = _rows(reading, chart.ordinates[0], chart.mu, count)
        made.append(Column("diagrams", symbol, symbol, chart.unit, *rows))
        source, places = {"V": (reading, everywhere), "a": (planned, project.accelerated)}.get(
            symbol, (None, ())
        )
        if source is None or symbol not in kinematic.planned:
            continue
        view = project.construction.view(kinematic.planned[symbol].view)
        assert view is not None
        assert view.scale is not None
        due = source.figure(kinematic.planned[symbol], view.scale)
        plan = row_of(due, places, count)
        made.append(
            Column(
                "diagrams", f"{symbol}_plan", f"{symbol}_plan", chart.unit, (None,) * count, plan
            )
        )
        made.append(_difference(f"{symbol}_difference", rows[1], plan))
    return tuple(made)


def _difference(letter: str, found: Sequence[float | None], due: Sequence[float | None]) -> Column:
    """Return by how much figures differ from what is due, in % of the largest due."""
    largest = max((abs(x) for x in due if x is not None), default=0.0)
    row = tuple(
        100.0 * (x - y) / largest if x is not None and y is not None and largest else None
        for x, y in zip(found, due, strict=True)
    )
    return Column("diagrams", letter, letter, "%", (None,) * len(row), row)
