"""The studio as a command begins it, where its extra is installed."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec

from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.said import said

NEEDED = ("starlette", "uvicorn", "watchfiles")


def served(
    scene: str | None, *, host: str, port: int, language: str, tell: Callable[[str], None]
) -> None:
    """Serve a scene or a folder, by path or name, until Ctrl-C.

    Raises
    ------
    SceneError
        If there is none.
    SheetError
        If the extra is not installed, or the host or the port cannot be had.
    """
    from graphic_tmm.serve.folder import folder_of

    folder = folder_of(scene)
    if any(find_spec(name) is None for name in NEEDED):
        raise SheetError(
            said("serving needs more packages: {remedy}", remedy=installing("[serve]"))
        )
    from graphic_tmm.serve.server import serve

    serve(folder, host=host, port=port, language=language, tell=tell)
