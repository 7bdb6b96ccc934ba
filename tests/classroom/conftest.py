"""One cluster a session: what one work does to its worker is no other's concern."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from support.cluster import cluster


@pytest.fixture(scope="session")
def scheduler() -> Iterator[str]:
    """The address of a scheduler with two workers, which stand where the tests were begun."""
    with cluster() as address:
        yield address
