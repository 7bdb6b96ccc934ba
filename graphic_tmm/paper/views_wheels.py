"""What a sheet shows of gears and planetary trains."""

from __future__ import annotations

import math
from dataclasses import replace

from graphic_tmm.captions import CAPTIONS
from graphic_tmm.mechanism.tooth_search import search
from graphic_tmm.paper.arranging import captioned, mu_text
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.gear_tables import dimension_table, sliding_table
from graphic_tmm.paper.ink_gear import draw_gear_ink
from graphic_tmm.paper.ink_planetary import Captions, draw_planetary_ink
from graphic_tmm.paper.ink_rolling import draw_rolling_ink
from graphic_tmm.paper.ink_sliding import draw_sliding_ink
from graphic_tmm.paper.ink_tables import SIZE
from graphic_tmm.paper.ink_train_tables import condition_table, rate_table, ratio_lines, train_table
from graphic_tmm.parts import Part
from graphic_tmm.plans.gear import Gear
from graphic_tmm.plans.gear_checks import verdicts
from graphic_tmm.plans.planetary import Planetary
from graphic_tmm.words import fixed, number, unit


def gear_views(part: Part, lettered: bool) -> list[Drawing]:
    """Return the meshing above its diagram of sliding, the rolled flanks, the tables."""
    made, language, reading = part.made, part.scene.language, part.reading
    assert isinstance(made, Gear)
    words, scales = CAPTIONS[language], part.scales()
    mu_l = mu_text(scales["gear"], language)
    mesh = draw_gear_ink(reading, made, language, words["gear"], lettered=lettered)
    sliding = draw_sliding_ink(reading, made, language, words["sliding"], lettered=lettered)
    mu_theta = mu_text(scales["sliding"], language)
    found = [
        captioned(mesh, words["gear"], ", ".join([mu_l, *_ratios(part)])),
        captioned(sliding, words["sliding"], mu_theta),
    ]
    for k in (0, 1):
        title = words["gear-rolling"].format(number=k + 1)
        view = draw_rolling_ink(part.construction, reading, made, k, title, lettered=lettered)
        found.append(captioned(view, title, mu_l))
    found.append(dimension_table(reading, made, language, words["gear-dimensions"]))
    found.append(sliding_table(reading, made, language, words["sliding"]))
    return [*found, _checks(part, made)]


def _ratios(part: Part) -> list[str]:
    """Return the contact ratio by formula and as drawn, and by how much they differ."""
    language, found = part.scene.language, part.results()
    formula, drawn, apart = (
        found[name][0]
        for name in ("contact_ratio", "contact_ratio_drawn", "contact_ratio_difference")
    )
    return [
        f"ε_{{α}} = {fixed(formula, 3, language)}",
        f"ab/p_{{b}} = {fixed(drawn, 3, language)} ({number(apart, language, 2)} %)",
    ]


def _checks(part: Part, made: Gear) -> Drawing:
    language = part.scene.language
    words, rows = CAPTIONS[language], []
    for found in verdicts(made.checks, part.reading):
        in_mm = found.unit == "m"
        factor, places = (1000.0, 2) if in_mm else (1.0, 3)
        cells = [fixed(factor * x, places, language) for x in (found.value, found.least)]
        wheel = str(found.wheel) if found.wheel else ""
        sign = "≥" if found.holds else "<"
        of = unit("mm", language) if in_mm else ""
        verdict = words["holds" if found.holds else "fails"]
        rows.append([words[found.name], wheel, f"{cells[0]} {sign} {cells[1]}", of, verdict])
    heads = [words[k] for k in ("checked", "wheel", "value", "unit", "verdict")]
    align = ["left", "centre", "centre", "left", "left"]
    return breakable(
        "table-gear-checks",
        words["gear checks"],
        heads,
        rows,
        again=words["continued"],
        size=SIZE,
        align=align,
    )


def planetary_views(part: Part, lettered: bool) -> list[Drawing]:
    """Return the train in two views with its velocities, the tables of conditions, rates and trains."""
    made, language, reading = part.made, part.scene.language, part.reading
    assert isinstance(made, Planetary)
    words, scales, log = CAPTIONS[language], part.scales(), part.construction
    lines = ratio_lines(log, reading, made, language)
    texts = {name: mu_text(scale, language) for name, scale in scales.items()}
    captions = Captions(
        (words["planetary"], texts["planetary"]),
        (words["planetary-velocities"], texts.get("planetary-velocities", "")),
        (words["planetary-rates"], texts.get("planetary-rates", ""), *lines, *_overall(part)),
    )
    shown = Captions(*(tuple(text for text in group if text) for group in captions))
    view = draw_planetary_ink(reading, made, shown, words["planetary"], lettered=lettered)
    found = [view, condition_table(log, reading, made, language)]
    found.append(rate_table(log, reading, made, language))
    if made.order.ratio is not None:
        wanted = replace(made.order, teeth=())
        found.append(train_table(search(wanted), language))
    return found


def _overall(part: Part) -> list[str]:
    """Return the overall ratio and the speed of the last wheel."""
    mark = part.extra.get("overall_ratio")
    if mark is None or not isinstance(part.made, Planetary):
        return []
    language = part.scene.language
    ratio = float(part.reading[mark].ravel()[0])
    first, last = part.scene.behind
    rpm = abs(part.made.order.speed) * 30.0 / math.pi
    speeds = [number(rpm, language), number(ratio, language), number(rpm / ratio, language)]
    text = f"{number(float(part.results()['planetary_ratio'][0]), language)}·{last}/{first}"
    return [
        f"U_{{0}} = {text} = {number(ratio, language)}",
        f"n = {speeds[0]}/{speeds[1]} = {speeds[2]} {CAPTIONS[language]['rpm']}",
    ]
