"""What is calculated beside a gear pair, against own formulas of 40 digits; a_w on the sheet gives μ_l."""

from __future__ import annotations

from pathlib import Path

import mpmath
import numpy as np
import pytest
from support.boards import usual_part
from support.gallery import SHEETS
from support.notes import concluded
from support.scenes import edited

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.gears.dimensions import VIEW as DIMENSIONS
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.record import BESIDE, VIEW
from graphic_tmm.chapters.gears.refusals import refuse_order
from graphic_tmm.chapters.gears.table import SLIDING
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.drawn import Drawn, Results, single
from graphic_tmm.fitting.choice import choices
from graphic_tmm.project import record
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.table import columns_of, results_of
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

SCENE = SHEETS / "gear-pair" / "scene.toml"
SAME = 1e-12
"""Some dozen roundings of 1e-16 each, of tangents that differ by a tenth of themselves at least."""


def part(scene: Scene) -> Drawn:
    return usual_part("gears", scene)


def own(order: GearTask) -> dict[str, mpmath.mpf]:
    """The pair from the tangents of its base circles: no involute function of the contact is used."""
    with mpmath.workdps(40):
        mp, z = mpmath.mpf, (order.z1, order.z2)
        alpha, m, x = (
            mpmath.radians(mp(order.alpha)),
            mp(order.m),
            (order.x1 or 0.0, order.x2 or 0.0),
        )
        due = mpmath.tan(alpha) - alpha
        due += 2 * (mp(x[0]) + mp(x[1])) / sum(z) * mpmath.tan(alpha)
        angle = mpmath.findroot(lambda a: mpmath.tan(a) - a - due, mp("0.4"))
        axes = m * sum(z) / 2 * mpmath.cos(alpha) / mpmath.cos(angle)
        dy = mp(x[0]) + mp(x[1]) - (axes / m - mp(sum(z)) / 2)
        base = [m * n / 2 * mpmath.cos(alpha) for n in z]
        tips = [m * (mp(n) / 2 + order.ha + s - dy) for n, s in zip(z, x, strict=True)]
        ends = [mpmath.sqrt(a**2 - b**2) for a, b in zip(tips, base, strict=True)]
        path = sum(ends) - mpmath.sqrt(axes**2 - sum(base) ** 2)
        turned = path / base[0]  # wheel 1 turns by so much while its string is unwound over ab
        return {"arc": turned * axes * z[0] / sum(z), "axes": axes, "r_a1": tips[0], "path": path}


def test_what_is_calculated_beside_moves_no_mark_of_the_drawing() -> None:
    log = record(read(SCENE), "gears").construction
    beside = [step for step in log.steps if step.it.view == VIEW]
    others = [step for step in log.steps if step not in beside]
    assert min(step.it.slot for step in beside) > max(step.it.slot for step in others)
    assert not {step.it for step in beside} & {mark for step in others for mark in step.uses}


def test_the_way_of_no_length_is_named_by_both_its_ends() -> None:
    """N₁N₁ = 0, not a point that stands for a length."""
    log = record(read(SCENE), "gears").construction
    lengths = {mark.name for step in log.steps if step.it.view == VIEW for mark in step.uses}
    assert "N_{1}N_{1}" in lengths
    assert "N_{1}" not in lengths


@pytest.mark.parametrize(
    "order",
    [
        GearTask(15, 25, 0.008, 0.83, 0.445),
        GearTask(22, 61, 0.003, 0.1, -0.3),
        GearTask(30, 30, 0.008, 0.0, 0.0, alpha=15.0),
    ],
)
def test_ratio_and_arc_of_engagement_are_those_of_unwound_strings(order: GearTask) -> None:
    project = record(Scene("", "T", "en").asking(gears=order), "gears")
    beside, due = BESIDE.on(project), own(order)
    wanted = (beside.ratio, beside.arc, beside.path)
    reading = execute(
        project.construction, {**project.given, GEARS_PLAN.on(project).line.mu: 1.0}, wanted
    )
    ratio, arc, path = (float(reading[mark].item()) for mark in wanted)
    assert ratio == order.z2 / order.z1
    assert arc == pytest.approx(float(due["arc"]), rel=SAME * 100)
    assert path == pytest.approx(float(due["path"]), rel=SAME * 100)


