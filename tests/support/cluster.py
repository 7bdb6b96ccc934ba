"""A Dask cluster on this machine, for tests; the test is skipped where there is no Dask."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

WAIT = "15s"
"""So long it looks for a worker that has died; of its own accord half a minute. On a busy machine a new one may
need 5 s to begin, and is given up if it is not waited for."""


@contextmanager
def cluster(workers: int = 2) -> Iterator[str]:
    """Yield the address of its scheduler, which gives up a work that one worker has died of."""
    distributed = pytest.importorskip("distributed")
    from dask import config

    with (
        config.set(
            {
                "distributed.comm.timeouts.connect": WAIT,
                "distributed.scheduler.allowed-failures": 0,
                "distributed.worker.profile.enabled": False,
            }
        ),
        distributed.LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            silence_logs=50,
        ) as found,
    ):
        yield found.scheduler_address
