"""The guides to one's own variant are true: their commands run in turn on the scene that they tell to write."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest
from docx import Document as read_docx
from support.command import invoke
from support.gallery import ROOT, SHEETS
from support.guides import LANGUAGES, blocks, commands, filled, guide, typed, unlike_in_shells
from support.real_server import serving

from graphic_tmm.checking.readings.csv_cells import heads
from graphic_tmm.scene.read import read

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def edited(file: Path, told: list[str]) -> None:
    """Write into a scene what the guide says: the values of keys that are there, then further sections."""
    values, *sections = told
    text = file.read_text(encoding="utf-8")
    for line in values.splitlines():
        key = line.split()[0]
        text, count = re.subn(rf'(?m)^({key} *= )"[^"]*"', rf"\1{line.partition('= ')[2]}", text)
        assert count == 1, key
    file.write_text("\n".join([text, *sections]), encoding="utf-8")


@pytest.mark.slow
def test_every_command_of_the_guide_does_what_it_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, many: Callable[[int, int], int]
) -> None:
    """In Russian, with decimal commas and words of its own; in both languages when measured."""
    for language in LANGUAGES if many(1, 0) else ("ru",):
        (folder := tmp_path / language).mkdir()
        monkeypatch.chdir(folder)
        monkeypatch.setenv("LC_ALL", language)
        _followed(language)


def _followed(language: str) -> None:
    text = guide("start", language)
    for words in commands(text):
        if words[:2] == ["check", "variant"] and words[2] == "readings.csv":
            filled(Path("readings.csv"), Path("table.csv"))
        if words[0] == "serve":
            with serving(Path(words[1])) as server:
                assert server.ask("/")[0] in (200, 307)  # one scene is shown at once
            continue
        done = invoke(*words)
        assert done.exit_code == 0, (words, done.output)
        assert done.stderr == "", words
        if words[:2] == ["new", "variant"]:
            edited(Path("variant/scene.toml"), blocks(text))
            assert read(Path("variant")).language == language
    assert list(Path("out").glob("variant*.svg"))
    assert "2026" in "".join(one.text for one in read_docx("out/variant-note.docx").paragraphs)
    assert Path("variant/composition.toml").exists()
    assert f'lang="{language}"' in Path("out/variant.html").read_text(encoding="utf-8")
    assert f'lang="{language}"' in Path("report.html").read_text(encoding="utf-8")
    assert len(Path("steps.txt").read_text(encoding="utf-8").splitlines()) > 10


def test_the_guides_tell_the_same() -> None:
    """The same commands, but for decimal commas; the same links and headings; the same mechanism."""
    first, second = (commands(guide("start", language)) for language in LANGUAGES)
    known, own = {"ускорения": "accelerations"}, {*LANGUAGES, "--decimal", "comma", "--bom"}
    assert [[w for w in words if w not in own] for words in first] == [
        [known.get(w, w) for w in words if w not in own] for words in second
    ]
    links = [
        [
            link.replace(".ru.", ".")
            for link in re.findall(r"\]\((\.\./[^)]*)\)", guide("start", one))
        ]
        for one in LANGUAGES
    ]
    assert links[0] == links[1]
    assert guide("start", "en").count("\n## ") == guide("start", "ru").count("\n## ") == 5


@pytest.mark.parametrize("language", LANGUAGES)
def test_links_of_a_guide_lead_somewhere(language: str) -> None:
    for link in re.findall(r"\]\(([^)#]*)", guide("start", language)):
        assert (SHEETS / link).exists(), link


def test_a_template_has_its_mm_in_the_fourth_column() -> None:
    assert all(tuple(heads(language))[3] in ("mm", "мм") for language in LANGUAGES)


@pytest.mark.parametrize("name", ["start", "class"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_line_to_type_is_understood_alike_by_cmd_powershell_and_sh(
    name: str, language: str
) -> None:
    """No single quotes, no redirection, nothing to activate; an extra that is named is one."""
    lines = typed(guide(name, language))
    assert len(lines) > 5
    assert [line for line in lines if unlike_in_shells(line)] == []
    extras = {
        one for line in lines for one in re.findall(r"\w+", "".join(re.findall(r"\[(.*)\]", line)))
    }
    assert extras
    assert extras <= set(PROJECT["optional-dependencies"])
    both = [line.split("pip", 1)[1] for line in lines if "pip install" in line]
    assert len(both) == 2  # for Windows, and elsewhere
    assert len(set(both)) == 1


def test_what_shells_take_otherwise_is_found() -> None:
    for line in (
        "pip install '.[pdf]'",
        "table x > y.csv",
        ". .venv/bin/activate",
        r"Scripts\activate",
    ):
        assert unlike_in_shells(line)
    assert not unlike_in_shells(r'.venv\Scripts\pip install ".[pdf]"')
