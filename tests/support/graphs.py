"""Every view of a log that has axes, drawn; what holds of a view, asked by the laws of `figures`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Rule, Subject
from graphic_tmm.paper.views import pole_figures
from support.figures import assert_pictures_make_the_view, without_ink, without_source


def axes_views(log: Construction) -> list[str]:
    """The views of a log that have axes, in their order."""
    return list(dict.fromkeys(f.view for f in log.figures if f.kind == "axes"))


def graphs(
    log: Construction,
    reading: Reading,
    names: Iterable[str],
    row: int,
    rules: Mapping[str, Rule] = MappingProxyType({}),
) -> list[Drawing]:
    """Every graph of a log, lettered."""
    made = []
    for view in axes_views(log):
        told = Names(list(names), "y", "x", lengths=pole_figures(log, reading, view, "en"))
        made.append(finished(draw_graph(Subject(log, reading, view), view, row, told, rules)))
    return made


def assert_read_off_the_log(
    log: Construction, views: Iterable[Drawing], traceless: Iterable[str] = ()
) -> None:
    """Every step of the views leaves ink or none by name, all ink has its source, pictures make the view."""
    drawn = list(views)
    assert not without_ink(log, drawn, traceless)
    for view in drawn:
        assert view.shows
        assert not without_source(view), view.name
        assert_pictures_make_the_view(log, view)
