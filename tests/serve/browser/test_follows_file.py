"""What is seen follows the file: sheets are swapped, place and size stay; the page keeps where one is in it."""

from __future__ import annotations

import json
import os
import socket
from collections.abc import Callable
from pathlib import Path

import pytest
from support.served import SMALL, small
from support.studios import Tab, expect, serious, serving

from graphic_tmm.serve import jobs

TWO = SMALL + '[[sheet]]\nformat = "A4"\nplace = ["velocities"]\n'


def saved(file: Path, text: str) -> None:
    """Write a file as editors do: beside it, then in its place."""
    other = file.with_name("other~")
    other.write_text(text, encoding="utf-8")
    os.replace(other, file)


def test_an_edit_swaps_the_sheet_and_keeps_size_and_place(studio: Tab, scene: Path) -> None:
    page, first = studio.page, studio.shown()
    desk = page.locator(".desk")
    desk.focus()
    for key in "1++":
        page.keyboard.press(key)
    desk.evaluate("(desk) => { desk.scrollLeft = 150; desk.scrollTop = 90; }")
    place = "(desk) => [desk.scrollLeft, desk.scrollTop, desk.scrollWidth, desk.scrollHeight]"
    before = desk.evaluate(place)
    assert before[:2] == [150, 90]
    saved(scene, SMALL.replace("0.1 m", "0.12 m"))
    assert studio.another(first) != first
    assert desk.evaluate(place) == before
    studio.told("Drawn as the file says.")


def test_what_did_not_change_is_not_touched(studio: Tab, scene: Path) -> None:
    saved(scene, TWO)
    studio.shown(1)
    studio.told("Drawn as the file says.")
    first, second = studio.shown(0), studio.shown(1)
    studio.page.evaluate("document.querySelectorAll('figure img').forEach((one) => (one.own = 1))")
    saved(scene, TWO.replace("10 1/s", "11 1/s"))
    studio.another(second, 1)
    expect(studio.page.locator(f"figure[data-shown='{first}']")).to_have_count(1)
    kept = "[...document.querySelectorAll('figure img')].map((one) => one.own === 1)"
    assert studio.page.evaluate(kept) == [True, False]


def test_a_sheet_has_its_true_shape_and_size(studio: Tab) -> None:
    figure = studio.page.locator("figure.sheet").first
    box = figure.bounding_box()
    assert box is not None
    assert abs(box["height"] / box["width"] - 297 / 210) < 0.005
    desk = studio.page.locator(".desk").bounding_box()
    assert desk is not None
    assert box["height"] <= desk["height"]
    studio.page.get_by_role("button", name="True size").click()
    box = figure.bounding_box()
    assert box is not None
    assert abs(box["width"] - 210 / 25.4 * 96) < 1


def test_faults_stand_beside_the_sheet_by_line_and_lead_to_their_field(
    studio: Tab, scene: Path
) -> None:
    first = studio.shown()
    saved(scene, SMALL.replace('"0.3 m"', '"0.3 kg"').replace('"10 1/s"', '"10 mm"'))
    studio.told("Faults: 2. The sheets are those of before.")
    faults = studio.page.locator(".faults .fault")
    expect(faults).to_have_count(2)
    expect(faults.nth(0)).to_contain_text("line 11 · point B of link 2")
    expect(faults.nth(0).locator("code")).to_have_text('points = { A = [0, 0], B = ["0.3 kg", 0] }')
    expect(faults.nth(1)).to_contain_text(
        "line 18 · the driving link and its motion: its angular speed"
    )
    expect(faults.nth(1)).to_contain_text("an angular speed is wanted here")
    assert studio.shown() == first
    faults.nth(1).get_by_role("button").click()
    expect(studio.page.locator(":focus")).to_have_value("10 mm")
    saved(scene, SMALL)
    expect(studio.page.locator("section.faults")).to_be_hidden()


