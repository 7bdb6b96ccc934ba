"""One cluster for all tests of a file: it takes seconds to begin, and some of the processor while it waits."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from support.cluster import cluster


@pytest.fixture(scope="module")
def scheduler() -> Iterator[str]:
    """The address of a scheduler with two workers, which stand where the tests were begun."""
    with cluster() as address:
        yield address
