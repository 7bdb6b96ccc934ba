"""The gallery in a browser: it asks for its pictures alone, and leads to the pages."""

from __future__ import annotations

import pytest
from support.browser import Opened, tool
from support.command import invoke
from support.served import SMALL

SIZES = {
    "light": {"viewport": {"width": 1280, "height": 800}, "color_scheme": "light"},
    "dark": {"viewport": {"width": 360, "height": 640}, "color_scheme": "dark"},
}
AXE = "() => axe.run().then((found) => found.violations.map((one) => one.id))"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("site")
    for name in ("first", "второй"):
        title = f'"{name} mechanism with a title that is long enough to be broken"'
        text = SMALL.replace('"Small"', title)
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    assert invoke("page", folder, "--all", "-o", folder / "out").exit_code == 0
    return folder / "out"


@pytest.mark.parametrize("look", SIZES)
def test_a_gallery_shows_its_pictures_and_leads_to_pages_and_languages(
    browser, site, look: str
) -> None:
    opened = Opened(browser, site / "index.html", **SIZES[look])
    opened.watch.own |= {file.as_uri() for file in site.iterdir()}
    page = opened.page
    try:
        page.wait_for_function("() => [...document.images].every((one) => one.naturalWidth > 0)")
        assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")
        opened.watch.took()  # pictures may be asked for before they are known as its own
        page.evaluate(tool("axe-core/axe.min.js").read_text(encoding="utf-8"))
        assert page.evaluate(AXE) == []
        page.click("nav a")
        assert page.evaluate("() => document.documentElement.lang") == "ru"
        page.click("main a >> nth=1")
        page.wait_for_selector("[role=tab]")
        assert page.url.partition("#")[0] == (site / "второй.html").as_uri()
        assert opened.settle() == []
    finally:
        opened.close()