def test_a_page_that_fails_is_not_said_of_the_sheets(
    studio: Tab, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = studio.shown()
    studio.told("Drawn as the file says.")
    monkeypatch.setattr(jobs, "paged", json.loads)  # which takes no task
    studio.page.get_by_role("tab", name="Plans step by step").click()
    studio.page.locator("iframe:not(.coming)").wait_for()
    old = studio.page.locator(".old")
    expect(old).to_be_hidden()
    saved(scene, SMALL.replace("0.1 m", "0.12 m"))
    expect(studio.page.locator("#told")).to_contain_text("their page was not made")
    expect(studio.page.locator(".faults .fault")).to_have_count(0)
    expect(old).to_contain_text("This page is out of date")
    assert serious(studio.page) == []
    hash_ = studio.page.locator("iframe").get_attribute("data-hash")
    monkeypatch.undo()
    old.get_by_role("button", name="Draw again").click()
    studio.page.locator(f"iframe:not(.coming):not([data-hash='{hash_}'])").wait_for()
    expect(old).to_be_hidden()
    studio.told("Drawn as the file says.")
    studio.page.get_by_role("tab", name="Sheets").click()
    assert studio.shown() != first


def test_what_was_never_drawn_has_no_sheets_of_before(
    folder: Path, tab_of: Callable[..., Tab]
) -> None:
    file = small(folder, "never-drawn")
    saved(file, SMALL.replace('"0.3 m"', '"0.3 kg"'))
    tab = tab_of("s/never-drawn/")
    tab.told("Faults: 1. Nothing could be drawn yet.")
    tab.page.get_by_role("tab", name="Plans step by step").click()
    tab.page.get_by_text("The page could not be made.").wait_for()


def test_a_file_that_is_no_toml_keeps_sheets_and_typed_values(studio: Tab, scene: Path) -> None:
    studio.allow("status of 4(09|22)")
    studio.field("drive.speed").fill("12 1/s")
    saved(scene, SMALL.replace("[drive]", "[drive"))
    studio.page.locator(".hint", has_text="The file is no TOML").wait_for()
    expect(studio.page.locator(".faults .fault")).to_contain_text("line 16")
    expect(studio.field("drive.speed")).to_have_value("12 1/s")
    assert studio.shown()
    saved(scene, SMALL)
    expect(studio.page.locator(".hint", has_text="The file is no TOML")).to_be_hidden()


def test_the_page_keeps_where_one_is(studio: Tab, scene: Path) -> None:
    page = studio.page
    page.get_by_role("tab", name="Plans step by step").click()
    inner = page.frame_locator("iframe:not(.coming)")
    inner.get_by_role("tab").first.wait_for()
    frame = page.locator("iframe:not(.coming)")
    place = "(frame) => frame.contentWindow.location.hash"
    frame.evaluate("(frame) => { frame.contentWindow.location.hash = '#positions/all/4'; }")
    shown = frame.get_attribute("data-hash")
    saved(scene, SMALL.replace("0.1 m", "0.12 m"))
    page.locator(f"iframe:not(.coming):not([data-hash='{shown}'])").wait_for()
    expect(page.locator("iframe")).to_have_count(1)
    assert frame.evaluate(place) == "#positions/all/4"
    page.reload()
    inner.get_by_role("tab").first.wait_for()
    assert frame.evaluate(place) == "#positions/all/4"


def test_a_page_has_the_window_until_something_is_wrong(studio: Tab, scene: Path) -> None:
    studio.allow("status of 422")
    aside = studio.page.locator("aside[aria-label=Values]")
    expect(aside).to_be_visible()
    studio.page.get_by_role("tab", name="Plans step by step").click()
    studio.page.locator("iframe:not(.coming)").wait_for()
    expect(aside).to_be_hidden()
    inner = studio.page.frame_locator("iframe:not(.coming)")
    inner.get_by_role("tab").first.wait_for()
    expect(inner.get_by_role("heading", level=1)).to_be_hidden()
    expect(inner.locator("#aids button:visible")).to_have_count(1)
    saved(scene, SMALL.replace('"0.3 m"', '"0.3 kg"'))
    expect(aside).to_be_visible()


def test_a_lost_connection_is_told_and_mended(tmp_path: Path, tab_of: Callable[..., Tab]) -> None:
    file = small(tmp_path, "held")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with serving(tmp_path, port) as address:
        tab = tab_of("s/held/", gallery=address)
        tab.allow("ERR_CONNECTION_REFUSED|ERR_INCOMPLETE_CHUNKED|ERR_CONNECTION_RESET|ERR_EMPTY")
        first = tab.shown()
    tab.told("The connection is lost")
    saved(file, SMALL.replace("0.1 m", "0.12 m"))
    with serving(tmp_path, port):
        assert tab.another(first) != first
        tab.told("Drawn as the file says.")


def test_lengths_changed_in_the_page_are_put_into_the_scene_and_taken_back(
    studio: Tab, scene: Path
) -> None:
    page = studio.page
    scene.write_text(SMALL.replace('"0.3 m"', '"0.3 m"  '), encoding="utf-8")
    page.get_by_role("tab", name="Plans step by step").click()
    inner = page.frame_locator("iframe:not(.coming)")
    inner.get_by_role("tab", name="Crank").click()
    inner.locator(".lengths summary").first.click()
    put = inner.get_by_role("button", name="Put into my scene")
    expect(put).to_be_disabled()
    field = inner.get_by_role("textbox", name="l_AB, value")
    field.fill("320")
    field.press("Enter")
    put.click()
    expect(inner.locator(".lengths .told")).to_contain_text("Put into the scene")
    text = scene.read_text("utf-8")
    assert text == SMALL.replace('"0.3 m"', '"0.32 m"  ')
    page.get_by_role("tab", name="Scheme").click()
    page.locator("[data-tool=undo]").click()
    page.locator(".scheme[aria-busy=false]").wait_for()
    assert scene.read_text("utf-8") == SMALL.replace('"0.3 m"', '"0.3 m"  ')


def test_lengths_changed_in_the_page_outlive_a_change_of_another_in_the_file(
    studio: Tab, scene: Path
) -> None:
    page = studio.page
    page.get_by_role("tab", name="Plans step by step").click()
    inner = page.frame_locator("iframe:not(.coming)")
    inner.get_by_role("tab", name="Crank").click()
    inner.locator(".lengths summary").first.click()
    crank, rod = (inner.get_by_role("textbox", name=f"l_{it}, value") for it in ("OA", "AB"))
    rod.fill("320")
    rod.press("Enter")
    longer = SMALL.replace('"0.1 m"', '"0.12 m"')
    saved(scene, longer)
    expect(crank).to_have_value("120")
    expect(rod).to_have_value("320")
    saved(scene, longer.replace('"0.3 m"', '"0.31 m"'))
    expect(rod).to_have_value("310")
