"""Files: read if they are ordinary files of a fit size, written whole or not at all, never over an input.

What one call of the program reads is remembered (`call`), so that nothing that it writes takes its place.
A text first goes to a temporary file in the folder where it shall stand. In a template (jinja2) what is put
into it is data and is escaped, unless a template has made it.
"""

from __future__ import annotations

import os
import re
import shutil
import stat
import sys
import unicodedata
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from secrets import token_hex
from socket import gethostname
from typing import TYPE_CHECKING, BinaryIO, NamedTuple, NoReturn

from graphic_tmm.errors import Fault, SceneError, SheetError, printable, reason_of
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from jinja2 import Environment


HOST = re.sub(r"[^A-Za-z0-9-]", "", gethostname())[:40] or "host"
STANDARD_INPUT = Path("-")
"""The name by which standard input is read."""
_PART = re.compile(r"\.graphic-tmm-([A-Za-z0-9-]+)-([0-9]+)-[0-9a-f]+\.part")
"""Machine, process, and what no thread of it draws twice (`mkstemp` would narrow the rights of a new file)."""
_INPUTS: ContextVar[list[Path] | None] = ContextVar("inputs", default=None)


class Kind(NamedTuple):
    """What sort of file is read.

    ``noun``: what it is, "a scene"; ``remedy``: what a person names instead of one that is none;
    ``largest``: how many bytes it may have.
    """

    noun: str
    remedy: str
    largest: int


@contextmanager
def call() -> Iterator[None]:
    """Remember the files read within, so that `write` refuses to take their places."""
    token = _INPUTS.set([])
    try:
        yield
    finally:
        _INPUTS.reset(token)


# ---------------------------------------------------------------- reading


def opened(file: Path, kind: Kind) -> BinaryIO:
    """Return an ordinary file opened for reading bytes.

    Raises
    ------
    SceneError
        If it is not there, a folder, a device or a pipe, has more bytes than its kind may, or cannot be read.
    """
    try:
        state = file.stat()
        if stat.S_ISDIR(state.st_mode):
            _refuse(file, said("this is a folder; {remedy}", remedy=kind.remedy))
        if not stat.S_ISREG(state.st_mode):
            _refuse(
                file,
                said("this is a device or a pipe, no ordinary file; {remedy}", remedy=kind.remedy),
            )
        if state.st_size > kind.largest:
            _refuse(file, _large(kind))
        stream = file.open("rb")
    except FileNotFoundError:
        _refuse(file, said("there is no such file; {remedy}", remedy=kind.remedy))
    except (OSError, ValueError) as error:
        reason = reason_of(error)
        _refuse(
            file,
            said("the file cannot be read ({reason}); check its name and rights", reason=reason),
        )
    if (inputs := _INPUTS.get()) is not None:
        inputs.append(file)
    return stream


def read(file: Path, kind: Kind) -> bytes:
    """Return the bytes of a file, or of standard input; raises as `opened`."""
    try:
        with _standard_input() if file == STANDARD_INPUT else opened(file, kind) as stream:
            data = stream.read(kind.largest + 1)
    except OSError as error:
        reason = reason_of(error)
        _refuse(
            file,
            said("the file cannot be read ({reason}); {remedy}", reason=reason, remedy=kind.remedy),
        )
    if len(data) > kind.largest:  # it grew, or does not tell its size
        _refuse(file, _large(kind))
    return data


@contextmanager
def _standard_input() -> Iterator[BinaryIO]:
    """Give standard input, and leave it open: it is the system's."""
    yield sys.stdin.buffer


def _large(kind: Kind) -> str:
    mega = kind.largest >= 1_000_000
    most = f"{kind.largest // 1_000_000} MB" if mega else f"{kind.largest // 1000} kB"
    return said(
        "the file is too large: {noun} has at most {most}; {remedy}",
        noun=kind.noun,
        most=most,
        remedy=kind.remedy,
    )


def _refuse(file: Path, message: str) -> NoReturn:
    raise SceneError(str(file), (Fault("", 0, message),)) from None


