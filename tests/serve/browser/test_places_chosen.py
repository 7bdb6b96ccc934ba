"""A plate whose place is not told: its places are shown small beside the fault, and a click writes one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from support.gallery import ROOT
from support.plates import machine
from support.studios import Tab, expect

from graphic_tmm.scene.read import read


def test_a_click_on_a_place_writes_it(scene: Path, tab_of: Callable[..., Tab]) -> None:
    text = (ROOT / "sheets" / "landing-gear" / "scene.toml").read_text("utf-8")
    scene.write_text(text.replace('near = "102 deg"\n', ""), encoding="utf-8")
    tab = tab_of(f"s/{scene.parent.name}/")
    places = tab.page.locator(".faults .pictures button")
    expect(places.first).to_be_visible(timeout=30_000)
    listed = places.locator("span").all_inner_texts()
    assert len(listed) > 1
    assert places.first.locator("polyline").count() == 4
    places.nth(1).click()
    expect(places).to_have_count(0, timeout=30_000)
    near = read(scene).mechanism.by_number[2].near
    assert near is not None
    assert f"near = {near.angle:.6g} deg" == listed[1]
    tab.shown()


@pytest.mark.parametrize("seed", [1, 4])
def test_places_stand_beside_the_scheme_too(
    seed: int, scene: Path, tab_of: Callable[..., Tab]
) -> None:
    text = "".join(
        line for line in machine(seed).text.splitlines(True) if not line.startswith("near")
    )
    scene.write_text(f'language = "en"\n{text}', encoding="utf-8")
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    places = tab.page.locator("aside:visible .pictures button")
    expect(places.first).to_be_visible(timeout=30_000)
    chosen = places.last.inner_text()
    tab.allow(".*422.*")
    places.last.click()
    expect(places).to_have_count(0, timeout=30_000)
    expect(tab.page.locator(".scheme-side .structure b")).to_have_text("W = 1", timeout=30_000)
    expect(tab.page.locator(".scheme-side > .wrong")).to_have_text("")
    near = read(scene).mechanism.by_number[5].near
    assert near is not None
    assert f"near = {near.angle:.6g} deg" == chosen
