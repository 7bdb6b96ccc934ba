"""A page that is practised on is otherwise as ever: nothing of practice touches the other tabs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support import pages
from support.browser import FRAMES

from graphic_tmm.page.page import page as written

SCENE = "crank-rocker"
LAID = """(tab) => [...document.querySelectorAll(`#${tab}, #${tab} *`)]
  .filter((one) => one.checkVisibility() && !one.closest("svg svg, g"))
  .map((one) => [one.tagName, one.getAttribute("class") ?? "", one.getBoundingClientRect()])
  .map(([tag, name, { x, y, width, height }]) =>
    [tag, name, ...[x, y, width, height].map((size) => Math.round(size * 10) / 10)].join(" "))"""
"""Everything that is seen of a tab, and where it is."""


@pytest.fixture(scope="module")
def both(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("both")
    for name in ("bare", "practised"):
        text = written(*pages.on_sheets(SCENE, "en"), practised=name == "practised")
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    return folder / "bare.html", folder / "practised.html"


TABS = {
    "play": "#velocities/all/9",
    "crank": "#crank:@40",
    "sheets": "#sheets:",
    "lecture": "#lecture:velocities/all/9",
}


@pytest.mark.turns(2)
@pytest.mark.parametrize("tab", TABS)
def test_other_tabs_are_laid_out_as_ever(
    opened: Callable[..., Any], both: tuple[Path, Path], tab: str
) -> None:
    laid = []
    for file in both:
        page = opened(file, TABS[tab], viewport={"width": 1280, "height": 900}).page
        page.locator("html.ready").wait_for()
        if tab == "crank":
            page.locator("#crank[data-ready]").wait_for()
        page.evaluate(FRAMES)
        laid.append([page.evaluate(LAID, tab)])
        page.set_viewport_size({"width": 1920, "height": 900})
        page.evaluate(FRAMES)
        laid[-1].append(page.evaluate(LAID, tab))
    assert min(map(len, laid[0])) > 20
    assert laid[0] == laid[1]
