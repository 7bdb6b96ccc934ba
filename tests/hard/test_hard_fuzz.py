"""Three hundred changed scene files, the same ones each time; more by ``python tests/hard/fuzz.py``."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner
from fuzz import case, changed
from gallery import NAMES, SHEETS

from graphic_tmm.__main__ import main

QUICK = ("crank-rocker", "scotch-yoke", "tangent-mechanism", "planetary", "gear-pair", "slider-diagrams")
"""Scenes that are drawn in a fraction of a second."""


@pytest.mark.parametrize("first", range(0, 300, 50))
def test_changed_scenes_are_drawn_or_refused(first: int) -> None:
    found = [case(number, 1, QUICK) for number in range(first, first + 50)]
    faults = [one for one in found if one.fault and "takes" not in one.fault]
    assert not faults, faults
    # a machine may be busy with other things; a hang of 30 s is a fault on any
    assert {one.status for one in found} == {0, 2}


def test_a_case_is_told_by_its_seed_and_number() -> None:
    assert changed(3, 17) == changed(3, 17)
    assert changed(3, 17) != changed(3, 18)


@pytest.mark.parametrize("name", NAMES)
def test_every_scene_tells_its_steps(name: str) -> None:
    result = CliRunner().invoke(main, ["steps", str(SHEETS / name)])
    assert (result.exit_code, result.exception) == (0, None)


def test_a_sketch_that_no_sheet_holds_is_refused_at_once(tmp_path: Path) -> None:
    """A rim of 95 mm for the windrower's flywheel would be 120 m wide: refused before it is hatched."""
    text = (SHEETS / "windrower" / "scene.toml").read_text(encoding="utf-8")
    path = tmp_path / "scene.toml"
    path.write_text(text.replace('D_e      = "0.6 m"', 'D_e      = "95 mm"'), encoding="utf-8")
    result = CliRunner().invoke(main, ["draw", str(path), "-o", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert "does not fit" in result.stderr
    assert not (tmp_path / "out").exists()
