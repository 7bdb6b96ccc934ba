"""The composition of a scene like this one to begin with: plans about as large, as many sheets."""

from __future__ import annotations

from functools import cache

import pytest
from support.each import each
from support.gallery import SHEETS

from graphic_tmm.classroom.variants.variant import Value, Variant, base, scene_of
from graphic_tmm.fitting.compose import Composed
from graphic_tmm.fitting.given import LARGER
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets


def varied(name: str, **lengths: str) -> Scene:
    values = tuple(Value(f"lengths.{key}", length) for key, length in lengths.items())
    return scene_of(base(SHEETS / name), Variant("7", values))


@cache
def own(name: str) -> Composed:
    return composed_sheets(varied(name))[1]


SMALL = {"OA": "100 mm", "OB": "310 mm", "BC": "560 mm", "CD": "170 mm"}
LARGE = {"OA": "118 mm", "OB": "355 mm", "BC": "640 mm", "CD": "190 mm"}


@pytest.mark.turns(1, "variants")
@pytest.mark.slow
@each("lengths", [SMALL, LARGE])
def test_a_variant_keeps_its_size_and_as_many_sheets(lengths: dict[str, str]) -> None:
    of = own("shaper")
    made, found = composed_sheets(varied("shaper", **lengths), of.composition, near=True)
    assert len(found.sheets) == len(of.sheets)
    for name in ("velocities", "accelerations"):
        assert 1.0 / LARGER <= made.boards[0].sizes[name] / of.composition.sizes[name] <= LARGER
    assert "composition.toml" not in " ".join(map(str, made.scene.remarks))


@pytest.mark.turns(1, "variants")
@pytest.mark.slow
def test_the_scene_itself_is_drawn_as_it_was() -> None:
    of = own("shaper")
    _, found = composed_sheets(varied("shaper"), of.composition, near=True)
    assert list(map(svg, found.sheets)) == list(map(svg, of.sheets))


@pytest.mark.turns(1, "variants")
@pytest.mark.slow
def test_what_begins_with_a_scene_of_other_sheets_is_composed_as_if_it_had_not() -> None:
    due, other = own("shaper"), own("crank-rocker")
    assert len(due.sheets) != len(other.sheets)
    _, found = composed_sheets(varied("shaper"), other.composition, near=True)
    assert list(map(svg, found.sheets)) == list(map(svg, due.sheets))
