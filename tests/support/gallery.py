"""The clone, its cases, the scenes of the package and those of a mechanism, each drawn once."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets, make
from support.boards import in_usual_size
from support.once import read_once

if TYPE_CHECKING:
    from graphic_tmm.fitting.compose import Composed
    from graphic_tmm.paper.drawing import Sheet

ROOT = Path(__file__).parents[2]
"""The clone: what is committed beside the package."""
SHEETS = ROOT / "sheets"
CASES = ROOT / "tests" / "cases"
"""Scenes, tables and readings that were found from outside."""
FOLDERS = sorted(path.parent for path in SHEETS.glob("*/scene.toml"))
ALL = [folder.name for folder in FOLDERS]
EVERYDAY = (
    "arc-cam",
    "cam",
    "crank-press",
    "crank-rocker",
    "engine",
    "gear-pair",
    "lettering",
    "locomobile",
    "oscillating-cylinder",
    "planetary",
    "slider-diagrams",
)
"""Scenes enough that every chapter has one: of these a test of one scene is an everyday one."""

LARGEST = "windrower"
"""A scene of all that a machine is asked for."""
COMPOUND = ("project",)
"""Scenes of a mechanism and parts that are scenes of the package by themselves too."""
PLATES = (
    "allan-gear",
    "landing-gear",
    "planar-platform",
    "stephenson-gear",
    "swinging-screen",
    "tipper-hoist",
)
"""Scenes with plates on three legs."""


def _has_mechanism(folder: Path) -> bool:
    return folder.name not in COMPOUND and "drive" in tomllib.loads(
        (folder / "scene.toml").read_text(encoding="utf-8")
    )


def _has_accelerations(folder: Path) -> bool:
    if not _has_mechanism(folder):
        return False
    scene = tomllib.loads((folder / "scene.toml").read_text(encoding="utf-8"))
    drives = scene.get("drive", {})
    first = drives[0] if isinstance(drives, list) else drives
    return bool(first.get("accelerations"))


NAMES = [folder.name for folder in FOLDERS if _has_mechanism(folder)]
ACCELERATED = [folder.name for folder in FOLDERS if _has_accelerations(folder)]
NO_PLANS = ("rolling-centrodes",)
"""Scenes with a mechanism whose sheets show no plan of velocities."""
PLANS = [(name, "velocities") for name in NAMES if name not in NO_PLANS] + [
    (name, "accelerations") for name in ACCELERATED
]
"""Every plan of velocities and accelerations of the scenes."""


def scene(name: str) -> Scene:
    """Return a scene of the package as it is read; it is shared: what is found of it is kept beside it."""
    return read_once(SHEETS / name)


def one_crank(name: str) -> bool:
    """Whether one crank that turns drives the mechanism of a scene."""
    mechanism = scene(name).mechanism
    assert mechanism is not None
    return not (mechanism.further or mechanism.drive.slides or mechanism.at_rest)


def asking(*sections: str) -> list[str]:
    """Return the mechanisms of the package whose files have one of these sections; none is drawn."""
    return [name for name in NAMES if not scene(name).told.keys().isdisjoint(sections)]


@cache
def made(name: str, *, exact: bool = False) -> DrawnScene:
    """Return all that a scene of the package calls for, drawn; it is shared: change nothing of it."""
    return make(scene(name), exact=exact)


def exact(name: str) -> DrawnScene:
    """Return the same by the exact hand and without a ruler."""
    return made(name, exact=True)


def drawn(name: str, *, exact: bool = False) -> Drawn:
    """Return the mechanism of a scene of the package, drawn."""
    found = made(name, exact=exact).mechanism
    assert found is not None
    return found


@cache
def usual(name: str) -> DrawnScene:
    """Return all that a scene calls for by the exact hand in its usual size: no sheet is tried."""
    return in_usual_size(scene(name), exact=True)


def in_usual(name: str) -> Drawn:
    """Return the mechanism of a scene of the package in its usual size, by the exact hand."""
    found = usual(name).mechanism
    assert found is not None
    return found


@cache
def composed(name: str) -> tuple[DrawnScene, Composed]:
    """Return a scene of the package composed onto its sheets, and what of it was drawn for them."""
    return composed_sheets(scene(name))


def by_turns(name: str, many: Callable[[int, int], int]) -> tuple[Sheet, ...]:
    """Return a sheet of a scene of the package, which it is by turns; all of them when measured."""
    found = paper(name)[1]
    first = ALL.index(name) % len(found)
    return found if many(1, 0) else found[first : first + 1]


@cache
def paper(name: str) -> tuple[DrawnScene, tuple[Sheet, ...]]:
    """Return the same with its sheets alone."""
    made, found = composed(name)
    return made, found.sheets
