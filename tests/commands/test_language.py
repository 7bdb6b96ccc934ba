"""In whose language a person is answered: the one asked for, else the scene's, else the terminal's."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from support.found_once import found_once as found_once
from support.turns import in_turn

from graphic_tmm.__main__ import main

SCENE = 'title = "t"\nlanguage = "{language}"\ncolour = "red"\n'
RUSSIAN = re.compile("[а-яё]{4}")


def invoke(*arguments: object, locale: str = "C") -> Result:
    return CliRunner(env={"LC_ALL": locale}).invoke(main, [str(a) for a in arguments])


@pytest.fixture
def readings(tmp_path: Path) -> Path:
    """Readings without a column that they need."""
    file = tmp_path / "r.csv"
    file.write_text("position,segment,mm\n", encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("scene", "asked", "locale", "russian"),
    [
        ("engine", (), "C", True),
        ("engine", ("-l", "en"), "ru_RU.UTF-8", False),
        ("crank-rocker", (), "ru_RU.UTF-8", False),
        ("crank-rocker", ("--language=ru",), "C", True),
        ("crank-rocker", ("--language", "ru"), "C", True),
    ],
)
def test_an_error_behind_a_scene(
    scene: str, asked: tuple[str, ...], locale: str, russian: bool, readings: Path
) -> None:
    done = invoke("check", scene, readings, *asked, locale=locale)
    assert done.exit_code == 2
    assert bool(RUSSIAN.search(done.stderr)) == russian
    assert ("is missing; add it" in done.stderr) != russian


@pytest.mark.parametrize(
    ("locale", "russian"),
    [("ru_RU.UTF-8", True), ("ru", True), ("C", False), ("de_DE.UTF-8", False), ("", False)],
)
def test_without_a_scene_it_is_the_terminals(
    locale: str, russian: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for arguments in (["--help"], ["draw", "--help"], ["draw", "no-such-scene"], ["drow"]):
        done = invoke(*arguments, locale=locale)
        assert bool(RUSSIAN.search(done.output)) == russian, done.output


def test_a_scene_that_cannot_be_read_is_refused_in_its_language(tmp_path: Path) -> None:
    faults = "".join(f"fault{k} = 1\n" for k in range(60))
    for language, told in (("ru", "и ещё"), ("en", "more faults; put these right first")):
        scene = tmp_path / f"{language}.toml"
        scene.write_text(SCENE.format(language=language) + faults, encoding="utf-8")
        done = invoke("draw", scene)
        assert done.exit_code == 2
        assert told in done.stderr


def test_help_of_every_command_is_whole_in_russian() -> None:
    for name in main.list_commands(None):  # type: ignore[arg-type]
        done = invoke(name, "--help", "-l", "ru")
        assert done.exit_code == 0
        body = done.output.split("\n", 1)[1]
        english = re.findall(r"\b[a-z]{4,} [a-z]{3,} [a-z]{3,}\b", body)
        assert not english, (name, english)


def test_a_sheet_is_drawn_in_the_language_asked_for(tmp_path: Path) -> None:
    done = invoke("draw", "accelerating-crank", "-o", tmp_path, "-l", "ru")
    drawn = Path(done.stdout.splitlines()[0]).read_text(encoding="utf-8")
    assert 'lang="ru"' in drawn
    assert "План положений" in drawn


@pytest.mark.turns(1)
@pytest.mark.parametrize(
    ("arguments", "russian"),
    [
        (("table", "crank-rocker", "-l", "ru"), True),
        (("table", "crank-rocker"), False),
        (("steps", "crank-rocker", "-p", "scales", "-l", "ru"), True),
        (("steps", "oscillating-cylinder", "-p", "scales", "-l", "en"), False),
    ],
)
def test_what_is_printed_is_in_the_language_asked_for(
    arguments: tuple[str, ...], russian: bool
) -> None:
    done = invoke(*arguments)
    assert done.exit_code == 0
    assert bool(RUSSIAN.search(done.stdout)) == russian


@pytest.mark.slow
@pytest.mark.usefixtures("found_once")
def test_steps_tell_the_scale_factors_of_the_sheets_in_that_language(tmp_path: Path) -> None:
    """Words are wider in one language than in another, so each has scale factors of its own."""
    marks = (("ru", r"μ_v = ([\d,]+) \(м/с\)/мм"), ("en", r"μ_v = ([\d.]+) \(m/s\)/mm"))
    for language, mark in in_turn(marks, 1):
        assert (
            invoke("draw", "crank-press", "-o", tmp_path / language, "-l", language).exit_code == 0
        )
        files = (tmp_path / language).glob("*.svg")
        drawn = {one for file in files for one in re.findall(mark, file.read_text("utf-8"))}
        told = invoke("steps", "crank-press", "-p", "scales", "-l", language).stdout
        assert drawn == set(re.findall(mark, told))
