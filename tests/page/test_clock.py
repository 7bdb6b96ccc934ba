"""The speaker's clock, by the page's program run by node: hours, minutes, seconds of a time that has gone."""

from __future__ import annotations

from support.scripts import run

PROGRAM = """
globalThis.document = {
  createElement: () => ({ setAttribute() {}, append() {}, addEventListener() {}, textContent: "" }),
};
const { Clock } = await import("./clock.js");
const clock = new Clock({});
tell(asked.map((seconds) => {
  clock.gone = 1000 * seconds;
  clock.show();
  return clock.face.textContent;
}));
"""


def test_a_time_is_shown_as_a_clock_shows_it() -> None:
    shown = {
        0: "0:00", 9.99: "0:09", 59: "0:59", 60: "1:00", 61: "1:01", 3599: "59:59",
        3600: "1:00:00", 3661: "1:01:01", 7199.5: "1:59:59", 36000: "10:00:00",
    }  # fmt: skip
    assert run(PROGRAM, list(shown)) == list(shown.values())
