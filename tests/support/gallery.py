"""Where things stand: the clone, the cases, the scenes of the package, those of a mechanism."""

from __future__ import annotations

import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
"""The clone: what is committed beside the package."""
SHEETS = ROOT / "sheets"
CASES = ROOT / "tests" / "cases"
"""Scenes, tables and readings that were found from outside."""
FOLDERS = sorted(path.parent for path in SHEETS.glob("*/scene.toml"))
ALL = [folder.name for folder in FOLDERS]


def _has_mechanism(folder: Path) -> bool:
    return "drive" in tomllib.loads((folder / "scene.toml").read_text(encoding="utf-8"))


def _has_accelerations(folder: Path) -> bool:
    scene = tomllib.loads((folder / "scene.toml").read_text(encoding="utf-8"))
    return bool(scene.get("drive", {}).get("accelerations"))


NAMES = [folder.name for folder in FOLDERS if _has_mechanism(folder)]
ACCELERATED = [folder.name for folder in FOLDERS if _has_accelerations(folder)]
PLANS = [(name, "velocities") for name in NAMES] + [(name, "accelerations") for name in ACCELERATED]
"""Every plan of velocities and accelerations of the scenes."""
