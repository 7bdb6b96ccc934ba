"""What a sheet shows of planetary trains."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.trains.formulas import overall_ratio
from graphic_tmm.chapters.trains.ink import Captions, draw_planetary_ink
from graphic_tmm.chapters.trains.ink_bevel import draw_bevel_ink
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.chapters.trains.record import BESIDE, locks
from graphic_tmm.chapters.trains.table import (
    calculated_lines,
    condition_table,
    rate_table,
    ratio_lines,
    train_table,
    trains_wanted,
)
from graphic_tmm.drawn import Drawn
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
        *calculated_lines(log, reading, made.pairs.before.values(), language),
        *ratio_lines(log, reading, made, language),
        *_overall(drawn),
        *calculated_lines(log, reading, filter(None, (BESIDE.on(drawn).rack,)), language),
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
    draw = draw_bevel_ink if made.train.scheme.bevel else draw_planetary_ink
    view = draw(on, made, shown)
    views = [finished(view, lettered), condition_table(log, reading, made, language, high)]
    views.append(rate_table(log, reading, made, language, high))
    if (trains := trains_wanted(made)) is not None:
        views.append(train_table(trains, language, high))
    return views


def _torques(drawn: Drawn) -> list[str]:
    """Return the torques on the shafts and the efficiency, as they are calculated, of a train that moves."""
    if locks(drawn):
        return []
    beside, log = BESIDE.on(drawn), drawn.construction
    marks = [*beside.lost, *beside.torques.values(), beside.efficiency]
    marks += [*beside.powers.values(), beside.circulates]
    shown = [one for one in marks if one is not None]
    return list(calculated_lines(log, drawn.reading, shown, drawn.scene.language))


def _overall(drawn: Drawn) -> list[str]:
    """Return the overall ratio and the speed of the last wheel; ratios stage by stage in one line."""
    log, language, last = drawn.construction, drawn.scene.language, BESIDE.on(drawn).speed
    if last is None:
        return []
    _ = speaking(language)

    def put(mark: Mark) -> str:
        return number(drawn.value(mark), language)

    def stages(mark: Mark) -> str:
        step = log.step(mark)
        if step is None or step.op != overall_ratio:
            return put(mark) if drawn.value(mark) >= 0.0 else f"|{put(mark)}|"
        train, driven, driving = step.uses
        return f"{stages(train)}·{put(driven)}/{put(driving)}"

    step = log.step(last)
    assert step is not None
    turns, ratio = step.uses
    return [
        f"{ratio.name} = {stages(ratio)} = {put(ratio)}",
        f"n = {number(abs(drawn.value(turns)), language)}/{put(ratio)} = {put(last)} {_('rpm')}",
    ]


SHOWN = Views(draw={"planetary": planetary_views, **given_views("planetary")})
