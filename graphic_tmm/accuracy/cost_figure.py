"""The figure of an answer: error over minutes at the board, over seconds on the machine, where it comes from.

One column, as wide as a telephone: letters are as large there as in print. Everything is distinct by shape or
hatching, too, so that it can be read in grey.
"""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from math import log10
from typing import TYPE_CHECKING, Any

from graphic_tmm.accuracy.answer import Answer, MeasuredWay
from graphic_tmm.accuracy.answer_text import hand_name, of_worst, parts
from graphic_tmm.accuracy.settings import dividing
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.errors import needed
from graphic_tmm.language.numbers import number

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDE = 4.8
"""Width of the figure, inches."""
BOARD, MACHINE, BAR = 3.3, 1.9, 0.42
"""Heights of the large panel, the small one, and each bar, inches."""
HEAD, GAP, FOOT, LEFT = 0.3, 0.72, 0.85, 0.9
"""Room for the title, between panels, for the legend of sources, left of the axes, inches."""
SOURCES = {
    "method": ("#4d4d4d", ""),
    "reading": ("#d55e00", "///"),
    "ruler": ("#e69f00", ""),
    "swing": ("#0072b2", "--"),
    "prick": ("#56b4e9", "\\\\\\"),
    "compass": ("#009e73", "xx"),
    "digits": ("#cc79a7", "++"),
    "together": ("#ffffff", ""),
}
"""Colours that colour-blind people can distinguish (Okabe and Ito), and hatches."""
WORK = (("log", "x"), ("table", "o"), ("sheets", "s"), ("drawings", "^"))
"""What is timed, and its mark."""
SETTINGS: Any = {
    "svg.hashsalt": "graphic_tmm",
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "font.size": 8.5,
    "hatch.linewidth": 0.5,
}


def plotting() -> Any:
    """Return matplotlib, which draws the figure; raises MissingError where it is not there."""
    return needed("matplotlib", "matplotlib")


def figures(answer: Answer) -> dict[str, bytes]:
    """Return the figure as SVG and PNG, by the end of the file's name; the same answer gives the same bytes."""
    matplotlib = plotting()
    with matplotlib.rc_context(SETTINGS):
        drawn = _draw(answer)
        svg, png = BytesIO(), BytesIO()
        drawn.savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
        drawn.savefig(png, format="png", dpi=160, metadata={"Software": None})
    return {"svg": svg.getvalue(), "png": png.getvalue()}


def vector(answer: Answer, *, lettered: bool = False) -> str:
    """Return the figure as SVG; ``lettered``: its letters as text, not as outlines."""
    matplotlib = plotting()
    letters = {"svg.fonttype": "none" if lettered else "path"}
    with matplotlib.rc_context(SETTINGS | letters):
        svg = BytesIO()
        _draw(answer).savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
    return svg.getvalue().decode("utf-8")


def _draw(answer: Answer) -> Figure:
    from matplotlib.figure import Figure

    bars = len([*of_worst(answer)])
    heights = [BOARD, *([MACHINE] if answer.machine else []), *([BAR * bars] if bars else [])]
    title = _folded(answer.scene.title, 52)
    head = HEAD + 0.17 * title.count("\n")
    height = head + sum(heights) + GAP * (len(heights) - 1) + FOOT
    figure = Figure(figsize=(WIDE, height))
    top = height - head
    panels = []
    for tall in heights:
        box = (LEFT / WIDE, (top - tall) / height, 1.0 - (LEFT + 0.15) / WIDE, tall / height)
        panels.append(figure.add_axes(box))
        top -= tall + GAP
    words = WORDS[answer.scene.language]
    figure.text(
        0.02, 1.0 - 0.05 / height, title, va="top", fontsize=9.5,
        fontweight="bold", parse_math=False,
    )  # fmt: skip
    _board(panels[0], answer)
    if answer.machine:
        _machine(panels[1], answer)
    if bars:
        _sources(panels[-1], answer)
    for axes in panels[: len(panels) - (bars > 0)]:
        _ticks(axes, answer.scene.language)
        axes.set_ylabel(words["worst error"])
    return figure


def _folded(text: str, wide: int) -> str:
    from textwrap import wrap

    return "\n".join(wrap(text, wide)[:2])


