"""One loop over futures: a few more works are on their way than are done at once; nothing waits or piles up."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Future, wait

from graphic_tmm.classroom.batch.answer import Answer, answer, parcel
from graphic_tmm.classroom.batch.executors import Pool, opened
from graphic_tmm.classroom.batch.stopping import PULSE, Check
from graphic_tmm.classroom.batch.work import Work

WINDOW = 3
"""So many works are on their way for each that is done at once."""
Found = tuple[Work, Answer | BaseException]


def answers(
    where: int | str, works: Iterable[Work], language: str, check: Check, *, alone: bool = False
) -> Generator[Found, None, None]:
    """Yield each work with its answer, as they come; or with the error that kept it from coming.

    When a process dies, all works on their way are yielded with that error, and the rest go on in others.
    ``alone``: one at a time, so that it is known which of them it is. ``check``: raises where it is to end.
    """
    waiting = iter(works)
    broken = True
    while broken:
        with opened(where, alone=alone) as pool:
            window = 1 if alone else WINDOW * pool.at_once
            broken = yield from _until_broken(
                pool, window, waiting, lambda one: parcel(one, language), check
            )


def _until_broken(
    pool: Pool, window: int, waiting: Iterator[Work], packed: Callable[[Work], bytes], check: Check
) -> Generator[Found, None, bool]:
    """Yield answers until all works are done, or a process died: whether one did."""
    flying: dict[Future[Answer], Work] = {}
    broken = False
    while True:
        while not broken and len(flying) < window and (work := next(waiting, None)) is not None:
            try:
                flying[pool.executor.submit(answer, packed(work))] = work
            except BrokenExecutor as error:
                broken = True
                yield work, error
            except Exception as error:  # it cannot be pickled
                yield work, error
        if not flying:
            return broken
        ended, _ = wait(flying, timeout=PULSE, return_when=FIRST_COMPLETED)
        check()
        for future in ended:
            work = flying.pop(future)
            found = _found(future)
            broken = broken or isinstance(found, BrokenExecutor)
            yield work, found


def _found(future: Future[Answer]) -> Answer | BaseException:
    try:
        return future.exception() or future.result()
    except CancelledError as error:  # a scheduler has gone
        return error
