"""Graphs are read off the log: of all scenes that have some, and of machines drawn at random."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from support.boards import drawn_of
from support.each import each
from support.flywheels import crank, scene_of
from support.gallery import asking, in_usual
from support.graphs import assert_read_off_the_log, graphs

from graphic_tmm.chapters.diagrams.task import KinematicTask
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder

GRAPHS = asking("diagrams", "flywheel", "indicator", "engine")


def assert_graphs(work: Drawn) -> None:
    log, project = work.construction, work.project
    made = graphs(log, work.reading, project.names, project.count)
    assert len(made) >= 2
    assert_read_off_the_log(log, made)


@each("name", GRAPHS)
def test_graphs_of_the_scenes_are_read_off_the_log(name: str) -> None:
    assert_graphs(in_usual(name))


def test_the_scenes_have_graphs_of_every_chapter() -> None:
    assert {"slider-diagrams", "windrower", "engine", "locomobile"} <= set(GRAPHS)


@pytest.mark.slow
@each("seed", range(8), turns=3)
def test_graphs_of_machines_drawn_at_random_are_read_off_the_log(seed: int, tmp_path: Path) -> None:
    start = ("displacement", "velocity")[seed % 2]
    method = ("chords", "tangents")[seed // 2 % 2]
    path = tmp_path / "machine.toml"
    integration = ("areas", "middles", "chords")[seed % 3]
    more = f'integration = "{integration}"'
    path.write_text(scene_of(crank(seed), (8, 12, 17, 24)[seed % 4], more=more), encoding="utf-8")
    order = KinematicTask("B", start=start, method=method)
    sheets = (SheetOrder("A1", ("positions", "velocities", "diagrams", "flywheel")),)
    assert_graphs(drawn_of(replace(read(path), sheets=sheets).asking(diagrams=order), exact=True))
