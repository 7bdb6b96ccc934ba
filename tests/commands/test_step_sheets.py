"""steps --sheets: files whole or none, the same bytes twice, refusals with a remedy, any mechanism."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from support.boards import in_usual_size
from support.command import invoke
from support.refusals import refused
from support.sheets_of_random import scenes

from graphic_tmm.handout.handout import handout, handout_files
from graphic_tmm.readers.protocol import plans
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

TASK = "slider-diagrams"


def written(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def test_the_sheets_are_written_and_told(tmp_path: Path) -> None:
    done = invoke("steps", TASK, "--sheets", "-p", "velocities", "-n", "1", "-o", tmp_path)
    assert done.exit_code == 0, done.output
    files = written(tmp_path)
    assert done.stdout.split() == [str(tmp_path / name) for name in files]
    assert {name.rpartition("-")[0] for name in files} == {f"{TASK}-steps"}
    assert all(text.startswith(b"<svg") for text in files.values())
    first = next(iter(files.values())).decode()
    assert "Обзор кадров" in first


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_sheets_speak_the_language_asked_for(language: str, tmp_path: Path) -> None:
    done = invoke("steps", "-l", language, TASK, "--sheets", "-p", "positions", "-o", tmp_path)
    assert done.exit_code == 0, done.output
    text = "".join(data.decode() for data in written(tmp_path).values())
    assert f'xml:lang="{language}"' in text


@pytest.mark.slow
def test_the_same_bytes_twice() -> None:
    folder = Path(__file__).parents[2] / "sheets" / TASK
    first, second = (
        handout_files(make(read(folder)), ("velocities", "diagrams"), None, ("svg",))
        for _ in range(2)
    )
    assert first == second
    assert len(first) > 3


def test_a_pdf_is_one_file(tmp_path: Path) -> None:
    pytest.importorskip("typst")
    done = invoke("steps", TASK, "--sheets", "-p", "velocities", "-f", "pdf,svg", "-o", tmp_path)
    assert done.exit_code == 0, done.output
    names = list(written(tmp_path))
    assert names[-1] == f"{TASK}-steps.pdf"
    assert len(names) > 3


@pytest.mark.turns(3)
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("-p", "forces"), ["--plan", "the scene has no plan forces", "velocities"]),
        (("-p", "scales"), ["--plan", "nothing is drawn of scales", "leave out --sheets"]),
        (("-n", "99"), ["--position", "there is no 99"]),
        (("-p", "velocities", "-n", "x"), ["--position", "there is no x"]),
        (("-f", "dxf"), ["--format: no dxf", "svg, pdf, png"]),
        (("-f", "svg,bmp"), ["--format: no bmp"]),
        (("-o", "wall"), ["cannot write into wall", "with -o"]),
    ],
    ids=lambda words: " ".join(words) if isinstance(words, tuple) else "",
)
def test_what_is_wrong_is_refused_and_nothing_written(
    arguments: tuple[str, ...], words: list[str], tmp_path: Path
) -> None:
    (tmp_path / "wall").write_text("a file")
    home = os.getcwd()
    os.chdir(tmp_path)
    try:
        done = invoke("steps", "-l", "en", TASK, "--sheets", *arguments)
    finally:
        os.chdir(home)
    refused(done, *words)
    assert [path.name for path in tmp_path.iterdir()] == ["wall"]


def test_a_plan_that_a_position_has_not_is_refused(tmp_path: Path) -> None:
    done = invoke(
        "steps",
        "-l",
        "en",
        "crank-rocker",
        "--sheets",
        "-p",
        "accelerations",
        "-n",
        "1",
        "-o",
        tmp_path,
    )
    refused(done, "position 1 has no plan of accelerations", "2")
    assert not list(tmp_path.iterdir())


def test_a_format_belongs_to_sheets() -> None:
    refused(invoke("steps", "-l", "en", TASK, "-f", "svg"), "add --sheets")


@pytest.mark.slow
def test_random_mechanisms_are_handed_out(tmp_path: Path, many: Callable[[int, int], int]) -> None:
    for k, text in enumerate(scenes(many(6, 1))):
        file = tmp_path / f"random-{k}.toml"
        file.write_text(text, encoding="utf-8")
        found = handout(in_usual_size(read(file)), plans(), None)
        assert len(found) > 2
        assert {sheet.format for sheet in found} == {"A4"}
