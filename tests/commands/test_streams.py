"""Standard input as a scene or as readings; names completed by the shell; progress that is not shown."""

from __future__ import annotations

import io
import json
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from support.command import column, invoke, printed, tabled
from support.scenes import source

from graphic_tmm.__main__ import main
from graphic_tmm.commands.shared import telling
from graphic_tmm.scene.packaged import packaged


def fed(text: str, *arguments: str) -> Result:
    return CliRunner().invoke(main, list(arguments), input=text)


@pytest.mark.parametrize("words", [("steps", "-p", "velocities"), ("table", "-f", "csv")])
def test_a_scene_comes_from_standard_input(words: tuple[str, ...]) -> None:
    command, *options = words
    done = fed(source("crank-rocker"), command, "-", *options)
    assert done.exit_code == 0, done.output
    assert done.stdout == printed(command, "crank-rocker", *options)


def test_a_fault_of_standard_input_has_its_line() -> None:
    done = fed("title = 1\n", "table", "-", "-l", "en")
    assert done.exit_code == 2
    assert "-:1: title" in done.stderr


def test_sheets_of_standard_input_have_a_name(tmp_path: Path) -> None:
    done = fed(source("gear-pair"), "draw", "-", "-o", str(tmp_path))
    assert done.exit_code == 0, done.output
    assert done.stdout.split() == [f"{tmp_path}/scene.svg"]


@pytest.mark.slow
def test_readings_come_from_standard_input() -> None:
    readings = "plan,position,segment,mm\nvelocities,1,pb,{}\n"
    right = column(tabled("slider-diagrams"), "velocities", "pb")["mm"][1]
    done = fed(readings.format(right), "check", "slider-diagrams", "-", "-f", "json")
    assert done.exit_code == 0, done.output
    assert [one["verdict"] for one in json.loads(done.stdout)["readings"]] == ["fine"]
    wrong = fed(readings.format(right + 20), "check", "slider-diagrams", "-")
    assert wrong.exit_code == 1


def test_standard_input_is_one_thing() -> None:
    done = fed("", "check", "-", "-", "-l", "en")
    assert done.exit_code == 2
    assert "not both" in done.stderr


@pytest.mark.parametrize("command", ["draw", "table", "steps", "check", "accuracy"])
def test_the_shell_completes_names_of_scenes(command: str) -> None:
    told = {"_GRAPHIC_TMM_COMPLETE": "bash_complete", "COMP_CWORD": "2"}
    words = {"COMP_WORDS": f"graphic-tmm {command} crank"}
    done = CliRunner().invoke(main, [], prog_name="graphic-tmm", env=told | words)
    assert done.exit_code == 0, done.output
    names = [line.removeprefix("plain,") for line in done.stdout.splitlines()]
    assert [n for n in names if not n.startswith("file,")] == [
        path.name for path in packaged() if path.name.startswith("crank")
    ]


def test_the_shell_completes_mechanisms() -> None:
    told = {"_GRAPHIC_TMM_COMPLETE": "bash_complete", "COMP_CWORD": "3"}
    words = {"COMP_WORDS": "graphic-tmm new mine to"}
    done = CliRunner().invoke(main, [], prog_name="graphic-tmm", env=told | words)
    assert done.stdout.split() == ["plain,toggle"]


class Terminal(io.StringIO):
    """A stream that takes itself for a terminal."""

    def isatty(self) -> bool:
        """Return that it is one."""
        return True


@pytest.mark.parametrize("quiet", [True, False])
def test_a_quiet_command_shows_no_progress(quiet: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    import click

    from graphic_tmm.commands.shared.spoken import Command

    shown = Terminal()
    monkeypatch.setattr(telling, "PATIENCE", 0.0)
    monkeypatch.setenv("TERM", "xterm")

    @click.command(cls=Command)
    def slow() -> None:
        import threading

        monkeypatch.setattr(sys, "stderr", shown)
        with telling.waiting("drawing"):
            for one in threading.enumerate():
                if isinstance(one, threading.Timer):
                    one.join()

    CliRunner().invoke(slow, ["--quiet"] if quiet else [])
    assert ("drawing" in shown.getvalue()) is not quiet


@pytest.mark.parametrize("command", ["table", "steps", "check", "draw", "accuracy"])
def test_every_long_command_can_be_quiet(command: str) -> None:
    assert "--quiet" in invoke(command, "--help", "-l", "en").stdout
