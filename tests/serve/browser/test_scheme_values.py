"""Values typed beside a scheme: they stand while answers come, and over a file that has changed meanwhile."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from support import scheme_hand
from support.scheme_hand import SchemeHand, begun
from support.served import SMALL
from support.studios import Tab, expect, serving


@pytest.fixture(scope="module")
def gallery(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with serving(tmp_path_factory.mktemp("blank")) as found:
        yield found


SLOW = """(() => {
  const sent = window.fetch;
  window.fetch = async (...asked) => {
    await new Promise((go) => setTimeout(go, 500));
    return sent(...asked);
  };
})()"""
"""What lets answers come behind the next value that is typed."""


def typed_one_after_another(tab: Tab, values: list[str]) -> None:
    """Type into field after field as a person does, and wait for nothing."""
    keys = tab.page.keyboard
    tab.page.locator(".lengths input").first.focus()
    keys.press("Control+A")
    for value in values:
        keys.type(value, delay=25)
        keys.press("Tab")
        tab.page.wait_for_timeout(150)
    tab.page.locator(".scheme[aria-busy=false]").wait_for()


def test_lengths_typed_one_after_another_all_stand(
    gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    scheme_hand.shaper(hand)
    tab.page.evaluate(SLOW)
    # the first makes all larger by half; the others are a little off what they are then
    first, *others = (float(one.split()[0]) for one in hand.lengths().values())
    values = [f"{1.5 * first:.4g} mm", *(f"{round(1.5 * one) + 1} mm" for one in others[:-1])]
    values += ["1 deg", "70 rpm"]
    assert len(values) == 7
    typed_one_after_another(tab, values)
    fields = tab.page.locator(".lengths input, .next input")
    shown = fields.evaluate_all("(them) => them.map((one) => one.value)")
    assert shown[:7] == values
    text = tab.page.evaluate("JSON.parse(sessionStorage.getItem('scheme')).text")
    assert [one for one in values if f'"{one}"' not in text] == []


def test_a_refused_length_takes_nothing_else_back(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    tab.allow("status of 422")
    tab.page.evaluate(SLOW)
    typed_one_after_another(tab, ["0.11 m", "5 kg", "1 deg"])
    assert list(hand.lengths().values()) == ["0.11 m", "5 kg", "1 deg"]
    wrong = tab.page.locator(".lengths [aria-invalid=true]")
    expect(wrong).to_have_value("5 kg")
    expect(tab.page.locator(".scheme-side .wrong")).to_contain_text("AB: ")
    wanted = SMALL.replace("0.1 m", "0.11 m").replace("0 deg", "1 deg")
    assert scene.read_text("utf-8") == wanted
    wrong.press("Escape")
    assert hand.lengths()["AB"] == "0.3 m"
    expect(tab.page.locator(".scheme-side .wrong")).to_be_empty()


def test_what_is_drawn_behind_a_length_leaves_it(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    (x, y), (u, v) = hand.pin("A"), hand.pin("B")
    tab.page.evaluate(SLOW)
    tab.page.locator(".lengths input").nth(1).fill("0.32 m")
    tab.page.keyboard.press("Enter")
    hand.take("centre")
    hand.click(((x + u) / 2, (y + v) / 2))
    tab.page.locator(".scheme[aria-busy=true]").wait_for()
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    text = scene.read_text("utf-8")
    assert '"0.32 m"' in text
    assert "S2 = " in text


def test_a_section_is_added_once_and_said(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    begun(tab)
    more = tab.page.locator(".more")
    more.locator("select").first.select_option("load")
    keys = more.locator("form > .scheme-field")
    told = keys.locator("input").evaluate_all("(them) => them.map((one) => one.placeholder)")
    assert [told[0], told[1], told[2], told[-1]] == ["5", "D", "190 N", "against velocity"]
    for at, value in ((0, "3"), (1, "B"), (2, "190 N")):
        keys.nth(at).locator("input").fill(value)
    more.get_by_role("button", name="Add it").click()
    expect(more.locator(".section-added")).to_have_text(
        "Added: forces and moments on links, 3, B, 190 N"
    )
    expect(more.locator("form")).to_have_count(0)
    assert scene.read_text("utf-8").count("[[load]]") == 1
    more.locator("select").first.select_option("load")
    expect(more.locator("li")).to_contain_text(["the number of the link: 3"])
    expect(keys.first.locator("input")).to_have_value("")


def test_a_value_set_beside_the_sheets_stands_under_the_scheme(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    tab.page.get_by_role("tab", name="Sheets").click()
    field = tab.field("drive.speed")
    field.fill("12 1/s")
    field.press("Enter")
    tab.told("written")
    tab.page.get_by_role("tab", name="Scheme").click()
    hand.length("AB", "0.32 m")
    wanted = SMALL.replace("10 1/s", "12 1/s").replace("0.3 m", "0.32 m")
    assert scene.read_text("utf-8") == wanted
    expect(tab.page.locator(".scheme-side [aria-invalid=true]")).to_have_count(0)


def overtaken(scene: Path, tab: Tab, text: str) -> None:
    """Let the file be another just before the first act arrives."""

    def pass_on(route: Any) -> None:
        if scene.read_text("utf-8") == SMALL:
            scene.write_text(text, encoding="utf-8")
        route.continue_()

    tab.allow("status of 409")
    tab.page.route("**/scheme", pass_on)


def test_an_act_is_done_again_on_what_the_file_is_now(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    other = SMALL.replace('"10 1/s"', '"12 1/s" # mine')
    overtaken(scene, tab, other)
    (x, y), (u, v) = hand.pin("A"), hand.pin("B")
    hand.take("centre")
    hand.click(((x + u) / 2, (y + v) / 2))
    expect(tab.page.locator(".lengths")).to_contain_text("AS2")
    text = scene.read_text("utf-8")
    assert '"12 1/s" # mine' in text
    assert "S2 = " in text
    tab.page.locator("[data-tool=undo]").click()
    expect(tab.page.locator(".lengths")).not_to_contain_text("AS2")
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    assert scene.read_text("utf-8") == other


def test_a_length_that_was_changed_meanwhile_is_not_overwritten(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    begun(tab)
    other = SMALL.replace("0.3 m", "0.35 m")
    overtaken(scene, tab, other)
    field = tab.page.locator(".lengths input").nth(1)
    field.fill("0.32 m")
    field.press("Enter")
    expect(tab.page.locator(".scheme-side .wrong")).to_contain_text("AB: The file has changed")
    expect(field).to_have_attribute("aria-invalid", "true")
    field.press("Escape")
    expect(field).to_have_value("0.35 m")
    assert scene.read_text("utf-8") == other


def test_two_values_in_one_field_are_asked_about_and_a_sum_is_taken(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    field = tab.page.locator(".lengths input").nth(1)
    field.fill("310 mm-11 mm")
    field.press("Enter")
    expect(tab.page.locator(".scheme-side .wrong")).to_have_text(
        "AB: Two values stand here: write one, or a blank before the sign of a sum."
    )
    assert scene.read_text("utf-8") == SMALL
    hand.length("AB", "310 mm + 5 mm")
    assert '"310 mm + 5 mm"' in scene.read_text("utf-8")
    expect(tab.page.locator(".scheme-side .wrong")).to_be_empty()


def test_a_value_that_was_left_is_taken_back_from_the_paper(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    field = tab.page.locator(".lengths input").nth(1)
    field.fill("0.32 m")
    hand.click((300, 100))
    tab.told("Drawn as the file says.")
    larger = SMALL.replace("0.3 m", "0.32 m")
    for keys, text, file in (("z", "0.3 m", SMALL), ("y", "0.32 m", larger)):
        tab.page.locator(".scheme-paper").press(f"Control+{keys}")
        expect(field).to_have_value(text)
        tab.page.locator(".scheme[aria-busy=false]").wait_for()
        assert scene.read_text("utf-8") == file


def test_what_is_asked_of_a_named_length_waits(scene: Path, tab_of: Callable[..., Tab]) -> None:
    named = SMALL.replace('A = ["0.1 m", 0]', 'A = ["l", 0]').replace(
        "[frame]", "[lengths]\n[frame]"
    )
    named = named.replace("[lengths]", '[lengths]\nl = "0.1 m"').replace(
        'B = ["0.3 m"', 'B = ["3*l"'
    )
    scene.write_text(named, encoding="utf-8")
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    # the named length has a row of its own, the first
    typed_one_after_another(tab, ["0.1 m", "0.12 m", "0.4 m"])
    assert list(hand.lengths().values())[:3] == ["0.1 m", "0.12 m", "0.4 m"]
    assert scene.read_text("utf-8") == named.replace("3*l", "0.4 m")
    tab.page.get_by_role("button", name="here alone").click()
    expect(tab.page.locator(".question")).to_have_count(0)
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    assert 'A = ["0.12 m", 0]' in scene.read_text("utf-8")
