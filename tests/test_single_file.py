"""The program as one file: it is built, it starts, draws the sheets of the package, and opens the studio."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tomllib
from importlib.util import find_spec
from pathlib import Path
from urllib.request import urlopen

import pytest
from support.gallery import ROOT, SHEETS

from graphic_tmm.commands.shared import single_file
from graphic_tmm.errors import installing

SCENE = "crank-rocker"


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file, built for this system, in a folder with a scene of the person's own."""
    if find_spec("PyInstaller") is None:
        pytest.skip("pyinstaller is missing: pip install -e '.[single]'")
    home = tmp_path_factory.mktemp("single")
    subprocess.run([sys.executable, ROOT / ".ci" / "single_file.py", home], check=True)
    (home / "mine").mkdir()
    shutil.copy(SHEETS / SCENE / "scene.toml", home / "mine")
    (found,) = home.glob("graphic-tmm*")
    return found


def ran(program: Path, *arguments: str, status: int = 0) -> subprocess.CompletedProcess[str]:
    """Run it without anything of this checkout in reach."""
    bare = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    done = subprocess.run(
        [program, *arguments],
        cwd=program.parent,
        env={**bare, "LC_ALL": "C.UTF-8"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == status, done.stderr
    return done


@pytest.mark.slow
def test_it_draws_the_sheets_that_the_package_draws(program: Path) -> None:
    drawn = ran(program, "draw", SCENE, "-f", "svg,pdf", "-o", "out").stdout.split()
    sheets = [Path(path) for path in drawn if path.endswith(".svg")]
    assert [path.name for path in sheets] == [f"{SCENE}-{n}.svg" for n in (1, 2, 3)]
    for path in sheets:
        due = (SHEETS / SCENE / path.name).read_bytes()
        assert (program.parent / path).read_bytes() == due
    assert f"out/{SCENE}.pdf" in drawn or f"out/{SCENE}-1.pdf" in drawn


@pytest.mark.slow
def test_it_has_the_scenes_the_words_and_the_version_of_the_package(program: Path) -> None:
    listed = [line.split()[0] for line in ran(program, "scenes").stdout.splitlines()]
    assert listed == sorted(path.parent.name for path in SHEETS.glob("*/scene.toml"))
    assert "Отсчётов" in ran(program, "check", "engine", _published("engine"), "-l", "ru").stdout
    from graphic_tmm import __version__

    assert ran(program, "--version").stdout.split()[-1] == __version__
    assert f"## {__version__}" in ran(program, "--changes").stdout


def _published(name: str) -> str:
    return str(SHEETS / name / "published.csv")


@pytest.mark.slow
def test_processes_of_its_own_work(program: Path) -> None:
    (program.parent / "variants.csv").write_text("variant,drive.speed\n1,1100 rpm\n2,1300 rpm\n")
    ran(program, "batch", SCENE, "variants.csv", "--make", "table", "-o", "class", "--jobs", "2")
    assert len(list((program.parent / "class").glob(f"?/{SCENE}-?.csv"))) == 2


@pytest.mark.slow
@pytest.mark.parametrize(
    "arguments", [("accuracy", "cam", "-o", "out"), ("page", "cam", "--accuracy", "-o", "out")]
)
def test_a_picture_that_it_cannot_draw_is_refused_in_a_line(
    program: Path, arguments: tuple[str, ...]
) -> None:
    (line,) = ran(program, *arguments, "-l", "en", status=2).stderr.splitlines()
    assert "single file" in line
    assert "pip install matplotlib" in line


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="a browser is named otherwise here")
def test_opened_by_a_click_it_shows_its_own_folder_in_the_browser(
    program: Path, tmp_path: Path
) -> None:
    shown, browser = tmp_path / "shown.txt", tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > {shown}.part && mv {shown}.part {shown}\n')
    browser.chmod(0o755)
    with subprocess.Popen(
        [program],
        cwd=tmp_path,
        env={**os.environ, "BROWSER": str(browser)},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as studio:
        try:
            assert studio.stdout is not None
            address = studio.stdout.readline().strip()
            with urlopen(address, timeout=60) as gallery:
                assert b'"mine"' in gallery.read()
            with urlopen(f"{address}s/mine/events", timeout=60) as events:
                states = (json.loads(line[6:]) for line in events if line.startswith(b"data: "))
                drawn = next(state for state in states if state["page"] or state["errors"])
            assert len(drawn["sheets"]) == 3, drawn
            assert shown.read_text().strip() == address
        finally:
            os.killpg(studio.pid, signal.SIGINT)
    assert studio.returncode == 130


def test_where_nothing_can_be_written_the_documents_are_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "program"))
    assert single_file.studio_arguments() == ["serve", str(tmp_path), "--browser"]
    assert not capsys.readouterr().err
    monkeypatch.setattr(sys, "executable", str(tmp_path / "gone" / "program"))
    assert single_file.studio_arguments()[1] == str(tmp_path)
    (tmp_path / "Documents").mkdir()
    assert single_file.studio_arguments()[1] == str(tmp_path / "Documents")
    assert str(tmp_path / "gone") in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["Documents"]


def test_what_the_file_begins_loads_the_libraries_of_the_system(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    name = "LD_LIBRARY_PATH"
    monkeypatch.setenv(name, "/unpacked")
    monkeypatch.setenv(f"{name}_ORIG", "/own")
    single_file.without_own_libraries()
    assert os.environ[name] == "/own"
    monkeypatch.delenv(f"{name}_ORIG")
    single_file.without_own_libraries()
    assert name not in os.environ


def test_a_remedy_is_one_that_works_there(monkeypatch: pytest.MonkeyPatch) -> None:
    assert installing("[pdf]") == 'pip install "graphic-tmm[pdf]"'
    assert installing("pandas") == "pip install pandas"
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert installing("pandas") == (
        "this single file has no such package; where Python is: pip install pandas"
    )


def test_a_release_is_made_of_what_there_is() -> None:
    """Extras of pyproject.toml, files of the repository; of the newest version there are notes."""
    text = (ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    (extras,) = re.findall(r'-e "\.\[(.*?)\]"', text)
    assert set(extras.split(",")) <= project["optional-dependencies"].keys()
    files = set(re.findall(r"(?:\.ci|graphic_tmm)/[\w./-]+", text))
    assert files == {".ci/lock.txt", ".ci/single_file.py", "graphic_tmm/CHANGES.md"}
    assert all((ROOT / file).is_file() for file in files)
    assert "secrets." not in text
