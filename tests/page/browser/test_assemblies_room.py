"""The room of assemblies in a browser: each picture in its frame, all of it fits a phone, in the dark too."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support.axe import serious
from support.looks import PHONE, SMALL, WIDE
from support.plates import machine
from support.squares import square

import graphic_tmm as tmm
from graphic_tmm.page.page import page as written
from graphic_tmm.studio import sheets

SIZED = "\n[plans]\nmain = 0\n[[sheet]]\nformat = 'A1'\nplace = ['positions']\n"
OUTSIDE = """(all) => all.filter((svg) => {
  const [frame, ...lines] = [svg, ...svg.querySelectorAll("polyline")]
    .map((one) => one.getBoundingClientRect());
  return lines.length < 3 || lines.some((one) => one.left < frame.left - 1 || one.right > frame.right + 1 ||
    one.top < frame.top - 1 || one.bottom > frame.bottom + 1);
}).length"""
STRANGERS = {"plate": lambda: machine(1).text, "square": lambda: square(0).text}


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("kind", STRANGERS)
def test_assemblies_of_a_stranger_s_mechanism(
    kind: str, scheme: str, opened: Callable[..., Any], tmp_path: Path
) -> None:
    text = 'language = "en"\n' + STRANGERS[kind]().replace('accelerations = "all"\n', "") + SIZED
    made, found = sheets(tmm.read(text))
    file = tmp_path / "page.html"
    file.write_text(written(made, found, live=False), encoding="utf-8")
    page = opened(file, color_scheme=scheme, **PHONE).page
    page.get_by_role("tab", name="Assemblies").click()
    room = page.locator("#assemblies")
    assert room.is_visible()
    assert not page.locator("#sheets").is_visible()
    pictures = room.locator("li")
    assert pictures.count() > 1
    assert room.locator("svg").evaluate_all(OUTSIDE) == 0
    taken = room.locator("li.taken")
    assert taken.count() == 1
    assert "drawn" in taken.inner_text()
    assert all("near = " in one and "near_at = " in one for one in pictures.all_inner_texts())
    assert page.evaluate(WIDE) == []
    assert page.evaluate(SMALL) == []
    assert serious(page) == []
