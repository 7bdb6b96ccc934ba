"""check: its former options are the commands that they have become."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke

from graphic_tmm.__main__ import main
from graphic_tmm.commands.check import Check

FORMER = [
    (("S", "--template"), "template", {"scene": "S"}),
    (("--template", "S", "--short", "-o", "t.csv"), "template", {"short": True, "output": "t.csv"}),
    (("S", "--class", "F", "-o", "out"), "mark", {"scene": "S", "folder": "F", "output": "out"}),
    (("--class=F", "-l", "ru", "S"), "mark", {"scene": "S", "folder": "F"}),
    (("--trials", "20", "-oout", "--class", "F", "S"), "mark", {"folder": "F", "output": "out"}),
    (("S", "R", "--photo", "P"), "photo", {"scene": "S", "photo": "P", "readings": "R"}),
    (("--photo", "P", "--sheet", "2", "--", "S"), "photo", {"photo": "P", "sheet": 2}),
    (("-q", "-", "--photo=P"), "photo", {"scene": "-", "photo": "P", "readings": None}),
    (("S", "R"), "check", {"scene": "S", "readings": "R"}),
    (("S", "--", "--photo"), "check", {"scene": "S", "readings": "--photo"}),
]


@pytest.mark.parametrize(
    ("words", "name", "values"), FORMER, ids=[" ".join(words) for words, *_ in FORMER]
)
def test_a_former_spelling_is_the_command_that_it_has_become(
    words: tuple[str, ...], name: str, values: dict[str, object]
) -> None:
    check = main.get_command(main.make_context("tmm", ["check"]), "check")
    assert isinstance(check, Check)
    context = check.make_context("check", [*words])
    assert context.command.name == name
    assert {key: context.params.get(key) for key in values} == values


def test_a_former_spelling_prints_what_the_command_prints(tmp_path: Path) -> None:
    former = invoke("check", "cam", "--template", "--short")
    assert former.exit_code == 0
    assert former.stdout == invoke("template", "cam", "--short").stdout != ""
    (tmp_path / "handed").mkdir()
    former = invoke("check", "cam", "--class", tmp_path / "handed", "-l", "en")
    assert (former.exit_code, former.stderr) == (
        2,
        invoke("mark", "cam", tmp_path / "handed", "-l", "en").stderr,
    )


def test_an_option_without_its_value_is_refused() -> None:
    for option in ("--photo", "--class"):
        done = invoke("check", "cam", option)
        assert done.exit_code == 2
        assert option in done.stderr
