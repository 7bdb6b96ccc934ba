"""What a sheet shows of a pair of gears."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.contact import Verdict, verdicts
from graphic_tmm.chapters.gears.ink import draw_gear_ink
from graphic_tmm.chapters.gears.ink_rolling import NAME as ROLLING
from graphic_tmm.chapters.gears.ink_rolling import draw_rolling_ink
from graphic_tmm.chapters.gears.ink_shifts import NAME as CHART
from graphic_tmm.chapters.gears.ink_shifts import draw_shifts_ink
from graphic_tmm.chapters.gears.ink_sliding import draw_sliding_ink
from graphic_tmm.chapters.gears.plan import GEARS_PLAN, Gear
from graphic_tmm.chapters.gears.shifts import letter_of
from graphic_tmm.chapters.gears.table import dimension_table, gear_results, sliding_table, working
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import Tongues, speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import Heights, heights
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions

CHECKS = Tongues(
    {
        "pointed tooth": said("pointed tooth"),
        "tip thickness": said("tip thickness"),
        "undercut": said("undercut"),
        "interference": said("interference"),
        "clearance": said("clearance"),
        "ring tip": said("tips within N1"),
        "tip overlap": said("tips pass one another"),
        "assembly": said("radial assembly"),
        "contact ratio": said("contact ratio"),
    }
)
"""What the checks of the meshing are called."""


def gear_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the meshing above its diagram of sliding, the rolled flanks, the tables."""
    made, language, scales = GEARS_PLAN.on(drawn), drawn.scene.language, drawn.scales
    words, high = captions(language), heights(drawn.scene, "gears")
    mu_l, mu_theta = mu_text(scales["gear"], language), mu_text(scales["sliding"], language)
    mesh, sliding = (subject(drawn, words[key], "gears") for key in ("gear", "sliding"))
    told = ", ".join([mu_l, *_ratios(drawn)])
    found = [
        with_caption(draw_gear_ink(mesh, made), mesh, lettered, told),
        with_caption(draw_sliding_ink(sliding, made), sliding, lettered, mu_theta),
    ]
    for k in range(len(made.wheels)):
        name = f"{ROLLING}-{k + 1}"
        on = subject(drawn, words[name], "gears", name=name)
        found.append(with_caption(draw_rolling_ink(on, made, k), on, lettered, mu_l))
    if made.order.chart:
        found.extend(_chart(drawn, made, lettered))
    found.append(dimension_table(drawn, language, words["gear-dimensions"], high))
    found.append(sliding_table(drawn, language, words["sliding"], high))
    return [*found, _checks(drawn, made, high)]


def _chart(drawn: Drawn, made: Gear, lettered: bool) -> Iterator[Drawing]:
    """Yield the shifts that the teeth may have, if there are any."""
    language = drawn.scene.language
    on = subject(drawn, captions(language)[CHART], "gears", name=CHART)
    if (chart := draw_shifts_ink(on, made)) is not None:
        taken = (wheel.x for wheel in made.sizes.wheels)
        told = (f"{x.name} = {number(drawn.value(x), language)}" for x in taken)
        yield with_caption(chart, on, lettered, f"K: {', '.join(told)}")


def _ratios(drawn: Drawn) -> list[str]:
    """Return the contact ratio by formula and as drawn, and by how much they differ."""
    language, found = drawn.scene.language, single(gear_results(drawn))
    formula, measured, apart = (
        found[name][0]
        for name in ("contact_ratio", "contact_ratio_drawn", "contact_ratio_difference")
    )
    off = fixed(apart, drawn.percent_decimals, language)
    base = letter_of(GEARS_PLAN.on(drawn).order, "p_{b}")
    return [
        f"ε_{{α}} = {fixed(formula, 3, language)}",
        f"{working(drawn)}/{base} = {fixed(measured, 3, language)} ({off} %)",
    ]


def _checks(drawn: Drawn, made: Gear, heights: Heights) -> Drawing:
    """Return the table of checks: the wheels side by side, as their dimensions, then the pair."""
    language = drawn.scene.language
    _, words, found = (
        speaking(language),
        captions(language),
        list(verdicts(made.checks, drawn.reading)),
    )
    rows = []
    for name in dict.fromkeys(one.name for one in found):
        same = [one for one in found if one.name == name]
        cells = [_compared(one, language) for one in same]
        cells = ["", *cells] if [one.wheel for one in same] == [2] else cells
        failed = ", ".join(str(one.wheel) for one in same if not one.holds and one.wheel)
        verdict = _("holds") if all(one.holds for one in same) else _("fails")
        told = f"{verdict}: {failed}" if failed else verdict
        of = unit("mm", language) if same[0].unit == "m" else ""
        rows.append([CHECKS[language][name], *cells, *[""] * (2 - len(cells)), of, told])
    heads = [_("Check"), "1", "2", words["unit"], _("Verdict")]
    align = ["left", "centre", "centre", "left", "left"]
    return breakable(
        "table-gear-checks",
        _("Checks of the meshing"),
        heads,
        rows,
        again=words["continued"],
        size=heights.number,
        title_size=heights.title,
        align=align,
    )


def _compared(found: Verdict, language: str) -> str:
    """Return the value of a check beside its limit: 3,56 ≥ 1,60."""
    factor, places = (1000.0, 2) if found.unit == "m" else (1.0, 3)
    value, least = (fixed(factor * x, places, language) for x in (found.value, found.least))
    return f"{value} {'≥' if found.holds else '<'} {least}"


SHOWN = Views(draw={"gears": gear_views, **given_views("gears")})
