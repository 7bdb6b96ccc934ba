"""Ctrl-C heard where nothing can be left half done: between works, not wherever it happens to come.

An exception that comes from nowhere in the midst of `concurrent.futures` may leave one of its locks taken, and
the run would never end.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import current_thread, main_thread
from types import FrameType

PULSE = 0.2
"""So often, s, it is looked whether it was pressed while works are waited for."""
Check = Callable[[], None]
"""What raises KeyboardInterrupt if Ctrl-C was pressed."""


@contextmanager
def hearing() -> Iterator[Check]:
    """Give what raises KeyboardInterrupt if Ctrl-C was pressed within; pressed once more it comes at once.

    Where this is not the main thread, or somebody else listens to it, nothing is changed.
    """
    before = signal.getsignal(signal.SIGINT)
    if current_thread() is not main_thread() or before is not signal.default_int_handler:
        yield lambda: None
        return
    heard: list[int] = []

    def hear(number: int, frame: FrameType | None) -> None:
        if heard:
            raise KeyboardInterrupt
        heard.append(number)

    def check() -> None:
        if heard:
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, hear)
    try:
        yield check
    finally:
        signal.signal(signal.SIGINT, before)
