"""What one touches to add something: done in a copy, in so many files as the architecture says."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support.gallery import ROOT, SHEETS

SHEET = """
import sys
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheet_files
text = open(sys.argv[1]).read().replace('format = "A4"', 'format = "A3"')
open("scene.toml", "w").write(text)
(first, *_) = sheet_files(read("scene.toml"))[1].values()
print(first[:400])
"""
FORMULA = """
import numpy as np
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.chapters.gears import formulas
print(OPERATIONS["whole_depth"].run(np.array([[2.0]]), np.array([[0.25]])), OPERATIONS["whole_depth"].sentence)
"""
OPERATION = """
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.operations import instruments
from graphic_tmm.language.catalogue import speaking
print(OPERATIONS["mark_off"].sentence, speaking("ru")(OPERATIONS["mark_off"].sentence), sep=" | ")
"""


def added(folder: Path, edits: dict[str, tuple[str, str]], code: str, *arguments: str) -> str:
    """Return what a program prints with a copy of the package in which files (old, new) were edited."""
    copy = folder / "graphic_tmm"
    shutil.copytree(ROOT / "graphic_tmm", copy, ignore=shutil.ignore_patterns("__pycache__"))
    for name, (old, new) in edits.items():
        text = (copy / name).read_text(encoding="utf-8")
        assert old in text
        (copy / name).write_text(text.replace(old, new, 1), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        cwd=folder,
        env={"PYTHONPATH": str(folder), "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_a_format_is_one_file(tmp_path: Path) -> None:
    line = '        "A1 portrait": Format('
    new = f'        "A3": Format(420.0, 297.0, 0.6, 160.0, 60.0),\n{line}'
    scene = str(SHEETS / "slider-diagrams" / "scene.toml")
    told = added(tmp_path, {"paper/formats.py": (line, new)}, SHEET, scene)
    assert 'width="420mm"' in told
    assert 'viewBox="0 0 420 297"' in told


@pytest.mark.slow
def test_a_formula_is_one_file(tmp_path: Path) -> None:
    line = "@formula\ndef working_distance("
    new = (
        "@formula\ndef whole_depth(m: Number, c: Number) -> Number:\n"
        f'    """2·{{m}} + {{c}}·{{m}}"""\n\n\n{line}'
    )
    told = added(tmp_path, {"chapters/gears/formulas.py": (line, new)}, FORMULA)
    assert told.split() == ["[[4.5]]", "2·{m}", "+", "{c}·{m}"]


@pytest.mark.slow
def test_an_instrument_operation_is_two_files(tmp_path: Path) -> None:
    line = "@operation(fails=_NO_LINE)\ndef join("
    new = (
        "@operation()\ndef mark_off(on: Line) -> Point:\n"
        f'    """Mark off the beginning {{it}} of {{on}}."""\n    return Point(on.at)\n\n\n{line}'
    )
    entry = 'msgid "Draw the line {it} through {start} and {end}."'
    word = 'msgid "Mark off the beginning {it} of {on}."\nmsgstr "Отметить начало {it} прямой {on}."\n\n'
    edits = {
        "board/operations/instruments.py": (line, new),
        "language/ru.po": (entry, word + entry),
    }
    told = added(tmp_path, edits, OPERATION)
    assert "Mark off the beginning {it} of {on}. | Отметить начало {it} прямой {on}." in told
