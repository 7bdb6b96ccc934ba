"""A piece of work: what is done of what, by name, what it hangs on, what comes of it. All can be pickled."""

from __future__ import annotations

import faulthandler
import hashlib
import os
import pickle
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from contextlib import contextmanager
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from hashlib import sha256
from importlib import import_module
from importlib.metadata import version
from pathlib import Path, PurePath
from threading import Lock
from typing import Any, NamedTuple

from graphic_tmm.errors import TRACEBACK, SheetError, TmmError, own_fault, printable
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.reader import reading
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


PLAIN: tuple[Any, ...] = (str, bytes, bool, int, float, complex, type(None))
"""What is written as Python writes it; of a class derived from one, as that one."""


@cache
def package() -> str:
    """Return the version of this package, here: another may draw otherwise."""
    return version("graphic-tmm")


def digest(work: Work) -> str:
    """Return a name for what makes a piece of work: the package's version, its operation, what that is given.

    Raises
    ------
    TypeError
        If what it is given cannot be written down.
    """
    text = canonical((package(), work.operation, work.given))
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def canonical(one: Any) -> str:
    """Return a value as a text that nothing but its value and its type decides.

    Tables and sets are written in the order of their texts, records with the names of their fields.

    Raises
    ------
    TypeError
        If a part of it is of a type that cannot be written so.

    >>> canonical({"b": (1, 2.0), "a": {"y", "x"}})
    "{'a':{'x','y'},'b':(1,2.0)}"
    """
    if isinstance(one, Enum):
        return f"{_named(one)}.{one.name}"
    if isinstance(one, PLAIN):
        return str(next(plain for plain in PLAIN if isinstance(one, plain)).__repr__(one))
    if isinstance(one, PurePath):
        return f"Path({str(one)!r})"
    if isinstance(one, Mapping):
        pairs = sorted(f"{canonical(key)}:{canonical(value)}" for key, value in one.items())
        return f"{{{','.join(pairs)}}}"
    if isinstance(one, Set):
        return f"{{{','.join(sorted(map(canonical, one)))}}}"
    if isinstance(one, (tuple, list)) and not hasattr(one, "_fields"):
        left, right = "[]" if isinstance(one, list) else "()"
        return f"{left}{','.join(map(canonical, one))}{right}"
    told = (f"{name}={canonical(getattr(one, name))}" for name in _fields(one))
    return f"{_named(one)}({','.join(told)})"


def _fields(one: Any) -> Sequence[str]:
    if isinstance(one, tuple):
        names: Sequence[str] = one._fields  # type: ignore[attr-defined]
        return names
    if is_dataclass(one) and not isinstance(one, type):
        return [field.name for field in fields(one)]
    raise TypeError(f"{_named(one)}: give works texts, numbers, tables and records of them")


def _named(one: object) -> str:
    return f"{type(one).__module__}.{type(one).__qualname__}"


_ALONE = Lock()
"""A process draws one thing at a time, however many threads give it work."""


class Answer(NamedTuple):
    """What came of a piece of work: its files and what is told of it; or why there is none.

    ``refused``: what a person can put right; ``fault``: what nobody has foreseen.
    """

    files: Mapping[str, bytes] = {}
    told: tuple[str, ...] = ()
    refused: str = ""
    fault: str = ""


def parcel(work: Work, language: str) -> bytes:
    """Return a piece of work as it travels, with what it brings; ``language``: that of its messages.

    Raises
    ------
    SheetError
        If a file that it brings is another now.
    Exception
        Of pickle's, if it cannot travel.
    """
    whole = (package(), language, work, brought(work))
    return pickle.dumps(whole, pickle.HIGHEST_PROTOCOL)


def answer(sent: bytes, limit: float = 0.0) -> Answer:
    """Do a piece of work that was sent, and return what came of it; nothing is raised.

    ``limit``: after so many s its process ends (0: never).
    """
    with _ALONE, ending_after(limit):
        try:
            there, language, work, files = pickle.loads(sent)
        except Exception as error:
            return Answer(fault=_fault(error))
        with reading(language):
            speech = speaking(language)
            if there != package():
                says = said(
                    "graphic-tmm is {here} where the work is done, and {there} here: install one version",
                    here=package(),
                    there=there,
                )
                return Answer(refused=speech(says))
            try:
                return _answered(work, files)
            except TmmError as error:
                return Answer(refused=error.in_language(speech))
            except MemoryError:
                return Answer(fault=speech(said("there is too little memory for this")))
            except Exception as error:
                return Answer(fault=speech(_fault(error)))


@contextmanager
def ending_after(limit: float) -> Iterator[None]:
    """End this process at once if what is done within takes longer, s (0: however long it takes).

    Python's own watchman does it: a thread that needs nothing of Python and so is not kept waiting by a loop in
    machine code, on every system and in whichever thread the work is done, as no alarm of a signal is. Where it
    was is told if faults are to show that.
    """
    if not limit:
        yield
        return
    with open(os.devnull, "wb") as nowhere:
        told = 2 if os.environ.get(TRACEBACK) else nowhere
        faulthandler.dump_traceback_later(limit, exit=True, file=told)
        try:
            yield
        finally:
            faulthandler.cancel_dump_traceback_later()


def _answered(work: Work, brought: Mapping[str, bytes]) -> Answer:
    found: Any = done(work, brought)
    files = {
        str(name): text.encode("utf-8") if isinstance(text, str) else bytes(text)
        for name, text in found.files.items()
    }
    return Answer(files, tuple(map(str, found.told)))


def _fault(error: Exception) -> str:
    if os.environ.get(TRACEBACK):
        traceback.print_exception(error)
    return own_fault(error)
