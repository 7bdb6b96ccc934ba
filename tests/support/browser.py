"""A browser as a person has one, for pages that must do nothing but show themselves.

Playwright drives a Chromium that is there already: nothing is downloaded. `Watch` writes down whatever a page
does that it must not: complaints on the console, faults, dialogs, requests for anything but its own file.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from support.gallery import ROOT

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
"""No window, no greetings, no talk with anybody."""
WEB = ROOT / ".ci" / "web"
TOOLS = WEB / "node_modules"
REQUIRED = "GRAPHIC_TMM_BROWSER"
"""The variable that says "required": what is missing is then a failure and not skipped."""
OWN = "GRAPHIC_TMM_CHROMIUM"
"""The variable that names a browser of one's own."""
FRAMES = """() => new Promise((done) => {
  let left = 3;
  const one = () => { left -= 1; if (left < 0) done(); else requestAnimationFrame(one); };
  one();
})"""
"""What was asked to be drawn is drawn then, what a browser itself tells of a layout is heard and drawn too."""
SPOKEN = ("error", "warning", "assert")
"""The kinds of lines on the console that a page of ours never writes."""


def without(what: str, remedy: str) -> None:
    """Skip the test for what is missing on this machine, or fail where that is required."""
    told = f"{what} is missing: {remedy}"
    if os.environ.get(REQUIRED) == "required":
        pytest.fail(told, pytrace=False)
    pytest.skip(told)


def chromium() -> str:
    """Return the path of the browser, or skip the test."""
    named = [os.environ[OWN]] if OWN in os.environ else NAMES
    found = next(filter(None, map(shutil.which, named)), None)
    if found is None:
        without(
            " or ".join(named), f"install Chromium from the system's packages, or name it by {OWN}"
        )
    return str(found)


def tool(name: str) -> Path:
    """Return the path of a file in an npm package of ``.ci/web``, or skip the test."""
    found = TOOLS / name
    if not found.exists():
        without(f"{name} of npm", "npm ci --prefix .ci/web --ignore-scripts")
    return found


@contextmanager
def launched(*flags: str) -> Iterator[Browser]:
    """Yield a browser that runs until the end of the block, or skip the test."""
    path = chromium()
    try:
        from playwright.sync_api import sync_playwright
    except ModuleNotFoundError:
        without("playwright", "pip install -e '.[browser]'")
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=path, args=[*FLAGS, *flags])
        yield browser
        browser.close()


class Watch:
    """What a page, and the windows that it opens, did that it must not."""

    def __init__(self, context: BrowserContext, file: Path | None) -> None:
        self.faults: list[str] = []
        self.own = {"about:blank", *([file.as_uri()] if file is not None else [])}
        context.on("console", self._said)
        context.on("weberror", lambda one: self.faults.append(f"fault: {_told(one.error)}"))
        context.on("dialog", self._asked)
        context.on("request", self._requested)

    def _said(self, line: Any) -> None:
        if line.type in SPOKEN:
            self.faults.append(f"console {line.type}: {line.text}")

    def _asked(self, dialog: Any) -> None:
        self.faults.append(f"dialog {dialog.type}: {dialog.message}")
        dialog.dismiss()

    def _requested(self, request: Any) -> None:
        if request.url.partition("#")[0] not in self.own:
            self.faults.append(f"request: {request.url[:200]}")

    def took(self) -> list[str]:
        """Return the faults until now, and forget them."""
        found, self.faults = self.faults, []
        return found


class Opened:
    """A file, or nothing yet, in a tab of its own, watched: ``page`` is Playwright's."""

    def __init__(
        self, browser: Browser, file: Path | None, address: str = "", **options: Any
    ) -> None:
        self.file = file
        self.context = browser.new_context(
            **{"viewport": {"width": 1280, "height": 800}, **options}
        )
        self.context.set_default_timeout(10_000)
        self.watch = Watch(self.context, file)
        self.page: Page = self.context.new_page()
        if file is not None:
            self.page.goto(file.as_uri() + address)

    def settle(self) -> list[str]:
        """Return what the page did until now that it must not, and forget it.

        One more round to the page: what it said before that has arrived.
        """
        if not self.page.is_closed():
            self.page.title()
        return self.watch.took()

    def close(self) -> None:
        """Close the tab and all that it opened."""
        self.context.close()


def _told(fault: Any) -> str:
    """Return what a fault of the page's script says, with the first place that it tells."""
    stack = (getattr(fault, "stack", "") or "").splitlines()
    return " ".join(line.strip() for line in stack[:2]) or str(fault)