def test_the_arc_that_is_drawn_is_the_one_that_is_calculated() -> None:
    found = single(_results(part(read(SCENE))))
    for k in (1, 2):
        drawn = found[f"arc_of_engagement{k}"][0]
        assert drawn == pytest.approx(found["arc_of_engagement"][0], rel=1e-5)  # a spline's flank


def test_drawn_sizes_are_the_real_ones_in_the_scale_of_the_book() -> None:
    """Document 003: μ = 168.68/400 = 0.4217, r = 142 and 237, r_w = 150 and 250, a_w = 400 mm."""
    drawn = part(read(SHEETS / "gear-pair"))
    found, due = single(_results(drawn)), own(GEARS_PLAN.on(drawn).order)
    mu = drawn.scales["gear"].value
    assert mu == pytest.approx(float(due["axes"]) / 400.0, rel=SAME)
    assert choices(drawn).value(GEARS_PLAN.on(drawn).line.mu) == pytest.approx(mu, rel=SAME)
    sizes = {one.segment: one for one in _columns(drawn) if one.plan == DIMENSIONS}
    rounded = {k: np.round(sizes[k].mm[0]).tolist() for k in ("r", "r_w", "s", "a_w")}
    assert rounded == {"r": [142, 237], "r_w": [150, 250], "s": [41, 36], "a_w": [400]}
    for name in ("h", "h_w", "p", "p_b", "arc_of_engagement"):
        assert sizes[name].mm.item() == pytest.approx(found[name][0] / mu, rel=SAME)
    for name in ("r_a", "r_b", "r_f"):
        real = [found[f"{name}{k}"][0] for k in (1, 2)]
        assert sizes[name].mm[0] == pytest.approx(np.array(real) / mu, rel=SAME)


def test_mu_and_the_drawn_distance_are_not_both_given() -> None:
    order = GearTask(15, 25, 0.008, mu=0.0005, axes=400.0)
    with pytest.raises(TaskError, match="leave one of the two out"):
        refuse_order(order)


def test_the_table_of_sliding_has_its_limits_the_pole_and_the_stations_of_the_task() -> None:
    """Sliding from the speeds along the flanks: ω₁·x against ω₂·(N₁N₂ − x), with z instead of ω."""
    drawn = part(read(SCENE))
    gear = GEARS_PLAN.on(drawn)
    columns = {one.segment: one for one in _columns(drawn) if one.plan == SLIDING}
    x, first, second = (columns[name].value[0] for name in ("x", "theta1", "theta2"))
    names = [name for name, _ in columns["x"].at]
    assert {"N1", "N2", "a", "b", "P", "1", "5"} <= set(names)
    assert (np.diff(x) > 0.0).all()
    assert x[names.index("1")] == pytest.approx(
        0.0235 * drawn.scales["gear"].value * 1000, rel=1e-9
    )
    whole, (z1, z2) = x[-1], (gear.order.z1, gear.order.z2)
    inner = slice(1, -1)
    along = (x[inner] / z1, (whole - x[inner]) / z2)
    assert first[inner] == pytest.approx((along[0] - along[1]) / along[0], abs=1e-9)
    assert second[inner] == pytest.approx((along[1] - along[0]) / along[1], abs=1e-9)
    assert (first[-1], second[0]) == (1.0, 1.0)
    assert np.isnan([first[0], second[-1]]).all()


def test_that_all_checks_hold_is_told_in_words_and_only_then(tmp_path: Path) -> None:
    words = concluded(part(read(SCENE)))[-1]
    assert words.startswith("All conditions of the meshing hold")
    assert "1.158" in words
    undercut = edited(tmp_path, ("x1 = 0.83", "x1 = 0.0"), name="gear-pair")
    assert not [one for one in concluded(part(read(undercut))) if "All conditions" in one]


def _columns(drawn: Drawn) -> list[Column]:
    return columns_of(drawn)


def _results(drawn: Drawn) -> Results:
    return results_of(drawn)
