"""A chapter is a folder that can be deleted, with those above it: the scenes left are drawn as before."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from support.copies import copied
from support.gallery import ALL, COMPOUND, ROOT, scene

from graphic_tmm.scene.chapter import chapters, places

NAMES = [one.name for one in chapters()]
WHOLE = ("structure", "cam")
"""A chapter that most build on and a part: every scene that is left is drawn of these."""
DRAW = """
import hashlib, json, sys
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheet_files
found = {}
for path in sys.argv[1:]:
    for name, text in sheet_files(read(path))[1].items():
        found[name] = hashlib.sha256(text.encode()).hexdigest()
print(json.dumps(found))
"""


def with_those_above(name: str) -> set[str]:
    """A chapter and all that build on it, by what the chapters themselves declare."""
    gone = {name}
    for one in (*chapters(), *chapters()):
        if gone & set(one.builds_on):
            gone.add(one.name)
    return gone


@cache
def chapters_of(name: str) -> frozenset[str]:
    """The chapters that a scene of the package calls for, by its sections and by what its sheets show."""
    asked = scene(name)
    known = places()
    shown = {known[place][0].name for place in asked.called}
    tasks = {one.name for one in chapters() for s in one.sections if s.name in asked.tasks}
    return frozenset(shown | tasks)


def files_of(name: str) -> dict[str, bytes]:
    """The committed sheets of a scene of the package: it redraws to them with all chapters (test_sheets)."""
    return {path.name: path.read_bytes() for path in (ROOT / "sheets" / name).glob("*.svg")}


def ink(name: str) -> int:
    """How much there is to draw of a scene."""
    return sum(map(len, files_of(name).values()))


def covering(names: list[str]) -> list[str]:
    """Scenes enough that every chapter which any of some scenes calls for is called for, with little ink."""
    chosen: list[str] = []
    while (
        wanted := frozenset().union(*map(chapters_of, names)).difference(*map(chapters_of, chosen))
    ):
        chosen.append(max(names, key=lambda one: (len(chapters_of(one) & wanted), -ink(one))))
    return chosen


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_chapter_can_be_taken_out(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """Of most chapters one scene of those that are left is drawn; all of them when measured."""
    gone = with_those_above(name)
    alone = [one for one in ALL if one not in COMPOUND]
    left = covering([one for one in alone if not chapters_of(one) & gone])
    if name not in WHOLE and not many(1, 0):
        left = [min(left, key=ink)]
    copy = copied(tmp_path)
    for one in chapters():
        if one.name in gone:
            shutil.rmtree(copy / "chapters" / one.folder.rpartition(".")[2])
    paths = [str(ROOT / "sheets" / one) for one in left]
    done = subprocess.run(
        [sys.executable, "-c", DRAW, *paths],
        cwd=tmp_path,
        env={"PYTHONPATH": str(tmp_path), "PATH": ""},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    due = {
        file: hashlib.sha256(told).hexdigest()
        for one in left
        for file, told in files_of(one).items()
    }
    assert json.loads(done.stdout) == due
    assert due
