"""A plate whose place is not told: its places are shown small beside the fault, and a click writes one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from support.gallery import ROOT
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
