"""Lengths changed in a browser: what is told follows as Python has it, what cannot be assembled is refused."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from support import pages
from support.browser import Opened

from graphic_tmm.board.execute import execute
from graphic_tmm.page.dense import dense

Begin = Callable[..., Opened]
NAME, POSITION = "crank-rocker", 3


def _opened(page_of: Begin, name: str = NAME, **options: Any) -> Any:
    tab = page_of(name, address="#crank:", **options)
    tab.page.wait_for_selector("#crank[data-ready]")
    tab.page.locator(".lengths > summary").click()
    return tab.page


def _field(page: Any, letter: str) -> Any:
    return page.get_by_role("textbox", name=f"{letter}, value")


def _give(page: Any, letter: str, text: str) -> None:
    field = _field(page, letter)
    field.fill(text)
    field.press("Enter")


def _velocities(page: Any) -> list[float]:
    texts = page.locator("#crank .card:not(.lead) .values").first.locator("dd").all_text_contents()
    return [float(text.split()[0].replace("−", "-")) for text in texts]


def test_values_follow_a_length(page_of: Begin) -> None:
    """The crank of 20 mm is made one of 24: pa is ω_1·l_OA, the others are Python's."""
    page = _opened(page_of)
    page.locator("#crank .row").get_by_role("button", name=str(POSITION), exact=True).click()
    _give(page, "l_OA", "24")
    made, _ = pages.on_sheets(NAME, "en")
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    given = found.given | {mark: 0.024 for mark in found.log.given if mark.name == "l_{OA}"}
    reading, told = execute(found.log, given), _velocities(page)
    due = {
        step.it.name: abs(reading[step.it]).ravel()[
            found.at[POSITION] if reading[step.it].size > 1 else 0
        ]
        for step in found.log.steps
        if step.it.view == "velocities" and not isinstance(reading[step.it], tuple)
    }
    scale = reading[found.log.view("velocities").scale].item()  # type: ignore[union-attr]
    np.testing.assert_allclose(told[:3], [scale * due[k] for k in ("pa", "ab", "pb")], rtol=0.005)
    assert abs(told[0] - 0.024 * 125.66370614) < 0.005


def test_what_cannot_be_assembled_is_refused_and_named(page_of: Begin) -> None:
    page = _opened(page_of)
    before = _velocities(page)
    _give(page, "l_AB", "26")
    says = page.locator(".lengths .told").text_content()
    assert "26 mm: extreme positions, step 7 'B_0': the arcs do not meet" in says
    assert _field(page, "l_AB").get_attribute("aria-invalid") == "true"
    assert _velocities(page) == before
    _give(page, "l_AB", "64")
    assert _velocities(page) != before
    page.get_by_role("button", name="As given").click()
    assert _velocities(page) == before
    assert _field(page, "l_AB").input_value() == "60"


def test_keys_of_the_scene_are_copied(page_of: Begin) -> None:
    page = _opened(page_of)
    copy = page.get_by_role("button", name="Copy as TOML")
    assert copy.is_disabled()
    for letter, text in (("l_OA", "24"), ("Y_E", "31.5"), ("X_C", "62")):
        _give(page, letter, text)
    copy.click()
    assert tomllib.loads(page.get_by_label("TOML", exact=True).input_value()) == {
        "frame": {"C": ["62 mm", "-10 mm"]},
        "link": [
            {"number": 1, "points": {"A": ["24 mm", "0 mm"]}},
            {"number": 2, "points": {"E": ["40 mm", "31.5 mm"]}},
        ],
    }


def test_a_range_is_moved_by_keys_alone(page_of: Begin) -> None:
    """By a key one four-hundredth of the range, 30 mm: to a step of 0.01 mm."""
    page = _opened(page_of)
    range_ = page.get_by_role("slider", name="l_OA")
    range_.focus()
    range_.press("ArrowRight")
    assert _field(page, "l_OA").input_value() == "20.08"
    assert range_.get_attribute("aria-valuetext") == "20.08 mm"


