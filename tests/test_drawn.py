"""What was drawn can go to another process: operations travel by their names."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path

import pytest
from support.gallery import made

from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.operations.locus import REFINE
from graphic_tmm.readers.table import table
from graphic_tmm.scene.chapter import whole_book


@pytest.mark.parametrize("name", ["windrower", "cam", "gear-pair", "planetary"])
def test_a_drawn_scene_is_the_same_when_it_was_pickled(name: str) -> None:
    drawn = made(name)
    again = pickle.loads(pickle.dumps(drawn))
    assert table(again, "json", 3) == table(drawn, "json", 3)
    for one, other in zip(drawn.boards, again.boards, strict=True):
        pairs = list(zip(one.construction.steps, other.construction.steps, strict=True))
        assert all(a.op is b.op for a, b in pairs if a.op.name != REFINE)
        assert all(a[1:] == b[1:] for a, b in pairs)
        assert list(map(str, one.advice())) == list(map(str, other.advice()))


def test_another_process_reads_what_was_drawn_here(tmp_path: Path) -> None:
    """One that has imported nothing yet."""
    drawn = made("windrower")
    (tmp_path / "drawn").write_bytes(pickle.dumps(drawn))
    code = (
        "import pickle, sys; drawn = pickle.load(open(sys.argv[1], 'rb'));"
        "from graphic_tmm.readers.table import table; print(table(drawn, 'csv'), end='')"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "drawn")], capture_output=True, check=True
    )
    assert done.stdout.decode() == table(drawn, "csv")


def test_operations_are_pickled_as_themselves() -> None:
    whole_book()
    for op in OPERATIONS.values():
        assert pickle.loads(pickle.dumps(op)) is op
