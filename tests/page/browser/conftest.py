"""Pages in Chromium; what is opened is watched, and fails the test in which it does what it must not."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from support import pages
from support.browser import Opened

HERE = f"{Path(__file__).parent}{os.sep}"
PLAYED = ("crank-press", "crank-rocker", "gear-pair")
"""Scenes that are played from end to end: all that a machine is asked for, a plain mechanism, a part."""


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """A browser takes seconds to begin: nothing here is an everyday test. All are played when measured."""
    here = [item for item in items if str(item.path).startswith(HERE)]
    left_out = set()
    for item in here:
        item.add_marker(pytest.mark.slow)
        name = item.callspec.params.get("name") if hasattr(item, "callspec") else None
        if item.path.name == "test_plays.py" and name not in (None, *PLAYED):
            left_out.add(item)
    if left_out and not config.getoption("--measured"):
        config.hook.pytest_deselected(items=list(left_out))
        items[:] = [item for item in items if item not in left_out]


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


@pytest.fixture(scope="session")
def files(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Write pages of scenes of the package, each once; a page is in the scene's language if none is named.

    Workers of one run have one folder of them: what another has written is there.
    """
    own = tmp_path_factory.getbasetemp()
    folder = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "pages"
    folder.mkdir(exist_ok=True)

    def written(name: str, language: str = "") -> Path:
        spoken = language or pages.language(name)
        file = folder / f"{name}-{spoken}.html"
        if not file.exists():
            being_written = own / file.name
            being_written.write_text(pages.text(name, spoken), encoding="utf-8")
            being_written.replace(file)
        return file

    return written


@pytest.fixture
def page_of(opened: Callable[..., Opened], files: Callable[..., Path]) -> Callable[..., Opened]:
    """Open the page of a scene of the package and wait until its buttons are there."""

    def begin(name: str, language: str = "", address: str = "", **options: Any) -> Opened:
        tab = opened(files(name, language), address, **options)
        tab.page.get_by_role("tab").first.wait_for()
        return tab

    return begin
