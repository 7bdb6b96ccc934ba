"""What was made of a piece of work, kept beside the files; one run at a time writes there."""

from __future__ import annotations

import hashlib
import json
import os
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

from graphic_tmm.errors import SheetError, printable, reason_of
from graphic_tmm.files import write
from graphic_tmm.language.said import said

HOME = ".graphic-tmm"
"""The folder of the records, in that of the files."""
_PART = re.compile(r"[^\x00-\x1f\x7f-\x9f/\\:*?\"<>|]{1,200}")


class Record(NamedTuple):
    """Of a piece of work its name, the digest of what made it, those of its files, what was told of it."""

    work: str
    made_of: str
    files: Mapping[str, str]
    told: tuple[str, ...] = ()


def is_safe(name: str) -> bool:
    """Whether a file can be called so: in its folder or one below, on any disk, and no record.

    >>> is_safe("7/шатун-1.svg"), is_safe("../7.svg"), is_safe("/7.svg"), is_safe("7//1.svg")
    (True, False, False, False)
    """
    parts = name.split("/")
    fine = all(_PART.fullmatch(part) and part == part.strip(" ") for part in parts)
    return fine and not any(part.endswith(".") or part.startswith(HOME) for part in parts)


def digest_of(data: bytes) -> str:
    """Return the digest of a file's bytes."""
    return hashlib.sha256(data).hexdigest()


def place(work: str) -> Path:
    """Return where the record of a piece of work stands: no folder holds many of them."""
    name = digest_of(work.encode("utf-8", "surrogatepass"))
    return Path(HOME, name[:3], f"{name[3:35]}.json")


def write_record(out: Path, record: Record) -> None:
    """Write a record, whole or not at all; raises as `files.write`."""
    file = out / place(record.work)
    told = json.dumps(record._asdict(), ensure_ascii=True, indent=1)
    write(file.parent, {file.name: told + "\n"})


def read_record(out: Path, work: str) -> Record | None:
    """Return the record of a piece of work; None if there is none that can be believed."""
    try:
        told = json.loads((out / place(work)).read_bytes())
        files, lines = told["files"], told["told"]
        found = Record(str(told["work"]), str(told["made_of"]), dict(files), tuple(lines))
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    texts: tuple[Any, ...] = (*found.files, *found.files.values(), *found.told)
    fine = all(isinstance(one, str) for one in texts) and all(map(is_safe, found.files))
    return found if fine and found.work == work else None


def untouched(out: Path, name: str, digest: str) -> bool:
    """Whether a file is there with the bytes that it was written with."""
    try:
        with (out / name).open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest() == digest
    except OSError:
        return False


def lost(out: Path, record: Record) -> list[str]:
    """Return those of a record's files that are not there, or not as they were written."""
    return [name for name, digest in record.files.items() if not untouched(out, name, digest)]


def write_files(out: Path, files: Mapping[str, bytes]) -> None:
    """Write files into their folders below one, each whole or not at all; raises as `files.write`."""
    folders: dict[str, dict[str, bytes]] = {}
    for name, data in files.items():
        folder, _, last = name.rpartition("/")
        folders.setdefault(folder, {})[last] = data
    for folder, some in folders.items():
        write(out / folder, some)


def clear(out: Path, old: Mapping[str, str], new: Mapping[str, object]) -> Iterator[str]:
    """Take away the files of an earlier record that are made no more; yield those that were changed since."""
    for name in old.keys() - new.keys():
        file = out / name
        if untouched(out, name, old[name]):
            file.unlink(missing_ok=True)
            with suppress(OSError):  # something stands in it
                file.parent.rmdir()
        elif file.exists():
            yield name


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
