"""A crank that turns what nearly cannot be drawn: plans that fly away are not there, the page is."""

from __future__ import annotations

import cmath
import json
import math
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.boards import in_usual_size
from support.gallery import SHEETS
from support.linkages import four_bar, slider_crank
from support.scenes import written

from graphic_tmm.chapters.kinematics.task import PLANS
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Mechanism, Row
from graphic_tmm.page.crank import Turned, crank, fine
from graphic_tmm.page.cursors import on_paper
from graphic_tmm.page.pack import UNIT, packed, unpacked
from graphic_tmm.page.page import page
from graphic_tmm.page.strands import AWAY, unfolded
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import sheets

LARGE = 1000.0
"""At its positions a plan of a sheet reaches no farther, mm."""


def at_its_limit(pick: random.Random) -> tuple[Mechanism, float]:
    """A mechanism that at a fifth degree can only just be drawn, or just not; an angle where it can well."""
    degrees = 5 * pick.randrange(72)
    left = pick.choice((1, -1)) * 10.0 ** -pick.uniform(1.0, 14.0)
    r, turn = pick.uniform(0.2, 0.6), cmath.rect(1.0, math.radians(degrees))
    if pick.random() < 0.5:
        c = cmath.rect(pick.uniform(0.7, 1.2), pick.uniform(0, 2 * math.pi))
        apart = abs(r * turn - c)
        rod = apart * pick.uniform(0.3, 0.7)
        made = four_bar(r, rod, apart * (1 + left) - rod, c, sign=pick.choice((1, -1)))
        near_c = math.degrees(cmath.phase(c))
        return made, degrees + 10.0 * math.copysign(1.0, math.sin(math.radians(near_c - degrees)))
    e = pick.uniform(-0.3, 0.3)
    high = abs(r * turn.imag - e)
    made = slider_crank(r, high * (1 + left), e)
    down = math.copysign(10.0, turn.real) * -math.copysign(1.0, r * turn.imag - e)
    return made, degrees + down


def turned(mechanism: Mechanism, zero: float) -> Turned | None:
    row = Row(12, 0, zero % 360.0, (), ("all",))
    scene = Scene("limit", "limit", "en", mechanism, row, sheets=(SheetOrder("A1", PLANS),))
    return crank(in_usual_size(scene), ())


def held(found: Turned) -> int:
    """Check that nothing is farther than it may be, no figure coarser; return how many figures there are."""
    json.dumps(found.data, allow_nan=False)
    rows = unpacked(found.rows, found.data["lengths"])
    for figure in found.data["figures"]:
        assert max(map(abs, figure["box"])) <= 4 * AWAY * LARGE
        begun, count, _ = figure["rows"]
        for row in rows[begun : begun + count]:
            whole = unfolded(row, found.data["whole"], figure["refined"]) * UNIT
            assert np.abs(whole).max() <= 2 * AWAY * LARGE
    return len(found.data["figures"])


@pytest.mark.turns(2)
@pytest.mark.parametrize("seed", range(10))
@pytest.mark.slow
def test_mechanisms_at_their_limits_have_a_page(seed: int) -> None:
    pick = random.Random(seed)
    figures = 0
    for _ in range(4):
        try:
            found = turned(*at_its_limit(pick))
        except StructureError:
            continue  # what can be drawn in no position is refused, and has no page
        assert found is not None
        figures += held(found)
    assert figures


def short(tmp_path: Path, length: str) -> Path:
    text = (SHEETS / "crank-rocker" / "scene.toml").read_text("utf-8")
    told = 'B = ["60 mm", 0]'
    assert text.count(told) == 1
    return written(tmp_path, text.replace(told, f'B = ["{length}", 0]'))


@pytest.mark.slow
def test_a_coupler_far_too_short_has_a_page(tmp_path: Path) -> None:
    """It assembles at 17 angles; at one of them, 0.3° off its limit, the accelerations reach 10 km."""
    made, found = sheets(read(short(tmp_path, "1 mm")))
    assert page(made, found).startswith("<!DOCTYPE html>")
    told = crank(made, found)
    assert told is not None
    held(told)
    figures: dict[str, Any] = {one["name"]: one for one in told.data["figures"]}
    assert figures["positions"]["lines"]
    there = {
        name: [line[4] for line in figures[name]["lines"]]
        for name in ("velocities", "accelerations")
    }
    assert there["velocities"] != there["accelerations"]


def test_a_figure_that_flies_away_does_not_coarsen_the_others() -> None:
    row, rows = np.array([1.0, 2.0, np.nan, -3.0, 1e4]), list[Any]()
    told = fine(row, rows)
    back = rows[told["row"][0]] * told["worth"]
    np.testing.assert_allclose(back[[0, 1, 3, 4]], row[[0, 1, 3, 4]], atol=2e-3)
    assert fine(np.array([1.0, 2.0, 3.0]), [])["worth"] == pytest.approx(1e-5)
    giant = list[Any]()
    fine(np.array([1.0, -1e300, 1e300, -1e300, 1.0]), giant)
    assert unpacked(packed(giant), [5])[0].tolist() == giant[0].tolist()


def test_a_cursor_beside_its_sheet_is_not_there() -> None:
    sheet = Sheet("A4", "", "A4", 297.0, 210.0, ())
    spots = on_paper(np.array([1 + 1j, 297 + 210j, 1e9 + 1j, 1 - 2j]), sheet)
    assert np.isfinite(spots).tolist() == [True, True, False, False]
