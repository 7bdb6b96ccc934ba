"""The benches of the page, worked by node, and what Python has of the same tasks."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.resources import files
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import arrays
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.page.practice.pack import Packing
from graphic_tmm.page.practice.tasks import sheet_row
from graphic_tmm.scene.packaged import packaged
from support import gallery
from support.browser import without

WEB = Path(str(files("graphic_tmm.page") / "web"))


class Packed(NamedTuple):
    """A scene of the package as it is packed for practice."""

    name: str
    made: DrawnScene
    packing: Packing
    data: dict[str, Any]
    program: str


SOME = (
    "crank-press",
    "crank-rocker",
    "oscillating-cylinder",
    "scotch-yoke",
    "slider-diagrams",
    "tangent-mechanism",
    "windrower",
)
"""Scenes that have a group of every kind, loads, diagrams."""


@cache
def packed(name: str) -> Packed | None:
    """Return a scene as packed for practice; None where nothing of it is practised."""
    made = gallery.exact(name)
    row = sheet_row(made)
    if row is None:
        return None
    packing = Packing(made, row, ())
    return Packed(name, made, packing, packing.data(()), packing.program())


def practised(*, every: bool) -> list[Packed]:
    """Return scenes of the package that have something to practise, or every one."""
    names = [path.name for path in packaged()] if every else SOME
    found = (packed(name) for name in names)
    return [one for one in found if one is not None]


def node() -> str:
    """Return the path of node, or skip the test."""
    found = shutil.which("node")
    if found is None:
        without("node", "install it from the system's packages")
    return str(found)


def worked(
    scenes: Sequence[Packed],
    drawings: Mapping[str, Sequence[Mapping[str, Any]]],
    folder: Path,
    *,
    work: bool = False,
    more: str = "",
    together: Mapping[str, Sequence[Any]] = MappingProxyType({}),
) -> list[Any]:
    """Return what the page's own benches answer, scene by scene; ``folder``: an empty one.

    ``work``: whether each task is worked, rightly and wrongly. ``more``: what else is asked, of ``Bench`` and
    of the ``data`` of a scene, as JavaScript that pushes to ``answers``. ``together``: drawings of several
    plans, their points read.
    """
    program = Path(__file__).with_name("bench.mjs").read_text("utf-8").replace("// MORE", more)
    asked = [
        {
            "drawings": drawings.get(one.name, ()),
            "together": together.get(one.name, ()),
            "work": list(range(len(one.data["tasks"]))) if work else [],
        }
        for one in scenes
    ]
    return by_node(program, scenes, asked, folder)


def by_node(
    program: str, scenes: Sequence[Packed], asked: Sequence[Mapping[str, Any]], folder: Path
) -> list[Any]:
    """Return what a program for node answers that stands beside the page's modules for practice.

    ``asked``: of each scene what it is asked besides the data and the module that is written down.
    """
    shutil.copytree(WEB, folder, dirs_exist_ok=True)
    (folder / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    (folder / "program.mjs").write_text(program, encoding="utf-8")
    (folder / "practice" / "enter.js").unlink()
    told = []
    for k, (one, more) in enumerate(zip(scenes, asked, strict=True)):
        (folder / "practice" / f"written{k}.js").write_text(one.program, encoding="utf-8")
        told.append({"written": f"written{k}.js", "data": one.data, **more})
    (folder / "asked.json").write_text(json.dumps(told), encoding="utf-8")
    command = [node(), "program.mjs", "asked.json", "answered.json"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: list[Any] = json.loads((folder / "answered.json").read_text("utf-8"))
    return found


def numbers(value: Any, at: int) -> list[float]:
    """Return the numbers that a value is made of in one position."""
    flat: list[float] = []
    for part in arrays(value):
        z = part[0][at if part.shape[1] > 1 else 0]
        flat += [z.real, z.imag] if np.iscomplexobj(part) else [float(z)]
    return flat
