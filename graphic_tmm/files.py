"""Files written whole or not at all: every text first goes to a temporary name beside its place."""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from graphic_tmm.errors import SheetError


def write(
    folder: Path, texts: Mapping[str, str | bytes], *, remedy: str = "name another folder"
) -> tuple[Path, ...]:
    """Write texts or bytes (by file name) into a folder, made if it is not there; return the paths.

    ``remedy``: what a person can do if the folder cannot be written.

    Raises
    ------
    SheetError
        If the folder cannot be made or a file in it cannot be written; nothing is left behind then.
    """
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    waiting: list[tuple[Path, Path]] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            place = folder / name
            if place.is_dir():
                raise IsADirectoryError(21, "a folder stands there", str(place))
            passing = folder / f".{name}.{os.getpid()}.part"
            waiting.append((passing, place))
            passing.write_bytes(text.encode("utf-8") if isinstance(text, str) else text)
        for passing, place in waiting:
            os.replace(passing, place)
    except OSError as error:
        _clear(waiting, made)
        reason = (error.strerror or str(error)).lower()
        raise SheetError(f"cannot write into {folder}: {reason}; {remedy}") from error
    except BaseException:
        _clear(waiting, made)
        raise
    return tuple(place for _, place in waiting)


def _clear(waiting: list[tuple[Path, Path]], made: list[Path]) -> None:
    """Take away the temporary files, and the folders that were made if nothing stands in them."""
    for passing, _ in waiting:
        with suppress(OSError):  # it was never there, or its name is too long to be
            passing.unlink()
    for path in made:
        if path.is_dir() and not any(path.iterdir()):
            path.rmdir()
