"""Machine code kept in the user's cache folder, under the hash of all that it was made of.

What lies there is run, so the folder and its files must be the user's own and nobody else may write there; a
file that is not whole, or not what its name says, is thrown away. Where nothing can be kept code is made anew.
A file is written beside its place and moved there, so two processes do not meet.
"""

from __future__ import annotations

import hashlib
import os
import stat
import sys
import tempfile
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

VARIABLE = "GRAPHIC_TMM_CACHE"
"""The variable of the environment that names another folder; empty: nothing is kept."""
FORMAT = b"graphic-tmm loop 1\n"
"""How a file begins; then comes the hash of its name and the code, then the code."""
MOST = 256
"""Files that are kept, the newest."""
_SUFFIX, _PART = ".loop", ".part"
_HASH = 32


def folder(environ: Mapping[str, str], system: str = sys.platform) -> Path | None:
    """Return where machine code is kept; None for nowhere."""
    told = environ.get(VARIABLE)
    if told is not None:
        return Path(told) if told else None
    if system == "win32":
        base = environ.get("LOCALAPPDATA")
    elif system == "darwin":
        base = f"{environ['HOME']}/Library/Caches" if environ.get("HOME") else None
    else:
        base = environ.get("XDG_CACHE_HOME")
        if not base or not base.startswith("/"):
            base = f"{environ['HOME']}/.cache" if environ.get("HOME") else None
    return Path(base) / "graphic-tmm" / "loops" if base else None


def kept(name: str, make: Callable[[], bytes], place: Path | None) -> bytes:
    """Return the code of a name: as it lies in a folder, else as it is made; it lies there from then on.

    Parameters
    ----------
    name
        A hash of everything that the code hangs on.
    make
        Makes it.
    place
        The folder; None for none.
    """
    if place is None or not _own_folder(place):
        return make()
    file = place / f"{name}{_SUFFIX}"
    found = _read(file, name)
    if found is None:
        found = make()
        with suppress(OSError):
            _write(file, _sealed(name, found))
            _clear(place)
    return found


def _sealed(name: str, code: bytes) -> bytes:
    return FORMAT + hashlib.sha256(name.encode() + code).digest() + code


def _own_folder(place: Path) -> bool:
    """Make a folder, if it is not there, and return whether it is the user's own."""
    try:
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        found = place.lstat()
    except OSError:
        return False
    return stat.S_ISDIR(found.st_mode) and _own(found)


def _own(found: os.stat_result) -> bool:
    """Whether something is the user's own and nobody else may write it; only some systems tell."""
    if sys.platform == "win32":
        return True
    return found.st_uid == os.geteuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _read(file: Path, name: str) -> bytes | None:
    """Return the code of a file; None if there is none, or none to be trusted: that one is removed."""
    try:
        number = os.open(
            file, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
        )
    except OSError:
        return None
    with os.fdopen(number, "rb") as stream:
        about = os.fstat(stream.fileno())
        fit = stat.S_ISREG(about.st_mode) and _own(about)
        whole = stream.read() if fit else b""
    code = whole[len(FORMAT) + _HASH :]
    if code and whole == _sealed(name, code):
        with suppress(OSError):
            os.utime(file)
        return code
    with suppress(OSError):
        file.unlink()
    return None


def _write(file: Path, whole: bytes) -> None:
    """Write a file whole, or not at all."""
    number, part = tempfile.mkstemp(_PART, dir=file.parent)
    try:
        with os.fdopen(number, "wb") as stream:
            stream.write(whole)
        os.replace(part, file)
    except OSError:
        os.unlink(part)
        raise


def _clear(place: Path) -> None:
    """Remove the oldest files beyond `MOST`; parts of files that were never finished grow old too."""
    files = []
    for file in place.iterdir():
        if file.suffix in (_SUFFIX, _PART):
            with suppress(OSError):
                files.append((file.stat().st_mtime_ns, file.name))
    for _, name in sorted(files)[:-MOST]:
        with suppress(OSError):
            (place / name).unlink()
