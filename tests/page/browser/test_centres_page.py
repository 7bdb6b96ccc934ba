"""Instantaneous centres in a browser: their scheme moves with the crank; a student finds one by other lines."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support import pages
from support.browser import FRAMES, Opened

from graphic_tmm.board.hand import EXACT
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.page.dense import dense
from graphic_tmm.page.page import page as written

NAME = "centres-of-six-bar"
CIRCLES = """() => [...[...document.querySelectorAll("#crank .card svg")]
  .find((one) => one.getAttribute("aria-label") === "Instantaneous centres")
  .querySelectorAll(".body .pen path")]
  .filter((one) => one.getAttribute("visibility") !== "hidden")
  .map((one) => one.getAttribute("d") ?? "")
  .filter((one) => one.includes("A") || one.includes("a"))"""
"""What is drawn with arcs in the scheme of centres."""
NEAR = 0.05


def test_the_scheme_moves_with_the_crank(page_of: Callable[..., Opened]) -> None:
    made, _ = pages.on_sheets(NAME, "en")
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    centres = [
        one for one in CENTRES_PLAN.on(found.drawn).centres if one.name in ("P_{34}", "P_{13}")
    ]
    tab = page_of(NAME, address="#crank:@0")
    tab.page.wait_for_selector("#crank[data-ready]")
    tab.page.locator("#crank .choices").get_by_label("Instantaneous centres").check()
    card = tab.page.locator("#crank .card", has_text="Instantaneous centres")
    card.scroll_into_view_if_needed()
    card.locator("svg .body .pen path").first.wait_for(state="attached")
    for turned in (40, 251):
        tab.page.evaluate("(to) => { location.hash = `#crank:@${to}`; }", turned)
        tab.page.wait_for_function(
            "(to) => document.querySelector('#crank .angle').textContent.includes(to)",
            arg=f"{turned}°",
        )
        tab.page.evaluate(FRAMES)
        spots = [
            list(map(float, re.findall(r"-?\d+(?:\.\d+)?", one)[:2]))
            for one in tab.page.evaluate(CIRCLES)
        ]
        for one in centres:
            z = complex(found.drawn.reading[one.mark][0, turned])
            # a circle begins on its left
            assert any(abs(complex(x, -y) - z) < 1.3 + NEAR for x, y in spots), (turned, one.name)


@pytest.fixture(scope="session")
def practised(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("centres") / "page.html"
    file.write_text(written(*pages.on_sheets(NAME, "en"), practised=True), encoding="utf-8")
    return file


class Student:
    """Who works with instruments by the keyboard."""

    def __init__(self, page: Any) -> None:
        self.page, self.room = page, page.locator("#practice")

    def lay(self, key: str, *letters: str) -> None:
        self.page.keyboard.press(key)
        for letter in letters:
            buttons = self.room.locator(".listing button")
            texts = [text.split(" = ")[0] for text in buttons.all_inner_texts()]
            own = [k for k, text in enumerate(texts) if text == letter]
            buttons.nth(own[-1]).click()

    def told(self) -> str:
        return " ".join(self.room.locator(".judged").inner_text().split())

    def mark(self, z: complex) -> None:
        for axis, value in (("x", z.real), ("y", z.imag)):
            self.room.get_by_label(axis, exact=True).fill(f"{value:.2f}")
        self.page.keyboard.press("Enter")


def test_a_centre_by_other_lines_is_right(opened: Callable[..., Any], practised: Path) -> None:
    """Points are carried over, P_20 is found; then P_25 by (CE), which the log has not."""
    made, _ = pages.on_sheets(NAME, "en")
    assert made.mechanism is not None
    plan, place = CENTRES_PLAN.on(made.mechanism), 2

    def at(mark: Any) -> complex:
        row = made.mechanism.drawn_by(EXACT).reading[mark][0]  # type: ignore[union-attr]
        return complex(row[place if row.size > 1 else 0])

    page = opened(practised, "#practice:centres/all/3").page
    page.locator("html.ready").wait_for()
    student = Student(page)
    for of, mark in plan.points.items():
        student.lay("8", of.name)
        student.mark(at(mark))
        assert "Right." in student.told(), of.name
    centre = {one.name: one.mark for one in plan.centres}
    student.lay("1", "A", "O")
    student.lay("1", "B", "D")
    student.lay("7", "(AO)", "(BD)")
    student.mark(at(centre["P_{20}"]))
    assert "Right." in student.told()
    student.lay("3", "E", "(x)")
    student.lay("2", "P20", "(EP50)")
    student.lay("1", "C", "E")
    assert "(CE) is drawn" in student.told()
    student.lay("7", "(CE)", "(P20P50)")
    student.mark(at(centre["P_{25}"]))
    assert "Right." in student.told()
