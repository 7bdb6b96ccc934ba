"""What a sheet shows of a mechanism's balance: polar diagram, graph of the moment, counterweights, tables."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.balance.ink import (
    draw_polar,
    pull_letters,
    weight_letters,
    weight_strokes,
)
from graphic_tmm.chapters.balance.masses import Unbalance
from graphic_tmm.chapters.balance.plan import BALANCE_PLAN, Balance
from graphic_tmm.chapters.balance.scales import SCHEME
from graphic_tmm.chapters.balance.table import (
    balance_columns,
    balance_results,
    moment_title,
)
from graphic_tmm.chapters.balance.task import BALANCE, COUNTERWEIGHTS, FORCE, INERTIA, MOMENT
from graphic_tmm.chapters.balance.words import called
from graphic_tmm.chapters.kinematics.ink_positions import draw_position_ink
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.chapters.rotors.ink_polygon import draw_polygon_ink
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.scene.captions import captions


def balance_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the polar diagram, the graph of the moment, the counterweights and the tables."""
    made = BALANCE_PLAN.of(drawn)
    if made is None:
        return []
    language, high = drawn.scene.language, heights(drawn.scene, BALANCE)
    schemes = [_unbalance(drawn, one, lettered) for one in made.unbalances]
    schemes.append(_scheme(drawn, made, lettered))
    words = captions(language)
    rows = [
        [words[name], number(value, language, 3 if of == "%" else 4), unit(of, language)]
        for name, (value, of) in single(balance_results(drawn)).items()
    ]
    return [
        *schemes,
        _polar(drawn, made, lettered),
        _graph(drawn, made, lettered),
        result_table(BALANCE, tuple(balance_columns(drawn)), drawn.names, language, heights=high),
        results("table-balance-results", words[BALANCE], rows, language, high),
    ]


def _unbalance(drawn: Drawn, one: Unbalance, lettered: bool) -> Drawing:
    language, polygon = drawn.scene.language, one.polygon
    on = subject(drawn, called(polygon.view, speaking(language)), BALANCE)
    mu = drawn.scales[polygon.view]
    figure = f"{number(drawn.value(polygon.size), language, 4)} {unit('kg·m', language)}"
    lines = mu_text(mu, language), f"{symbol(polygon.size.name, language)} = {figure}"
    view = draw_polygon_ink(on, polygon, mu.value)
    return with_caption(view, on, lettered, *lines, known=[polygon.size])


def worst(drawn: Drawn, made: Balance) -> int:
    """Return the position (index) of the largest shaking force without counterweights."""
    row = np.nan_to_num(drawn.reading[made.bare.length][0], nan=-1.0)
    return int(np.argmax(row[: KINEMATICS_PLAN.on(drawn).in_turn]))


def _polar(drawn: Drawn, made: Balance, lettered: bool) -> Drawing:
    language = drawn.scene.language
    words, left_out = captions(language), {*drawn.undrawn, *KINEMATICS_PLAN.on(drawn).repeated}
    places = [k for k in drawn.all if k not in left_out]
    on = subject(drawn, words[FORCE], BALANCE)
    view = draw_polar(on, made, [escape(name) for name in drawn.names], places, worst(drawn, made))
    lines = [mu_text(drawn.scales[FORCE], language)]
    for one, which in zip(made.wholes, ("without", "with"), strict=False):
        if np.isfinite(most := drawn.value(one.most)):
            figure, largest = number(most, language, 4), symbol(one.most.name, language)
            lines.append(f"{largest} = {figure} {unit('N', language)}, {words[which]}")
            if one is made.weighted:
                left = number(drawn.value(one.top), language)
                lines.append(f"{one.top.name} = {left} {unit('mm', language)}")
    known = [one.top for one in made.wholes]
    return with_caption(view, on, lettered, *lines, known=known)


def _graph(drawn: Drawn, made: Balance, lettered: bool) -> Drawing:
    language = drawn.scene.language
    phi = made.base.mu
    up = on_axis(symbol("M_Φ", language), unit("N·m", language))
    along = on_axis("φ", unit(phi.unit.removesuffix("/mm"), language))
    names = [escape(name) for name in drawn.names]
    curves = {one.ordinate: symbol(one.moment.name, language) for one in made.wholes}
    letters = Names(names, up, along, curves if made.weights else {})
    on = subject(drawn, moment_title(drawn, language), BALANCE)
    view = draw_graph(on, MOMENT, drawn.project.count, letters)
    scales = [
        mu_text(drawn.scales[MOMENT], language),
        f"{phi.name} = {number(drawn.value(phi), language)} {unit(phi.unit, language)}",
    ]
    return with_caption(view, on, lettered, ", ".join(scales))


def _scheme(drawn: Drawn, made: Balance, lettered: bool) -> Drawing:
    """Return the mechanism in its main position: inertia forces with arms, counterweights at their radii."""
    language, k = drawn.scene.language, drawn.main
    words = captions(language)
    which = COUNTERWEIGHTS if made.weights else INERTIA
    title = f"{words[which]}, {words['position']} {escape(drawn.names[k])}"
    on = subject(drawn, title, BALANCE, name=which)
    seen = on.seen((COUNTERWEIGHTS, INERTIA), [k])
    traces = figure(seen, Manner(stays=lambda _, step: not made.weights))
    strokes = (*traces.staying, *weight_strokes(seen, made.weights, k))
    view = draw_position_ink(on, reaches(drawn), k, strokes)
    letters = weight_letters(on, seen, made.weights, k)
    view = view._replace(
        wanted=(*view.wanted, *(letters if made.weights else pull_letters(on, seen, made, k))),
        rubbed=(*view.rubbed, *traces.rubbed),
        shows=(*view.shows, *seen.views),
        role=SCHEME,
    )
    lines = [mu_text(drawn.scales[POSITIONS], language)]
    for one in made.weights:
        told = []
        for mark in (one.mass, one.radius):
            value, of = drawn.value(mark), mark.unit
            value, of = small(value, language) if mark is one.radius else (value, of)
            letter = symbol(mark.name, language)
            told.append(f"{letter} = {number(value, language, 4)} {unit(of, language)}")
        lines.append(", ".join(told))
    return with_caption(view, on, lettered, *lines)


SHOWN = Views(draw={BALANCE: balance_views})
