"""A piece of work: what is done, by name, of what; and what comes of it. All of it can be pickled."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from graphic_tmm.errors import SheetError, printable
from graphic_tmm.language.said import said


class Done(NamedTuple):
    """What came of a piece of work: files by name (``/`` between folders), and what a person should know."""

    files: Mapping[str, str | bytes]
    told: tuple[str, ...] = ()


class Work(NamedTuple):
    """A piece of work: its name, the function that does it, as ``module:name``, and what that is given.

    The function takes ``given``, which can be pickled and says all that the work hangs on, and returns `Done`;
    it writes nothing. ``brings``: files too large to be held for all works at once, path and digest of each
    (``given`` names them, too): they are read when the work is sent, and the function takes their bytes by path
    as a second thing.
    """

    name: str
    operation: str
    given: Any
    brings: tuple[tuple[str, str], ...] = ()


def done(work: Work, files: Mapping[str, bytes] | None = None) -> Done:
    """Do a piece of work, here and now; raises what its operation raises. ``files``: what it brings."""
    module, _, name = work.operation.partition(":")
    operation: Callable[..., Done] = getattr(import_module(module), name)
    return operation(work.given, files or {}) if work.brings else operation(work.given)


def brought(work: Work) -> dict[str, bytes]:
    """Return the files that a piece of work brings, by path.

    Raises
    ------
    SheetError
        If one is not what it was when the work was made of it.
    """
    found = {}
    for path, digest in work.brings:
        try:
            data = Path(path).read_bytes()
        except OSError:
            data = b""
        if sha256(data).hexdigest() != digest:
            raise SheetError(said("{file}: the file was changed meanwhile", file=printable(path)))
        found[path] = data
    return found
