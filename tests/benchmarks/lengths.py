"""What a length costs that is changed on a page: the log at every angle anew, and the ink of one angle.

`python tests/benchmarks/lengths.py [SCENE …]` runs the page's own program in node, without painting: the median
of frames, each with another length. The limit is for a processor that nobody else is on.
"""

from __future__ import annotations

import statistics
import sys

from support import gallery
from support.scripts import run

from graphic_tmm.board.script import Script
from graphic_tmm.page.crank import crank
from graphic_tmm.page.live.givens import live_log
from graphic_tmm.page.practice.pack import written_module

SCENES = ("crank-rocker", "windrower")
MOST = 8.0
"""A frame's script takes no longer than this in the median, ms: half of a frame at 60 Hz."""
FRAMES, WARM = 120, 40
PROGRAM = """
import "./practice/written.js";
import { LiveInk } from "./live/liveink.js";
import { LiveRun } from "./live/run.js";
const live = new LiveRun(asked.live, asked.whole);
const ink = new LiveInk(asked.ties, asked.whole, (k) => live.marks(k), (k) => live.few(k));
const { pin, paths, breaks } = asked.live;
live.kept = [...pin, ...paths, ...breaks.map(([slot]) => slot), ...ink.expressions.turning];
const slider = asked.live.sliders.find((one) => one.by === 1000);
const frame = (n) => {
  const begun = performance.now();
  const value = slider.v * (1 + 0.02 * Math.sin(n / 7));
  live.give(new Map(slider.slots.map((slot) => [slot, value])));
  for (let k = 0; k < asked.whole; k++) live.few(k);
  const run = performance.now();
  ink.given(true);
  ink.at(n % asked.whole);
  return [run - begun, performance.now() - run];
};
tell(Array.from({ length: asked.frames }, (_, n) => frame(n)));
"""


def main() -> None:
    """Measure the scenes that are named, or the usual ones."""
    for name in sys.argv[1:] or SCENES:
        made, sheets = gallery.paper(name)
        turned = crank(made, sheets, live=True)
        assert turned is not None
        script = Script()
        live, logs = live_log(turned.found, turned.slots, script, made.scene.language)
        asked = {
            "live": live,
            "ties": turned.data["ties"],
            "whole": turned.found.whole,
            "frames": FRAMES,
        }
        rows = run(PROGRAM, asked, written=written_module(script, {}, logs))[WARM:]
        log, ink = (statistics.median(row[k] for row in rows) for k in (0, 1))
        print(
            f"{name}: log {log:.2f} ms, ink {ink:.2f} ms, of {MOST:g} ms {(log + ink) / MOST:.2f}"
        )


if __name__ == "__main__":
    main()