def test_a_joint_is_dragged_to_its_lengths(page_of: Begin) -> None:
    """The joint B stands at its place of a mechanism with the lengths that the fields then have."""
    page = _opened(page_of)
    page.locator("#crank .row").get_by_role("button", name="1", exact=True).click()
    grip = page.locator(".lead .grip").last  # C, B, E …: the first lies on top
    names = [_field(page, one).input_value() for one in ("X_C", "Y_C")]
    box = grip.bounding_box()
    # taken hold of at its rim
    x, y = box["x"] + box["width"] / 2 + 14, box["y"] + box["height"] / 2
    assert 43 < box["width"] < 46
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 12, y - 5)
    page.mouse.move(x + 24, y - 10)
    after = [float(_field(page, one).input_value()) for one in ("X_C", "Y_C")]
    assert after[0] > float(names[0]) + 2
    assert after[1] > float(names[1]) + 0.5
    now = grip.bounding_box()
    assert abs(now["x"] + now["width"] / 2 + 14 - x - 24) < 2
    assert abs(now["y"] + now["height"] / 2 - y + 10) < 2


def test_what_is_no_number_is_refused_in_words(page_of: Begin) -> None:
    page = _opened(page_of)
    for text in ("abc", " "):
        _give(page, "l_OA", text)
        assert (
            page.locator(".lengths .told").text_content()
            == f'"{text}" is no number: the value stays.'
        )
        assert _field(page, "l_OA").input_value() == "20"


def test_the_crank_is_made_longer_beyond_its_pin(page_of: Begin) -> None:
    """Its own ring lies on the crank's line; dragged on along it the crank gets longer."""
    page = _opened(page_of)
    page.locator("#crank .row").get_by_role("button", name="1", exact=True).click()

    def middle(part: Any) -> complex:
        box = part.bounding_box()
        return complex(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)

    pin = middle(page.locator(".lead .handle"))
    rings = [middle(one) for one in page.locator(".lead .joint").all()]
    at = min(rings, key=lambda z: abs(z - pin))
    way = (at - pin) / abs(at - pin)
    page.mouse.move(at.real, at.imag)
    page.mouse.down()
    for step in (10, 20, 30):
        to = at + step * way
        page.mouse.move(to.real, to.imag)
    longer = float(_field(page, "l_OA").input_value())
    assert 22 < longer < 40
    # an extreme position turns with the length, and the positions with it
    along = (middle(page.locator(".lead .handle")) - pin) * way.conjugate()
    assert abs(along.real - 30) < 4
    page.mouse.up()
    assert page.get_by_role("button", name="1", exact=True).get_attribute("aria-pressed") == "true"
    assert float(_field(page, "l_OA").input_value()) == longer


def test_questions_are_answered_by_lengths(page_of: Begin) -> None:
    """A crank-rocker turns up to Grashof's bound; what is off it, or changes other letters, is no answer."""
    page = _opened(page_of)
    page.locator(".questions summary").click()
    asked = page.locator(".questions li").filter(has_text="at the most")
    bound = 60 + 45 - np.hypot(60, 10)
    answers = asked.get_by_role("status")
    _give(page, "l_OA", f"{bound - 0.02:.2f}")
    assert answers.text_content() == "Right."
    _give(page, "l_OA", f"{bound + 0.02:.2f}")
    assert answers.text_content() == "It does not turn round."
    _give(page, "l_OA", "30")
    assert answers.text_content() == "It turns round; lOA may go farther."
    _give(page, "l_CB", "46")
    assert answers.text_content() == "The rest has to be as given."
    page.get_by_role("button", name="As given").click()
    assert answers.text_content() == "Right."
    others = page.locator(".questions li").filter(has_not_text="at the most").get_by_role("status")
    assert all(text.startswith("Now: ") for text in others.all_text_contents())

    page.mouse.up()


