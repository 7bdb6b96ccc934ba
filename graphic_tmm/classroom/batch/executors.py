"""Who does the work: processes here, a cluster, or nobody else; each is an executor of Python's own kind.

Processes are forked from one that has loaded what drawing needs (Linux), or begun anew; they end at once when
nobody holds the other end of their line any more: at Ctrl-C, and however this process ended.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from functools import partial
from multiprocessing.connection import Connection
from threading import Thread
from typing import Any, NamedTuple

from graphic_tmm.errors import SheetError, installing, printable
from graphic_tmm.language.said import said

LOADED = "graphic_tmm.classroom.making"
"""What the process loads that others are forked from."""
METHOD = "forkserver" if sys.platform == "linux" else "spawn"
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""Variables of the environment by which a process is told to compute in one thread: there are others."""
PATIENCE = 15
"""So many s a scheduler has to answer."""

LARGE, MOST = "distributed.admin.large-graph-warning-threshold", "1 GB"
"""What travels at once is a photograph at the most: the cluster is not to warn of it."""


class Pool(NamedTuple):
    """An executor, how many pieces of work it does at once, and whether anybody is there to do them."""

    executor: Executor
    at_once: int
    has_workers: Callable[[], bool] = lambda: True


class Here(Executor):
    """Does what it is given at once, in this process."""

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Return a future that is done."""
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


@contextmanager
def opened(where: int | str, *, alone: bool = False) -> Iterator[Pool]:
    """Give an executor: so many processes, this process (0), or the cluster of a scheduler's address.

    ``alone``: one that does one piece of work at a time. What is done in it when an error comes is broken off.

    Raises
    ------
    SheetError
        If no scheduler answers at the address, or what speaks with it is not installed.
    """
    if isinstance(where, str):
        with _cluster(where) as found:
            yield found._replace(at_once=1) if alone else found
    elif where == 0:
        yield Pool(Here(), 1)
    else:
        count = 1 if alone else where
        with _processes(count) as pool:
            yield Pool(pool, count)


def died(error: BaseException) -> bool:
    """Whether an error tells that the process died in which the work was done."""
    return isinstance(error, BrokenExecutor) or type(error).__name__ == "KilledWorker"


# ---------------------------------------------------------------- processes


@contextmanager
def _processes(count: int) -> Iterator[Executor]:
    context = multiprocessing.get_context(METHOD)
    end, line = context.Pipe(duplex=False)
    with _single_threaded():
        if METHOD == "forkserver":
            _serve_forks(context)
        pool = ProcessPoolExecutor(count, context, initializer=_begin, initargs=(end,))
        try:
            yield pool
        except BaseException:
            line.close()  # they end now
            pool.shutdown(wait=True, cancel_futures=True)
            raise
        finally:
            pool.shutdown(wait=True)
            line.close()
            end.close()


def _serve_forks(context: Any) -> None:
    """Begin the process that others are forked from; Ctrl-C of the terminal passes it by, and them."""
    from multiprocessing import forkserver

    context.set_forkserver_preload([LOADED])
    kept = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        forkserver.ensure_running()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, kept)


@contextmanager
def _single_threaded() -> Iterator[None]:
    """Let processes that are begun within compute in one thread."""
    kept = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    try:
        yield
    finally:
        for name, value in kept.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


def _begin(line: Connection) -> None:
    """Begin a process that works: deaf to Ctrl-C, and at an end when its line is."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_watch, args=(line,), daemon=True).start()


def _watch(line: Connection) -> None:
    with suppress(EOFError, OSError):
        line.recv()
    os._exit(1)


# ---------------------------------------------------------------- a cluster


def _has_workers(client: Any) -> bool:
    try:
        return bool(client.ncores())
    except OSError:  # the scheduler has gone, too
        return False


@contextmanager
def _cluster(address: str) -> Iterator[Pool]:
    try:
        from dask import config
        from distributed import Client
    except ImportError as error:
        says = said("a scheduler needs the extra cluster: {remedy}", remedy=installing("[cluster]"))
        raise SheetError(says) from error
    try:
        opens: Any = Client  # its types are not told
        client = opens(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        says = said(
            "no scheduler answers at {address}: write it as the scheduler tells it, tcp://10.0.0.1:8786",
            address=printable(address),
        )
        raise SheetError(says) from error
    try:
        executor = client.get_executor(pure=False)
        with config.set({LARGE: MOST}):
            cores = max(1, sum(client.ncores().values()))
            yield Pool(executor, cores, partial(_has_workers, client))
        executor.shutdown()
    except BaseException:
        executor.shutdown(wait=False)
        raise
    finally:
        client.close()
