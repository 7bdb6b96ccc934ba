"""The program as one file that brings its own Python: what it does where it is opened by a click."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from tempfile import TemporaryFile

from graphic_tmm.commands.shared.telling import tell
from graphic_tmm.language.said import said


def studio_arguments() -> list[str]:
    """Return the arguments of the studio on the folder where the file stands, in the browser.

    Where nothing can be written there (a disk image, a folder of programs), it is the person's documents.
    """
    own, documents = Path(sys.executable).resolve().parent, Path.home() / "Documents"
    if _writable(own):
        return _studio(own)
    folder = documents if documents.is_dir() else Path.home()
    tell(
        said(
            "nothing can be written where this file stands ({own}): the studio shows {folder}",
            own=str(own),
            folder=str(folder),
        )
    )
    return _studio(folder)


def _studio(folder: Path) -> list[str]:
    return ["serve", str(folder), "--browser"]


def _writable(folder: Path) -> bool:
    """Whether a file can be made in a folder: on Windows the rights alone do not tell."""
    try:
        with TemporaryFile(dir=folder):
            return True
    except OSError:
        return False


def without_own_libraries() -> None:
    """Let programs that are begun from here, a browser above all, load the system's libraries (Linux)."""
    named = "LD_LIBRARY_PATH"
    os.environ.pop(named, None)
    if before := os.environ.get(f"{named}_ORIG"):
        os.environ[named] = before
