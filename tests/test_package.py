"""The rooms of the tree: public names, sizes of files, the top level, words on every operation."""

from __future__ import annotations

import string
import subprocess
from pathlib import Path

import pytest

import graphic_tmm
from graphic_tmm.board import calculations, curve, operations
from graphic_tmm.board.grammar import OPERATIONS

ROOT = Path(__file__).parent.parent
TOP = {"pyproject.toml", "graphic_tmm", "sheets", "tests", "README.md", "LICENSE"}


def test_public_names_are_sorted_complete_and_there() -> None:
    assert graphic_tmm.__all__ == sorted(graphic_tmm.__all__)
    assert set(graphic_tmm.__all__) == set(graphic_tmm._HOMES)
    for name in graphic_tmm.__all__:
        assert getattr(graphic_tmm, name).__name__ == name
    with pytest.raises(AttributeError):
        _ = graphic_tmm.nonsense


def test_no_room_is_longer_than_400_lines() -> None:
    long = {
        path.name: count
        for path in (ROOT / "graphic_tmm").rglob("*.py")
        if (count := len(path.read_text(encoding="utf-8").splitlines())) > 400
    }
    assert not long


def test_the_top_level_is_as_agreed() -> None:
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if listed.returncode:
        pytest.skip("not a checkout")
    tops = {line.split("/")[0] for line in listed.stdout.splitlines()}
    assert {top for top in tops if not top.startswith(".")} == TOP


def _placeholders(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name}


@pytest.mark.parametrize("op", OPERATIONS.values(), ids=str)
def test_an_operation_speaks_both_languages(op) -> None:
    assert op.en
    assert op.ru
    assert _placeholders(op.en) == _placeholders(op.ru)
    assert _placeholders(op.en) <= {*op.arguments, "it"}
    if op.formula:
        assert _placeholders(op.formula) == set(op.arguments)
    if "side" in op.arguments:
        assert op.sides[0] != ("+", "−")
        assert "side" in _placeholders(op.en)
    for gap in op.gaps:
        assert _placeholders(gap.en) == _placeholders(gap.ru) <= set(op.arguments)


def test_every_operation_is_in_the_table() -> None:
    rooms = (operations, calculations, curve)
    made = {
        v.name for room in rooms for v in vars(room).values() if type(v).__name__ == "Operation"
    }
    assert made == set(OPERATIONS)
