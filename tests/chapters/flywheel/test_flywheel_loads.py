"""Loads reduced to the crank by the lever: every one that is not inertia's counts, however it is carried."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.command import printed
from support.scenes import ONLY_POSITIONS

import graphic_tmm

SCENE = Path(graphic_tmm.__file__).parents[1] / "sheets" / "windrower" / "scene.toml"
MOMENT = """[[load]]
link = 3
moment = "40 N*m"

[forces]
couples = "{couples}"
"""


def _segment(folder: Path, forces: str) -> float:
    """Return cd, mm, of the flywheel of the windrower with other loads."""
    file = folder / "scene.toml"
    task = SCENE.read_text("utf-8").partition("[diagrams]")[0]
    file.write_text(task.replace("[forces]\n", forces) + ONLY_POSITIONS, encoding="utf-8")
    told = json.loads(printed("table", file, "-f", "json", "--exact"))
    return float(told["results"]["cd"]["value"])


@pytest.mark.slow
def test_a_moment_does_the_same_work_as_a_pair_of_forces(tmp_path: Path) -> None:
    moment, pair = (
        _segment(tmp_path, MOMENT.format(couples=couples)) for couples in ("moment", "pair")
    )
    assert pair == pytest.approx(moment, rel=1e-12)
    assert abs(moment - _segment(tmp_path, "[forces]\n")) > 1.0
