"""The README is true: its worked commands print what it shows, its links lead somewhere, it stays short."""

from __future__ import annotations

import re
import shlex
import textwrap
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.gallery import ROOT

from graphic_tmm.__main__ import main as command_line

README = (ROOT / "README.md").read_text(encoding="utf-8")
GAP = "…"


def examples() -> list[tuple[str, list[str]]]:
    """Return the worked commands: the words after the program's name, and the lines shown under them."""
    section = README.split("## Five commands, worked")[1].split("\n## ")[0]
    blocks = re.findall(r"(?m)(?:^    .*\n)+", section)
    found = []
    for block in blocks:
        first, *shown = [line[4:].rstrip() for line in block.splitlines()]
        if first.startswith("$ graphic-tmm "):
            found.append((first.removeprefix("$ graphic-tmm "), shown))
    return found


def unlike(shown: list[str], printed: list[str]) -> str | None:
    """Return the first line shown that is not printed where it should be; None if all are."""
    at, free = 0, False
    for line in shown:
        if line == GAP:
            free = True
            continue
        rest = printed[at:] if free else printed[at : at + 1]
        if line not in rest:
            return line
        at, free = at + rest.index(line) + 1, False
    return None if free or at == len(printed) else printed[at]


def test_the_judge_of_lines_can_fail() -> None:
    printed = ["a", "b", "c"]
    assert unlike(["a", "b", "c"], printed) is None
    assert unlike(["a", GAP, "c"], printed) is None
    assert unlike(["a", GAP], printed) is None
    assert unlike(["a", "c"], printed) == "c"
    assert unlike([GAP, "d", GAP], printed) == "d"
    assert unlike(["a", "b"], printed) == "c"


def test_five_commands_are_worked() -> None:
    commands = [words.split()[0] for words, _ in examples()]
    assert list(dict.fromkeys(commands)) == ["draw", "table", "steps", "check", "accuracy"]


@pytest.mark.every
@pytest.mark.slow
@pytest.mark.parametrize(("words", "shown"), examples(), ids=lambda x: str(x).split()[0])
def test_worked_commands_print_what_is_shown(
    words: str, shown: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "sheets").symlink_to(ROOT / "sheets")
    monkeypatch.chdir(tmp_path)
    ran = CliRunner().invoke(command_line, shlex.split(words))
    assert ran.exit_code == 0, ran.output
    printed = [line.rstrip() for line in ran.stdout.splitlines()]
    assert shown
    assert unlike(shown, printed) is None


@pytest.mark.slow
def test_what_is_shown_in_python_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The first block draws a scene, the second a construction, whose comment tells what is printed."""
    section = README.split("## In Python")[1].split("\n## ")[0]
    scene, board = re.findall(r"(?m)(?:^    .*\n)+", section)
    monkeypatch.chdir(tmp_path)
    known: dict[str, object] = {}
    exec(textwrap.dedent(scene), known)
    assert not capsys.readouterr().out
    exec(textwrap.dedent(board), known)
    due = re.search(r"# (\d+) mm, as this hand reads it", board)
    assert due
    assert capsys.readouterr().out.startswith(due[1])
    assert sorted(one.name for one in tmp_path.iterdir()) == ["four-bar.svg", "sheet.svg"]


def test_readme_is_short() -> None:
    assert len(README.encode()) <= 10 * 1024


@pytest.mark.parametrize("page", sorted(ROOT.glob("*.md")) + sorted(ROOT.glob("*/**/README.md")))
def test_links_lead_somewhere(page: Path) -> None:
    if any(part.startswith(".") or part == "out" for part in page.relative_to(ROOT).parts):
        return
    links = re.findall(r"\]\(([^)#:]+)[^)]*\)", page.read_text(encoding="utf-8"))
    lost = [link for link in links if not (page.parent / link).exists()]
    assert not lost


def test_the_gallery_shows_every_scene() -> None:
    text = (ROOT / "sheets" / "README.md").read_text(encoding="utf-8")
    shown = set(re.findall(r'<a href="([^"/]+)/">', text))
    assert shown == {path.parent.name for path in (ROOT / "sheets").glob("*/scene.toml")}
    lost = [
        src
        for src in re.findall(r'<img src="([^"]+)"', text)
        if not (ROOT / "sheets" / src).exists()
    ]
    assert not lost