def _ticks(axes: Axes, language: str) -> None:
    """Number both axes: at 1, 2 and 5 where they are short, at powers of ten where they are long."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        if axis.get_scale() != "log":
            continue
        decades = log10(high / low)
        subs = (1.0, 2.0, 5.0) if decades < 2.5 else (1.0,)
        axis.set_major_locator(LogLocator(subs=subs, numticks=7 if decades >= 2.5 else 12))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: number(value, language, 3)))


def _board(axes: Axes, answer: Answer) -> None:
    """Draw the error over minutes at the board: all settings, the front, the scene, the knee."""
    words = WORDS[answer.scene.language]
    every = [w for w in answer.ways if 0.0 < w.worst < float("inf")]
    axes.plot(
        [w.minutes for w in every], [w.worst for w in every], ".", color="#b5b5b5", markersize=3,
        label=words["figure all"],
    )  # fmt: skip
    front = [row for row in answer.rows if row.way is not answer.own.way or row is answer.knee]
    _rows(axes, front, "-o", words["front"], color="black", linewidth=1.0, markersize=4)
    for key, row, shape, colour in (
        ("figure own", answer.own, "o", "#d55e00"),
        ("figure knee", answer.knee, "D", "#0072b2"),
    ):
        _rows(axes, [row], shape, words[key], color=colour, markersize=8, markeredgecolor="black")
    if answer.printed is not None and max(answer.printed.values()) > 0.0:
        axes.plot(
            [answer.own.way.minutes], [max(answer.printed.values())], "P", color="#cc79a7",
            markersize=8, markeredgecolor="black", label=words["figure printed"],
        )  # fmt: skip
    for row in {id(row.way): row for row in (answer.own, answer.knee)}.values():
        _number(axes, row)
    axes.set_xscale("log")
    if answer.own.worst > 0.0:
        axes.set_yscale("log")
    axes.margins(0.06, 0.1)
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.set_xlabel(words["board"])
    axes.legend(loc="best", fontsize=7.5, framealpha=0.9, handletextpad=0.3)


def _rows(axes: Axes, rows: Sequence[MeasuredWay], shape: str, label: str, **style: Any) -> None:
    rows = [row for row in rows if row.worst > 0.0]
    x, y = [row.way.minutes for row in rows], [row.worst for row in rows]
    axes.plot(x, y, shape, label=label, **style)


def _number(axes: Axes, row: MeasuredWay) -> None:
    """Write next to a row into how many parts it is divided."""
    divided = dividing()
    counts = [value for name, value in row.way.changes if name in divided]
    if counts and row.worst > 0.0:
        axes.annotate(
            f"N = {counts[0]}", (row.way.minutes, row.worst), textcoords="offset points",
            xytext=(7, 5), ha="left", fontsize=8,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8},
        )  # fmt: skip


def _machine(axes: Axes, answer: Answer) -> None:
    """Draw the error over CPU seconds of what a user asks for; what is not to be believed is hollow."""
    words = WORDS[answer.scene.language]
    for what, shape in WORK:
        rows = sorted(
            (
                one.seconds.least,
                answer.counts[one.positions][what == "drawings"],
                one.seconds.doubtful,
            )
            for one in answer.machine
            if one.what == what and one.positions in answer.counts
        )
        rows = [row for row in rows if row[1] > 0.0]
        for believed, fill in ((True, "black"), (False, "white")):
            some = [(x, y) for x, y, doubtful in rows if doubtful != believed]
            axes.plot(
                [x for x, _ in some], [y for _, y in some], shape, color="black",
                markerfacecolor=fill, markersize=5, label=words[f"timed {what}"] if believed else None,
            )  # fmt: skip
        axes.plot([x for x, *_ in rows], [y for _, y, _ in rows], ":", color="black", linewidth=0.8)
    axes.set_xscale("log")
    if answer.own.worst > 0.0:
        axes.set_yscale("log")
    axes.margins(0.1, 0.2)
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axes.legend(loc="best", fontsize=7.5, framealpha=0.9, handletextpad=0.3)
    axes.set_xlabel(words["machine"])


def _sources(axes: Axes, answer: Answer) -> None:
    """Draw a bar of the sources for each hand."""
    words = WORDS[answer.scene.language]
    names: dict[str, None] = {}
    heads = []
    for k, origin in enumerate(of_worst(answer)):
        heads.append(words[hand_name(answer, origin)])
        at = 0.0
        for name, share in parts(origin.of[answer.worst]):
            colour, hatch = SOURCES[name]
            axes.barh(
                -k, share, left=at, height=0.72, color=colour, hatch=hatch, edgecolor="black",
                linewidth=0.5, label=None if name in names else words[f"from {name}"],
            )  # fmt: skip
            names[name] = None
            if share > 0.07:
                axes.text(
                    at + share / 2, -k, f"{100.0 * share:.0f} %", ha="center", va="center",
                    fontsize=8,
                    bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.85},
                )  # fmt: skip
            at += share
    axes.set_xlim(0.0, 1.0)
    axes.set_yticks([-float(k) for k in range(len(heads))], heads, fontsize=7)
    axes.set_xticks([])
    axes.set_title(
        words["figure sources"].format(quantity=words[answer.worst]), fontsize=8.5, loc="left"
    )
    for side in axes.spines.values():
        side.set_visible(False)
    axes.legend(
        loc="upper left", bbox_to_anchor=(-0.24, 0.0), fontsize=7.5, ncols=2, frameon=False,
        columnspacing=0.8, handletextpad=0.4,
    )  # fmt: skip
