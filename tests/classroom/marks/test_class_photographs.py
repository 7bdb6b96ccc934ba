"""Photographs handed in: judged as check --photo judges each; one without a frame is named and skipped."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.command import invoke
from support.photographed.taking import SHEETS, Conditions, taken

NUMBER = 4


@pytest.mark.slow
def test_a_photograph_is_judged_as_it_would_be_alone(tmp_path: Path) -> None:
    pytest.importorskip("PIL.Image")
    from PIL import Image

    scene, sheet = SHEETS[NUMBER]
    place = tmp_path / "handed"
    place.mkdir()
    photo = place / f"Иванов_{sheet}.jpg"
    photo.write_bytes(taken(NUMBER, Conditions(wide=2400)).jpeg)
    Image.new("RGB", (600, 400), "white").save(place / "Петров.png")
    options = ("--trials", 40)
    done = invoke("check", scene, "--class", place, *options, "-o", tmp_path / "out")
    assert done.exit_code == 1, done.output
    alone = invoke(
        "check", scene, "--photo", photo, "--sheet", sheet, *options, "-f", "json",
        "--overlay", tmp_path / "under.svg",
    )  # fmt: skip
    assert alone.exit_code in (0, 1), alone.output
    due = json.loads(alone.stdout)
    found = json.loads((tmp_path / "out" / "reports" / "Иванов_.json".replace("_", "")).read_text())
    assert len(due["readings"]) > 20
    for key in ("readings", "mistakes", "counts", "lessons"):
        assert found[key] == due[key]
    assert "Петров" in done.stdout
