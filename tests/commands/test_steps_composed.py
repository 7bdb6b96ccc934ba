"""steps: a composition beside the scene is what the sheets are drawn by, and what the protocol tells of."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.gallery import SHEETS

from graphic_tmm.__main__ import main
from graphic_tmm.fitting import fit


@pytest.mark.slow
def test_no_size_is_chosen_where_a_composition_stands_beside(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(SHEETS / "crank-rocker" / "scene.toml", tmp_path)
    shutil.copytree(tmp_path, tmp_path / "alone")
    runner = CliRunner()
    done = runner.invoke(main, ["draw", str(tmp_path), "-o", str(tmp_path), "--composition"])
    assert done.exit_code == 0, done.output
    searched = runner.invoke(main, ["steps", str(tmp_path / "alone")])

    def refused(*args: object) -> None:
        raise AssertionError("sizes are chosen")

    monkeypatch.setattr(fit, "by_rule", refused)
    for command in ("steps", "table", "draw"):
        where = ["-o", str(tmp_path)] if command == "draw" else []
        told = runner.invoke(main, [command, str(tmp_path), *where])
        assert told.exit_code == 0, told.output
        if command == "steps":
            assert told.stdout == searched.stdout
    assert runner.invoke(main, ["steps", str(tmp_path / "alone")]).exit_code != 0
