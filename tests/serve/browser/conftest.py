"""One studio a session, over a folder into which every test puts a scene of its own, in Chromium."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from support.served import small
from support.studios import Tab, serving

HERE = f"{Path(__file__).parent}{os.sep}"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """A browser takes seconds to begin: nothing here is an everyday test."""
    for item in items:
        if str(item.path).startswith(HERE):
            item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("scenes")


@pytest.fixture(scope="session")
def address(folder: Path) -> Iterator[str]:
    with serving(folder) as found:
        yield found


@pytest.fixture
def tab_of(browser: Any, address: str) -> Iterator[Callable[..., Tab]]:
    """Open addresses below the gallery's; a tab that did what it must not fails the test."""
    tabs: list[Tab] = []

    def begin(place: str = "", gallery: str = address, **options: Any) -> Tab:
        tabs.append(Tab(browser, gallery, place, **options))
        return tabs[-1]

    yield begin
    faults = [fault for tab in tabs for fault in tab.settle()]
    for tab in tabs:
        tab.context.close()
    assert faults == []


@pytest.fixture
def scene(folder: Path, request: pytest.FixtureRequest) -> Path:
    """The file of a scene that only this test has; its folder is called as the test is."""
    return small(folder, request.node.name.removeprefix("test_")[:40])


@pytest.fixture
def studio(scene: Path, tab_of: Callable[..., Tab]) -> Tab:
    """The studio of that scene, its sheet there."""
    tab = tab_of(f"s/{scene.parent.name}/")
    tab.shown()
    return tab
