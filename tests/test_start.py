"""The guides to one's own variant are true: their commands run in turn on the scene that they tell to write."""

from __future__ import annotations

import csv
import re
import shlex
from pathlib import Path

import pytest
from docx import Document as read_docx
from support.command import invoke
from support.gallery import SHEETS

from graphic_tmm.checking.readings.csv_cells import heads
from graphic_tmm.scene.read import read

LANGUAGES = ("en", "ru")


def guide(language: str) -> str:
    return (SHEETS / f"start.{language}.md").read_text(encoding="utf-8")


def commands(text: str) -> list[list[str]]:
    return [shlex.split(line) for line in re.findall(r"(?m)^    \$ graphic-tmm (.*)$", text)]


def edited(file: Path, blocks: list[str]) -> None:
    """Write into a scene what the guide says: the values of keys that are there, then further sections."""
    values, *sections = blocks
    text = file.read_text(encoding="utf-8")
    for line in values.splitlines():
        key = line.split()[0]
        text, count = re.subn(rf'(?m)^({key} *= )"[^"]*"', rf"\1{line.partition('= ')[2]}", text)
        assert count == 1, key
    file.write_text("\n".join([text, *sections]), encoding="utf-8")


def filled(file: Path, table: Path) -> None:
    """Fill in a template with the mm of a table, as if they had been measured."""
    told = csv.reader(table.read_text("utf-8-sig").splitlines(), delimiter=_separator(table))
    lengths = {(plan, position, segment): mm for plan, position, _, segment, mm, *_ in told}
    rows = list(csv.reader(file.read_text("utf-8-sig").splitlines(), delimiter=_separator(file)))
    for row in rows[1:]:
        row[3] = lengths.get((row[0], row[1], row[2]), "")
    assert sum(bool(row[3]) for row in rows[1:]) > 40
    text = "\n".join(_separator(file).join(row) for row in rows)
    file.write_text(text, encoding="utf-8")


def _separator(file: Path) -> str:
    return ";" if ";" in file.read_text("utf-8-sig").partition("\n")[0] else ","


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_command_of_the_guide_does_what_it_says(
    language: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LC_ALL", language)
    text = guide(language)
    blocks = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)
    for words in commands(text):
        target = words[words.index(">") + 1] if ">" in words else ""
        if words[:2] == ["check", "variant"] and words[2] == "readings.csv":
            filled(Path("readings.csv"), Path("table.csv"))
        done = invoke(*words[: words.index(">")] if target else words)
        assert done.exit_code == 0, (words, done.output)
        assert done.stderr == "", words
        if target:
            Path(target).write_text(done.stdout, encoding="utf-8")
        if words[:2] == ["new", "variant"]:
            edited(Path("variant/scene.toml"), blocks)
            assert read(Path("variant")).language == language
    assert list(Path("out").glob("variant*.svg"))
    assert "2026" in "".join(one.text for one in read_docx("out/variant-note.docx").paragraphs)
    assert len(Path("steps.txt").read_text(encoding="utf-8").splitlines()) > 10


def test_the_guides_tell_the_same() -> None:
    """The same commands, but for decimal commas; the same links and headings; the same mechanism."""
    first, second = (commands(guide(language)) for language in LANGUAGES)
    assert [words[0] for words in first] == [words[0] for words in second]
    links = [re.findall(r"\]\((\.\./[^)]*)\)", guide(language)) for language in LANGUAGES]
    assert links[0] == links[1]
    assert guide("en").count("\n## ") == guide("ru").count("\n## ") == 5


@pytest.mark.parametrize("language", LANGUAGES)
def test_links_of_a_guide_lead_somewhere(language: str) -> None:
    for link in re.findall(r"\]\(([^)#]*)", guide(language)):
        assert (SHEETS / link).exists(), link


def test_a_template_has_its_mm_in_the_fourth_column() -> None:
    assert all(tuple(heads(language))[3] in ("mm", "мм") for language in LANGUAGES)
