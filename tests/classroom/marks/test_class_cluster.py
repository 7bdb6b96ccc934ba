"""A class marked by a cluster: the same bytes as by processes; photographs, too, that no worker can see."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.batches import files_of
from support.cluster import cluster
from support.command import invoke
from support.handed_in import SCENE, write_class
from support.photographed.taking import SHEETS, Conditions, taken

pytest.importorskip("distributed")
pytestmark = pytest.mark.filterwarnings("default")  # its own
TRIALS = ("--trials", 40)
NUMBER = 4


def both(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *words: object) -> dict[str, bytes]:
    """Assert that a cluster whose workers stand elsewhere writes what processes write; return that."""
    pytest.importorskip("PIL.Image")
    with cluster() as address:
        monkeypatch.chdir(tmp_path)
        there = invoke(*words, "-o", "there", "--scheduler", address)
    here = invoke(*words, "-o", "here")
    assert (there.exit_code, there.stdout) == (here.exit_code, here.stdout), there.output
    assert here.exit_code == 0, here.output
    found = files_of(tmp_path / "there")
    assert found == files_of(tmp_path / "here")
    return found


@pytest.mark.slow
def test_tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_class(tmp_path, 3, positions=8)
    table = ("--variants", "variants.csv")
    found = both(tmp_path, monkeypatch, "check", SCENE, "--class", "handed", *table, *TRIALS)
    assert len([name for name in found if name.startswith("reports/")]) == 6


@pytest.mark.slow
def test_photographs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    scene, sheet = SHEETS[NUMBER]
    place = tmp_path / "handed"
    place.mkdir()
    (place / f"Иванов_{sheet}.jpg").write_bytes(taken(NUMBER, Conditions(wide=2400)).jpeg)
    found = both(tmp_path, monkeypatch, "check", scene, "--class", "handed", *TRIALS)
    assert len(found["reports/Иванов.json"]) > 1000
