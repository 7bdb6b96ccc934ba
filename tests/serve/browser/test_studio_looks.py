"""The studio for everybody: by keys, read aloud, on a phone, in the dark, in a folder; files come down."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support.gallery import SHEETS
from support.served import SMALL, small
from support.studios import SIZES, Tab, expect, in_sight, serious, serving

LOOKS: dict[str, dict[str, Any]] = {
    "light": {"color_scheme": "light"},
    "dark": {"color_scheme": "dark"},
    "forced": {"forced_colors": "active"},
}


@pytest.mark.parametrize(
    ("look", "size"), [("light", "desk"), ("dark", "phone"), ("forced", "turned")]
)
def test_axe_finds_nothing_serious_and_everything_fits(
    look: str, size: str, folder: Path, tab_of: Callable[..., Tab]
) -> None:
    file = small(folder, f"looks-{look}")
    file.write_text(SMALL.replace('"0.3 m"', '"0.3 kg"'), encoding="utf-8")
    tab = tab_of(f"s/{file.parent.name}/", viewport=SIZES[size], **LOOKS[look])
    tab.told("Faults: 1")
    file.write_text(SMALL, encoding="utf-8")
    tab.shown()
    tab.allow("status of 422")
    field = tab.field("drive.speed")
    field.fill("400")
    field.press("Enter")
    tab.page.locator(".refused").wait_for()
    assert serious(tab.page) == []
    tab.page.get_by_role("tab", name="Plans step by step").click()
    tab.page.locator("iframe:not(.coming)").wait_for()
    assert serious(tab.page) == []
    assert in_sight(tab.page) == []
    tab.page.goto(tab.page.url.partition("/s/")[0] + "/")
    tab.page.locator(".card img").first.wait_for()
    assert serious(tab.page) == []
    assert in_sight(tab.page) == []


def test_everything_is_reached_by_keys(studio: Tab) -> None:
    page = studio.page
    # they may come after the sheets
    page.locator(".values .field").first.wait_for(state="attached")
    reached = []
    for _ in range(14):
        page.keyboard.press("Tab")
        reached.append(
            page.evaluate(
                "() => document.activeElement.getAttribute('aria-label')"
                " ?? document.activeElement.textContent"
            )
        )
    order = ["Scenes", "Sheets", "Dark or light", "Larger", "Smaller", "The whole sheet"]
    assert reached[:6] == order
    assert reached[6] == "True size"
    assert reached[7].startswith("The sheets: arrows move them")
    assert reached[8] == "Find a value"
    assert reached[9] == "The scene"
    page.get_by_role("tab", name="Sheets").focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("tab", name="Scheme")).to_be_focused()
    expect(page.locator("#panel-scheme")).to_be_visible()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("tab", name="Plans step by step")).to_be_focused()
    expect(page.locator("#panel-page")).to_be_visible()
    expect(page.locator("#panel-sheets")).to_be_hidden()
    assert page.locator("[role=status], [aria-live]").count() == 1


def test_the_gallery_shows_scenes_as_they_stand(tmp_path: Path, tab_of: Callable[..., Tab]) -> None:
    small(tmp_path, "good")
    bad = small(tmp_path, "bad")
    bad.write_text(SMALL.replace('"0.3 m"', '"0.3 kg"').replace("Small", "Wrong"), encoding="utf-8")
    with serving(tmp_path) as address:
        tab = tab_of(gallery=address)
        tab.allow("ERR_")
        page = tab.page
        good = page.locator(".card", has_text="Small")
        good.locator("img").wait_for()
        expect(good).to_contain_text("without faults")
        wrong = page.locator(".card", has_text="Wrong")
        expect(wrong).to_contain_text("faults: 1")
        bad.write_text(SMALL.replace("Small", "Mended"), encoding="utf-8")
        expect(wrong).to_contain_text("without faults")
        good.get_by_role("link").click()
        tab.shown()
        expect(page.get_by_role("heading", level=1)).to_have_text("Small")
        page.get_by_role("link", name="Scenes").click()
        expect(page.locator(".card")).to_have_count(2)


def test_a_scene_of_the_package_is_only_read(tab_of: Callable[..., Tab]) -> None:
    with serving(SHEETS / "crank-rocker") as address:
        tab = tab_of(gallery=address)
        tab.allow("ERR_")
        tab.shown()
        expect(tab.field("drive.speed")).to_be_disabled()
        tab.page.get_by_text("A scene of the package is not changed").wait_for()


def test_files_come_down(studio: Tab) -> None:
    with studio.page.expect_download() as found:
        studio.page.get_by_role("link", name="Page for a browser (HTML)").click()
    text = Path(found.value.path()).read_text("utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert found.value.suggested_filename.endswith(".html")
