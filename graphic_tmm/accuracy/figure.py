"""The figure of a study: error over work at the board and over time on the machine, both axes logarithmic."""

from __future__ import annotations

import math
from collections.abc import Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

from graphic_tmm.accuracy.lessons import along, divisions
from graphic_tmm.accuracy.measure import Measurement
from graphic_tmm.accuracy.settings import GRID, dividing
from graphic_tmm.accuracy.study import Study
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.language.numbers import number

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = {
    "exact": "#4d4d4d",
    "cad": "#0072b2",
    "careful": "#009e73",
    "student": "#d55e00",
    "scene": "#cc79a7",
}
"""Colours that colour-blind people can distinguish (Okabe and Ito)."""
MARKS = {"exact": "s", "cad": "D", "careful": "^", "student": "o", "scene": "v"}
ROW, WIDE = 2.4, 5.2
"""Height of a row and width of a column, inches."""
HEAD, FOOT, LEFT = 1.05, 0.5, 0.75
"""Room for the title with the legend, for the name of the costs, for that of the errors, inches."""
APART = 1.4
"""Two settings are distinct on the axis of minutes from this ratio on."""
SETTINGS: Any = {
    "svg.hashsalt": "graphic_tmm",
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "font.size": 8.5,
}


def figures(study: Study) -> dict[str, bytes]:
    """Return the figure as SVG and PNG, by the end of the file's name; the same study gives the same bytes."""
    import matplotlib

    with matplotlib.rc_context(SETTINGS):
        drawn = _draw(study)
        svg, png = BytesIO(), BytesIO()
        drawn.savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
        drawn.savefig(png, format="png", dpi=130, metadata={"Software": None})
    return {"svg": svg.getvalue(), "png": png.getvalue()}


def _draw(study: Study) -> Figure:
    from matplotlib.figure import Figure

    language, words = study.scene.language, WORDS[study.scene.language]
    names = [name for name in study.quantities if _plotted(study, name)]
    sides = (False, True) if study.timed else (False,)
    cells = [(name, machine) for name in names for machine in sides]
    columns = max(min(2, len(cells)), 1)
    rows = max(math.ceil(len(cells) / columns), 1)
    height, wide = ROW * rows + HEAD + FOOT, WIDE * columns
    figure = Figure(figsize=(wide, height))
    figure.subplots_adjust(
        left=LEFT / wide,
        right=1.0 - 0.15 / wide,
        bottom=FOOT / height,
        top=1.0 - HEAD / height,
        wspace=0.14 if study.timed else 0.24,
        hspace=0.22,
    )
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for k, (axes, (name, machine)) in enumerate(zip(grid, cells, strict=False)):
        _panel(axes, study, name, machine)
        _ticks(axes, language)
        if not machine:
            axes.set_ylabel(f"{words[name]}: {words['error']}")
        if k + columns >= len(cells):
            axes.set_xlabel(words["machine" if machine else "board"])
    for axes in grid[len(cells) :]:
        axes.set_axis_off()
    title = words["title"].format(title=study.scene.title)
    figure.suptitle(title, y=1.0 - 0.12 / height, va="top", fontsize=11, parse_math=False)
    handles, labels = _legend(study)
    figure.legend(
        handles,
        labels,
        loc="upper center",
        bbox_to_anchor=(0.5, 1.0 - 0.32 / height),
        ncols=math.ceil(len(labels) / 2) if columns > 1 else 3,
        frameon=False,
    )
    return figure


def _ticks(axes: Axes, language: str) -> None:
    """Number both axes: at 1, 2 and 5 where they are short, at powers of ten where they are long."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        decades = math.log10(high / low)
        subs = (1.0, 2.0, 5.0) if decades < 2.5 else (1.0,)
        axis.set_major_locator(LogLocator(subs=subs, numticks=7 if decades >= 2.5 else 12))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: number(value, language, 3)))


def _plotted(study: Study, name: str) -> bool:
    return any(run.quantity == name and run.error > 0.0 for run in study.runs)


def _hands(study: Study) -> list[str]:
    found = dict.fromkeys((*GRID, study.hand))
    return [hand for hand in found if any(run.hand == hand for run in study.runs)]


def _cost(run: Measurement, machine: bool) -> float:
    if not machine:
        return run.work.minutes
    return 1e3 * run.seconds.least if run.seconds is not None else math.nan


def _panel(axes: Axes, study: Study, name: str, machine: bool) -> None:
    """Draw one quantity over one cost."""
    mine = [run for run in study.runs if run.quantity == name and run.error > 0.0]
    others = [run for run in mine if run.axis not in (*dividing(), "trials")]
    _points(axes, others, machine, color="#9a9a9a", marker=".", markersize=5, zorder=1)
    for hand in _hands(study):
        row = [run for run in along(study.runs, name, hand) if run.error > 0.0]
        style: dict[str, Any] = {"color": COLOURS[hand], "marker": MARKS[hand], "markersize": 4}
        style["linestyle"] = "none" if machine else "-"
        _points(axes, row, machine, linewidth=0.9, zorder=2, **style)
    best = study.fast if machine else study.fronts
    front = [run for run in mine if run in best]
    _points(axes, front, machine, **FRONT)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axes.margins(0.08, 0.14)
    if not machine:
        _number(axes, study, name)


FRONT: dict[str, Any] = {
    "color": "black",
    "marker": "o",
    "markersize": 8,
    "markerfacecolor": "none",
    "markeredgewidth": 0.7,
    "zorder": 3,
}
"""The ring round a setting on the Pareto front."""


def _points(axes: Axes, runs: Sequence[Measurement], machine: bool, **style: Any) -> None:
    if runs:
        x, y = [_cost(run, machine) for run in runs], [run.error for run in runs]
        axes.plot(x, y, **({"linestyle": "none"} | style))


def _number(axes: Axes, study: Study, name: str) -> None:
    """Write the number of positions next to the student's least error, and at both ends of that row."""
    row = [run for run in along(study.runs, name, "student") if run.error > 0.0]
    if not row:
        return
    least = min(row, key=lambda run: run.error)
    apart = [end for end in (row[0], row[-1]) if not 1 / APART < _ratio(end, least) < APART]
    for run in (least, *apart):
        axes.annotate(
            f"{divisions(run)}",
            (run.work.minutes, run.error),
            textcoords="offset points",
            xytext=(0, 7),
            ha="center",
            color=COLOURS["student"],
            fontsize=8,
            fontweight="bold" if run is least else "normal",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8},
            zorder=4,
        )


def _ratio(run: Measurement, other: Measurement) -> float:
    return run.work.minutes / other.work.minutes


def _legend(study: Study) -> tuple[list[Any], list[str]]:
    from matplotlib.lines import Line2D

    words = WORDS[study.scene.language]
    handles, labels = [], []
    for hand in _hands(study):
        handles.append(Line2D([], [], color=COLOURS[hand], marker=MARKS[hand], markersize=4))
        labels.append(words[hand])
    handles.append(Line2D([], [], linestyle="none", **FRONT))
    labels.append(words["front"])
    handles.append(Line2D([], [], color="#9a9a9a", marker=".", linestyle="none"))
    labels.append(words["other"])
    number_of: dict[str, Any] = {"marker": "$12$", "markersize": 10, "color": COLOURS["student"]}
    handles.append(Line2D([], [], linestyle="none", **number_of))
    labels.append(words["count"])
    return handles, labels
