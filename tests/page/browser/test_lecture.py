"""A lecture: read from the last row, driven by a remote, with a window for the speaker."""

from __future__ import annotations

import re
import statistics

import pytest

WIDE = {"viewport": {"width": 1920, "height": 1080}}
ADDRESS = "#lecture:velocities/5/9"
FULL = "() => document.documentElement.classList.contains('full')"
OF = re.compile(r"(\d+) of (\d+)")


@pytest.fixture
def lecture(page_of):
    def begin(address: str = ADDRESS, scene: str = "windrower", **options):
        return page_of(scene, "en", address, **{**WIDE, **options})

    return begin


def steps(page) -> tuple[str, int, int]:
    """What the lecture shows: the plan, the picture, how many there are."""
    told = page.locator("#lecture .saying")
    found = OF.search(told.locator(".count").inner_text())
    assert found
    return told.locator("h2").inner_text(), int(found[1]), int(found[2])


def test_an_address_opens_there(lecture) -> None:
    page = lecture().page
    assert page.get_by_role("tab", selected=True).inner_text() == "Lecture"
    assert steps(page)[:2] == ("Velocity plan, position 5", 9)


def test_a_remote_goes_through_the_plans(lecture) -> None:
    page = lecture().page
    for key, by in {
        "PageDown": 1,
        "ArrowRight": 1,
        "Space": 1,
        "PageUp": -1,
        "ArrowLeft": -1,
    }.items():
        before = steps(page)
        page.keyboard.press(key)
        assert steps(page) == (before[0], before[1] + by, before[2])
    page.keyboard.press("Home")
    assert steps(page)[1] == 0
    page.keyboard.press("End")
    title, at, most = steps(page)
    assert at == most
    page.keyboard.press("PageDown")
    assert steps(page)[:2] == ("Acceleration plan, position 2", 0)
    page.keyboard.press("PageUp")
    assert steps(page) == (title, most, most)
    page.keyboard.press("ArrowUp")
    assert steps(page)[:2] == ("Velocity plan, position 4", 0)


def test_a_lecture_goes_from_plan_to_plan_in_one_position(lecture) -> None:
    page = lecture("#lecture:velocities/8/0").page
    met = []
    for _ in range(4):
        met.append(steps(page)[0])
        page.keyboard.press("End")
        page.keyboard.press("PageDown")
    assert met[:2] == ["Velocity plan, position 8", "Acceleration plan, position 8"]
    assert len(set(met)) == 4


@pytest.mark.parametrize("scene", ["windrower", "engine"])
def test_every_sentence_is_read_from_the_last_row(lecture, scene: str) -> None:
    page = lecture("#lecture:", scene).page
    page.keyboard.press("f")
    small = page.evaluate(
        """() => {
      const told = document.querySelector("#lecture .saying"), found = [];
      const size = (part) => parseFloat(getComputedStyle(part).fontSize) / innerHeight;
      const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
      for (let before = ""; before !== location.hash; press("PageDown")) {
        before = location.hash;
        const read = [...told.querySelectorAll(".step, .calc")].filter((part) => part.checkVisibility());
        if (!read.every((part) => size(part) >= 1 / 25)) found.push(`${before}: small`);
        if (told.scrollWidth > told.clientWidth) found.push(`${before}: wide`);
      }
      return found;
    }"""
    )
    assert small == []


def test_letters_and_new_lines_are_seen_from_afar(lecture) -> None:
    """Of letters only those are smaller that would meet another one, or the edge."""
    page = lecture("#lecture:positions/all/20").page
    while page.locator("#lecture .stage path.now").count() == 0:
        page.keyboard.press("PageDown")
    small = page.evaluate(
        """(least) => {
      const svg = document.querySelector("#lecture .stage"), wide = svg.getScreenCTM().a;
      const now = [...svg.querySelectorAll("path.now:not(.label path)")];
      const times = (group) => Number(group.style.getPropertyValue("--times"));
      const high = (one) => 10 * Number(one.closest(".lettering").getAttribute("stroke-width"));
      const labels = [...svg.querySelectorAll(".label")], edge = svg.getBoundingClientRect();
      const letters = labels.map((one) => high(one) * wide * times(one));
      const boxes = labels.map((one) => one.getBoundingClientRect());
      const free = labels.filter((_, k) => {
        if (letters[k] >= least) return false;
        const { left, right, top, bottom } = boxes[k], more = (least / letters[k] - 1) / 2;
        const [x, y] = [more * (right - left) + 2, more * (bottom - top) + 2];
        const meets = (box, n) => n !== k && box.left < right + x && left - x < box.right
          && box.top < bottom + y && top - y < box.bottom;
        const over = left - x < edge.left || right + x > edge.right
          || top - y < edge.top || bottom + y > edge.bottom;
        return !over && !boxes.some(meets);
      });
      const lines = now.map((one) => parseFloat(getComputedStyle(one).strokeWidth) * wide);
      return { lines, letters, free: free.length };
    }""",
        1080 / 45,
    )
    assert small["lines"]
    assert min(small["lines"]) >= 4.9
    assert small["free"] == 0
    assert statistics.median(small["letters"]) >= 1080 / 45


