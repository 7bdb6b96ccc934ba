"""One run at a time writes into a folder: the second is told so. The system opens the lock when a run ends.

A run that has written nothing leaves no folder and no lock.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from graphic_tmm.classroom.batch.record import HOME
from graphic_tmm.errors import SheetError, printable, reason_of
from graphic_tmm.language.said import said


@contextmanager
def locked(out: Path) -> Iterator[None]:
    """Keep other runs out of a folder, which is made if it is not there.

    Raises
    ------
    SheetError
        If another run writes into it, or it cannot be written into.
    """
    folder, file = printable(str(out)), out / HOME / "lock"
    new = [path for path in (file.parent, out, *out.parents) if not path.exists()]
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        stream = file.open("ab")
    except OSError as error:
        reason = reason_of(error)
        says = said(
            "cannot write into {folder}: {reason}; {remedy}",
            folder=folder,
            reason=reason,
            remedy=said("name another folder with -o"),
        )
        raise SheetError(says) from error
    with stream:
        if not (_taken(stream) and _is_at(stream, file)):
            says = said(
                "another run writes into {folder} now: let it end, or name another folder with -o",
                folder=folder,
            )
            raise SheetError(says)
        try:
            yield
        finally:
            with suppress(OSError):  # Windows takes away no file that is open: there it stays
                if file.parent in new and list(file.parent.iterdir()) == [file]:
                    file.unlink()
            _let_go(stream)
            for path in new:
                with suppress(OSError):  # something stands in it
                    path.rmdir()


def _is_at(stream: BinaryIO, file: Path) -> bool:
    """Whether a file is the one of that name; the run that it was opened beside may have taken it away."""
    with suppress(OSError):
        return os.path.samestat(os.fstat(stream.fileno()), file.stat())
    return False


def _taken(stream: BinaryIO) -> bool:
    """Take a lock until the file is closed, or its process ends; whether nobody else has it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a disk that knows no locks; on Windows, that somebody has it
        return sys.platform != "win32"
    return True


def _let_go(stream: BinaryIO) -> None:
    """Open the lock: a process that was just begun by another thread may still have the file."""
    if sys.platform != "win32":
        import fcntl

        with suppress(OSError):
            fcntl.flock(stream, fcntl.LOCK_UN)
