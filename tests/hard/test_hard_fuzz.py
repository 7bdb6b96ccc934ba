"""Changed files and command lines, the same each time; more by ``python tests/hard/fuzz.py``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import fuzz_inputs as inputs
import pytest
import shapely
from fuzz import case, cased
from fuzz_tasks import task
from support.command import invoke
from support.gallery import NAMES, SHEETS
from support.scenes import source

from graphic_tmm.paper.symbols.kinematic import MOST, MOST_HATCHES, hatched, hatching

QUICK = (
    "crank-rocker",
    "scotch-yoke",
    "tangent-mechanism",
    "planetary",
    "gear-pair",
    "slider-diagrams",
)
"""Scenes that are drawn in a fraction of a second."""


@pytest.mark.slow
def test_changed_scenes_are_drawn_or_refused(many: Callable[[int, int], int]) -> None:
    found = [case(number, 1, QUICK) for number in range(many(300, 30))]
    assert not [one for one in found if one.fault]
    # 1: a check that found something
    ends = {one.status for one in found}
    assert 2 in ends
    assert ends & {0, 1, 3}
    assert ends <= {0, 1, 2, 3}


@pytest.mark.slow
def test_changed_files_beside_a_scene_are_used_or_refused(many: Callable[[int, int], int]) -> None:
    for kind in inputs.KINDS:
        assert (kind, cased(0, inputs.unchanged(kind)).status) in {(kind, 0), (kind, 1)}
    found = [inputs.case(number, 1) for number in range(many(300, 16))]
    assert not [one for one in found if one.fault]
    assert {one.status for one in found} == {0, 1, 2}


@pytest.mark.parametrize(("first", "usual"), [(0, 4), pytest.param(4, 6, marks=pytest.mark.slow)])
@pytest.mark.slow
def test_changed_photographs_are_judged_or_refused(
    first: int, usual: int, many: Callable[[int, int], int]
) -> None:
    pytest.importorskip("cv2")
    pytest.importorskip("PIL.Image")
    from fuzz_photographs import case as photographed

    found = [
        photographed(number, 1, ("crank-rocker",))
        for number in range(first, first + many(14 * usual, usual))
    ]
    assert not [one for one in found if one.fault]
    # 1: points were seen, and one is wrong
    ends = {one.status for one in found}
    assert 2 in ends
    assert ends & {0, 1, 3}
    assert ends <= {0, 1, 2, 3}


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "old", "new", "says"),
    [
        ("crank-press", '"90 mm"', '"90000000.0 mm"', "the stroke has no length"),
        ("engine", 'r  = "0.3 m"', 'r  = "3e-07 m"', ""),
        ("gear-pair", "x2 = 0.445", "x2 = 4.45", ""),
    ],
)
def test_what_the_fuzzer_found_is_drawn(
    name: str, old: str, new: str, says: str, tmp_path: Path
) -> None:
    """Forces that are not there in the position asked for; a rim thinner than any dimension; a flank that works
    in one point."""
    text = source(name)
    scene, out = tmp_path / "scene.toml", tmp_path / "out"
    assert old in text
    scene.write_text(text.replace(old, new), encoding="utf-8")
    result = invoke("draw", scene, "-o", out)
    assert (result.exit_code, result.exception) == (0, None), result.output
    assert says in result.stderr
    assert "nan" not in next(out.glob("*.svg")).read_text(encoding="utf-8")


@pytest.mark.slow
def test_a_plan_too_small_to_measure_is_refused(tmp_path: Path) -> None:
    text = source("lever")
    scene, out = tmp_path / "scene.toml", tmp_path / "out"
    scene.write_text(text.replace('mu_l = "0.003 m/mm"', 'mu_l = "4000.0 m/mm"'), encoding="utf-8")
    result = invoke("draw", scene, "-o", out, "-l", "en")
    assert (result.exit_code, out.exists()) == (2, False), result.output
    assert "scales.mu_l: " in result.stderr
    assert "too small to measure" in result.stderr


def test_a_case_is_told_by_its_seed_and_number() -> None:
    assert task(3, 17) == task(3, 17)
    assert task(3, 17) != task(3, 18)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_scene_tells_its_steps(name: str) -> None:
    result = invoke("steps", SHEETS / name)
    assert (result.exit_code, result.exception) == (0, None)


@pytest.mark.parametrize("size", [1e5, 1e9])
def test_hatching_of_what_no_sheet_holds_has_an_end(size: float) -> None:
    """A rim of 95 mm for the windrower's flywheel would be 120 m wide: it is refused, but hatched first."""
    assert len(hatched(shapely.box(0.0, 0.0, size, 100.0))) <= 2 * MOST
    assert len(hatching(0j, complex(size, 0.0), 1)) <= MOST_HATCHES + 1


def test_hatching_of_what_a_sheet_holds_is_what_it_was() -> None:
    assert len(hatching(0j, 100 + 0j, 1)) == 66
    spots = hatched(shapely.box(0.0, 0.0, 841.0, 594.0))
    assert abs(len(spots) - 1435 / 2**0.5 / 2.5) <= 1
