"""One Chromium a session; what it opens is watched, and fails the test in which it does what it must not."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from support.browser import Opened, launched


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """A browser takes seconds to begin: nothing here is an everyday test."""
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    with launched() as found:
        yield found


@pytest.fixture
def opened(browser: Any) -> Iterator[Callable[..., Opened]]:
    """Open files; each is closed at the end of the test, which fails if one did what it must not."""
    tabs: list[Opened] = []

    def begin(file: Path, address: str = "", **options: Any) -> Opened:
        tabs.append(Opened(browser, file, address, **options))
        return tabs[-1]

    yield begin
    faults = [fault for tab in tabs for fault in tab.settle()]
    for tab in tabs:
        tab.close()
    assert faults == []
