"""A scene in other scale factors: its lengths change with them, what they stand for does not."""

from __future__ import annotations

from functools import cache

import pytest
from support.gallery import SHEETS

from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.congruence.remade import Remaking
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


@cache
def made_of(name: str) -> DrawnScene:
    return make(read(SHEETS / name), exact=True)


@pytest.mark.parametrize("name", ["windrower", "cam", "engine", "slider-diagrams"])
def test_lengths_of_one_scale_factor_change_and_no_figure_else(name: str) -> None:
    made = made_of(name)
    remaking = Remaking(made)
    due, groups = cells(made), remaking.groups
    for group in dict.fromkeys(groups.values()):
        if sum(map(abs, group.powers)) != 1:
            continue
        same = {one for one in groups.values() if one.powers == group.powers}
        other = cells(remaking.of(dict.fromkeys(same, 1.25), {}))
        for key, cell in due.items():
            if cell.mm and cell.value:
                times = 1.25 if groups[key[:2]] in same else 1.0
                now = other[key]
                assert now.mm == pytest.approx(times * cell.mm, rel=1e-6), key
                assert now.value == pytest.approx(cell.value, rel=1e-6), key


def test_a_position_may_have_a_scale_factor_of_its_own() -> None:
    made = made_of("windrower")
    remaking = Remaking(made)
    group = remaking.groups["velocities", "pa"]
    other = cells(remaking.of({group: 1.25}, {group: {"3": 0.8}}))
    for (plan, segment, place), cell in cells(made).items():
        if (plan, segment) == ("velocities", "pa") and cell.mm:
            times = 0.8 if place == "3" else 1.25
            assert other[plan, segment, place].mm == pytest.approx(times * cell.mm)


def test_every_polygon_has_its_own_scale_factor() -> None:
    symbols = Remaking(made_of("windrower")).symbols
    assert symbols["velocities"].keys() == {"μ_v"}
    assert symbols["diagrams"].keys() == {"μ_S", "μ_V", "μ_a"}