# ---------------------------------------------------------------- writing


def write(
    folder: Path, texts: Mapping[str, str | bytes], *, remedy: str = said("name another folder")
) -> tuple[Path, ...]:
    """Write texts or bytes (by file name) into a folder, created if missing; return the paths.

    ``remedy``: what a person can do if the folder cannot be written. Half-written files of a killed run are
    removed.

    Raises
    ------
    SheetError
        If the folder cannot be created, a file cannot be written or would replace one that this `call` has
        read; nothing is left behind then.
    """
    for name in texts:
        _spare(folder / name, remedy)
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    waiting: list[tuple[Path, Path]] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            place = folder / name
            if place.is_dir():
                raise IsADirectoryError(21, said("a folder stands there"), str(place))
            if place.exists() and not place.is_file():
                raise OSError(22, said("a device or a pipe stands there"), str(place))
            passing = folder / f".graphic-tmm-{HOST}-{os.getpid()}-{token_hex(8)}.part"
            waiting.append((passing, place))
            passing.write_bytes(text.encode("utf-8") if isinstance(text, str) else text)
            with suppress(OSError):  # nothing stands there yet
                shutil.copymode(place, passing)
        _sweep(folder)
        _place(waiting)
    except OSError as error:
        _clear(waiting, made)
        reason = reason_of(error)
        raise SheetError(
            said(
                "cannot write into {folder}: {reason}; {remedy}",
                folder=printable(str(folder)),
                reason=reason,
                remedy=remedy,
            )
        ) from error
    except BaseException:
        _clear(waiting, made)
        raise
    return tuple(place for _, place in waiting)


def _spare(place: Path, remedy: str) -> None:
    """Refuse a place where a file stands that was read: under this name, another one, or by a link."""
    for file in _INPUTS.get() or ():
        if _same(file, place):
            raise SheetError(
                said(
                    "{place}: this file was read; it is not written over: {remedy}",
                    place=printable(str(place)),
                    remedy=remedy,
                )
            )


def _same(file: Path, place: Path) -> bool:
    """Whether two names mean one file, here or on a disk that ignores case."""
    with suppress(OSError, ValueError):
        if os.path.samefile(file, place):
            return True
    return _folded(file) == _folded(place)


def _folded(file: Path) -> str:
    """Return where a file stands, links of its folder followed, in one form for all ways of spelling."""
    whole = os.path.join(os.path.realpath(file.parent), file.name)
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", whole).casefold())


def _place(waiting: list[tuple[Path, Path]]) -> None:
    """Put files that are written into their places: all of them, even if Ctrl-C falls in between."""
    left = list(waiting)
    try:
        while left:
            os.replace(*left[0])
            left.pop(0)
    except KeyboardInterrupt:
        for passing, place in left:
            if passing.exists():
                os.replace(passing, place)
        raise


def _sweep(folder: Path) -> None:
    """Take away temporary files of this program on this machine whose process is gone."""
    for path in folder.glob(".graphic-tmm-*.part"):
        match = _PART.fullmatch(path.name)
        if match and match[1] == HOST and _gone(int(match[2])):
            with suppress(OSError):
                path.unlink()


def _gone(process: int) -> bool:
    """Whether a process has ended; False where the system offers no harmless way to ask."""
    if os.name != "posix":
        return False
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return True
    except (OSError, OverflowError):
        return False
    return False


def _clear(waiting: list[tuple[Path, Path]], made: list[Path]) -> None:
    """Remove the temporary files, and created folders that are empty."""
    for passing, _ in waiting:
        with suppress(OSError):  # it was never there, or its name is too long to be
            passing.unlink()
    for path in made:
        with suppress(OSError):  # something stands in it, of another thread perhaps
            path.rmdir()


def environment(package: str) -> Environment:
    """Return the templates of a package, from its folder ``templates``.

    Every text is escaped, and a name that is not given is an error.
    """
    from jinja2 import Environment, PackageLoader, StrictUndefined

    return Environment(
        loader=PackageLoader(package),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
