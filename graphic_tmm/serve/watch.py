"""Which files change: the folders of the scenes are watched, each for itself, nothing below them."""

from __future__ import annotations

import asyncio
from pathlib import Path

from graphic_tmm.serve.desk import Desk

QUIET = 60
"""What changes within so many ms is looked at together: an editor writes and renames."""
STEP = 10
"""How often it is asked, ms, whether something has changed."""
POLL = 300
"""How often files are looked at where the system does not tell, ms."""
AGAIN = 2.0
"""After a folder could not be watched, or has gone, it is tried again, s."""


async def watch(desk: Desk) -> None:
    """Look at the scenes again whenever a file in their folders has changed; for ever."""
    while True:
        try:
            await _watched(desk, desk.folder.watched())
        except OSError:  # too many files are watched, or the folder has gone
            await asyncio.sleep(AGAIN)
            desk.look_all()


async def _watched(desk: Desk, folders: frozenset[Path]) -> None:
    """Look at scenes again as folders change; until there are others to be watched."""
    from watchfiles import awatch

    desk.look_all()
    async for _ in awatch(
        *folders,
        watch_filter=lambda change, path: _is_scene(path),
        debounce=QUIET,
        step=STEP,
        poll_delay_ms=POLL,
        recursive=False,
        ignore_permission_denied=True,
    ):
        desk.look_all()
        if desk.folder.watched() != folders:
            return


def _is_scene(path: str) -> bool:
    """Whether a path may be that of a scene, of a composition, or of a new folder."""
    name = path.rpartition("/")[2].rpartition("\\")[2]
    return name.endswith(".toml") or "." not in name
