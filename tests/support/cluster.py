"""A Dask cluster of two workers on this machine, for tests; the test is skipped where there is no Dask."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

WAIT = "5s"
"""So long it looks for a worker that has died; of its own accord half a minute."""


@contextmanager
def cluster() -> Iterator[str]:
    """Yield the address of its scheduler."""
    distributed = pytest.importorskip("distributed")
    from dask import config

    with (
        config.set({"distributed.comm.timeouts.connect": WAIT}),
        distributed.LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            silence_logs=50,
        ) as found,
    ):
        yield found.scheduler_address
