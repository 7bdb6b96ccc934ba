"""The crank in a browser: turned by keys, range, handle and buttons; what is drawn and told is Python's."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support import pages
from support.browser import FRAMES, Opened
from support.linkages import four_bar

from graphic_tmm.language.numbers import fixed
from graphic_tmm.mechanism.records import Row
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.page import page
from graphic_tmm.page.strands import MovingFigures, MovingStroke, strands
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import sheets

Begin = Callable[..., Opened]
NAME = "crank-rocker"
NEAR = 0.03
"""What rounding on the way to the page and in it may come to, mm."""
INK = """(title) => [...[...document.querySelectorAll("#crank .card svg")]
  .find((one) => one.getAttribute("aria-label") === title).querySelectorAll(".body .pen path:not(.still)")]
  .filter((one) => one.getAttribute("visibility") !== "hidden")
  .map((one) => [one.getAttribute("transform") ?? "", one.getAttribute("d") ?? ""])"""
"""The ink of a figure that moves, by its title."""


def _crank(page_of: Begin, name: str = NAME, turn: str = "@0", **options: Any) -> Any:
    tab = page_of(name, address=f"#crank:{turn}", **options)
    tab.page.wait_for_selector("#crank[data-ready]")
    return tab.page


def _angle(found: Any) -> str:
    return str(found.locator("#crank .angle").text_content())


def _dense(name: str = NAME) -> Dense:
    made, _ = pages.on_sheets(name, pages.language(name))
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    return found


def _told(found: Dense, index: int) -> str:
    return f"φ = {float(found.angles[index]) % 360.0:.4g}°"


def test_keys_turn_the_crank(page_of: Begin) -> None:
    shown, found = _crank(page_of), _dense()
    for key, index in (
        ("ArrowRight", 1),
        ("ArrowUp", 2),
        ("PageUp", 32),
        ("ArrowLeft", 31),
        ("PageDown", 1),
        ("ArrowLeft", 0),
        ("ArrowDown", 359),
    ):
        shown.locator("body").press(key)
        assert _angle(shown).startswith(_told(found, index)), key


def test_the_range_is_the_crank_for_who_has_no_pointer(page_of: Begin) -> None:
    shown, found = _crank(page_of), _dense()
    range_ = shown.get_by_role("slider")
    range_.focus()
    range_.press("ArrowRight")
    assert _angle(shown).startswith(_told(found, 1))
    range_.press("PageUp")
    assert _angle(shown).startswith(_told(found, 31))
    assert range_.get_attribute("aria-valuetext") == _angle(shown)


def test_buttons_go_to_the_positions_and_tell_what_tables_tell(page_of: Begin) -> None:
    shown = _crank(page_of)
    made, _ = pages.on_sheets(NAME, "en")
    assert made.mechanism is not None
    columns = [one for one in columns_of(made.mechanism) if one.plan == "velocities"]
    figures = rounded_figures(columns)
    for k, name in enumerate(made.mechanism.names):
        shown.locator("#crank .row").get_by_role("button", name=name, exact=True).click()
        assert _angle(shown).endswith(f"position {name}")
        texts = (
            shown.locator("#crank .card:not(.lead) .values").first.locator("dd").all_text_contents()
        )
        due = [fixed(one.value[k], one.places, "en") for one in figures]
        assert [text.split()[0] for text in texts] == due


def test_the_handle_is_dragged_round(page_of: Begin) -> None:
    shown, found = _crank(page_of), _dense()
    ring = shown.locator("#crank .handle")

    def place() -> tuple[float, float]:
        box = ring.bounding_box()
        assert box is not None
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    start = place()
    shown.locator("body").press("PageUp")
    shown.locator("body").press("PageUp")
    shown.locator("body").press("PageUp")
    quarter = place()
    shown.get_by_role("slider").fill("0")
    shown.mouse.move(*start)
    shown.mouse.down()
    for share in (0.3, 0.6, 1.0):
        shown.mouse.move(*(a + share * (b - a) for a, b in zip(start, quarter, strict=True)))
    shown.mouse.up()
    # the address says it a little later, once for a whole drag
    shown.wait_for_function("() => Math.abs(location.hash.split('@')[1] - 90) < 2")
    turn = float(re.findall(r"@(-?[\d.]+)", shown.evaluate("() => location.hash"))[0])
    assert abs(turn - 90.0) < 2.0
    assert math.dist(place(), quarter) < 4.0
    assert found.whole == 360


def test_it_runs_when_asked_and_never_by_itself(page_of: Begin) -> None:
    shown = _crank(page_of)
    shown.clock.install()
    before = _angle(shown)
    shown.clock.run_for(1000)
    assert _angle(shown) == before
    shown.get_by_role("button", name="Turn the crank").click()
    shown.clock.run_for(600)
    assert _angle(shown) != before
    shown.get_by_role("button", name="Stop the crank").click()
    stood = _angle(shown)
    shown.clock.run_for(1000)
    assert _angle(shown) == stood


def test_figures_are_chosen(page_of: Begin) -> None:
    shown = _crank(page_of)
    assert shown.locator("#crank .card:not(.lead):visible").count() == 2
    shown.get_by_role("checkbox", name="Velocity plan").uncheck()
    assert shown.locator("#crank .card:not(.lead):visible").count() == 1


@pytest.mark.parametrize("number", range(3))
def test_the_ink_is_that_of_python(page_of: Begin, number: int) -> None:
    shown, found = _crank(page_of), _dense()
    figures = [
        m for c in found.drawn.project.chapters for m in MovingFigures.of(c).figures(found.drawn)
    ]
    moving = figures[number]
    made = strands(found, moving)
    rows = made.at(found.whole, [key for key in made.rows if isinstance(key, MovingStroke)])
    shown.locator("#crank .card").nth(number).scroll_into_view_if_needed()
    for index in (0, 7, 45, 203, 331):
        shown.get_by_role("slider").fill(str(index))
        begun = [_begins(*one) for one in shown.evaluate(INK, moving.title)]
        due = [(r[index][0], -r[index][1]) for r in rows.values() if np.isfinite(r[index][0])]
        assert len(begun) == len(due)
        apart = np.abs(np.subtract.outer(_complex(begun), _complex(due)))
        assert apart.min(axis=0).max() < NEAR
        assert apart.min(axis=1).max() < NEAR


def _complex(spots: list[tuple[float, float]]) -> np.ndarray:
    return np.array([complex(*spot) for spot in spots])


def _begins(transform: str, d: str) -> tuple[float, float]:
    x, y = map(float, re.findall(r"-?[\d.]+(?:e-?\d+)?", d)[:2])
    by = re.findall(r"-?[\d.]+(?:e-?\d+)?", transform) or ["0", "0"]
    return x + float(by[0]), y + float(by[1])


def test_where_it_cannot_be_drawn_it_says_why(opened: Begin, tmp_path: Path) -> None:
    row = Row(12, 0, 60.0, (), ("all",))
    orders = (SheetOrder("A1", ("positions", "velocities")),)
    scene = Scene("gap", "Gap", "en", four_bar(0.3, 0.3, 0.25, 0.4 + 0j), row, sheets=orders)
    file = tmp_path / "gap.html"
    file.write_text(page(*sheets(scene)), encoding="utf-8")
    tab = opened(file, "#crank:@120")
    tab.page.wait_for_selector("#crank[data-ready]")
    says = str(tab.page.locator("#crank .why").text_content())
    assert says.startswith("It cannot be drawn here: ")
    assert "'B'" in says
    assert tab.page.locator("#crank .lead .body").get_attribute("visibility") == "hidden"
    assert tab.page.evaluate(SHOWN) == []
    tab.page.get_by_role("slider").fill("0")
    assert tab.page.locator("#crank .why").text_content() == ""
    assert len(tab.page.evaluate(SHOWN)) > 0


SHOWN = """() => [...document.querySelectorAll("#crank .values div")]
  .filter((one) => one.checkVisibility({ visibilityProperty: true })).map((one) => one.textContent)"""
"""What a person sees of what is told at an angle, as "v = 1.2 m/s"."""
TURNED = f"""(keys) => keys.map((key) => {{
  document.body.dispatchEvent(new KeyboardEvent("keydown", {{ key, bubbles: true }}));
  const room = document.querySelector("#crank");
  return [room.querySelector(".angle").textContent, ({SHOWN})(), room.innerText];
}})"""
"""The angle, what a person sees and all that is written, after each of some keys."""
FIGURE = re.compile(r"(?:^|[ (])[−-]?\d+(?:[.,]\d+)?(?:[ ·]|$)")
SENSELESS = re.compile(r"NaN|undefined|null|Infinity|—|10[⁻−-]|\de-\d")


@pytest.mark.parametrize(
    "name", ["windrower", "engine", "accelerating-crank", "oscillating-cylinder"]
)
def test_what_is_told_is_a_figure_or_is_not_there(page_of: Begin, name: str) -> None:
    shown, met = _crank(page_of, name, viewport={"width": 1600, "height": 5000}), 0
    angles = set()
    for box in shown.get_by_role("checkbox").all():
        box.check()
    shown.evaluate(FRAMES)  # it hears which figures stand in the window
    for angle, told_of, whole in shown.evaluate(TURNED, 12 * ["PageUp", "ArrowRight"]):
        angles.add(angle)
        met += len(told_of)
        assert [one for one in told_of if not FIGURE.search(one.partition("=")[2])] == []
        assert not SENSELESS.search(whole), SENSELESS.findall(whole)
    assert len(angles) == 24
    assert met > 24


def test_cursors_run_on_the_curves_of_the_sheet(page_of: Begin) -> None:
    shown = _crank(page_of, "slider-diagrams")
    for box in shown.get_by_role("checkbox").all():
        box.check()
    shown.locator("#crank .cursor").first.scroll_into_view_if_needed()
    shown.evaluate(FRAMES)
    seen = set()
    for turn in (0, 40, 95, 200):
        shown.get_by_role("slider").fill(str(turn))
        spots = shown.evaluate(
            """() => [...document.querySelectorAll("#crank .cursor circle")].map((one) => {
              const at = new DOMPoint(+one.getAttribute("cx"), +one.getAttribute("cy"));
              return [...one.closest("svg").querySelectorAll(".pen path")].some((path) => {
                const width = path.style.strokeWidth; path.style.strokeWidth = ".3px";
                const on = path.isPointInStroke(at); path.style.strokeWidth = width; return on; });
            })"""
        )
        assert spots == [True] * len(spots)
        seen.add(len(spots))
    assert seen == {2}


def test_a_scene_without_a_mechanism_has_no_crank(page_of: Begin) -> None:
    tab = page_of("gear-pair")
    assert tab.page.get_by_role("tab", name="Crank").count() == 0
