"""A command is a file: put there it is found, and nothing else has to know of it."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphic_tmm import commands
from graphic_tmm.__main__ import main

HELLO = '''
import click

@click.command()
@click.argument("name")
def hello(name: str) -> None:
    """Greet NAME."""
    click.echo(f"hello, {name}")
'''


def test_a_new_command_is_one_new_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "hello.py").write_text(HELLO, encoding="utf-8")
    monkeypatch.setattr(commands, "__path__", [*commands.__path__, str(tmp_path)])
    listed = CliRunner().invoke(main, ["--help"])
    assert "hello     Greet NAME." in listed.stdout
    assert CliRunner().invoke(main, ["hello", "board"]).stdout == "hello, board\n"
    sys.modules.pop("graphic_tmm.commands.hello")
    assert CliRunner().invoke(main, ["goodbye"]).exit_code == 2


def test_what_commands_share_is_no_command() -> None:
    assert CliRunner().invoke(main, ["shared"]).exit_code == 2


def test_a_command_loads_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "graphic_tmm.commands.accuracy", raising=False)
    assert CliRunner().invoke(main, ["schema", "--help"]).exit_code == 0
    assert "graphic_tmm.commands.accuracy" not in sys.modules


def test_the_changes_are_printed_the_newest_first_in_both_languages() -> None:
    ended = CliRunner().invoke(main, ["--changes"])
    text = (Path(commands.__file__).parents[1] / "CHANGES.md").read_text(encoding="utf-8")
    assert (ended.exit_code, ended.stdout) == (0, text)
    versions = [line for line in text.splitlines() if line.startswith("## ")]
    assert versions == sorted(
        versions, key=lambda one: [int(n) for n in one[3:].split(".")], reverse=True
    )
    assert "--changes" in CliRunner().invoke(main, ["--help"]).stdout
    assert "Показать, что изменилось" in CliRunner().invoke(main, ["--help", "-l", "ru"]).stdout
