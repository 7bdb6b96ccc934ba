"""Pages of other scenes than the default one: without scripts, on a phone, seen by axe, in one language."""

from __future__ import annotations

import re

import pytest
from support import pages
from support.axe import STROKES, serious
from support.lesson import names
from support.looks import PHONE, SMALL, WIDE

from graphic_tmm.readers.protocol import plans, steps_of

LOOKED_AT = ("engine", "gear-pair", "lettering")
"""Scenes of a machine, of a part, of none."""
TAGS = ("wcag2a", "wcag2aa", "wcag21aa", "wcag22aa", "best-practice")


def tabs(page):
    """Yield the names of the ways to look at a scene, each chosen in turn."""
    for one in page.get_by_role("tab").all():
        one.click()
        yield one.text_content()


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", LOOKED_AT)
def test_without_scripts_there_are_sheets_and_protocol(name: str, opened, files) -> None:
    spoken = pages.language(name)
    made, sheets = pages.on_sheets(name, spoken)
    page = opened(files(name), java_script_enabled=False).page
    for sheet in sheets:
        (drawn,) = (
            page.locator("svg").filter(has=page.locator("title", has_text=sheet.title)).all()[:1]
        )
        assert drawn.is_visible()
        assert drawn.bounding_box()["width"] > 600
    assert page.get_by_role("heading", level=1).text_content() == made.scene.title
    told = re.sub(r"[\s\[\]]", "", page.locator("body").inner_text())
    due = steps_of(made, plans(), None, spoken, why=True) if made.boards else []
    lost = [line for line in due if re.sub(r"[\s\[\]]|^\s*\d+(–\d+)?\.", "", line) not in told]
    assert lost == []
    assert not page.get_by_role("button").all()


@pytest.mark.parametrize("name", LOOKED_AT)
def test_there_is_a_tab_for_what_there_is_to_see(name: str, page_of) -> None:
    page = page_of(name).page
    called = names(pages.language(name))
    due = {
        "engine": ["play", "crank", "sheets", "lecture"],
        "gear-pair": ["play", "sheets", "lecture", "turning"],
    }
    assert list(tabs(page)) == [called[key] for key in due.get(name, ["sheets"])]
    for _ in tabs(page):
        panel = page.get_by_role("tabpanel")
        assert panel.count() == 1
        assert panel.locator("svg[role=img]:visible, canvas:visible").first.is_visible()


@pytest.mark.parametrize("name", LOOKED_AT)
def test_a_phone_never_scrolls_sideways(name: str, page_of) -> None:
    page = page_of(name, **PHONE).page
    for tab in tabs(page):
        assert (tab, page.evaluate(WIDE)) == (tab, [])
        assert (tab, page.evaluate(SMALL)) == (tab, [])


@pytest.mark.parametrize("name", LOOKED_AT)
def test_axe_finds_nothing_serious(name: str, page_of) -> None:
    page = page_of(name).page
    for tab in tabs(page):
        assert (tab, *serious(page, without=STROKES, tags=TAGS)) == (tab,)


def test_axe_can_find_something(opened, tmp_path) -> None:
    file = tmp_path / "bad.html"
    body = "<button></button><p style='color:#bbb;background:#fff'>pale</p><img src=''>"
    file.write_text(f"<!DOCTYPE html><title>t</title>{body}", encoding="utf-8")
    page = opened(file).page
    found = {one.partition(":")[0] for one in serious(page, without=STROKES, tags=TAGS)}
    assert {"button-name", "color-contrast", "html-has-lang", "image-alt"} <= found


@pytest.mark.parametrize("language", pages.LANGUAGES)
def test_a_page_is_in_one_language(language: str, page_of) -> None:
    page = page_of("crank-rocker", language).page
    assert page.evaluate("document.documentElement.lang") == language
    called = names(language)
    for key in ("first", "previous", "next", "last"):
        assert page.get_by_role("button", name=called[key], exact=True).is_visible()
    page.get_by_role("button", name=called["next"], exact=True).click()
    letters = "[А-яЁё]" if language == "en" else r"\b(?:the|draw|step|position|through|mark)\b"
    for tab in tabs(page):
        assert (tab, re.findall(letters, page.locator("main").inner_text(), re.IGNORECASE)) == (
            tab,
            [],
        )
