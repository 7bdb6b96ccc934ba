"""What the page costs: its size, writing it, until it can be used, its frames in a browser.

`python tests/benchmarks/page.py` measures the default scene in Chromium (see `tests/support/browser.py`), with
the limit of frames off and painted by the processor: a frame lasts from one that could be shown to the next.
Pan and zoom move the first sheet of each scene that is named: `page.py windrower project`; the default one's if
none is.
"""

from __future__ import annotations

import gzip
import re
import statistics
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clock import Row, in_turns, process, show
from support.browser import Opened, launched
from support.gallery import SHEETS
from support.lesson import names

from graphic_tmm.page.page import page
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

if TYPE_CHECKING:
    from playwright.sync_api import Browser

SCENE = "windrower"
UNLIMITED = ("--disable-frame-rate-limit", "--disable-gpu-vsync")
LARGEST, PACKED, BARE = 1800, 550, 500
"""The most that the page of the default scene may be, kB: as it is, compressed, without its sheets."""
READY, SLOW = 0.5, 2.0
"""Seconds until a page can be used, and where the processor is four times as slow."""
WRITTEN = 2.5
FRAMES = {"a step": (5, 10), "a degree": (5, 10), "all plans": (16, 33), "pan and zoom": (12, 16)}
"""Frames, ms: the median, and that of 95 in a hundred."""
COUNT = 240
WATCHED = """
const watch = () => {
  if (document.querySelector("[role=toolbar] button, [role=tab]") === null) return requestAnimationFrame(watch);
  requestAnimationFrame(() => setTimeout(() => { document.readyAt = performance.now(); }));
};
if (location.protocol === "file:") requestAnimationFrame(watch);
"""
MEASURED = """async ([kind, called, count]) => {
  const named = (one) => one.getAttribute("aria-label") ?? one.textContent.trim();
  const button = (name) => [...document.querySelectorAll("button")].find((one) => named(one) === name);
  const press = (one, key) => one.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  const seen = (one) => one.checkVisibility();
  const slider = [...document.querySelectorAll("[role=slider], input[type=range]")].find(seen);
  const paper = [...document.querySelectorAll("canvas")].find(seen);
  const acts = {
    step: () => {
      const before = location.hash;
      button(called.next).click();
      if (before === location.hash) button(called.first).click();
    },
    degree: () => {
      if (slider instanceof HTMLInputElement) {
        const before = slider.value;
        slider.stepUp();
        if (slider.value === before) slider.value = slider.min;
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      } else press(slider, "ArrowRight");
    },
    move: (k) => {
      const { left, top, width, height } = paper.getBoundingClientRect();
      const clientX = left + width * (0.5 + 0.3 * Math.sin(k / 9));
      const clientY = top + height * (0.5 + 0.3 * Math.cos(k / 7));
      const turn = { deltaY: Math.floor(k / 30) % 2 ? 40 : -40, clientX, clientY, ctrlKey: true };
      paper.dispatchEvent(new WheelEvent("wheel", { ...turn, bubbles: true, cancelable: true }));
    },
  };
  if ((kind === "degree" && !slider) || (kind === "move" && !paper)) return [];
  const frame = () => new Promise((done) => requestAnimationFrame(() => done(performance.now())));
  const times = [];
  for (let k = -20; k < count; k += 1) {
    const before = await frame();
    acts[kind](k);
    await frame();
    const after = await frame();
    if (k >= 0) times.push((after - before) / 2);
  }
  return times;
}"""


def kilobytes(text: str) -> tuple[float, float]:
    """Return how large a text is, and compressed."""
    data = text.encode()
    return len(data) / 1000, len(gzip.compress(data, 9)) / 1000


def sizes(text: str) -> list[Row]:
    """Return the lines of the table of sizes."""
    whole, packed = kilobytes(text)
    bare, _ = kilobytes(re.sub(r"<svg.*?</svg>", "", text, flags=re.DOTALL))
    return [
        Row("its page", f"{whole:.0f} kB", f"≤ {LARGEST}", whole <= LARGEST),
        Row("compressed", f"{packed:.0f} kB", f"≤ {PACKED}", packed <= PACKED),
        Row("without its sheets", f"{bare:.0f} kB", f"≤ {BARE}", bare <= BARE),
    ]