LET_GO = (
    "(e, v) => { e.value = v; for (const n of ['input', 'change']) e.dispatchEvent(new Event(n)); }"
)
DRAGGED = "(e, v) => { e.value = v; e.dispatchEvent(new Event('input')); }"
INK = """() => [...document.querySelectorAll("#crank .card svg.moving")].map((svg) => {
  const back = svg.getScreenCTM().inverse();
  const [x, y, width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  const inked = [...svg.querySelectorAll(".body .pen > path, .body .letters > g")];
  const boxes = inked.filter((one) => getComputedStyle(one).visibility !== "hidden").map((one) => {
    const { left, top, right, bottom } = one.getBoundingClientRect();
    const [a, b] = [new DOMPoint(left, top), new DOMPoint(right, bottom)].map((p) => p.matrixTransform(back));
    return { letter: one.tagName === "g", sides: [a.x, a.y, b.x, b.y] };
  });
  const over = boxes.map(({ sides: [a, b, c, d] }) => Math.max(x - a, y - b, c - x - width, d - y - height));
  return { over: Math.max(0, ...over), letters: boxes.filter((one) => one.letter).map((one) => one.sides) };
})"""
"""Of each figure how far its ink lies outside its box, mm; the boxes of its letters."""
SEEN = """() => [...document.querySelectorAll("#crank svg.moving")].map((svg) => {
  const seen = (one) => getComputedStyle(one).visibility !== "hidden";
  const there = [...svg.querySelectorAll("path, g")].filter(seen);
  const told = there.map((one) => `${one.getAttribute("d") || ""} ${one.getAttribute("transform")}`);
  return [svg.getAttribute("viewBox"), svg.getAttribute("style"), ...told].join("|");
})"""
OVER = 0.2
"""Half a pen: lines are told by their middles, mm."""


def _captions(page: Any) -> list[str]:
    texts: list[str] = page.locator("#crank figcaption small").all_inner_texts()
    return texts


def _figures(page: Any) -> list[str]:
    """Return all that is seen of each figure, and its box."""
    return page.evaluate(SEEN)  # type: ignore[no-any-return]


def test_scale_factors_are_chosen_anew_when_a_length_is_let_go(page_of: Begin) -> None:
    """A crank of 12 mm, not 20: all plans grow to the next standard scale, and say so; quantities stay."""
    page = _opened(page_of, "crank-rocker", language="en")
    own, figures = _captions(page), _figures(page)
    assert own[0] == "μl = 0.001 m/mm"
    crank = page.get_by_role("slider", name="l_OA", exact=True)
    crank.evaluate(DRAGGED, "0.012")
    assert _captions(page) == own
    during = _velocities(page)
    crank.evaluate(LET_GO, "0.012")
    assert _velocities(page) == during
    assert _captions(page)[:3] == [
        "μl = 0.0005 m/mm",
        "μv = 0.025 (m/s)/mm",
        "μa = 2 (m/s²)/mm",
    ]
    assert _field(page, "μ_l").input_value() == "0.0005"
    page.get_by_role("button", name="As given").click()
    assert _captions(page) == own
    assert _figures(page) == figures
    assert _field(page, "μ_l").input_value() == "0.001"


def test_a_scale_factor_of_ones_own_stays(page_of: Begin) -> None:
    page = _opened(page_of, "crank-rocker", language="en")
    _give(page, "μ_l", "0.002")
    _give(page, "l_OA", "12")
    assert _captions(page)[:2] == ["μl = 0.002 m/mm", "μv = 0.025 (m/s)/mm"]


@pytest.mark.parametrize(
    ("scene", "letter", "share"),
    [
        ("crank-rocker", "l_AB", 1.4),
        ("crank-rocker", "l_CB", 0.6),
        ("shaper", "l_OA", 1.4),
        ("windrower", "l_BS3", 0.6),
    ],
)
def test_ink_stays_in_its_box(page_of: Begin, scene: str, letter: str, share: float) -> None:
    """At all angles, of all figures; at the one that is shown no letters of two lie on one another."""
    page = _opened(page_of, scene, viewport={"width": 1400, "height": 9000})
    for box in page.locator("#crank").get_by_role("checkbox").all():
        box.check()
    slider = page.get_by_role("slider", name=letter, exact=True)
    slider.evaluate(LET_GO, str(share * float(slider.input_value())))
    assert page.evaluate("() => document.querySelector('svg.moving').classList.contains('own')")
    page.wait_for_timeout(200)
    assert not any(_on_one_another(one["letters"]) for one in page.evaluate(INK)[:2])
    angle = page.locator("#crank").get_by_role("slider").first
    for k in range(0, 360, 17):
        angle.evaluate(DRAGGED, str(k))
        assert max(one["over"] for one in page.evaluate(INK)) <= OVER, k


def _on_one_another(letters: list[list[float]]) -> bool:
    """Whether boxes of letters meet by more than the white about them."""
    return any(
        min(a[2], b[2]) - max(a[0], b[0]) > 1.0 and min(a[3], b[3]) - max(a[1], b[1]) > 1.0
        for a, b in combinations(letters, 2)
    )
