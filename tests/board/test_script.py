"""Operations written down in JavaScript: node and numpy make the same of the same values."""

from __future__ import annotations

import json
import random
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.benches import WEB, node

from graphic_tmm.board.geometry import cis, degrees
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.script import Script
from graphic_tmm.board.source import NotCompiled
from graphic_tmm.board.values import Angle, Arc, Curve, Length, Line, Number, Point, Side, arrays
from graphic_tmm.page.practice.pack import written_module
from graphic_tmm.scene.chapter import whole_book

TIMES = 12
NEAR = 1e-9


def _written() -> dict[str, Operation]:
    """All operations of the board and of its chapters that can be written down."""
    whole_book()
    found, script = {}, Script()
    for name, op in OPERATIONS.items():
        if op.across or Curve in (*op.takes, op.leaves):
            continue
        try:
            script.add(op.run)
        except NotCompiled:
            continue
        found[name] = op
    return found


VALUES: dict[Any, Callable[[random.Random], Any]] = {
    Point: lambda chance: [chance.uniform(-90, 90), chance.uniform(-90, 90)],
    Length: lambda chance: chance.choice([chance.uniform(1, 90), -chance.uniform(1, 90), 0.0]),
    Angle: lambda chance: chance.choice([chance.uniform(-360, 360), 45.0, 90.0, -180.0]),
    Number: lambda chance: chance.choice([chance.uniform(0.1, 9), -chance.uniform(0.1, 9), 2.0]),
    Side: lambda chance: chance.choice([-1.0, 1.0]),
    Line: lambda chance: [VALUES[Point](chance), _direction(chance)],
    Arc: lambda chance: [VALUES[Point](chance), chance.uniform(30, 120)],
}


def _direction(chance: random.Random) -> list[float]:
    z = complex(cis(np.array([[VALUES[Angle](chance)]]))[0, 0])
    return [z.real, z.imag]


def _array(kind: Any, told: Any) -> Any:
    if kind is Line:
        return Line(_array(Point, told[0]), _array(Point, told[1]))
    if kind is Arc:
        return Arc(_array(Point, told[0]), _array(Length, told[1]))
    return np.array([[complex(*told) if kind is Point else told]])


def _numbers(value: Any) -> list[float]:
    flat: list[float] = []
    for part in arrays(value):
        z = np.asarray(part).ravel()[0]
        flat += [z.real, z.imag] if np.iscomplexobj(part) else [float(z)]
    return flat


def _ran(asked: list[list[Any]], written: str, folder: Path) -> list[list[float | None]]:
    shutil.copytree(WEB / "practice", folder / "practice")
    (folder / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    (folder / "practice" / "written.js").write_text(written, encoding="utf-8")
    (folder / "asked.json").write_text(json.dumps(asked), encoding="utf-8")
    script = Path(__file__).parents[1] / "support" / "operations.mjs"
    shutil.copy(script, folder / script.name)
    command = [node(), script.name, "asked.json", "answered.json"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    answers: list[list[float | None]] = json.loads((folder / "answered.json").read_text("utf-8"))
    return answers


def test_node_makes_what_numpy_makes(tmp_path: Path) -> None:
    chance, script, ops = random.Random(5), Script(), _written()
    cases = [
        (op, [VALUES[kind](chance) for kind in op.takes])
        for op in ops.values()
        for _ in range(TIMES)
        if not op.choices
    ]
    written = written_module(script, {"operations": {n: o.run for n, o in ops.items()}})
    answers = _ran([[op.name, *values] for op, values in cases], written, tmp_path)
    compared = 0
    for (op, values), answer in zip(cases, answers, strict=True):
        with np.errstate(all="ignore"):
            due = _numbers(op.run(*map(_array, op.takes, values)))
        for want, got in zip(due, answer, strict=True):
            if not np.isfinite(want) or got is None:
                assert not np.isfinite(want), (op.name, values, due, answer)
                assert got is None, (op.name, values, due, answer)
                continue
            compared += 1
            assert abs(want - got) <= NEAR * max(1.0, *map(abs, filter(np.isfinite, due))), op.name
    assert len(ops) > 220
    assert compared > 2_500


def test_the_eight_main_directions_are_exact(tmp_path: Path) -> None:
    script = Script()
    tables = {"operations": {"cis": cis, "degrees": degrees}}
    written = written_module(script, tables)
    angles = [45.0 * k for k in range(-8, 9)]
    found = _ran([["cis", angle] for angle in angles], written, tmp_path)
    due = [complex(z) for z in cis(np.array([angles]))[0]]
    told = [complex(x or 0.0, y or 0.0) for x, y in found]
    assert [z for k, z in enumerate(told) if k % 2 == 0] == due[::2]
    assert max(abs(a - b) for a, b in zip(told, due, strict=True)) < 1e-15


def _loops(x: Any) -> Any:
    found = 0.0
    for one in x:
        found = found + one
    return found


def _slices(x: Any) -> Any:
    return x[:, :1]


def _unknown(x: Any) -> Any:
    return np.roll(x, 1)


@pytest.mark.parametrize("function", [_loops, _slices, _unknown, np.sin, lambda x: x])
def test_what_is_no_matter_of_single_numbers_is_not_written_down(function: Any) -> None:
    with pytest.raises(NotCompiled):
        Script().add(function)


def _default(new: Any, delete: Any) -> Any:
    function = new + delete
    return function


def test_no_name_is_one_of_the_language() -> None:
    script = Script()
    assert script.add(_default) == "$_default"
    assert "new_" in script.texts[_default]
    assert "let function_;" in script.texts[_default]
