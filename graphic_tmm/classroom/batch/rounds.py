"""One loop over futures: a few more works under way than are done at once; Ctrl-C is heard between."""

from __future__ import annotations

import signal
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Future, wait
from contextlib import contextmanager
from itertools import chain
from threading import current_thread, main_thread
from time import monotonic
from types import FrameType

from graphic_tmm.classroom.batch.executors import Pool, died, opened
from graphic_tmm.classroom.batch.work import Answer, Work, answer, parcel
from graphic_tmm.errors import SheetError, TmmError
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said

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


WINDOW = 3
"""So many works are on their way for each that is done at once."""
LONELY = 60.0
"""After so many s without an answer a cluster is asked whether it has any workers left."""
Found = tuple[Work, Answer | BaseException]


class TooLongError(Exception):
    """A piece of work that was done alone came to its limit, and its process ended."""


def answers(
    where: int | str,
    works: Iterable[Work],
    language: str,
    check: Check,
    *,
    alone: bool = False,
    limit: float = 0.0,
) -> Generator[Found, None, None]:
    """Yield each work with its answer, as they come; or with the error that kept it from coming.

    When a process dies, all works on their way are yielded with that error, and the rest go on in others.
    ``alone``: one at a time, so that it is known which of them it is. ``check``: raises where it is to end.
    ``limit``: a process that does a work longer than so many s ends (0: none); not this one.

    Raises
    ------
    SheetError
        If all workers of a cluster have gone: what is on its way would never come.
    """
    ends = limit if where != 0 else 0.0
    waiting = iter(works)
    if (first := next(waiting, None)) is None:
        return  # nobody is called for nothing
    waiting = chain((first,), waiting)
    broken = True
    while broken:
        with opened(where, alone=alone) as pool:
            window = 1 if alone else WINDOW * pool.at_once
            broken = yield from _until_broken(
                pool, window, waiting, lambda one: parcel(one, language), check, ends
            )


def _until_broken(
    pool: Pool,
    window: int,
    waiting: Iterator[Work],
    packed: Callable[[Work], bytes],
    check: Check,
    limit: float,
) -> Generator[Found, None, bool]:
    """Yield answers until all works are done, or a process died: whether one did."""
    flying: dict[Future[Answer], tuple[Work, float]] = {}
    broken, heard = False, monotonic()
    while True:
        while not broken and len(flying) < window and (work := next(waiting, None)) is not None:
            try:
                sent = pool.executor.submit(answer, packed(work), limit)
                flying[sent] = work, monotonic()
            except BrokenExecutor as error:
                broken = True
                yield work, error
            except TmmError as error:
                yield work, Answer(refused=error.in_language(reader()))
            except Exception as error:  # it cannot be pickled
                yield work, error
        if not flying:
            return broken
        ended, _ = wait(flying, timeout=PULSE, return_when=FIRST_COMPLETED)
        check()
        heard = monotonic() if ended else _attended(pool, heard)
        for future in ended:
            work, begun = flying.pop(future)
            found = _outcome(future)
            broken = broken or isinstance(found, BrokenExecutor)
            if window == 1 and limit and monotonic() - begun >= limit and _died(found):
                found = TooLongError()
            yield work, found


def _attended(pool: Pool, heard: float) -> float:
    """Return when an answer, or that there are workers, was heard last."""
    if monotonic() - heard <= LONELY:
        return heard
    if not pool.has_workers():
        raise SheetError(
            said(
                "the cluster has no workers: begin some, then say the same command; what is done stays"
            )
        )
    return monotonic()


def _died(found: Answer | BaseException) -> bool:
    return isinstance(found, BaseException) and died(found)


def _outcome(future: Future[Answer]) -> Answer | BaseException:
    try:
        return future.exception() or future.result()
    except CancelledError as error:  # a scheduler has gone
        return error
