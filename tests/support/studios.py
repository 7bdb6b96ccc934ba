"""The studio as a person has it: served to a browser by this computer, watched at what it does."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import uvicorn

from graphic_tmm.serve.desk import Desk
from graphic_tmm.serve.folder import folder_of
from graphic_tmm.serve.routes import application
from support.browser import Watch, tool
from support.served import PATIENCE, TOKEN

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


SIZES = {
    "desk": {"width": 1280, "height": 800},
    "phone": {"width": 390, "height": 844},
    "turned": {"width": 844, "height": 390},
}
AXE = """() => axe.run({ exclude: [["iframe"]] }, { resultTypes: ["violations"] }).then((found) =>
  found.violations.filter((one) => ["serious", "critical"].includes(one.impact))
    .map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 160)).join(" ")}`))"""


def expect(it: Any) -> Any:
    """Return what waits until something holds of a part of a page."""
    from playwright.sync_api import expect as waiting

    waiting.set_options(timeout=PATIENCE * 1000)
    return waiting(it)


@contextmanager
def serving(folder: Path, port: int = 0, language: str = "") -> Iterator[str]:
    """Serve a folder, or a scene, in a thread; yield the address of its gallery."""
    app = application(Desk(folder_of(str(folder)), language), TOKEN)
    config = uvicorn.Config(
        app,
        host="127.0.0.1",
        port=port,
        log_level="critical",
        lifespan="on",
        timeout_graceful_shutdown=0,
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        end = time.monotonic() + PATIENCE
        while not server.started and time.monotonic() < end:
            time.sleep(0.02)
        place = server.servers[0].sockets[0].getsockname()[1]
        yield f"http://127.0.0.1:{place}/{TOKEN}/"
    finally:
        server.should_exit = True
        thread.join(PATIENCE)


class _Below:
    """The addresses that begin with one."""

    def __init__(self, address: str) -> None:
        self.address = address

    def __contains__(self, other: str) -> bool:
        return other == "about:blank" or other.startswith(self.address)


class Tab:
    """A page of the studio in a tab, watched: whatever it asks for has to stand below its address."""

    def __init__(self, browser: Browser, gallery: str, address: str, **options: Any) -> None:
        self.context = browser.new_context(
            **{"viewport": {"width": 1280, "height": 800}, **options}
        )
        self.context.set_default_timeout(2000 * PATIENCE)
        self.watch = Watch(self.context, None)
        self.watch.own = _Below(gallery)  # type: ignore[assignment]
        self.page: Page = self.context.new_page()
        self.page.goto(gallery + address)
        self.allowed = "(?!)"

    def allow(self, pattern: str) -> None:
        """Take lines of the console for what they are: the browser's own account of what was refused."""
        self.allowed = pattern

    def settle(self) -> list[str]:
        """Return what the page did until now that it must not."""
        self.page.title()
        return [one for one in self.watch.took() if not re.search(self.allowed, one)]

    # ------------------------------------------------------------ the studio's parts

    def told(self, text: str) -> None:
        """Wait until the line at the foot says something."""
        self.page.locator("#told", has_text=text).wait_for()

    def field(self, key: str) -> Any:
        """Return the input of a value, its section open."""
        self.page.locator(".values input[type=search]").fill(key)
        field = self.page.locator(".field").filter(has=self.page.locator("label"))
        return field.locator(f"xpath=self::*[@data-key='{key}']").locator("input, select, textarea")

    def shown(self, number: int = 0) -> str:
        """Return the hash of the sheet whose picture is seen, as soon as there is one."""
        figure = self.page.locator("figure.sheet").nth(number)
        figure.locator("img").wait_for()
        return str(figure.get_attribute("data-shown"))

    def another(self, before: str, number: int = 0) -> str:
        """Return the hash of a sheet's picture as soon as it is another one."""
        figure = self.page.locator("figure.sheet").nth(number)
        expect(figure).not_to_have_attribute("data-shown", before)
        return self.shown(number)


def serious(page: Any) -> list[str]:
    """What axe finds to be in the way of a person."""
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(tool("axe-core/axe.min.js").read_text(encoding="utf-8"))
    return page.evaluate(AXE)  # type: ignore[no-any-return]


def in_sight(page: Any) -> list[str]:
    """What stands out of the window sideways, or is too small to press."""
    return page.evaluate(  # type: ignore[no-any-return]
        """() => {
          const wide = document.documentElement.scrollWidth > innerWidth ? ["the page is too wide"] : [];
          const pressed = [...document.querySelectorAll("button, select, input, summary, header a")];
          const small = pressed.filter((one) => one.checkVisibility()).filter((one) => {
            const { width, height } = one.getBoundingClientRect();
            return Math.min(width, height) < 43.5;
          });
          return [...wide, ...small.map((one) => one.outerHTML.slice(0, 100))];
        }"""
    )
