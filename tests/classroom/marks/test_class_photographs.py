"""Photographs handed in: judged as check --photo judges each; one without a frame is named and skipped."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.command import invoke
from support.photographed.taking import SHEETS, Conditions, taken

NUMBER = 5


@pytest.mark.slow
@pytest.mark.filterwarnings("default")  # of the cluster's
def test_a_photograph_is_judged_as_it_would_be_alone(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By a worker of a cluster, which stands elsewhere and does not see the photograph."""
    pytest.importorskip("PIL.Image")
    from PIL import Image

    scene, sheet = SHEETS[NUMBER]
    place, options = tmp_path / "handed", ("--trials", 40)
    place.mkdir()
    photo = place / f"Иванов_{sheet}.jpg"
    photo.write_bytes(taken(NUMBER, Conditions(wide=1600)).jpeg)
    Image.new("RGB", (600, 400), "white").save(place / "Петров.png")
    monkeypatch.chdir(tmp_path)
    words = ("--class", "handed", "--scheduler", scheduler, "-o", "out")
    done = invoke("check", scene, *words, *options)
    assert done.exit_code == 1, done.output
    alone = invoke(
        "check", scene, "--photo", photo, "--sheet", sheet, *options, "-f", "json",
        "--overlay", tmp_path / "under.svg",
    )  # fmt: skip
    assert alone.exit_code in (0, 1), alone.output
    due = json.loads(alone.stdout)
    found = json.loads((tmp_path / "out" / "reports" / "Иванов.json").read_text("utf-8"))
    assert len(due["readings"]) > 20
    for key in ("readings", "mistakes", "counts", "lessons"):
        assert found[key] == due[key]
    assert "Петров" in done.stdout
