"""A class set and marked by a cluster: the same bytes as by processes; photographs, that no worker can see."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.batches import files_of
from support.command import invoke
from support.gallery import SHEETS
from support.handed_in import SCENE, write_class
from support.photographed import taking

from graphic_tmm.classroom.batch.run import run
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.variant import base

pytestmark = pytest.mark.filterwarnings("default")  # its own
NUMBER = 5


@pytest.mark.turns(1, "cluster")
@pytest.mark.slow
def test_a_cluster_whose_workers_stand_elsewhere_writes_what_processes_write(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_class(tmp_path, 3, positions=8)
    monkeypatch.chdir(tmp_path)
    words = ("mark", SCENE, "handed", "--variants", "variants.csv", "--trials", 40)
    there = invoke(*words, "-o", "there", "--scheduler", scheduler)
    here = invoke(*words, "-o", "here")
    assert (there.exit_code, there.stdout) == (here.exit_code, here.stdout), there.output
    assert here.exit_code == 0, here.output
    found = files_of(tmp_path / "there")
    assert found == files_of(tmp_path / "here")
    assert len([name for name in found if name.startswith("reports/")]) == 6


@pytest.mark.turns(1, "cluster")
@pytest.mark.slow
def test_a_task_and_its_key_are_those_of_processes(scheduler: str, tmp_path: Path) -> None:
    found = works(base(SHEETS / "scotch-yoke"), ())
    run(found, tmp_path / "one", executor=1)
    assert not run(found, tmp_path / "cluster", executor=scheduler).failed
    assert files_of(tmp_path / "cluster") == files_of(tmp_path / "one") != {}


@pytest.mark.turns(1, "cluster")
@pytest.mark.slow
def test_a_photograph_is_judged_as_it_would_be_alone(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By a worker of a cluster, which stands elsewhere and does not see the photograph."""
    pytest.importorskip("PIL.Image")
    from PIL import Image

    scene, sheet = taking.SHEETS[NUMBER]
    place, options = tmp_path / "handed", ("--trials", 40)
    place.mkdir()
    photo = place / f"Иванов_{sheet}.jpg"
    photo.write_bytes(taking.taken(NUMBER, taking.Conditions(wide=1600)).jpeg)
    Image.new("RGB", (600, 400), "white").save(place / "Петров.png")
    monkeypatch.chdir(tmp_path)
    words = ("handed", "--scheduler", scheduler, "-o", "out")
    done = invoke("mark", scene, *words, *options)
    assert done.exit_code == 1, done.output
    alone = invoke(
        "photo", scene, photo, "--sheet", sheet, *options, "-f", "json",
        "--overlay", tmp_path / "under.svg",
    )  # fmt: skip
    assert alone.exit_code in (0, 1), alone.output
    due = json.loads(alone.stdout)
    found = json.loads((tmp_path / "out" / "reports" / "Иванов.json").read_text("utf-8"))
    assert len(due["readings"]) > 20
    for key in ("readings", "mistakes", "counts", "lessons"):
        assert found[key] == due[key]
    assert "Петров" in done.stdout
