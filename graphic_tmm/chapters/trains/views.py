"""What a sheet shows of planetary trains."""

from __future__ import annotations

from graphic_tmm.chapters.trains.ink import Captions, draw_planetary_ink
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.chapters.trains.record import BESIDE
from graphic_tmm.chapters.trains.table import (
    calculated_lines,
    condition_table,
    rate_table,
    ratio_lines,
    train_table,
    trains_wanted,
)
from graphic_tmm.drawn import Drawn, results_of, single
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions


def planetary_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the train in two views with its velocities, the tables of conditions, rates and trains."""
    made, language, reading = PLANETARY_PLAN.on(drawn), drawn.scene.language, drawn.reading
    words, scales, log = captions(language), drawn.scales, drawn.construction
    told = (
        *calculated_lines(log, reading, made.pairs.speeds, language),
        *ratio_lines(log, reading, made, language),
        *_overall(drawn),
        *_torques(drawn),
    )
    texts = {name: mu_text(scale, language) for name, scale in scales.items()}
    found = Captions(
        (words["planetary"], texts["planetary"]),
        (words["planetary-velocities"], texts.get("planetary-velocities", "")),
        (words["planetary-rates"], texts.get("planetary-rates", ""), *dict.fromkeys(told)),
    )
    shown = Captions(*(tuple(text for text in group if text) for group in found))
    high = heights(drawn.scene, "planetary")
    on = subject(drawn, words["planetary"], "planetary")
    view = draw_planetary_ink(on, made, shown)
    views = [finished(view, lettered), condition_table(log, reading, made, language, high)]
    views.append(rate_table(log, reading, made, language, high))
    if (trains := trains_wanted(made)) is not None:
        views.append(train_table(trains, language, high))
    return views


def _torques(drawn: Drawn) -> list[str]:
    """Return the torques on the shafts and the efficiency, as they are calculated."""
    beside, log = BESIDE.on(drawn), drawn.construction
    marks = [*beside.lost, *beside.torques.values(), beside.efficiency]
    shown = [one for one in marks if one is not None]
    return list(calculated_lines(log, drawn.reading, shown, drawn.scene.language))


def _overall(drawn: Drawn) -> list[str]:
    """Return the overall ratio and the speed of the last wheel."""
    made = PLANETARY_PLAN.on(drawn)
    if made.pairs.ratio is None:
        return []
    language = drawn.scene.language
    _ = speaking(language)
    ratio = float(drawn.reading[made.pairs.ratio].ravel()[0])
    rows = (*made.order.behind, *made.order.before)
    last_speed = BESIDE.on(drawn).speed
    step = drawn.construction.step(last_speed) if last_speed is not None else None
    assert step is not None
    turns = [float(drawn.reading[mark].ravel()[0]) for mark in (step.uses[0], step.it)]
    speeds = [number(turns[0], language), number(ratio, language), number(turns[1], language)]
    ratios = single(results_of(drawn, made.results))
    own = ratios["planetary_ratio"][0]
    train = number(own, language) if own >= 0.0 else f"|{number(own, language)}|"
    text = "·".join((train, *(f"{row[-1]}/{row[0]}" for row in rows)))
    return [
        f"U_{{0}} = {text} = {number(ratio, language)}",
        f"n = {speeds[0]}/{speeds[1]} = {speeds[2]} {_('rpm')}",
    ]


SHOWN = Views(draw={"planetary": planetary_views, **given_views("planetary")})