def test_the_screen_turns_black_and_back(lecture) -> None:
    page = lecture().page
    black = page.locator("#lecture .black")
    for key in "b.":
        page.keyboard.press(key)
        assert black.is_visible()
        page.keyboard.press(key)
        assert not black.is_visible()
    page.keyboard.press("b")
    page.keyboard.press("PageDown")
    assert not black.is_visible()


def test_dark_and_light_by_key_and_button(lecture) -> None:
    page = lecture(color_scheme="light").page
    ground = "() => getComputedStyle(document.body).backgroundColor"
    light = page.evaluate(ground)
    page.keyboard.press("d")
    dark = page.evaluate(ground)
    assert dark != light
    page.get_by_role("button", name="Dark or light").click()
    assert page.evaluate(ground) == light


def test_the_lecture_fills_the_screen(lecture) -> None:
    page = lecture().page
    page.keyboard.press("f")
    page.wait_for_function("() => document.fullscreenElement !== null")
    assert page.evaluate(FULL)
    assert not page.get_by_role("tab").first.is_visible()
    page.keyboard.press("f")
    page.wait_for_function("() => document.fullscreenElement === null")
    assert page.get_by_role("tab").first.is_visible()
    page.get_by_role("button", name="Full screen", exact=True).click()
    page.wait_for_function("() => document.fullscreenElement !== null")
    page.evaluate("() => document.exitFullscreen()")
    page.wait_for_function("() => !document.documentElement.classList.contains('full')")


def begun_with(script: str, opened, files):
    """Open a lecture in a browser that runs a script before it: the page is begun anew where it is then."""
    page = opened(files("windrower", "en"), ADDRESS, **WIDE).page
    page.locator("html.ready").wait_for()
    page.add_init_script(script)
    page.reload()
    page.locator("html.ready").wait_for()
    return page


REFUSED = {
    "refused": "Element.prototype.requestFullscreen = () => Promise.reject(new TypeError('no'))",
    "missing": "delete Element.prototype.requestFullscreen",
}


@pytest.mark.parametrize("how", REFUSED)
def test_where_the_screen_is_refused_the_window_is_filled(opened, files, how: str) -> None:
    page = begun_with(REFUSED[how], opened, files)
    page.keyboard.press("f")
    assert page.evaluate(FULL)
    assert not page.get_by_role("tab").first.is_visible()
    assert page.locator("#lecture").bounding_box() == {
        "x": 0,
        "y": 0,
        "width": 1920,
        "height": 1080,
    }
    page.keyboard.press("Escape")
    assert page.get_by_role("tab").first.is_visible()


def speaker_of(page):
    with page.expect_popup() as found:
        page.get_by_role("button", name="Speaker's window").click()
    return found.value


def test_the_speaker_sees_what_is_told_why_and_what_follows(lecture) -> None:
    page = lecture().page
    other = speaker_of(page)
    now, after = other.locator(".speaker-now"), other.locator(".speaker-next")
    assert re.match(r"Velocity plan, position 5\s+9 of ", now.inner_text())
    assert "Why:" in now.inner_text()
    following = after.locator(".telling").inner_text()
    assert after.locator("svg path.now").count() > 0
    page.bring_to_front()
    page.keyboard.press("PageDown")
    assert following in now.inner_text()
    assert after.locator(".telling").inner_text() != following


def test_the_speaker_drives_the_lecture(lecture) -> None:
    page = lecture().page
    other = speaker_of(page)
    other.get_by_role("button", name="Next step").click()
    assert steps(page)[1] == 10
    other.keyboard.press("PageUp")
    assert steps(page)[1] == 9
    other.get_by_role("button", name="Black").click()
    assert page.locator("#lecture .black").is_visible()
    other.keyboard.press("b")
    assert not page.locator("#lecture .black").is_visible()
    other.locator(".plans select").select_option(label="Acceleration plan")
    assert steps(page)[:2] == ("Acceleration plan, position 2", 0)
    page.keyboard.press("End")
    assert other.locator(".speaker-next .remark").first.inner_text() == "Group 4-5, position 8"


def test_the_clock_is_the_speaker_s(lecture) -> None:
    other = speaker_of(lecture().page)
    clock = other.get_by_role("timer")
    assert clock.inner_text() == "0:00"
    other.get_by_role("button", name="Start the clock").click()
    other.wait_for_function("() => document.querySelector('.clock').textContent !== '0:00'")
    other.get_by_role("button", name="Stop the clock").click()
    other.get_by_role("button", name="Clock to 0:00").click()
    assert clock.inner_text() == "0:00"


def test_the_speaker_s_window_opens_once_and_closes_with_the_page(lecture) -> None:
    page = lecture().page
    other = speaker_of(page)
    page.get_by_role("button", name="Speaker's window").click()
    assert page.context.pages == [page, other]
    other.close()
    again = speaker_of(page)
    assert "9 of " in again.locator(".speaker-now").inner_text()
    with again.expect_event("close"):
        page.reload()


def test_a_window_that_is_refused_is_told(opened, files) -> None:
    page = begun_with("window.open = () => null", opened, files)
    page.get_by_role("button", name="Speaker's window").click()
    assert "allow windows of this page" in page.get_by_role("alert").inner_text()
