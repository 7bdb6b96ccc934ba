"""A table as curves over the coordinate of the drive, by matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.errors import SheetError, needed
from graphic_tmm.face.tables import Column, Table
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.spread import QUANTILES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

HEIGHT, WIDTH = 2.6, 7.0
"""Of the axes of one unit, inches."""
BAND = 0.25
"""How dark nine of ten drawings are shown."""


def plotted(
    table: Table, segments: Sequence[str] | None, axes: Axes | None, language: str
) -> list[Axes]:
    """Draw columns of a table over the drive's coordinate; each unit has axes of its own, see `Drawn.plot`."""
    chosen = [table[name] for name in (table.columns if segments is None else segments)]
    units = list(dict.fromkeys(one.unit for one in chosen))
    if axes is None:
        pyplot = needed("matplotlib.pyplot", "matplotlib")
        size = (WIDTH, HEIGHT * max(len(units), 1))
        figure, grid = pyplot.subplots(
            max(len(units), 1), 1, sharex=True, squeeze=False, figsize=size, layout="constrained"
        )
        figure.suptitle(table.title, parse_math=False)
        found = list(grid[:, 0])
    elif len(units) > 1:
        says = said(
            "one pair of axes shows one unit, here are {units}: choose segments, or leave out ax",
            units=", ".join(one or "1" for one in units),
        )
        raise SheetError(says)
    else:
        found = [axes]
    for on, of in zip(found, units, strict=False):
        _curves(on, [one for one in chosen if one.unit == of], language)
        on.set_ylabel(unit(of, language))
    known = bool(chosen) and np.isfinite(_across(chosen[0])).all()
    found[-1].set_xlabel(_titled(chosen[0].sweep, language) if known else "")
    return found


def _titled(sweep: Sweep, language: str) -> str:
    """Return the name of a coordinate and its unit."""
    name = sweep.name or sweep.letter
    return f"{f'${_math(name)}$' if '_' in name else name}, {unit(sweep.unit, language)}"


def _curves(axes: Any, columns: Sequence[Column], language: str) -> None:
    for one in columns:
        across = _across(one)
        named = not np.isfinite(across).all()
        order = np.arange(len(across)) if named else np.argsort(across, kind="stable")
        x: Any = [one.positions[k] for k in order] if named else across[order]
        middle, low, high = _spread(one.value)
        there = np.isfinite(middle[order])
        x = [x[k] for k in np.flatnonzero(there)]
        label = f"${_math(one.name)}$" if "_" in one.name else one.name
        (line,) = axes.plot(x, middle[order][there], marker=".", label=label)
        if len(one.value) > 1:
            band = low[order][there], high[order][there]
            axes.fill_between(x, *band, alpha=BAND, color=line.get_color(), linewidth=0.0)
    axes.grid(True, color="#dddddd", linewidth=0.6)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)


def _spread(rows: Reals) -> Reals:
    """Return median, 5th and 95th hundredth over the drawings, (3, position); NaN where none has a figure."""
    found = np.full((3, rows.shape[1]), np.nan)
    there = np.isfinite(rows).any(axis=0)
    shares = [QUANTILES[name] for name in ("median", "p5", "p95")]
    if there.any():
        found[:, there] = np.nanquantile(rows[:, there], shares, axis=0)
    return found


def _math(name: str) -> str:
    """Return a name with an index as matplotlib writes it."""
    stem, _, index = name.partition("_")
    return f"\\mathdefault{{{stem}_{{{index}}}}}"


def _across(column: Column) -> Reals:
    """Return how far the drive has gone at the positions: of a crank since the first, from where that was.

    Positions of a row go one way; one outside the row (an extreme one) stands where its angle is.
    """
    angles = column.coordinates
    if not column.sweep.turns or not np.isfinite(angles).all() or len(angles) < 2:
        return angles
    way = np.sign((angles[1] - angles[0] + 180.0) % 360.0 - 180.0) or 1.0
    gone = (way * (angles - angles[0])) % 360.0
    gone[gone > 360.0 - 1e-6] = 0.0
    whole: Reals = angles[0] + way * gone
    return whole
