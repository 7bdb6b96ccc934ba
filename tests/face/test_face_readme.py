"""What the documentation of the face shows is what happens: its page, its docstrings, the notebook."""

from __future__ import annotations

import doctest
import json
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from support.each import each
from support.gallery import ROOT, SHEETS

PAGE = ROOT / "graphic_tmm" / "face" / "README.md"
NOTEBOOK = SHEETS / "notebook.ipynb"
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
TOLD = ["reading", "drawn", "tables", "steps", "sheets", "checks", "board"]


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder of one's own: what the examples write stands there."""
    monkeypatch.chdir(tmp_path)


@pytest.mark.slow
def test_the_page_of_the_face_is_true() -> None:
    found = doctest.testfile(str(PAGE), module_relative=False, optionflags=FLAGS, encoding="utf-8")
    assert found.attempted > 30
    assert found.failed == 0


@each("name", [*(f"graphic_tmm.face.{one}" for one in TOLD), "graphic_tmm.scene.records"])
@pytest.mark.slow
def test_the_examples_of_docstrings_are_true(name) -> None:
    found = doctest.testmod(import_module(name), optionflags=FLAGS)
    assert found.attempted
    assert found.failed == 0


def cells() -> list[dict[str, Any]]:
    told = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    assert told["nbformat"] == 4
    found: list[dict[str, Any]] = told["cells"]
    return found


@pytest.mark.slow
def test_every_cell_of_the_notebook_runs() -> None:
    pytest.importorskip("matplotlib").use("Agg")
    names: dict[str, Any] = {}
    code = ["".join(cell["source"]) for cell in cells() if cell["cell_type"] == "code"]
    assert len(code) > 10
    for k, text in enumerate(code):
        exec(compile(text, f"cell {k + 1}", "exec"), names)
    for verb in (
        "read",
        "draw",
        "motion",
        "Board",
        ".with_",
        ".table",
        ".check",
        ".plot",
        ".steps",
    ):
        assert any(verb in text for text in code), verb


def test_the_notebook_is_kept_without_what_it_printed() -> None:
    assert all(not cell.get("outputs") for cell in cells())
    assert all(cell.get("execution_count") is None for cell in cells())
