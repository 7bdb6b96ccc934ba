"""How a note is set as PDF where the typesetter fails."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from graphic_tmm.note.pdf import _compiled


class Fault(Exception):
    """What the typesetter raises."""


def failing(says: str, *, always: bool = False) -> Any:
    """A typesetter that fails where figures move, or always, and sets the first line of its source else."""

    def compiled(path: str, **_: object) -> bytes:
        first = Path(path).read_text(encoding="utf-8").partition("\n")[0]
        if always or first.endswith("auto"):
            raise Fault(says)
        return first.encode()

    return SimpleNamespace(compile=compiled, TypstError=Fault)


def test_figures_stand_where_they_are_told_of_if_they_cannot_move(tmp_path: Path) -> None:
    made = _compiled(failing("internal error: parent group"), tmp_path, "words")
    assert made == b"#let floating = none"


@pytest.mark.parametrize(
    ("says", "always"), [("unknown variable: x", False), ("internal error: another", True)]
)
def test_other_faults_are_not_hidden(says: str, always: bool, tmp_path: Path) -> None:
    with pytest.raises(Fault, match=says):
        _compiled(failing(says, always=always), tmp_path, "words")
