"""A plan is played: what is told with each step, what lights up, which instrument lies where."""

from __future__ import annotations

import re
from typing import Any

import pytest

VELOCITIES = "#velocities/1/"
MEETING, MEASURING = 8, 9
"""Stops of the windrower's plan of velocities: where a3 is found, where aa3 is measured."""


@pytest.fixture
def play(page_of):
    def begin(stop: int, name: str = "windrower", plan: str = VELOCITIES, **options: Any) -> Any:
        return page_of(name, "en", f"{plan}{stop}", **options).page.locator("#play")

    return begin


def terms(room: Any) -> list[str]:
    """What the terms of the equation above the sentence are: unknown, begun or whole, and new."""
    found = room.locator(".heads .term")
    return [
        (found.nth(k).get_attribute("class") or "").removeprefix("term ")
        for k in range(found.count())
    ]


def test_every_step_is_a_stop_and_ink_comes_with_its_own(play) -> None:
    """Calculations before the first line leave the picture as it is; so does what is calculated of readings."""
    room = play(0)
    seen = []
    for _ in range(5):
        stage = room.locator("svg.stage")
        seen.append((stage.get_attribute("data-step"), stage.get_attribute("data-picture")))
        room.get_by_role("button", name="Next step").click()
    assert seen == [("0", "0"), ("1", "0"), ("2", "0"), ("3", "1"), ("4", "2")]


def test_the_equation_lights_up_term_by_term(play) -> None:
    room = play(MEETING - 2)
    assert terms(room) == ["unknown", "whole", "begun now"]
    room.page.keyboard.press("ArrowRight")
    assert terms(room) == ["begun now", "whole", "begun"]
    room.page.keyboard.press("ArrowRight")
    assert terms(room) == ["whole now", "whole", "whole now"]
    under = [room.locator(f".heads .lines{n}").count() for n in (1, 2)]
    assert under == [2, 1], "what is known in direction has one line, what is known wholly two"


def test_a_polygon_of_forces_has_its_equation(play) -> None:
    room = play(3, plan="#forces%204-5/8/")
    assert terms(room)[:2] == ["whole now", "unknown"]
    assert room.locator(".heads .sum").inner_text().replace(" ", "").endswith("=0")


def test_a_reading_is_told_with_its_scale_and_fills_the_table(play) -> None:
    room = play(MEASURING)
    told = " ".join(room.locator(".telling .reading").inner_text().split())
    found = re.fullmatch(r"aa3 = −?(\S+) mm → vA3A = \1 mm × (\S+) \(m/s\)/mm = (\S+) m/s", told)
    assert found, told
    row = room.locator(".values tr.now")
    assert row.locator("td").all_inner_texts()[0] == f"{found[1]} mm"
    assert row.locator("td").all_inner_texts()[2].endswith(f"{found[3]} m/s")
    rows = room.locator(".values tbody tr")
    assert 0 < room.locator(".values tbody tr:visible").count() < rows.count()
    room.get_by_role("button", name="Last picture").click()
    assert room.locator(".values tbody tr:visible").count() == rows.count()


def test_all_that_matters_is_in_sight(play) -> None:
    """Drawing, equation, sentence, reading, reason, table and buttons need no scrolling on a usual window."""
    room = play(MEASURING)
    for part in (".stage", ".equation", ".step", ".reading", ".why", ".values", ".bar", ".options"):
        box = room.locator(part).first.bounding_box()
        assert box is not None, part
        assert box["y"] >= 0, part
        assert box["y"] + box["height"] <= 800, part
        assert box["x"] + box["width"] <= 1280, part


@pytest.mark.parametrize(
    "pointed", [".values tr.now", ".telling .reading", ".telling .letter >> nth=0"]
)
def test_pointing_at_a_mark_lights_it_up_everywhere(play, pointed: str) -> None:
    room = play(MEASURING)
    assert room.locator(".lit").count() == 0
    room.locator(pointed).first.hover()
    assert room.locator(".stage path.lit").count() > 0
    assert room.locator(".values tr.lit").count() == 1
    assert room.locator(".steps button.lit").count() >= 1
    room.page.mouse.move(640, 5)
    assert room.locator(".lit").count() == 0


def test_pointing_at_the_drawing_lights_up_the_words(play) -> None:
    room = play(MEASURING)
    room.locator(".stage path.now[data-of]").first.dispatch_event("pointerover")
    assert room.locator(".telling .reading.lit").count() == 1


def test_a_tap_lights_up_and_stays(play) -> None:
    room = play(MEASURING, viewport={"width": 390, "height": 844}, has_touch=True)
    room.locator(".telling .reading").tap()
    assert room.locator(".stage path.lit").count() > 0


def test_the_instrument_lies_on_the_drawing_and_can_be_taken_off(play) -> None:
    room = play(MEASURING)
    ruler = room.locator(".instrument path")
    assert ruler.count() == 1
    assert ruler.is_visible()
    assert "Ruler" in room.locator(".telling .tool").inner_text()
    room.get_by_label("Instrument").uncheck()
    assert not ruler.is_visible()
    assert not room.locator(".telling .tool").is_visible()


