"""Imports that come late: when what they name is first used, so that a declaration costs what is asked of it.

They are written as ordinary imports, which checkers of types and of layers therefore see as such:

    with late(__name__):
        from graphic_tmm.chapters.cam.plan import record

``record`` is a `Late` then. It imports its module when it is called, or when something of it is asked for. What
has to be there at once (a text, a number, what is compared or gone through) is not for this.
"""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib import import_module
from threading import Lock
from typing import Any

from graphic_tmm.errors import MissingError
from graphic_tmm.language.said import said

_ONE_AT_A_TIME = Lock()


class Late:
    """Something of a module that is imported when it is first used: called, or asked for an attribute."""

    __slots__ = ("_found", "_name", "_room")
    _found: Any

    def __init__(self, room: str, name: str) -> None:
        """``room``: the module, ``name``: what of it."""
        self._room, self._name = room, name

    def it(self) -> Any:
        """Return what is meant.

        Raises
        ------
        ImportError
            There is no such module, or nothing of that name in it.
        """
        try:
            return self._found
        except AttributeError:
            pass
        room = import_module(self._room)
        if self._name not in vars(room):
            raise ImportError(f"cannot import name {self._name!r} from {self._room!r}")
        self._found = vars(room)[self._name]
        return self._found

    def __call__(self, *args: Any, **keys: Any) -> Any:
        """Call it."""
        return self.it()(*args, **keys)

    def __getattr__(self, name: str) -> Any:
        """Return an attribute of it."""
        if name in Late.__slots__:
            raise AttributeError(name)
        return getattr(self.it(), name)

    def __repr__(self) -> str:
        """Return where it stands."""
        return f"<late {self._room}.{self._name}>"


class _Room:
    """A module that is not imported; ``rooms``: a package, of which only modules are taken."""

    def __init__(self, name: str, rooms: bool = False) -> None:
        self._name, self._rooms = name, rooms

    def __getattr__(self, name: str) -> Any:
        return _Room(f"{self._name}.{name}") if self._rooms else Late(self._name, name)


@contextmanager
def late(package: str) -> Iterator[None]:
    """Let what a package imports from modules (``from … import …``) come late, as long as the context lasts.

    Parameters
    ----------
    package : str
        The package that imports: its own ``__name__``. Of itself it imports modules, whose names are late.
    """
    with _ONE_AT_A_TIME:
        usual = builtins.__import__

        def importing(
            name: str,
            globals: Mapping[str, object] | None = None,
            locals: Mapping[str, object] | None = None,
            fromlist: Sequence[str] | None = (),
            level: int = 0,
        ) -> Any:
            if globals is None or globals.get("__name__") != package or not fromlist or level:
                return usual(name, globals, locals, fromlist or (), level)
            return _Room(name, rooms=name == package)

        builtins.__import__ = importing
        try:
            yield
        finally:
            builtins.__import__ = usual


def needed(module: str, package: str) -> Any:
    """Return a module that may be missing.

    Raises
    ------
    MissingError
        If it is: how its package is installed.
    """
    try:
        return import_module(module)
    except ImportError as error:
        says = said("this needs the package {package}: pip install {package}", package=package)
        raise MissingError(says) from error
