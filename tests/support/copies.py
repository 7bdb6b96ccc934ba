"""Copies of the package, in which chapters are taken out and files are edited."""

from __future__ import annotations

import shutil
from pathlib import Path

from support.gallery import ROOT


def copied(folder: Path) -> Path:
    """Copy the package into a folder, with what Python has compiled of it; return the copy."""
    being_written = shutil.ignore_patterns("*.pyc.*")
    return shutil.copytree(ROOT / "graphic_tmm", folder / "graphic_tmm", ignore=being_written)
