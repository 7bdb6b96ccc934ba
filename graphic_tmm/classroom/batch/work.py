"""A piece of work: what is done, by name, of what; and what comes of it. All of it can be pickled."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any, NamedTuple


class Done(NamedTuple):
    """What came of a piece of work: files by name (``/`` between folders), and what a person should know."""

    files: Mapping[str, str | bytes]
    told: tuple[str, ...] = ()


class Work(NamedTuple):
    """A piece of work: its name, the function that does it, as ``module:name``, and what that is given.

    The function takes ``given``, which can be pickled and says all that the work hangs on, and returns `Done`;
    it writes nothing.
    """

    name: str
    operation: str
    given: Any


def done(work: Work) -> Done:
    """Do a piece of work, here and now; raises what its operation raises."""
    module, _, name = work.operation.partition(":")
    operation: Callable[[Any], Done] = getattr(import_module(module), name)
    return operation(work.given)
