"""What a piece of work hangs on, as one name: the same in every process, another if any of that is another."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence, Set
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from importlib.metadata import version
from pathlib import PurePath
from typing import Any

from graphic_tmm.classroom.batch.work import Work

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
