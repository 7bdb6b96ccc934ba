"""A class marked by a cluster: the same bytes as by processes."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.batches import files_of
from support.command import invoke
from support.handed_in import SCENE, write_class

pytestmark = pytest.mark.filterwarnings("default")  # its own


@pytest.mark.slow
def test_a_cluster_whose_workers_stand_elsewhere_writes_what_processes_write(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_class(tmp_path, 3, positions=8)
    monkeypatch.chdir(tmp_path)
    words = ("check", SCENE, "--class", "handed", "--variants", "variants.csv", "--trials", 40)
    there = invoke(*words, "-o", "there", "--scheduler", scheduler)
    here = invoke(*words, "-o", "here")
    assert (there.exit_code, there.stdout) == (here.exit_code, here.stdout), there.output
    assert here.exit_code == 0, here.output
    found = files_of(tmp_path / "there")
    assert found == files_of(tmp_path / "here")
    assert len([name for name in found if name.startswith("reports/")]) == 6
