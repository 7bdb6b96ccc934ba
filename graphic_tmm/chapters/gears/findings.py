"""That a gear pair passes all checks of its meshing, or which it fails, in words."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.gears.contact import verdicts
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.shift_chart import chart_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

FAILS = {
    "pointed tooth": said(
        "the teeth of wheel {wheel} are pointed: their flanks meet at the radius {top:.4g} mm, and there they "
        "end and the contact with them; take a smaller x{wheel}"
    ),
    "tip thickness": said(
        "the teeth of wheel {wheel} are {value:.3g} mm thick at the tip, {least:.3g} mm are usual: take a "
        "smaller x{wheel}"
    ),
    "undercut": said(
        "wheel {wheel} is undercut: x{wheel} = {value:.4g} is too little; take {enough:.4f} at least, or more "
        "teeth"
    ),
    "interference": said(
        "interference: the tips of wheel {other} reach a point of wheel {wheel} where the radius of curvature "
        "is {value:.3g} mm, its involute begins at {least:.3g} mm; the contact ratio {ratio:.4g} is the most "
        "that the line of action leaves; take a greater x{wheel}"
    ),
    "tips of the rack": said(
        "interference: the tips of the rack reach a point of wheel {wheel} where the radius of curvature is "
        "{value:.3g} mm, its involute begins at {least:.3g} mm; the contact ratio {ratio:.4g} is the most that "
        "the line of action leaves; take a greater x{wheel}"
    ),
    "clearance": said(
        "the tips of wheel {other} cut {depth:.3g} mm into the roots of wheel {wheel}: leave delta_y out, or "
        "take a greater one"
    ),
    "ring tip": said(
        "interference: the ring's tip radius {value:.5g} mm is less than {least:.5g} mm, its tips reach "
        "beyond N1; the contact ratio is {ratio:.4g}, counted from N1; give the ring more teeth, a smaller ha "
        "or a greater x2"
    ),
    "tip overlap": said(
        "where the tip circles cross the teeth overlap by {depth:.3g} mm: give the ring more teeth, a smaller "
        "ha or a greater x2"
    ),
    "assembly": said(
        "the wheel cannot be put into the ring along the line of centres, {depth:.3g} mm are wanting: put it "
        "in along the axis, or give the ring more teeth"
    ),
    "contact ratio": said(
        "the contact ratio {ratio:.4g} is below 1: a pair of teeth leaves before the next one touches"
    ),
}
"""By check; ``value`` and ``least`` in mm, or coefficients; ``enough``: the least, rounded up."""


def failures(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield each check that fails, a sentence each; of a pointed tooth its thickness is none to tell."""
    made, _ = GEARS_PLAN.on(drawn), speaking(language)
    if made.order.chart and chart_of(made.order) is None:
        yield _(
            "no shifts give wheels of these teeth that can mesh: the chart of shifts is left out"
        )
    fails = [one for one in verdicts(made.checks, drawn.reading) if not one.holds]
    pointed = {one.wheel for one in fails if one.name == "pointed tooth"}
    ringed = any(one.name == "ring tip" for one in fails)  # tells of the same tips
    ratio = drawn.value(made.sizes.contact_ratio)
    for one in fails:
        if one.name == "tip thickness" and one.wheel in pointed:
            continue
        if one.name == "interference" and ringed:
            continue
        mm = 1000.0 if one.unit == "m" else 1.0
        top = made.sizes.wheels[min(one.wheel, len(made.sizes.wheels)) - 1].top
        name = one.name
        if made.rack and name == "interference":
            name = "tips of the rack"
        yield _(
            FAILS[name],
            wheel=one.wheel,
            other=3 - one.wheel,
            value=mm * one.value,
            least=mm * one.least,
            enough=math.ceil(1e4 * one.least) / 1e4,
            depth=-mm * one.value,
            top=1000.0 * drawn.value(top),
            ratio=ratio,
        )


WARNINGS = Warned(failures)