def written(folder: Path) -> list[Row]:
    """Return the line that tells how long writing the page takes a fresh process."""
    call = process("-m", "graphic_tmm", "page", SCENE, "-o", str(folder))
    seconds = in_turns({"page": call}, rounds=5)["page"]
    return [Row("writing it, cold", f"{seconds:.2f} s", f"< {WRITTEN}", seconds < WRITTEN)]


def ready(browser: Browser, file: Path, slower: int) -> float:
    """Return the seconds from asking for a page to the frame in which it can be used: median of five."""
    found = []
    for _ in range(6):
        tab = Opened(browser, None)
        tab.context.new_cdp_session(tab.page).send(
            "Emulation.setCPUThrottlingRate", {"rate": slower}
        )
        tab.page.add_init_script(WATCHED)
        tab.page.goto(file.as_uri())
        while (at := tab.page.evaluate("document.readyAt")) is None:
            tab.page.wait_for_timeout(20)
        found.append(at / 1000)
        tab.close()
    return statistics.median(found[1:])


def frames(
    browser: Browser, file: Path, language: str, kind: str, address: str, tab: str = ""
) -> list[float]:
    """Return the frames (ms) in which something is done again and again; none where there is none."""
    opened = Opened(browser, file, address)
    opened.page.get_by_role("tab").first.wait_for()
    if tab:
        there = opened.page.get_by_role("tab", name=tab, exact=True)
        if not there.count():
            return []
        there.click()
        opened.page.wait_for_timeout(500)
    found: list[float] = opened.page.evaluate(MEASURED, [kind, dict(names(language)), COUNT])
    opened.close()
    return found


def told(what: str, kind: str, times: Sequence[float]) -> Row:
    """Return the line of the table: the median frame and that of 95 in a hundred."""
    most = FRAMES[kind]
    wanted = f"< {most[0]} / {most[1]} ms"
    if not times:
        return Row(what, "not there", wanted, False)
    found = statistics.median(times), statistics.quantiles(times, n=20)[-1]
    holds = all(a < b for a, b in zip(found, most, strict=True))
    return Row(what, f"{found[0]:.1f} / {found[1]:.1f} ms", wanted, holds)


def page_of(name: str, folder: Path) -> tuple[Any, Path]:
    """Write the page of a scene of the package; return its scene and its file."""
    made, found = sheets(read(SHEETS / name))
    file = folder / f"{name}.html"
    file.write_text(page(made, found), encoding="utf-8")
    return made.scene, file


def main(scenes: Sequence[str] = (SCENE,)) -> None:
    """Print the tables."""
    with tempfile.TemporaryDirectory() as kept:
        folder = Path(kept)
        scene, file = page_of(SCENE, folder)
        show(f"the page of {SCENE}", [*sizes(file.read_text("utf-8")), *written(folder / "cold")])
        with launched() as browser:
            usual, slow = ready(browser, file, 1), ready(browser, file, 4)
        show(
            "until it can be used, from file://",
            [
                Row("as it is", f"{usual:.2f} s", f"< {READY}", usual < READY),
                Row("a processor 4 times as slow", f"{slow:.2f} s", f"< {SLOW}", slow < SLOW),
            ],
        )
        spoken, called = scene.language, names(scene.language)
        rows = []
        with launched(*UNLIMITED) as browser:
            step = frames(browser, file, spoken, "step", "#velocities/5/0")
            rows.append(told("one plan: a step", "a step", step))
            for what, address in (
                ("one plan: a degree of the crank", "#velocities/5/0"),
                ("all plans", ""),
            ):
                kind = "a degree" if address else "all plans"
                times = frames(browser, file, spoken, "degree", address, called["crank"])
                rows.append(told(what, kind, times))
            for name in scenes:
                _, other = page_of(name, folder)
                times = frames(browser, other, spoken, "move", "", called["sheets"])
                rows.append(told(f"{name}: pan and zoom of a sheet", "pan and zoom", times))
        show("frames, no limit, software raster: median / 95 %", rows)


if __name__ == "__main__":
    main(sys.argv[1:] or (SCENE,))
