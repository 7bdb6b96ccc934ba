"""A language is one file: a made-up one is put beside the others, and sheets, tables and errors speak it."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support.messages import PACKAGE, messages

from graphic_tmm.language import catalogue

SHEETS = PACKAGE.parent / "sheets"
WORD = re.compile(r"(?<![{_^\\<\w])[A-Za-z]{3,}(?![\w}])")


def backwards(text: str) -> str:
    """Return an English text in a made-up language: every word of three letters and more backwards."""
    return WORD.sub(lambda found: found[0][::-1], text)


def quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of catalogues with one more, of the language called xx."""
    folder = tmp_path_factory.mktemp("catalogues")
    shutil.copy(catalogue.FOLDER / "ru.po", folder)
    lines = ['msgid ""', 'msgstr "Plural-Forms: nplurals=2; plural=n != 1;\\n"', ""]
    for one in messages():
        same = one.context.startswith(("index", "unit", "standard", "decimal"))
        told = one.text if same else backwards(one.text)
        lines += [f"msgctxt {quoted(one.context)}"] if one.context else []
        lines += [f"msgid {quoted(one.text)}"]
        if one.plural:
            lines += [f"msgid_plural {quoted(one.plural)}", f"msgstr[0] {quoted(told)}"]
            lines += [f"msgstr[1] {quoted(backwards(one.plural))}", ""]
        else:
            lines += [f"msgstr {quoted(told)}", ""]
    (folder / "xx.po").write_text("\n".join(lines), encoding="utf-8")
    return folder


def run(folder: Path, *arguments: object) -> subprocess.CompletedProcess[str]:
    """Run the program with the catalogues of a folder."""
    script = (
        "import sys; from pathlib import Path; from graphic_tmm.language import catalogue;"
        "catalogue.FOLDER = Path(sys.argv.pop(1));"
        "from graphic_tmm.__main__ import main; main()"
    )
    command = [sys.executable, "-c", script, folder, *arguments]
    return subprocess.run(
        [str(one) for one in command], capture_output=True, encoding="utf-8", check=False
    )


@pytest.mark.slow
def test_a_scene_is_drawn_in_it(folder: Path, tmp_path: Path) -> None:
    text = (SHEETS / "accelerating-crank" / "scene.toml").read_text(encoding="utf-8")
    mine = tmp_path / "scene.toml"
    mine.write_text(
        re.sub("^language *= .*", 'language = "xx"', text, flags=re.M), encoding="utf-8"
    )
    assert 'language = "xx"' in mine.read_text(encoding="utf-8")
    done = run(folder, "draw", mine, "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    drawn = "".join(Path(line).read_text(encoding="utf-8") for line in done.stdout.splitlines())
    for said in ("Plan of positions", "Acceleration plan", "Legal owner"):
        assert backwards(said) in drawn
        assert said not in drawn
    steps = run(folder, "steps", mine, "-p", "velocities", "-n", "1").stdout
    assert backwards("mark") in steps
    assert not re.search(r"\b(mark|draw|Measure|Calculate)\b", steps)


def test_errors_and_helps_are_said_in_it(folder: Path, tmp_path: Path) -> None:
    done = run(folder, "draw", tmp_path / "nothing", "-l", "xx")
    assert done.returncode == 2
    assert backwards("there is no such file") in done.stderr
    helped = run(folder, "draw", "--help", "--language", "xx").stdout
    assert backwards("Folder for the sheets.") in helped
    assert backwards("Usage:") in helped
    assert "[en|ru|xx]" in helped