def test_the_list_of_steps_is_the_drawing_for_those_who_cannot_see_it(play) -> None:
    room = play(1)
    steps = room.get_by_role("group", name="Steps")
    assert steps.get_by_role("heading").count() >= 3
    buttons = steps.get_by_role("button")
    count = int(room.locator(".count").inner_text().split()[-1])
    assert buttons.count() == count + 1, "what is given, every step, what is ready"
    last = buttons.nth(count)
    last.focus()
    room.page.keyboard.press("Enter")
    assert last.get_attribute("aria-current") == "step"
    assert steps.locator("[aria-current]").count() == 1
    box, frame = last.bounding_box(), steps.bounding_box()
    assert box is not None
    assert frame is not None
    assert box["y"] + box["height"] <= frame["y"] + frame["height"] + 1, "it is scrolled into sight"


def test_the_drawing_is_one_stop_of_the_keyboard(play) -> None:
    room = play(3)
    assert room.locator(".stage[tabindex='0']").count() == 1
    assert room.locator(".stage [tabindex]").count() == 0
    room.locator(".stage").focus()
    room.page.keyboard.press("ArrowRight")
    assert room.locator(".stage").get_attribute("data-step") == "4"


def test_other_positions_are_one_stop_each_with_figures_of_their_own(play) -> None:
    room = play(22, name="engine", plan="#velocities/all/")
    assert room.locator(".telling .step").first.inner_text() == "The same in position 11."
    assert room.locator(".telling .reading").count() >= 3
    assert room.locator(".values caption").inner_text().endswith("position 11")


def test_it_runs_at_the_pace_that_is_chosen(play) -> None:
    room = play(0)
    room.page.clock.install()
    room.page.clock.pause_at(room.page.evaluate("() => Date.now() / 1000 + 60"))
    room.get_by_label("Pace").select_option("4")
    room.get_by_role("button", name="Play the steps").click()
    before = int(room.locator(".stage").get_attribute("data-step"))
    room.page.clock.run_for(2000)
    assert int(room.locator(".stage").get_attribute("data-step")) == before
    room.page.clock.run_for(2500)
    assert int(room.locator(".stage").get_attribute("data-step")) == before + 1
    room.get_by_role("button", name="Pause").click()


def test_the_mechanism_stands_beside_its_plan(play) -> None:
    """The position that is played, and the line that the step uses, lit; gone with its switch."""
    room = play(3, plan="#velocities/2/")
    inset = room.locator(".inset")
    assert inset.is_visible()
    places = inset.locator("path[data-at]").evaluate_all("all => all.map(p => p.dataset.at)")
    assert set(places) == {"2"}
    assert inset.locator("text", has_text="A").count() == 1
    assert inset.locator("text.used").all_text_contents() == ["O", "A"]
    assert inset.locator("path.used").count() == 1
    inset_box, paper = inset.bounding_box(), room.locator("div.paper").bounding_box()
    stage = room.locator(".stage").bounding_box()
    assert inset_box["width"] >= 0.3 * paper["width"]
    assert inset_box["x"] + inset_box["width"] <= stage["x"] + 1
    room.get_by_role("checkbox", name="Mechanism").uncheck()
    assert not inset.is_visible()


def test_a_plan_of_accelerations_has_the_mechanism_in_its_own_position(play) -> None:
    """Its rows are counted otherwise than those of the plan of positions: it is known by its name."""
    room = play(3, plan="#accelerations/6/")
    places = room.locator(".inset path[data-at]").evaluate_all("all => all.map(p => p.dataset.at)")
    assert set(places) == {"6"}


PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True}


def places(room: Any) -> set[str]:
    return {*room.locator(".inset path[data-at]").evaluate_all("all => all.map(p => p.dataset.at)")}


def test_the_plan_of_positions_begins_with_its_mechanism(play) -> None:
    """Where the paper is small, until the first step; beside the plan it goes through the positions."""
    room = play(0, plan="#positions/all/", **PHONE)
    inset, paper = room.locator(".inset"), room.locator("div.paper").bounding_box()
    assert inset.bounding_box()["width"] >= 0.9 * paper["width"]
    room.get_by_role("button", name="Next step").click()
    assert not inset.is_visible()
    room = play(0, plan="#positions/all/")
    assert places(room) == {"2"}
    room.page.keyboard.press("End")
    room.page.keyboard.press("ArrowLeft")
    while "same in position" not in room.locator(".telling").inner_text():
        room.page.keyboard.press("ArrowLeft")
    assert places(room) not in ({"2"}, set())


def test_first_sight_is_the_mechanism_and_a_plan_that_is_ready(page_of) -> None:
    page = page_of("windrower", "en").page
    assert page.locator("#play .inset").is_visible()
    assert page.locator("#play .places option:checked").text_content() == "2"
    page = page_of("windrower", "en", **PHONE).page
    inset, paper = page.locator("#play .inset"), page.locator("#play div.paper").bounding_box()
    assert inset.bounding_box()["width"] >= 0.9 * paper["width"]


def test_what_a_step_takes_is_seen_on_the_plan(play) -> None:
    room = play(MEETING)
    taken = room.locator(".stage path.taken:not(.label path)")
    assert taken.count() >= 2
    colours = "(all) => [...new Set(all.map((one) => getComputedStyle(one).stroke))]"
    new = room.locator(".stage .label.now path")
    assert taken.evaluate_all(colours) != new.evaluate_all(colours)
    room.page.keyboard.press("End")
    assert taken.count() == 0
