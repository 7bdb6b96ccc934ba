"""Accuracy on the page: beside a plan where its errors come from, the step at a tap, the figure at the end."""

from __future__ import annotations

from typing import Any

import pytest
from support import pages
from support.tasks import answered

from graphic_tmm.page.page import page as written

SCENE = "slider-diagrams"
PHONE = {"width": 390, "height": 844}


@pytest.fixture(scope="session")
def weighed_page(tmp_path_factory):
    made, found = pages.on_sheets(SCENE, "en")
    file = tmp_path_factory.mktemp("weighed") / "page.html"
    file.write_text(written(made, found, weighed=answered(SCENE, "en")), encoding="utf-8")
    return file


@pytest.fixture
def weighed(opened, weighed_page):
    def begin(address: str = "", **options: Any) -> Any:
        tab = opened(weighed_page, address, **options)
        tab.page.get_by_role("tab").first.wait_for()
        return tab.page

    return begin


def test_a_plan_tells_its_errors_and_leads_to_the_step(weighed) -> None:
    page = weighed("#velocities/1/2")
    beside = page.locator("#play .errors section")
    assert beside.count() == 1
    assert "%" in beside.inner_text()
    widths = beside.locator(".shares rect").evaluate_all(
        "(all) => all.map((one) => one.getBoundingClientRect().width)"
    )
    assert len(widths) == beside.locator("li").count() > 1
    whole = beside.locator(".shares").bounding_box()["width"]
    assert sum(widths) == pytest.approx(whole, rel=0.03)
    told = beside.locator("p").inner_text()
    beside.get_by_role("button", name="Show this step").click()
    step = page.locator("#play .telling .step").inner_text().rstrip(".")
    assert step.replace("\n", "") in told.replace("\n", "")


def test_a_plan_that_gives_none_of_the_quantities_tells_none(weighed) -> None:
    page = weighed("#positions/all/2")
    assert page.locator("#play .errors section").count() == 0


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_sentences_and_figure_fit_a_phone(weighed, scheme: str) -> None:
    page = weighed("#accuracy:velocities", viewport=PHONE, color_scheme=scheme)
    room = page.locator("#accuracy")
    assert room.locator("p").count() >= 4
    figure = room.locator("svg").bounding_box()
    assert 300 < figure["width"] <= PHONE["width"]
    assert room.evaluate("(one) => one.scrollWidth <= one.clientWidth")
    before = room.evaluate("(one) => one.scrollTop")
    room.focus()
    page.keyboard.press("End")
    page.wait_for_function(
        "(top) => document.getElementById('accuracy').scrollTop > top", arg=before
    )
    ink, paper = room.locator("svg").evaluate(
        "(one) => [getComputedStyle(one).fill, getComputedStyle(one).backgroundColor]"
    )
    assert (ink == "rgb(0, 0, 0)") == (scheme == "light")
    assert (paper == "rgb(255, 255, 255)") == (scheme == "light")


def test_without_scripts_it_is_a_part_of_the_document(opened, weighed_page) -> None:
    page = opened(weighed_page, java_script_enabled=False).page
    assert page.get_by_role("heading", name="Accuracy of the constructions").is_visible()
    assert page.locator("#accuracy svg").is_visible()
